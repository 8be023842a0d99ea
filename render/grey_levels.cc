// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/grey_levels.h"

#include <algorithm>
#include <cstddef>
#include <functional>

#include "interval/functions.h"
#include "robust/rational.h"

namespace veritope {

GreyLevels::GreyLevels() {
  // 255 exp(-x) = g + 1/2 for x = log(510 / (2 g + 1)).
  for (std::size_t g = 0; g < bounds_.size(); ++g)
    bounds_[g] = log(enclose(Rational(510) / Rational(2 * g + 1))).hi();
}

std::uint8_t GreyLevels::level(double x) const {
  const auto last = std::upper_bound(bounds_.begin(), bounds_.end(), x, std::greater<>());
  return static_cast<std::uint8_t>(last - bounds_.begin());
}

}  // namespace veritope
