// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/orient2d.h"

#include "interval/interval.h"
#include "predicates/fixed_formulas.h"

namespace veritope::internal {
namespace {

// The sign, if each axis fits a lattice of L limbs.
template <int L>
[[gnu::always_inline]] inline Sign3 on_lattice(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  std::array<FixedInt<L>, 3> x, y;
  if (!to_lattice<L, 3>({a.x, b.x, c.x}, x) || !to_lattice<L, 3>({a.y, b.y, c.y}, y))
    return Sign3::kUncertain;
  return to_sign3(orient2d_fixed<LatticeWidth<L>>(from_first(x), from_first(y)));
}

// Where one limb does not suffice. REQUIRES that on_lattice<1> is uncertain.
[[gnu::always_inline]] inline Sign3 on_longer_lattice(const Vec2d& a, const Vec2d& b,
                                                      const Vec2d& c) {
  return has_equal_points<2>(std::array<double, 6>{a.x, a.y, b.x, b.y, c.x, c.y})
             ? Sign3::kZero
             : on_lattice<2>(a, b, c);
}

[[gnu::noinline]] Sign after_lattice(const Vec2d& a, const Vec2d& b, const Vec2d& c,
                                     TierCounts* tally) {
  return cascade<2>(
      tally, [&] { return orient2d_interval(a, b, c); }, [&] { return orient2d_exact(a, b, c); });
}

// Apart, so that one limb needs few registers.
[[gnu::noinline]] Sign after_one_limb(const Vec2d& a, const Vec2d& b, const Vec2d& c,
                                      TierCounts* tally) {
  return cascade<1>(
      tally, [&]() VT_TIER { return on_longer_lattice(a, b, c); },
      [&](TierCounts* t) VT_TIER { return after_lattice(a, b, c, t); });
}

}  // namespace

Sign3 orient2d_lattice(const Vec2d& a, const Vec2d& b, const Vec2d& c) noexcept {
  const Sign3 s = on_lattice<1>(a, b, c);
  return is_certain(s) ? s : on_longer_lattice(a, b, c);
}

Sign3 orient2d_interval(const Vec2d& a, const Vec2d& b, const Vec2d& c) noexcept {
  const ScopedUpward upward;
  return formulas::Orient2d<Interval>(Interval(a.x), Interval(a.y), Interval(b.x), Interval(b.y),
                                      Interval(c.x), Interval(c.y))
      .det()
      .sign();
}

Sign orient2d_exact(const Vec2d& a, const Vec2d& b, const Vec2d& c) noexcept {
  using T = Wide<degree_limbs(2, 1)>;  // two products
  const auto v = to_wide<T, 6>({a.x, a.y, b.x, b.y, c.x, c.y});
  return formulas::Orient2d<T>(v[0], v[1], v[2], v[3], v[4], v[5]).det().sign();
}

Sign orient2d_off_axes(const Vec2d& a, const Vec2d& b, const Vec2d& c, TierCounts* tally) noexcept {
  return cascade<1>(
      tally, [&]() VT_TIER { return on_lattice<1>(a, b, c); },
      [&](TierCounts* t) VT_TIER { return after_one_limb(a, b, c, t); });
}

}  // namespace veritope::internal
