// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/star_box/star_zeros.h: S1 for patches whose normals are zero in corners or along sides, or whose tangent
// planes there pass through a centre. Theory: docs/THEORY.md, STAR-5. The conditions: docs/certificates/star-box-2.md,
// section 4.
#pragma once
#include "solids/pieces/crossing_number.h"
#include "solids/pieces/piece_forest.h"

namespace veritope {

/// Whether S1 holds on the piece for these centres, where coefficients of g_c may be zero as STAR-5 allows. It holds
/// wherever has_star_signs does. Zeros are zeros of integers; nothing is decided by a tolerance.
bool has_star_signs_or_zeros(PieceForest& forest, PieceForest::Id id, const CentreLine& centres);

}  // namespace veritope
