// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_make.h: models over a domain: clouds of knots, and control points for which the map is the identity,
// or nearly so.
#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "robust/base/result.h"
#include "solids/dms/dms_model.h"

namespace veritope {

enum class DmsControlRule {
  kGreville,  ///< the mean of the first knots of the vertices: the map is the identity
  kEdges,     ///< the mean of the vertices: [HHQ04]'s; the identity where all clouds are collapsed
};

/// Clouds drawn at random: each knot lies within `radius` times the shortest edge at its vertex, lengths in the maximum
/// norm.
struct DmsCloudDraw {
  Rational radius;
  std::uint64_t seed = 0;
};

struct DmsMakeOptions {
  int degree = 2;
  std::optional<DmsCloudDraw> clouds;  ///< nothing: all are collapsed
  DmsControlRule control = DmsControlRule::kGreville;
};

/// The mean of the first knots of a multiset of vertices, as many of each vertex as it occurs; or of the vertices
/// themselves. REQUIRES vertices that exist, ascending.
DmsPoint control_place(const DmsModel& model, std::span<const std::uint32_t> vertices,
                       DmsControlRule rule);

/// Gives the model shared control points by a rule, for all multisets of vertices of its tetrahedra. The attributes of
/// each are the means of those of its vertices, vertex_attributes[v attributes + a]. REQUIRES a degree, clouds and
/// tetrahedra that validate() accepts.
void set_control_by_rule(DmsModel& model, DmsControlRule rule,
                         std::span<const Rational> vertex_attributes);

/// A model of the degree over a domain: a model of degree 1 whose map is the identity. Its attributes are kept; where
/// all clouds are collapsed they are the same functions. Drawn knots of vertices on the boundary lie on no inner side
/// of a face there. Clouds are halved, at last to one point, until the model satisfies the conditions (a), (b) and (c)
/// of docs/formats/dms-files.md, by tests that are sufficient for them.
/// @error kBadArgument for a degree outside 1 to 9, a radius below 0, or a domain of another kind; kOverLimit for one
/// with knots of more bits than a file may have.
Result<DmsModel> make_dms(const DmsModel& domain, const DmsMakeOptions& options);

namespace internal {
/// Replaces the clouds by drawn ones: make_dms without its control points. REQUIRES collapsed clouds, a domain without
/// defects.
void draw_clouds(DmsModel& model, const DmsCloudDraw& draw);
}  // namespace internal

}  // namespace veritope
