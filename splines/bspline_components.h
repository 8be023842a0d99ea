// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/bspline_components.h: B-spline maps made of coordinates of other maps.
#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "splines/bspline.h"

namespace veritope {

/// The map of the first `count` coordinates; a weight stays. REQUIRES 1 <= count <= map.dimension().
template <Ring R, std::size_t N>
BSpline<R, N> first_coordinates(const BSpline<R, N>& map, int count) {
  VT_CHECK(count >= 1 && count <= map.dimension(), "coordinates that the map does not have");
  if (count == map.dimension()) return map;
  std::vector<R> values;
  const auto add = [&](int c) {
    const auto component = map.component(c);
    values.insert(values.end(), component.begin(), component.end());
  };
  for (int c = 0; c < count; ++c) add(c);
  if (map.is_rational()) add(map.dimension());
  return {map.axes(), count + (map.is_rational() ? 1 : 0), map.is_rational(), std::move(values)};
}

}  // namespace veritope
