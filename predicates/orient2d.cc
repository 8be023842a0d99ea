// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/orient2d.h"

#include "predicates/lattice.h"
#include "robust/base/int128.h"

namespace veritope::internal {

// Differences have at most 61 bits, their products 122.
Sign3 orient2d_lattice(Vec2d a, Vec2d b, Vec2d c) {
  std::array<std::int64_t, 3> x, y;
  if (!to_short_lattice<3>({a.x, b.x, c.x}, x) || !to_short_lattice<3>({a.y, b.y, c.y}, y)) {
    return Sign3::kUncertain;
  }
  const int128 left = static_cast<int128>(x[1] - x[0]) * (y[2] - y[0]);
  const int128 right = static_cast<int128>(y[1] - y[0]) * (x[2] - x[0]);
  return to_sign3(sign_of(left - right));
}

Sign3 orient2d_interval(Vec2d, Vec2d, Vec2d) { return Sign3::kUncertain; }

Sign orient2d_exact(Vec2d a, Vec2d b, Vec2d c) {
  const auto x = to_integers<3>({a.x, b.x, c.x});
  const auto y = to_integers<3>({a.y, b.y, c.y});
  return formulas::Orient2d<Integer>(x[0], y[0], x[1], y[1], x[2], y[2]).det().sign();
}

Sign orient2d_after_filter(Vec2d a, Vec2d b, Vec2d c, TierCounts* tally) {
  return cascade<1>(
      tally, [&] { return orient2d_lattice(a, b, c); },
      [&] { return orient2d_interval(a, b, c); }, [&] { return orient2d_exact(a, b, c); });
}

}  // namespace veritope::internal
