// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/implicit_point.h"

#include <cmath>

#include "interval/interval.h"
#include "predicates/implicit_formulas.h"
#include "predicates/implicit_homogeneous.h"
#include "predicates/implicit_lattice.h"
#include "robust/base/check.h"
#include "robust/filter.h"

namespace veritope {
namespace {

using formulas::homogeneous;
using formulas::plane_vectors;
using formulas::Triple;
using internal::coordinates;
using internal::ImplicitLayer;
using internal::kPoints;
using internal::triples;

// t: the defining points, then a, b, c. The sign of the orientation times that of the denominator.
template <typename T, std::size_t N>
constexpr auto whole_orientation(const std::array<Triple<T>, N>& t) {
  using formulas::difference;
  const auto query = plane_vectors(t, N - 3);
  const auto e = difference(t[0], t[N - 3]);
  if constexpr (N == 8) {
    const auto plane = plane_vectors(t, 2);
    return sign_of(formulas::line_plane_orientation(difference(t[1], t[0]), plane.v, plane.w,
                                                    plane.g, e, query.v, query.w));
  } else {
    return sign_of(formulas::three_planes_orientation(plane_vectors(t, 0), plane_vectors(t, 3),
                                                      plane_vectors(t, 6), e, query.v, query.w));
  }
}

template <typename P>
std::array<double, 3 * kPoints<P> + 9> all_coordinates(const P& p, const Vec3d& a, const Vec3d& b,
                                                       const Vec3d& c) {
  const auto defining = coordinates(p.points());
  std::array<double, 3 * kPoints<P> + 9> all;
  VT_UNROLL for (std::size_t i = 0; i < defining.size(); ++i) all[i] = defining[i];
  const double plane[] = {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z};
  VT_UNROLL for (std::size_t i = 0; i < 9; ++i) all[defining.size() + i] = plane[i];
  return all;
}

// Bit budgets on a lattice of L limbs. On FixedInt every product is as wide as its factors together,
// so that sums are what has to fit.
struct ImplicitBudget {
  int d;                                                                     // a difference
  constexpr int n() const { return bits_of_sum(2, bits_of_product(d, d)); }  // a normal: 2 L limbs
  constexpr int n_d() const { return bits_of_sum(3, bits_of_product(n(), d)); }    // n . d: 3 L
  constexpr int c() const { return bits_of_sum(2, bits_of_product(n(), n())); }    // n x n: 4 L
  constexpr int n_c() const { return bits_of_sum(3, bits_of_product(n(), c())); }  // 6 L
  constexpr int line() const { return bits_of_sum(2, bits_of_product(n_d(), n_d())); }    // 6 L
  constexpr int planes() const { return bits_of_sum(3, bits_of_product(n_d(), n_c())); }  // 9 L
};
template <int L>
constexpr bool limbs_hold(ImplicitBudget b) {
  return b.n() < 128 * L - 1 && b.n_d() < 192 * L - 1 && b.c() < 256 * L - 1 &&
         b.n_c() < 384 * L - 1 && b.line() < 384 * L - 1 && b.planes() < 576 * L - 1;
}
// As digits, on a lattice of one limb: a difference has 1 digit, n 2, n . d 3, n x n 4 and n . (n x n) 6. A top digit
// holds what is above the digits below it, and is at most 2^62, so that a product of digits is at most 2^124; no column
// has more than six of them, and the last sum three and a carry.
constexpr bool digits_hold(ImplicitBudget b) {
  constexpr int k = kDigitBits;
  return b.d <= k && b.n() - k <= k && b.n_d() - 2 * k <= k && b.c() - 3 * k <= k &&
         b.n_c() - 5 * k <= k;
}
static_assert(digits_hold({internal::lattice_bits(1) + 1}));
static_assert(limbs_hold<2>({internal::lattice_bits(2) + 1}));

// The coordinates as one digit each, or as two limbs; false if they do not fit.
template <std::size_t N>
bool to_ring(const std::array<double, N>& c, std::array<Digits<1>, N>& out) {
  return internal::on_lattice(
      internal::lattice_of(internal::biased_exponent(c), internal::lattice_bits(1)), c, out);
}
template <std::size_t N>
bool to_ring(const std::array<double, N>& c, std::array<FixedInt<2>, N>& out) {
  return internal::to_lattice<2, N>(c, out);
}

template <typename T, std::size_t N>
Sign3 orientation_on_lattice(const std::array<double, N>& c) {
  std::array<T, N> v;
  return to_ring(c, v) ? to_sign3(whole_orientation(triples(v))) : Sign3::kUncertain;
}
template <std::size_t N>
Sign3 denominator_on_lattice(const std::array<double, N>& c) {
  std::array<FixedInt<2>, N> v;
  return to_ring(c, v) ? to_sign3(homogeneous(triples(v)).denominator.sign()) : Sign3::kUncertain;
}

// ---- The float layer -----------------------------------------------------------------------------

double largest(const Triple<double>& t) {
  return larger(larger(std::abs(t.x), std::abs(t.y)), std::abs(t.z));
}
Triple<double> minus(const Vec3d& a, const Vec3d& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

// The rounded point with its scalars; `scale` is the product of the largest differences that make up
// the denominator, `most` the largest of all differences.
template <typename H>
ImplicitLayer layer_of(const H& h, double rel, double scale, double reach, double most) {
  ImplicitLayer layer{h.numerator.x, h.numerator.y, h.numerator.z,
                      h.denominator, rel * scale,   reach};
  if (!(most <= internal::kImplicitReach)) layer.d = 0;
  return layer;
}
template <std::size_t N>
std::array<Integer, N> integers_of(const std::array<double, N>& c) {
  std::array<Integer, N> out;
  internal::to_integers(c, out);
  return out;
}
// The sign of the denominator, by the filter if it is sure; makes it positive in the layer.
template <std::size_t N>
Sign settle_denominator(ImplicitLayer& layer, const std::array<Vec3d, N>& points) {
  const Sign3 s =
      layer.d == 0 ? Sign3::kUncertain : sign_beyond(layer.d, layer.scale + internal::kImplicitAbs);
  if (!is_certain(s)) {
    layer.d = 0;
    const auto c = coordinates(points);
    const Sign3 exact_sign = denominator_on_lattice(c);
    return is_certain(exact_sign) ? to_sign(exact_sign)
                                  : homogeneous(triples(integers_of(c))).denominator.sign();
  }
  if (s == Sign3::kNegative) {
    layer.x = -layer.x, layer.y = -layer.y, layer.z = -layer.z, layer.d = -layer.d;
  }
  return to_sign(s);
}

}  // namespace

namespace internal {

template <typename P>
Sign3 implicit_lattice(const P& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) noexcept {
  return orientation_on_lattice<Digits<1>>(all_coordinates(p, a, b, c));
}
template <typename P>
Sign3 implicit_interval(const P& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) noexcept {
  const auto all = all_coordinates(p, a, b, c);
  std::array<Interval, std::tuple_size_v<decltype(all)>> v;
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = Interval(all[i]);
  const ScopedUpward upward;
  return whole_orientation(triples(v));
}
template <typename P>
Sign implicit_integer(const P& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) noexcept {
  return whole_orientation(triples(integers_of(all_coordinates(p, a, b, c))));
}
template <typename P>
Sign implicit_exact(const P& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) noexcept {
  const Sign3 s = orientation_on_lattice<FixedInt<2>>(all_coordinates(p, a, b, c));
  return is_certain(s) ? to_sign(s) : implicit_integer(p, a, b, c);
}

}  // namespace internal

namespace {

template <typename P>
Sign decide(const P& p, const Vec3d& a, const Vec3d& b, const Vec3d& c, TierCounts* tally) {
  const Sign denominator = p.denominator_sign();
  return cascade(
      tally, [&] { return internal::implicit_filter(p.layer(), p.points()[0], a, b, c); },
      [&](TierCounts* t) {
        VT_CHECK(denominator != Sign::kZero, "the orientation of a point that is not defined");
        return denominator * cascade<1>(
                                 t, [&] { return internal::implicit_lattice(p, a, b, c); },
                                 [&] { return internal::implicit_interval(p, a, b, c); },
                                 [&] { return internal::implicit_exact(p, a, b, c); });
      });
}

}  // namespace

LinePlanePoint::LinePlanePoint(const Vec3d& p, const Vec3d& q, const Vec3d& a, const Vec3d& b,
                               const Vec3d& c) noexcept
    : points_{p, q, a, b, c} {
  const Triple<double> u = minus(q, p), v = minus(b, a), w = minus(c, a), g = minus(a, p);
  const double mu = largest(u), mv = largest(v), mw = largest(w), mg = largest(g);
  layer_ = layer_of(formulas::line_plane(u, v, w, g), internal::kLinePlaneRel, mu * (mv * mw), mg,
                    larger(larger(mu, mv), larger(mw, mg)));
  denominator_ = settle_denominator(layer_, points_);
}

ThreePlanePoint::ThreePlanePoint(const std::array<Vec3d, 9>& points) noexcept : points_(points) {
  std::array<formulas::PlaneVectors<double>, 3> plane;
  double scale = 1, most = 0;
  for (int i = 0; i < 3; ++i) {
    const Vec3d &a = points[3 * i], &b = points[3 * i + 1], &c = points[3 * i + 2];
    plane[i] = {minus(b, a), minus(c, a), minus(a, points[0])};
    const double mv = largest(plane[i].v), mw = largest(plane[i].w);
    scale = i == 0 ? mv * mw : scale * (mv * mw);
    most = larger(most, larger(mv, mw));
  }
  const double g2 = largest(plane[1].g), g3 = largest(plane[2].g);
  layer_ = layer_of(formulas::three_planes(plane[0], plane[1], plane[2]), internal::kThreePlanesRel,
                    scale, g2 + g3, larger(most, larger(g2, g3)));
  denominator_ = settle_denominator(layer_, points_);
}

Sign orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const LinePlanePoint& d,
              TierCounts* tally) {
  return decide(d, a, b, c, tally);
}
Sign orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const ThreePlanePoint& d,
              TierCounts* tally) {
  return decide(d, a, b, c, tally);
}

