// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/star_box/flat_patch.h: patches of any degree that are mapped one to one onto a convex triangle or
// quadrilateral. Theory: docs/THEORY.md, STAR-6. The conditions: docs/certificates/star-box-2.md, section 5.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "solids/patches/patch_complex.h"

namespace veritope {

/// Whether the patch is flat, decided in rationals: polynomial, with control points in one plane, those of each side on
/// one line, the corners of a strictly convex polygon, and a normal that nowhere turns over.
/// @cost O(degree^4) products of rationals, once its control points lie in one plane
bool is_flat_patch(const Patch& patch);

/// Which patches of a complex a mesh box may take whole; each is tested when first asked for.
class FlatPatches {
 public:
  enum class Kind {
    kTriangles,  ///< polynomial triangles of degree 1, all that version 1 of the certificate knows
    kAll,        ///< is_flat_patch
  };
  FlatPatches(const PatchComplex& complex, Kind kind) : complex_(&complex), kind_(kind) {}

  bool contain(std::uint32_t patch);

 private:
  const PatchComplex* complex_;
  Kind kind_;
  std::vector<std::optional<bool>> known_;
};

}  // namespace veritope
