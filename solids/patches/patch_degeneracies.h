// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/patches/patch_degeneracies.h: patches that are a point or a curve, and patches with a parameter line inside
// that is one point: no map of such a patch is one to one apart from its sides. Decided exactly.
// Design: docs/design/0037-named-gaps-and-joints.md.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solids/patches/patch.h"

namespace veritope {

struct PatchDegeneracy {
  enum class Kind {
    kPoint,         ///< all control points are one point
    kCurve,         ///< the normal is zero everywhere: the image is a curve
    kSingularLine,  ///< one point for all parameters of a line inside the domain
  } kind = Kind::kPoint;
  std::uint32_t patch = 0;
  // For kSingularLine: the parameter that is fixed, u or v (0 or 1), or the barycentric coordinate of a corner of a
  // triangle (0, 1 or 2), and bounds of its value, which are equal if it is rational with a denominator of at most 20
  // bits.
  std::size_t axis = 0;
  std::array<Rational, 2> at;
};

/// The first of each patch, ascending. Patches with a weight that is not positive or a degree over kMaxPatchDegree are
/// passed over, and so are all patches after the first 50,000.
std::vector<PatchDegeneracy> find_degeneracies(std::span<const Patch> patches);

}  // namespace veritope
