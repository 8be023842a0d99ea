// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/implicit_cache.h"

#include <bit>

#include "predicates/implicit_homogeneous.h"
#include "predicates/lattice.h"
#include "robust/base/check.h"

namespace veritope {

namespace internal {
namespace {

using formulas::Triple;

// Bits for the coordinates of the defining points; those of a query may have one more.
constexpr int kBits = lattice_bits(1) - 1;

template <typename P>
bool defining_digits(const P& p, LatticeUnit& lattice, std::array<std::int64_t, 3>& base,
                     std::array<Triple<Digits<1>>, kPoints<P>>& out) {
  const auto c = coordinates(p.points());
  lattice = lattice_of(biased_exponent(c), kBits);
  std::array<Digits<1>, 3 * kPoints<P>> v;
  if (!on_lattice(lattice, c, v)) return false;
  out = triples(v);
  base = {v[0].d[0], v[1].d[0], v[2].d[0]};
  return true;
}

template <typename D, typename Orientation>
Sign3 orientation(const D& p, const Vec3d& a, const Vec3d& b, const Vec3d& c, Orientation f) {
  const std::array<double, 9> q{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z};
  std::array<Digits<1>, 9> v;
  const auto reach =
      std::bit_cast<std::uint64_t>(p.lattice.unit) + (std::uint64_t{lattice_bits(1)} << 52);
  if (biased_exponent(q) >= reach >> 52 || !on_lattice(p.lattice, q, v)) return Sign3::kUncertain;
  const auto t = triples(v);
  const Triple<Digits<1>> base{{{p.base[0]}}, {{p.base[1]}}, {{p.base[2]}}};
  return to_sign3(
      f(formulas::difference(base, t[0]),
        formulas::cross(formulas::difference(t[1], t[0]), formulas::difference(t[2], t[0]))));
}

}  // namespace

bool find_digits(const LinePlanePoint& p, LinePlaneDigits& out) noexcept {
  std::array<Triple<Digits<1>>, 5> t;
  if (!defining_digits(p, out.lattice, out.base, t)) return false;
  const auto plane = formulas::plane_vectors(t, 2);
  const auto u = formulas::difference(t[1], t[0]);
  const auto n = formulas::cross(plane.v, plane.w);
  out.u = {u.x.d[0], u.y.d[0], u.z.d[0]};
  out.t = formulas::dot(n, plane.g);
  out.denominator = formulas::dot(n, u);
  return true;
}
bool find_digits(const ThreePlanePoint& p, ThreePlanesDigits& out) noexcept {
  std::array<Triple<Digits<1>>, 9> t;
  if (!defining_digits(p, out.lattice, out.base, t)) return false;
  const auto h = formulas::homogeneous(t);
  out.numerator = {settled(h.numerator.x), settled(h.numerator.y), settled(h.numerator.z)};
  out.denominator = h.denominator;
  return true;
}

Sign3 orientation_of_digits(const LinePlaneDigits& p, const Vec3d& a, const Vec3d& b,
                            const Vec3d& c) noexcept {
  return orientation(p, a, b, c, [&](const auto& e, const auto& m) {
    const Triple<Digits<1>> u{{{p.u[0]}}, {{p.u[1]}}, {{p.u[2]}}};
    return sign_of(column_product(p.t, formulas::dot(u, m)) +
                   column_product(p.denominator, formulas::dot(e, m)));
  });
}
Sign3 orientation_of_digits(const ThreePlanesDigits& p, const Vec3d& a, const Vec3d& b,
                            const Vec3d& c) noexcept {
  return orientation(p, a, b, c, [&](const auto& e, const auto& m) {
    return sign_of(formulas::last_sum(column_product(p.numerator[0], m.x) +
                                          column_product(p.numerator[1], m.y) +
                                          column_product(p.numerator[2], m.z),
                                      column_product(p.denominator, formulas::dot(e, m))));
  });
}

}  // namespace internal

namespace {

template <typename P>
Sign decide(const CachedPoint<P>& p, const Vec3d& a, const Vec3d& b, const Vec3d& c,
            TierCounts* tally) {
  const P& point = p.point();
  return cascade(
      tally, [&] { return internal::implicit_filter(point.layer(), point.points()[0], a, b, c); },
      [&](TierCounts* t) {
        VT_CHECK(point.is_defined(), "the orientation of a point that is not defined");
        return point.denominator_sign() *
               cascade<1>(
                   t,
                   [&] {
                     const internal::PointDigits<P>* digits = p.digits();
                     const Sign3 s = digits == nullptr
                                         ? Sign3::kUncertain
                                         : internal::orientation_of_digits(*digits, a, b, c);
                     return is_certain(s) ? s : internal::implicit_lattice(point, a, b, c);
                   },
                   [&] { return internal::implicit_interval(point, a, b, c); },
                   [&] { return internal::implicit_exact(point, a, b, c); });
      });
}

}  // namespace

Sign orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const CachedPoint<LinePlanePoint>& d,
              TierCounts* tally) {
  return decide(d, a, b, c, tally);
}
Sign orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const CachedPoint<ThreePlanePoint>& d,
              TierCounts* tally) {
  return decide(d, a, b, c, tally);
}

}  // namespace veritope
