// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/base_side.h: on which side of its base a patch lies, exactly: the sign that seed 001 [GRF03] gives a
// free-form cell (section 3.2, figure 9).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "solids/patches/patch.h"

namespace veritope {

enum class BaseSide : std::uint8_t {
  kZero,  ///< in the plane of the base
  kPlus,  ///< nowhere behind the base, seen from the side to which the patch's normal points, and somewhere before it
  kMinus,  ///< nowhere before it, and somewhere behind it
  kMixed,  ///< points on both sides are proved
  kOpen    ///< the base has no area, or some thousands of Bernstein coefficients do not tell
};
/// A tensor patch has two base triangles; one without an area is left out. The patch is
/// kPlus if it is nowhere behind either of their planes, and so on; it is kMixed if it is on both sides of one of them,
/// or before one and behind the other.
BaseSide base_side(const Patch& patch);

/// The patch itself, or the halves of its domain over both base triangles as Bezier triangles, exactly.
std::vector<Patch::Triangle> triangles_of(const Patch& patch);

/// Numbers of patches.
struct BaseSideCounts {
  std::uint64_t plus = 0, minus = 0, zero = 0, mixed = 0, open = 0;
  void add(BaseSide side);
};
BaseSideCounts count_base_sides(std::span<const Patch> patches, unsigned jobs);

}  // namespace veritope
