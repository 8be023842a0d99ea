// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/in_circle.h"

#include "interval/interval.h"
#include "predicates/fixed_formulas.h"

namespace veritope::internal {
namespace {

std::array<double, 8> coordinates(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) {
  return {a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y};
}

// The sign, if all coordinates fit one lattice of L limbs.
template <int L>
Sign3 on_lattice(const std::array<double, 8>& c) {
  std::array<FixedInt<L>, 8> v;
  if (!to_lattice<L, 8>(c, v)) return Sign3::kUncertain;
  auto d = from_last<2>(v);
  if constexpr (L == 1) {
    if (shorten(d) <= ShortCircle::kBudget.diff) return to_sign3(in_circle_fixed<ShortCircle>(d));
  }
  return to_sign3(in_circle_fixed<LatticeWidthCircle<L>>(d));
}

}  // namespace

Sign3 in_circle_lattice(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) noexcept {
  const auto v = coordinates(a, b, c, d);
  if (are_corners_of_a_box<2>(v)) return Sign3::kZero;
  const Sign3 s = on_lattice<1>(v);
  if (is_certain(s)) return s;
  return has_equal_points<2>(v) ? Sign3::kZero : on_lattice<2>(v);
}

Sign3 in_circle_interval(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) noexcept {
  const ScopedUpward upward;
  return formulas::InCircle<Interval>(Interval(a.x), Interval(a.y), Interval(b.x), Interval(b.y),
                                      Interval(c.x), Interval(c.y), Interval(d.x), Interval(d.y))
      .det()
      .sign();
}

Sign in_circle_exact(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) noexcept {
  using T = Wide<degree_limbs(4, 4)>;  // twelve products
  const auto v = to_wide<T, 8>(coordinates(a, b, c, d));
  return formulas::InCircle<T>(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]).det().sign();
}

Sign in_circle_after_filter(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d,
                            TierCounts* tally) noexcept {
  return cascade<1>(
      tally, [&] { return in_circle_lattice(a, b, c, d); },
      [&] { return in_circle_interval(a, b, c, d); }, [&] { return in_circle_exact(a, b, c, d); });
}

}  // namespace veritope::internal
