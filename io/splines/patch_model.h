// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/patch_model.h: patch complexes as spline models (to write them), and the reverse (to certify them).
// Design: docs/design/0015-patch-complex.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/splines/spline_model.h"
#include "robust/base/result.h"
#include "solids/patches/patch.h"

namespace veritope {

/// One entity for each patch, in their order, without groups: tensor patches as surfaces without inner knots on
/// [0,1]^2, triangles as they are. Where they come from is not kept. REQUIRES positive weights, as a SplineModel has
/// them: the reader refuses others.
SplineModel model_of(std::span<const Patch> patches);

/// What one entity of a model becomes.
struct PatchEntity {
  std::size_t first_patch = 0;
  std::size_t num_patches = 0;
  /// Where a surface is cut, along u and v, in its own parameters (SurfacePieces). Empty for a triangle.
  std::array<std::vector<Rational>, 2> breaks;
};
/// An entity that is not a surface or triangle in space.
struct ForeignEntity {
  std::string kind;              ///< spline_kind_name
  std::optional<int> dimension;  ///< set for surfaces and triangles: they are foreign because of it
  Place place;                   ///< with the entity's number
};
/// "entity 3, a curve", "entity 0, a surface with 2 coordinates": why a model is no patch complex.
std::string to_string(const ForeignEntity& foreign);

/// The patches of a model, in the order of its entities; pieces of one surface u-major, v fastest.
struct PatchSource {
  std::vector<Patch> patches;          ///< their origins have the numbers of the entities
  std::vector<PatchEntity> entities;   ///< one for each of the model's
  std::vector<ForeignEntity> foreign;  ///< if there are any, patches and entities are empty
};
/// Surfaces are cut at their knots and, where they share a side as a whole, at each other's
/// (solids/patches/patch_sources.h). Triangles stay whole: a side that a triangle and a cut surface share does not
/// match. A model without entities has no patches.
/// @error kOverLimit, with the entity, for over kMaxPatches patches or a degree over kMaxSplineDegree.
///        kBadArgument for a degree below 1.
Result<PatchSource> patch_source(const SplineModel& model);

}  // namespace veritope
