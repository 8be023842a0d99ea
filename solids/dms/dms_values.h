// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_values.h: the Bernstein coefficients of a solid's map on simplices on which it is one polynomial.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "solids/dms/dms_evaluator.h"

namespace veritope {

/// The polynomial map of the degree that has these values at the points of a simplex with the barycentric coordinates
/// (indices + 1) / (n + corners): Bernstein coefficients. `corners` is 3 or 4; indices are in the order of
/// triangle_index or tetrahedral_index.
class SimplexInterpolation {
 public:
  SimplexInterpolation(int degree, std::size_t corners);

  std::vector<DmsPoint> points(std::span<const DmsPoint> corners) const;
  std::vector<DmsPoint> coefficients(std::span<const DmsPoint> values) const;

 private:
  std::vector<std::vector<Rational>> shares_;   // of each point
  std::vector<std::vector<Rational>> inverse_;  // rows give coefficients
};

/// x, y, z of the map at points of the domain; nothing if one of them is outside.
std::optional<std::vector<DmsPoint>> values_at(DmsEvaluator& evaluator,
                                               std::span<const DmsPoint> points);

}  // namespace veritope
