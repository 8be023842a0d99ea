// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/affine_patch.h: patches that are affine images of their domains, whatever their degrees, and the exact
// parameters of a point on them.
#pragma once
#include <array>
#include <optional>

#include "solids/patches/patch.h"

namespace veritope {

class AffinePatch {
 public:
  /// Nothing if the patch is not an affine image of its domain, or is degenerate. Patches with weights count if all
  /// weights are equal.
  static std::optional<AffinePatch> make(const Patch& patch);
  /// The parameters of the tensor form, (u, v) or (s, t) of a triangle, at which the patch has this point, if it is of
  /// the patch's plane; another point's parameters are those of a projection of it. Nothing if they leave [0,1].
  std::optional<std::array<Rational, 2>> parameters_of(const PatchPoint& point) const;

 private:
  bool is_triangle_ = false;
  PatchPoint origin_;
  std::array<PatchPoint, 2> axes_;
  std::size_t i_ = 0, j_ = 0;  // the coordinates in which they are solved for
  Rational determinant_;
};

}  // namespace veritope
