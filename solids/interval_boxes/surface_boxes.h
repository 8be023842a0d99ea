// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/interval_boxes/surface_boxes.h: face, edge and vertex boxes of a patch complex at a resolution eps, as the
// paper makes them from interval evaluation and interval intersections. Source: [SSP01] 3. Design:
// docs/design/0019-paper-conditions.md.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "robust/base/result.h"
#include "solids/interval_boxes/boundary_model.h"

namespace veritope {

struct SurfaceBoxOptions {
  /// How far a box extends beyond the hull of what it stands for, on every side, as a part of eps. [SSP01] gets this
  /// from rounded interval arithmetic over an interval of parameters (eq. 13), whose widths are positive along every
  /// axis.
  double margin = 0.125;
  std::size_t max_boxes = 1'000'000;
  int max_level = 18;  ///< of pieces
};

/// One box of the cover, and the pieces of V that it stands for: it holds their closed hulls in its interior.
struct SurfaceBox {
  enum class Kind {
    kFace,    ///< one piece that has no point on an edge
    kEdge,    ///< the pieces on both sides of a stretch of an edge
    kVertex,  ///< a box of a vertex cluster
  };
  Kind kind = Kind::kFace;
  Box3d box{};               ///< in the model's units
  std::uint32_t entity = 0;  ///< patch, edge or vertex of the complex
  std::vector<PieceForest::Id> pieces;
};
const char* to_string(SurfaceBox::Kind kind);

/// A connected component of intersections of boxes of two edge chains at a vertex, the component that holds the vertex:
/// the proved common point of its edges (they end in it exactly). Its boxes are the vertex boxes.
struct VertexCluster {
  std::uint32_t vertex = 0;
  std::vector<std::uint32_t> boxes;  ///< ascending
};

struct SurfaceCover {
  double eps = 0;
  std::vector<SurfaceBox> boxes;
  std::vector<VertexCluster> clusters;  ///< by vertex, those with an edge
  double largest = 0;  ///< the greatest size of a box ([SSP01] 2: its longest edge), at most eps

  std::vector<Box3d> plain_boxes() const;
};

/// Pieces are split until their closed hulls, grown by margin * eps on every side, are no larger than eps; those with a
/// point on an edge go to edge boxes together with what lies across the edge, split to the same stretches; where this
/// makes a box too large, both sides are split. Smooth edges of the complex are edges here, too. In a planar model, the
/// curve's pieces are faces and its ends are edges of the wall: the boxes around them are called vertex boxes. Every
/// leaf is in the interior of its box: C1 and B1 hold by construction; conditions.h decides C2 and C3.
/// @error kBadArgument unless eps is finite and positive and margin lies in (0, 1/2); kOverLimit if the boxes or the
/// levels do not suffice
Result<SurfaceCover> make_surface_cover(BoundaryModel& model, double eps,
                                        const SurfaceBoxOptions& options = {});

}  // namespace veritope
