// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/lines.h: linear maps of control nets that act along one axis.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "splines/grid.h"
#include "splines/ring.h"

namespace veritope::internal {

/// The entries of a net along one axis, stride apart.
template <typename T>
struct Line {
  T* first;
  std::size_t stride;
  T& operator[](std::size_t i) const { return first[i * stride]; }
};

/// The coefficients of a Bezier or B-spline map whose `axis` has new_size control points, from those of `map`: calls
/// on_line(Line<const R> from, Line<R> to) for every line of every component; `to` starts as zeros.
template <template <Ring, std::size_t> class Map, Ring R, std::size_t N, typename OnLine>
std::vector<R> map_lines(const Map<R, N>& map, std::size_t axis, std::size_t new_size,
                         OnLine on_line) {
  const Grid<N> grid = map.grid();
  const std::span<const R> from = map.coefficients();
  const std::size_t stride = grid.stride(axis);
  const std::size_t block = stride * grid.size[axis], new_block = stride * new_size;
  const std::size_t num_blocks = from.size() / block;  // of all components
  std::vector<R> to(num_blocks * new_block);
  for (std::size_t b = 0; b < num_blocks; ++b)
    for (std::size_t i = 0; i < stride; ++i)
      on_line(Line<const R>{from.data() + b * block + i, stride},
              Line<R>{to.data() + b * new_block + i, stride});
  return to;
}

/// The shape without one axis.
template <typename T, std::size_t N>
requires(N > 1) std::array<T, N - 1> without_axis(const std::array<T, N>& values,
                                                  std::size_t axis) {
  std::array<T, N - 1> rest;
  for (std::size_t i = 0, j = 0; i < N; ++i)
    if (i != axis) rest[j++] = values[i];
  return rest;
}

template <typename T, std::size_t N>
std::array<T, N> permuted(const std::array<T, N>& values, const std::array<std::size_t, N>& order) {
  std::array<T, N> out;
  for (std::size_t i = 0; i < N; ++i) out[i] = values[order[i]];
  return out;
}

/// The net with its axes in another order: new axis i is old axis order[i].
template <typename R, std::size_t N>
std::vector<R> permuted_net(std::span<const R> from, const Grid<N>& grid,
                            const std::array<std::size_t, N>& order) {
  const Grid<N> new_grid{permuted(grid.size, order)};
  std::vector<R> to;
  to.reserve(from.size());
  for (std::size_t base = 0; base < from.size(); base += grid.count())
    for (std::size_t i = 0; i < grid.count(); ++i) {
      const auto index = new_grid.index_of(i);
      std::array<std::size_t, N> old_index{};
      for (std::size_t a = 0; a < N; ++a) old_index[order[a]] = index[a];
      to.push_back(from[base + grid.at(old_index)]);
    }
  return to;
}

/// Adds y to x, without a copy where the ring allows.
template <typename R>
void accumulate(R& x, const R& y) {
  if constexpr (requires { x += y; }) {
    x += y;
  } else {
    x = x + y;
  }
}

}  // namespace veritope::internal
