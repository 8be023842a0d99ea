// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/curve_passes.h: how often a curve of the plane passes a ray from a point, and whether it passes
// through the point, exactly.  Theory: docs/THEORY.md, CHAIN-5.
#pragma once
#include <optional>
#include <vector>

#include "robust/integer.h"
#include "solids/patches/common_roots.h"

namespace veritope {

/// A directed curve in a plane, relative to a point: Bernstein coefficients of its homogeneous coordinates, of weights
/// that are positive. Either coordinate may be multiplied by a positive number.
struct RelativeCurve {
  std::vector<Integer> along;   ///< in the direction of a ray from the point
  std::vector<Integer> across;  ///< to its left
};

/// How often the curve passes the ray counter-clockwise as seen from the point, minus how often it passes it clockwise.
/// An end on the line of the ray counts as a point to its right. Over a closed chain of curves the sum is the winding
/// number around the point. Nothing if the curve passes through the point: this is exact for all curves.
/// @cost pieces in proportion to the logarithm of the distance from the point
std::optional<int> passes_of(const RelativeCurve& curve);

/// The parameters at which the curve passes through the point.
CommonRoots roots_of(const RelativeCurve& curve);

}  // namespace veritope
