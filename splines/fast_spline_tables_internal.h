// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/fast_spline_tables_internal.h: how fast_spline.h prepares a spline.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "robust/base/result.h"
#include "splines/bspline.h"
#include "splines/fast_spline_internal.h"

namespace veritope::internal {

inline constexpr double kFastLimit = 0x1p200;
inline constexpr double kFastWeightRatio = 0x1p-40;
inline constexpr std::size_t kFastMaxCoefficients = std::size_t{1} << 26;

struct FastAxisStorage {
  int degree = 0;
  std::vector<double> breaks, origin, rate, slope_scale;
  std::vector<std::uint32_t> first;
  double per_bucket = 0;
  std::size_t buckets = 0;
  /// |s^ - s| <= error for the computed and the exact parameter in [0, 1] of the cell (docs/bounds/fast_spline.md, 3).
  std::vector<Rational> error;
  /// |slope_scale - degree / length|, an upper bound.
  std::vector<double> scale_error;
};

/// Four components of one coefficient.
struct alignas(32) FastLane {
  double v[4];
};

template <std::size_t N>
struct FastStorage {
  std::array<FastAxisStorage, N> axes;
  int num_components = 0;
  bool is_rational = false;
  std::size_t num_coefficients = 0;
  std::vector<FastLane> coefficients;
  std::vector<double> bounds, inverse_weight;

  FastSplineTables tables() const;
};

template <std::size_t N>
Result<BSpline<Rational, N>> exact_bspline(const BSpline<double, N>& map);
template <std::size_t N>
Result<FastStorage<N>> make_fast_storage(const BSpline<Rational, N>& map);
/// Makes the tables of the knots breaks[i] < breaks[i + 1].
Result<FastAxisStorage> make_fast_axis(int degree, const std::vector<Rational>& breaks);

}  // namespace veritope::internal
