// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/v_complex_data.h: a V-complex from plain lists.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "robust/base/result.h"
#include "topology/v_complex.h"

namespace veritope {

/// A V-curve in a loop: along it or against it.
struct CurveUseData {
  std::uint32_t curve = 0;
  bool is_forward = true;
};

/// Each loop has the half-V-surface on its left, seen from outside of the cell.
struct HalfVSurfaceData {
  std::uint32_t trivariate = 0;
  std::vector<std::vector<CurveUseData>> loops;
};

struct VCellData {
  std::vector<std::uint32_t> trivariates;
  std::vector<HalfVSurfaceData> half_surfaces;
};

/// A half-V-surface of the lists, and a use in one of its loops.
struct HalfVSurfacePlace {
  std::uint32_t cell = 0, half_surface = 0;
};
struct CurveUsePlace {
  std::uint32_t cell = 0, half_surface = 0, loop = 0, use = 0;
};

/// Curves and points are those of the V-complex: cells that meet there name the same ones.
struct VComplexData {
  std::uint32_t num_points = 0;
  std::vector<std::array<std::uint32_t, 2>> curves;  ///< where each begins and where it ends
  std::vector<VCellData> cells;
  std::vector<std::array<HalfVSurfacePlace, 2>> glued;
  /// Uses across each other. Only for a cell that uses a curve more than twice, for instance one that is glued to
  /// itself.
  std::vector<std::array<CurveUsePlace, 2>> across;
  /// Uses that are mates, one for each pair of loops. Only where the first use of a loop could have several mates.
  std::vector<std::array<CurveUsePlace, 2>> mates;
};

/// Elements get the numbers that they have in the lists: cells, curves and points; half-V-surfaces and uses in the
/// order of the lists; V-surfaces in the order of their first halves.
/// @error kBadArgument, with a sentence that names the place in the lists: a number that names nothing, a loop that is
///   not closed, a use without one across it, or with several; glued loops that do not fit; a curve or point without
///   use
/// @cost O(n log n)
Result<VComplex> make_v_complex(const VComplexData& data);

}  // namespace veritope
