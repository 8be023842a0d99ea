// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/miranda_internal.h: condition X3 of docs/certificates/patch-invalid.md over any ordered ring: exact
// with Rational, a forecast with double.
#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include "splines/bezier.h"
#include "splines/bezier_domain.h"

namespace veritope::internal {

/// The map on [lo, hi] of `axis`, as a map of [0,1]^2; constant along the axis if lo = hi. REQUIRES 0 <= lo <= hi <= 1.
template <Ring R>
BezierSurface<R> part_along(BezierSurface<R> map, std::size_t axis, const R& lo, const R& hi) {
  if (lo < hi) return restricted(std::move(map), axis, lo, hi);
  return left_part(right_part(std::move(map), axis, lo), axis, R());
}

template <typename R>
struct ValueRange {
  R least, greatest;
};
/// A side of a rectangle: an end of an axis.
struct RectangleEnd {
  std::size_t axis;
  bool is_upper;
};

/// The range of y·P / w over the control points (P, w), or over those at one end only if `end` is given.
template <Ring R>
ValueRange<R> control_values(const BezierSurface<R>& map, const std::array<R, 3>& y,
                             const std::optional<RectangleEnd>& end) {
  const auto rows = static_cast<std::size_t>(map.degree(0)) + 1,
             columns = static_cast<std::size_t>(map.degree(1)) + 1;
  std::size_t low[2] = {0, 0}, high[2] = {rows, columns};
  if (end) {
    if (end->is_upper) low[end->axis] = high[end->axis] - 1;
    high[end->axis] = low[end->axis] + 1;
  }
  std::optional<ValueRange<R>> out;
  for (std::size_t i = low[0]; i < high[0]; ++i)
    for (std::size_t j = low[1]; j < high[1]; ++j) {
      const std::size_t at = i * columns + j;
      R value = y[0] * map.component(0)[at];
      value = value + y[1] * map.component(1)[at];
      value = value + y[2] * map.component(2)[at];
      if (map.is_rational()) value = value / map.component(3)[at];
      if (!out) out = ValueRange<R>{value, value};
      if (value < out->least) out->least = value;
      if (out->greatest < value) out->greatest = value;
    }
  return *out;
}

/// The sheet (0: a, 1: b) and the axis of each of the three parameters that are not fixed, in their order.
struct FreeParameter {
  std::size_t sheet, axis;
};

/// Whether X3 holds for two maps that are restricted to their rectangles. REQUIRES positive weights.
template <Ring R>
bool has_opposite_signs(const std::array<BezierSurface<R>, 2>& maps,
                        const std::array<std::array<R, 3>, 3>& rows,
                        const std::array<FreeParameter, 3>& parameters) {
  for (std::size_t i = 0; i < 3; ++i)
    for (const bool is_upper : {false, true}) {
      std::optional<RectangleEnd> ends[2];
      ends[parameters[i].sheet] = RectangleEnd{parameters[i].axis, is_upper};
      const ValueRange<R> a = control_values(maps[0], rows[i], ends[0]),
                          b = control_values(maps[1], rows[i], ends[1]);
      const bool holds = is_upper ? b.greatest < a.least : a.greatest < b.least;
      if (!holds) return false;
    }
  return true;
}

}  // namespace veritope::internal
