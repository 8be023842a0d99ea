// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/mesh/patch_bend_internal.h"

#include <algorithm>

namespace veritope::internal {

PatchBend::PatchBend(const TilePatch& patch) : num_powers_(patch.points.size()) {
  const std::array<std::size_t, 2> size = {static_cast<std::size_t>(patch.degrees[0]) + 1,
                                           static_cast<std::size_t>(patch.degrees[1]) + 1};
  const auto point = [&](std::size_t power, std::size_t at) {
    const TilePoint& q = patch.points[power][at];
    return Box3(enclose(q[0]), enclose(q[1]), enclose(q[2]));
  };
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::size_t step = axis == 0 ? size[1] : 1, degree = size[axis] - 1;
    const Interval n(static_cast<double>(degree)), both(static_cast<double>(degree * (degree - 1)));
    for (std::size_t at = 0; at < patch.num_points(); ++at) {
      const std::size_t along = axis == 0 ? at / size[1] : at % size[1];
      for (std::size_t power = 0; power < num_powers_; ++power) {
        if (along + 1 > degree) continue;
        const Box3 middle = point(power, at + step), d = middle - point(power, at);
        first_[axis].coefficients.push_back(n * d);
        if (along + 2 > degree) continue;
        second_[axis].coefficients.push_back(both * ((point(power, at + 2 * step) - middle) - d));
      }
    }
  }
}

std::array<Interval, 3> PatchBend::bounds_of(const Derivative& d, const Interval& t) const {
  std::array<double, 3> most{};
  for (std::size_t at = 0; at < d.coefficients.size(); at += num_powers_) {
    Box3 value = d.coefficients[at + num_powers_ - 1];
    for (std::size_t power = num_powers_ - 1; power-- > 0;)
      value = t * value + d.coefficients[at + power];
    for (std::size_t c = 0; c < 3; ++c) most[c] = std::max(most[c], mag(value[c]));
  }
  return {Interval::from_bounds(0, most[0]), Interval::from_bounds(0, most[1]),
          Interval::from_bounds(0, most[2])};
}

std::array<double, 2> PatchBend::of(const CellMapBounds& map, const Interval& t) const {
  const auto bound = [](double x) { return Interval::from_bounds(0, x); };
  const Interval two(2.0), eighth(0.125);
  std::array<double, 2> out;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto s = bounds_of(first_[axis], t), second = bounds_of(second_[axis], t);
    Interval sum = bound(map.second[3]) * s[0] * s[1] + bound(map.second[4]) * s[0] * s[2] +
                   bound(map.second[5]) * s[1] * s[2];
    sum *= two;
    for (std::size_t a = 0; a < 3; ++a)
      sum += bound(map.first[a]) * second[a] + bound(map.second[a]) * sqr(s[a]);
    out[axis] = (eighth * sum).hi();
  }
  return out;
}

}  // namespace veritope::internal