namespace internal {

Sign3 implicit_filter(const ImplicitLayer& layer, const Vec3d& base, const Vec3d& a, const Vec3d& b,
                      const Vec3d& c) noexcept {
  const Triple<double> e = minus(base, a), v = minus(b, a), w = minus(c, a);
  const formulas::Homogeneous<double, double> h{{layer.x, layer.y, layer.z}, layer.d};
  const double me = largest(e), mv = largest(v), mw = largest(w);
  const double error = (layer.scale * (mv * mw)) * (layer.reach + me) + kImplicitAbs;
  const bool is_known = layer.d > 0 && veritope::larger(veritope::larger(me, mv), mw) <= kImplicitReach;
  return is_known ? sign_beyond(formulas::orientation(h, e, v, w), error) : Sign3::kUncertain;
}

template Sign3 implicit_lattice(const LinePlanePoint&, const Vec3d&, const Vec3d&,
                                const Vec3d&) noexcept;
template Sign3 implicit_interval(const LinePlanePoint&, const Vec3d&, const Vec3d&,
                                 const Vec3d&) noexcept;
template Sign implicit_exact(const LinePlanePoint&, const Vec3d&, const Vec3d&,
                             const Vec3d&) noexcept;
template Sign implicit_integer(const LinePlanePoint&, const Vec3d&, const Vec3d&,
                               const Vec3d&) noexcept;
template Sign3 implicit_lattice(const ThreePlanePoint&, const Vec3d&, const Vec3d&,
                                const Vec3d&) noexcept;
template Sign3 implicit_interval(const ThreePlanePoint&, const Vec3d&, const Vec3d&,
                                 const Vec3d&) noexcept;
template Sign implicit_exact(const ThreePlanePoint&, const Vec3d&, const Vec3d&,
                             const Vec3d&) noexcept;
template Sign implicit_integer(const ThreePlanePoint&, const Vec3d&, const Vec3d&,
                               const Vec3d&) noexcept;

}  // namespace internal
}  // namespace veritope
