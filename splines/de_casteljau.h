// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/de_casteljau.h: evaluation, subdivision and restriction of Bezier maps by repeated blends.
#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include "splines/bezier.h"
#include "splines/de_casteljau_line.h"

namespace veritope {
namespace internal {

/// The blend that cuts at t.
template <Ring R>
AffineBlend<R> cut_at(const R& t) {
  return {one<R>() - t, t};
}

template <Ring R, std::size_t N, typename OnLine>
void on_lines(Bezier<R, N>& map, std::size_t axis, OnLine on_line) {
  const Grid<N> grid = map.grid();
  for (int c = 0; c < map.num_components(); ++c) {
    R* const values = map.component(c).data();
    grid.for_each_line(axis,
                       [&](std::size_t first) { on_line(values + first, grid.stride(axis)); });
  }
}

}  // namespace internal

/// Restricts the map to the part [0, t] of `axis`, as a map of [0,1]^N. Any t is admitted: beyond [0,1] the map is
/// extrapolated.
template <Ring R, std::size_t N>
Bezier<R, N> left_part(Bezier<R, N> map, std::size_t axis, const R& t) {
  const auto blend = internal::cut_at(t);
  internal::on_lines(map, axis, [&](R* first, std::size_t stride) {
    internal::keep_left(first, stride, map.degree(axis), blend);
  });
  return map;
}
/// Restricts the map to the part [t, 1].
template <Ring R, std::size_t N>
Bezier<R, N> right_part(Bezier<R, N> map, std::size_t axis, const R& t) {
  const auto blend = internal::cut_at(t);
  internal::on_lines(map, axis, [&](R* first, std::size_t stride) {
    internal::keep_right(first, stride, map.degree(axis), blend);
  });
  return map;
}
/// Both halves at t.
template <Ring R, std::size_t N>
std::pair<Bezier<R, N>, Bezier<R, N>> split(const Bezier<R, N>& map, std::size_t axis, const R& t) {
  return {left_part(map, axis, t), right_part(map, axis, t)};
}

/// The values of all components at a point, homogeneous if the map is rational: de Casteljau along the axes in turn.
template <Ring R, std::size_t N>
std::vector<R> evaluate(const Bezier<R, N>& map, const std::array<R, N>& at) {
  std::vector<R> values;
  values.reserve(static_cast<std::size_t>(map.num_components()));
  std::vector<R> work;
  for (int c = 0; c < map.num_components(); ++c) {
    work.assign(map.component(c).begin(), map.component(c).end());
    for (std::size_t axis = 0; axis < N; ++axis) {
      // What is left is a grid of the axes from `axis` on; its first slice is the result along the axis.
      std::size_t stride = 1;
      for (std::size_t i = axis + 1; i < N; ++i)
        stride *= static_cast<std::size_t>(map.degree(i)) + 1;
      const auto blend = internal::cut_at(at[axis]);
      for (std::size_t i = 0; i < stride; ++i)
        internal::keep_right(work.data() + i, stride, map.degree(axis), blend);
    }
    values.push_back(work.front());
  }
  return values;
}

}  // namespace veritope
