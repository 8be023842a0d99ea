// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/affine_map.h: affine maps with rational entries, applied to the points of Bezier and B-spline maps.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "robust/base/check.h"
#include "splines/bezier.h"
#include "splines/binomial.h"
#include "splines/bspline.h"
#include "splines/lines.h"

namespace veritope {

/// x -> linear x + translation.
struct AffineMap {
  int rows = 0, columns = 0;
  std::vector<Rational> linear;       // row by row
  std::vector<Rational> translation;  // one for each row
};

namespace internal {

/// The components after the affine map, each with as many entries as before. In homogeneous coordinates the translation
/// is multiplied by the weight, and the weight stays.
template <Ring R>
std::vector<R> mapped(const AffineMap& affine, std::span<const R> from, bool is_rational) {
  const auto rows = static_cast<std::size_t>(affine.rows),
             columns = static_cast<std::size_t>(affine.columns);
  VT_CHECK(affine.linear.size() == rows * columns && affine.translation.size() == rows,
           "an affine map needs an entry for every row and column");
  const std::size_t size = from.size() / (columns + (is_rational ? 1 : 0));
  std::vector<R> to;
  to.reserve(size * (rows + 1));
  for (std::size_t row = 0; row < rows; ++row) {
    const R shift = ring_number<R>(affine.translation[row]);
    std::vector<R> factors;
    for (std::size_t c = 0; c < columns; ++c)
      factors.push_back(ring_number<R>(affine.linear[row * columns + c]));
    for (std::size_t i = 0; i < size; ++i) {
      R value = is_rational ? R(shift * from[columns * size + i]) : shift;
      for (std::size_t c = 0; c < columns; ++c) accumulate(value, factors[c] * from[c * size + i]);
      to.push_back(std::move(value));
    }
  }
  if (is_rational) to.insert(to.end(), from.end() - static_cast<std::ptrdiff_t>(size), from.end());
  return to;
}

}  // namespace internal

/// The image of the map under the affine map. REQUIRES affine.columns = map.dimension().
template <Ring R, std::size_t N>
Bezier<R, N> transformed(const Bezier<R, N>& map, const AffineMap& affine) {
  VT_CHECK(affine.columns == map.dimension(), "an affine map of another dimension");
  return {map.degrees(), affine.rows + (map.is_rational() ? 1 : 0), map.is_rational(),
          internal::mapped(affine, map.coefficients(), map.is_rational())};
}
template <Ring R, std::size_t N>
BSpline<R, N> transformed(const BSpline<R, N>& map, const AffineMap& affine) {
  VT_CHECK(affine.columns == map.dimension(), "an affine map of another dimension");
  return {map.axes(), affine.rows + (map.is_rational() ? 1 : 0), map.is_rational(),
          internal::mapped(affine, map.coefficients(), map.is_rational())};
}

}  // namespace veritope
