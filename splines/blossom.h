// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/blossom.h: the blossom (polar form) of Bezier maps.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "robust/base/check.h"
#include "splines/bezier.h"
#include "splines/de_casteljau.h"

namespace veritope {

/// The blossoms of the components. They are symmetric and affine in the degree(a) arguments of every axis a. They are
/// the map itself where the arguments of each axis are equal, and coefficient (i, j, ...) where i arguments of axis 0
/// are 1 and its others 0, and so on. REQUIRES arguments[a].size() = degree(a).  @cost as evaluation.  @source [Ram89]
template <Ring R, std::size_t N>
std::vector<R> blossom(const Bezier<R, N>& map, const std::array<std::vector<R>, N>& arguments) {
  std::vector<R> values, work;
  for (int c = 0; c < map.num_components(); ++c) {
    work.assign(map.component(c).begin(), map.component(c).end());
    for (std::size_t axis = 0; axis < N; ++axis) {
      VT_CHECK(arguments[axis].size() == static_cast<std::size_t>(map.degree(axis)),
               "a blossom has as many arguments as the degree");
      // What is left is a grid of the axes from `axis` on; its first slice becomes the result along the axis.
      const std::size_t stride = map.grid().stride(axis);
      int left = map.degree(axis);
      for (const R& t : arguments[axis]) {
        const auto blend = internal::cut_at(t);
        for (std::size_t i = 0; i < stride; ++i)
          internal::blend_forward(work.data() + i, stride, left, blend);
        --left;
      }
    }
    values.push_back(work.front());
  }
  return values;
}

}  // namespace veritope
