// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/interval/draw.h: random intervals of all exponents, with zeros, subnormals, infinite bounds.
#pragma once
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "interval/interval.h"
#include "robust/base/random.h"
#include "robust/binary64.h"

namespace veritope {

inline double draw_finite(Random& random) {
  switch (random.below(8)) {
    case 0: return 0;
    case 1: return static_cast<double>(random.between(-9, 9)) * 0x1p-1074;
    case 2: return static_cast<double>(random.between(-3, 3));
    case 3: return (random.below(2) != 0 ? -1 : 1) * std::numeric_limits<double>::max();
    case 4: return 2 * random.unit() - 1;
    case 5: return std::ldexp(2 * random.unit() - 1, static_cast<int>(random.between(-30, 30)));
    default: break;
  }
  for (;;) {
    const double v = std::bit_cast<double>(random.next());
    if (is_finite(v)) return v;
  }
}

/// Nonempty; one in eight is a point, one in eight has an infinite end.
inline Interval draw_interval(Random& random) {
  double lo = draw_finite(random), hi = draw_finite(random);
  if (lo > hi) std::swap(lo, hi);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  switch (random.below(16)) {
    case 0:
    case 1: hi = lo; break;
    case 2: hi = infinity; break;
    case 3: lo = -infinity; break;
    default: break;
  }
  return Interval::from_bounds(lo, hi);
}

}  // namespace veritope
