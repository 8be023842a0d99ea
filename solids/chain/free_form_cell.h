// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/free_form_cell.h: what lies between a patch and the triangles over its corners, as a closed chain of
// patches: the free-form cell of seed 001 [GRF03], with ruled strips in the place of its planes.
// Theory: docs/THEORY.md, CHAIN-1.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "solids/classify/tensor_form.h"
#include "solids/patches/patch.h"

namespace veritope {

/// A triangle between corners of a patch.
using BaseTriangle = std::array<PatchPoint, 3>;
/// One for a triangle, two for a tensor patch; counterclockwise as the patch.
std::vector<BaseTriangle> base_triangles(const Patch& patch);

/// On which side of its base a patch lies, by its control points.
enum class CellSign : std::uint8_t {
  kZero,   ///< in the plane of the base: the cell contributes nothing off that plane
  kPlus,   ///< on the side to which the patch's normal points, or in the plane
  kMinus,  ///< on the other side
  kMixed   ///< on both, or the corners are not in one plane
};
CellSign cell_sign(const Patch& patch);

/// The chain of the patch, minus its base triangles, plus strips: over each side e that is not its chord c
///   (1 - r) c(t) + r e(t),   0 <= r <= 1.
/// The base has the parameters and weights of the patch's sides along its own, so that equal curves cancel. Coordinates
/// are divided by 2^scale, edges are numbered from `first_edge`, at most kEdgesOfCell; all windings are those of
/// `shell`. REQUIRES weights > 0.
std::vector<TensorForm> free_form_cell(const Patch& patch, int scale, std::uint32_t first_edge,
                                       std::uint32_t shell);
inline constexpr std::uint32_t kEdgesOfCell = 9;

}  // namespace veritope
