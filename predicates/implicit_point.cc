// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/implicit_point.h"

#include <cmath>
#include <limits>

#include "interval/interval.h"
#include "predicates/implicit_formulas.h"
#include "predicates/lattice.h"
#include "robust/filter.h"

namespace veritope {
namespace {

using formulas::Triple;
using internal::ImplicitLayer;

// The number of points that define P, and where its base lies among them.
template <typename P>
constexpr std::size_t kPoints =
    std::tuple_size_v<std::decay_t<decltype(std::declval<P>().points())>>;

// ---- The formulas over a ring: t holds the defining points ---------------------------------------

template <typename T, std::size_t N>
constexpr auto homogeneous(const std::array<Triple<T>, N>& t) {
  using formulas::difference;
  if constexpr (N == 5) {
    return formulas::line_plane(difference(t[1], t[0]), difference(t[3], t[2]),
                                difference(t[4], t[2]), difference(t[2], t[0]));
  } else {
    using Plane = formulas::PlaneVectors<T>;
    const auto plane = [&](int i) {
      return Plane{difference(t[i + 1], t[i]), difference(t[i + 2], t[i]), difference(t[i], t[0])};
    };
    return formulas::three_planes(plane(0), plane(3), plane(6));
  }
}

// t: the defining points, then a, b, c. The sign of the orientation times that of the denominator.
template <typename T, std::size_t N>
constexpr auto whole_orientation(const std::array<Triple<T>, N>& t) {
  using formulas::difference;
  std::array<Triple<T>, N - 3> defining;
  for (std::size_t i = 0; i < N - 3; ++i) defining[i] = t[i];
  const Triple<T>& a = t[N - 3];
  return formulas::orientation(homogeneous(defining), difference(t[0], a), difference(t[N - 2], a),
                               difference(t[N - 1], a));
}

// ---- Coordinates in a ring -----------------------------------------------------------------------

template <std::size_t N>
std::array<double, 3 * N> coordinates(const std::array<Vec3d, N>& p) {
  std::array<double, 3 * N> c;
  for (std::size_t i = 0; i < N; ++i)
    c[3 * i] = p[i].x, c[3 * i + 1] = p[i].y, c[3 * i + 2] = p[i].z;
  return c;
}
template <typename T, std::size_t N>
std::array<Triple<T>, N / 3> triples(const std::array<T, N>& c) {
  std::array<Triple<T>, N / 3> t;
  for (std::size_t i = 0; i < N / 3; ++i) t[i] = {c[3 * i], c[3 * i + 1], c[3 * i + 2]};
  return t;
}
template <typename P>
std::array<Vec3d, kPoints<P> + 3> with_plane(const P& p, const Vec3d& a, const Vec3d& b,
                                             const Vec3d& c) {
  std::array<Vec3d, kPoints<P> + 3> all;
  for (std::size_t i = 0; i < kPoints<P>; ++i) all[i] = p.points()[i];
  all[kPoints<P>] = a, all[kPoints<P> + 1] = b, all[kPoints<P> + 2] = c;
  return all;
}

// Bit budgets of homogeneous() and orientation() on a lattice of L limbs: every product is as wide as
// its factors together, so that sums are what has to fit.
template <int L>
constexpr bool budgets_hold() {
  const int d = bits_of_sum(2, internal::lattice_bits(L));
  const int n = bits_of_sum(2, bits_of_product(d, d));    // a normal's component: 2 L limbs
  const int n_u = bits_of_sum(3, bits_of_product(n, d));  // dot with a difference: 3 L
  const int c = bits_of_sum(2, bits_of_product(n, n));    // cross product of normals: 4 L
  const int line = bits_of_sum(3, bits_of_product(bits_of_product(n_u, d), n));  // 6 L
  const int line_all = bits_of_sum(2, line);
  const int planes =
      bits_of_sum(3, bits_of_product(bits_of_sum(2, bits_of_product(n_u, c)), n));  // 9 L
  const int denominator = bits_of_sum(3, bits_of_product(n, c));                    // 6 L
  const int planes_other = bits_of_product(denominator, n_u);
  const int planes_all = bits_of_sum(2, planes > planes_other ? planes : planes_other);
  return n < 128 * L - 1 && n_u < 192 * L - 1 && c < 256 * L - 1 && line_all < 384 * L - 1 &&
         denominator < 384 * L - 1 && planes_all < 576 * L - 1;
}
static_assert(budgets_hold<1>() && budgets_hold<2>());

template <int L, std::size_t N>
Sign3 orientation_on_lattice(const std::array<double, N>& c) {
  std::array<FixedInt<L>, N> v;
  if (!internal::to_lattice<L, N>(c, v)) return Sign3::kUncertain;
  return to_sign3(whole_orientation(triples(v)).sign());
}
template <int L, std::size_t N>
Sign3 denominator_on_lattice(const std::array<double, N>& c) {
  std::array<FixedInt<L>, N> v;
  if (!internal::to_lattice<L, N>(c, v)) return Sign3::kUncertain;
  return to_sign3(homogeneous(triples(v)).denominator.sign());
}

template <typename P>
Sign3 lattice(const P& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return orientation_on_lattice<1>(coordinates(with_plane(p, a, b, c)));
}
template <typename P>
Sign3 interval(const P& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const auto all = coordinates(with_plane(p, a, b, c));
  std::array<Interval, std::tuple_size_v<decltype(all)>> v;
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = Interval(all[i]);
  const ScopedUpward upward;
  return whole_orientation(triples(v)).sign();
}
template <typename P>
Sign integer(const P& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return whole_orientation(triples(internal::to_integers(coordinates(with_plane(p, a, b, c)))))
      .sign();
}
template <typename P>
Sign exact(const P& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Sign3 s = orientation_on_lattice<2>(coordinates(with_plane(p, a, b, c)));
  return is_certain(s) ? to_sign(s) : integer(p, a, b, c);
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
// The sign of the denominator, by the filter if it is sure; makes it positive in the layer.
template <std::size_t N>
Sign settle_denominator(ImplicitLayer& layer, const std::array<Vec3d, N>& points) {
  const Sign3 s =
      layer.d == 0 ? Sign3::kUncertain : sign_beyond(layer.d, layer.scale + internal::kImplicitAbs);
  if (!is_certain(s)) {
    layer.d = 0;
    const auto c = coordinates(points);
    Sign3 exact_sign = denominator_on_lattice<1>(c);
    if (!is_certain(exact_sign)) exact_sign = denominator_on_lattice<2>(c);
    return is_certain(exact_sign)
               ? to_sign(exact_sign)
               : homogeneous(triples(internal::to_integers(c))).denominator.sign();
  }
  if (s == Sign3::kNegative) {
    layer.x = -layer.x, layer.y = -layer.y, layer.z = -layer.z, layer.d = -layer.d;
  }
  return to_sign(s);
}

template <typename P>
Sign decide(const P& p, const Vec3d& a, const Vec3d& b, const Vec3d& c, TierCounts* tally) {
  const Sign denominator = p.denominator_sign();
  return cascade(
      tally, [&] { return internal::implicit_filter(p.layer(), p.points()[0], a, b, c); },
      [&](TierCounts* t) {
        return denominator * cascade<1>(
                                 t, [&] { return lattice(p, a, b, c); },
                                 [&] { return interval(p, a, b, c); },
                                 [&] { return exact(p, a, b, c); });
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
              TierCounts* tally) noexcept {
  return decide(d, a, b, c, tally);
}
Sign orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const ThreePlanePoint& d,
              TierCounts* tally) noexcept {
  return decide(d, a, b, c, tally);
}

namespace internal {

Sign3 implicit_filter(const ImplicitLayer& layer, const Vec3d& base, const Vec3d& a, const Vec3d& b,
                      const Vec3d& c) noexcept {
  const Triple<double> e = minus(base, a), v = minus(b, a), w = minus(c, a);
  const formulas::Homogeneous<double, double> h{{layer.x, layer.y, layer.z}, layer.d};
  const double me = largest(e), mv = largest(v), mw = largest(w);
  const double error = (layer.scale * (mv * mw)) * (layer.reach + me) + kImplicitAbs;
  const bool is_known = layer.d > 0 && larger(larger(me, mv), mw) <= kImplicitReach;
  return is_known ? sign_beyond(formulas::orientation(h, e, v, w), error) : Sign3::kUncertain;
}

Sign3 implicit_lattice(const LinePlanePoint& p, const Vec3d& a, const Vec3d& b,
                       const Vec3d& c) noexcept {
  return lattice(p, a, b, c);
}
Sign3 implicit_lattice(const ThreePlanePoint& p, const Vec3d& a, const Vec3d& b,
                       const Vec3d& c) noexcept {
  return lattice(p, a, b, c);
}
Sign3 implicit_interval(const LinePlanePoint& p, const Vec3d& a, const Vec3d& b,
                        const Vec3d& c) noexcept {
  return interval(p, a, b, c);
}
Sign3 implicit_interval(const ThreePlanePoint& p, const Vec3d& a, const Vec3d& b,
                        const Vec3d& c) noexcept {
  return interval(p, a, b, c);
}
Sign implicit_exact(const LinePlanePoint& p, const Vec3d& a, const Vec3d& b,
                    const Vec3d& c) noexcept {
  return exact(p, a, b, c);
}
Sign implicit_exact(const ThreePlanePoint& p, const Vec3d& a, const Vec3d& b,
                    const Vec3d& c) noexcept {
  return exact(p, a, b, c);
}
Sign implicit_integer(const LinePlanePoint& p, const Vec3d& a, const Vec3d& b,
                      const Vec3d& c) noexcept {
  return integer(p, a, b, c);
}
Sign implicit_integer(const ThreePlanePoint& p, const Vec3d& a, const Vec3d& b,
                      const Vec3d& c) noexcept {
  return integer(p, a, b, c);
}

}  // namespace internal
}  // namespace veritope
