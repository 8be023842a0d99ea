// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/grid.h: indices of control nets: N axes, the last one fastest.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace veritope {

/// A grid of size[0] x ... x size[N - 1] entries.
template <std::size_t N>
struct Grid {
  std::array<std::size_t, N> size{};

  std::size_t count() const {
    std::size_t product = 1;
    for (const std::size_t s : size) product *= s;
    return product;
  }
  /// count(), or nothing if it is over the limit. It never overflows: sizes may be those that a file claims.
  std::optional<std::size_t> count_up_to(std::size_t limit) const {
    if (std::find(size.begin(), size.end(), std::size_t{0}) != size.end()) return 0;
    std::size_t product = 1;
    for (const std::size_t s : size) {
      if (product > limit / s) return std::nullopt;
      product *= s;
    }
    return product;
  }
  /// The offset from one entry to the next along `axis`.
  std::size_t stride(std::size_t axis) const {
    std::size_t product = 1;
    for (std::size_t i = axis + 1; i < N; ++i) product *= size[i];
    return product;
  }
  std::size_t at(const std::array<std::size_t, N>& index) const {
    std::size_t offset = 0;
    for (std::size_t i = 0; i < N; ++i) offset = offset * size[i] + index[i];
    return offset;
  }
  /// Inverse of at().
  std::array<std::size_t, N> index_of(std::size_t offset) const {
    std::array<std::size_t, N> index;
    for (std::size_t i = N; i-- > 0; offset /= size[i]) index[i] = offset % size[i];
    return index;
  }
  friend bool operator==(const Grid&, const Grid&) = default;

  /// Calls visit(first) with the offset of the first entry of every line along `axis`; the others are
  /// stride(axis) apart.
  template <typename Visit>
  void for_each_line(std::size_t axis, Visit visit) const {
    const std::size_t inner = stride(axis), block = inner * size[axis];
    for (std::size_t outer = 0; outer < count(); outer += block)
      for (std::size_t i = 0; i < inner; ++i) visit(outer + i);
  }
};

}  // namespace veritope
