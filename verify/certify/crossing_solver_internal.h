// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/crossing_solver_internal.h: what the two files of CrossingSolver share.
#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "verify/certify/crossing_solver.h"
#include "verify/certify/sheet_tangents_internal.h"

namespace veritope {

/// A - B and its derivatives by the four parameters.
struct CrossingSolver::Linear {
  internal::Vector3 difference;
  std::array<internal::Vector3, 4> columns;
};

namespace internal {

/// Y for the frame's coordinates, which are 2^scale times the model's, as integer rows for the model's whose largest
/// number is approximately `size`.
std::optional<std::array<std::array<std::int64_t, 3>, 3>> integer_rows(
    const Matrix3& inverse, const std::array<int, 3>& scale, double size);

/// A witness with intervals of the half width 2^-m around the solution's parameters; the fixed one is a multiple of
/// 2^-fixed_bits. Nothing if a rectangle leaves its patch's domain or the two are not apart.
std::optional<CrossingWitness> box_around(const PieceForest& forest,
                                          const std::array<SheetPlace, 2>& solution,
                                          std::size_t fixed, unsigned fixed_bits, unsigned m,
                                          const std::array<std::array<std::int64_t, 3>, 3>& rows);

}  // namespace internal

}  // namespace veritope
