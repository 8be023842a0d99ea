// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/patch_cone.h: the directions in which a complex of patches leaves one of its points.
// Theory: docs/THEORY.md, POINT-6 to POINT-8.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "solids/classify/patch_classifier.h"
#include "solids/expression/tangent_cone.h"

namespace veritope {

/// A point of the domain of the patch's map, if it is rational: (u, v), or the barycentric coordinates of corners 1 and
/// 2 of a triangle.
std::optional<std::array<Rational, 2>> domain_place(const Patch& patch, const AlgebraicPair& at);

class PatchCones {
 public:
  /// The complex must outlive this.
  explicit PatchCones(const PatchComplex& complex);

  /// Nothing at an apex: an end of a collapsed side whose next row is not in one plane with it, or does not turn around
  /// it in one direction; and where two sectors have more than rims in common, as along an edge of angle 0. Where a
  /// direction is irrational, inside of a patch that is not flat, or on a side that is not straight, at irrational
  /// parameters, the cone is enclosed.
  std::optional<TangentCone> at(const OnPatch& where) const;

 private:
  const PatchComplex& complex_;
  std::vector<std::vector<PatchCorner>> corners_;  ///< of each vertex
};

}  // namespace veritope
