// SPDX-License-Identifier: LGPL-3.0-or-later
// A part of the normal chain of a solid: the cells of some of its patches (docs/THEORY.md, CHAIN-1). Unlike the whole
// chain it is no solid, and its function f takes other values than 0 and 1.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "predicates/vec.h"
#include "solids/classify/patch_rays.h"
#include "solids/patches/patch_complex.h"

class ChainPart {
 public:
  /// The simplices and free-form cells of patches first, ..., last - 1. REQUIRES corners and an origin that binary64
  /// has.
  ChainPart(const veritope::PatchComplex& complex, std::uint32_t first, std::uint32_t last,
            const veritope::Vec3d& origin);

  /// f(Q), the sum of the coefficients of the cells that hold the point; nothing on a wall of a cell.
  std::optional<int> value(const veritope::Vec3d& point) const;

 private:
  using Base = std::array<veritope::Vec3d, 3>;
  std::optional<int> simplex_value(const Base& base, const veritope::Vec3d& point) const;

  veritope::Vec3d origin_;
  std::vector<Base> bases_;
  std::vector<veritope::PatchRays> cells_;
};
