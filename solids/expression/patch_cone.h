// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/patch_cone.h: the directions in which a complex of patches leaves one of its points.
// Theory: docs/THEORY.md, POINT-6 and POINT-7.
#pragma once
#include <optional>
#include <vector>

#include "solids/classify/patch_classifier.h"
#include "solids/expression/operand.h"

namespace veritope {

class PatchCones {
 public:
  /// The complex must outlive this.
  explicit PatchCones(const PatchComplex& complex);

  /// Nothing at an end of a collapsed side; where two sectors have more than rims in common, as along an edge of angle
  /// 0; and where a direction is irrational: inside of a patch that is not flat, or on a side that is not straight, at
  /// irrational parameters.
  std::optional<TangentCone> at(const OnPatch& where) const;

 private:
  const PatchComplex& complex_;
  std::vector<std::vector<PatchCorner>> corners_;  ///< of each vertex
};

}  // namespace veritope
