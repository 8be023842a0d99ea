// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/curve_crossings.h: where polygons and polynomial curves meet the surface of a model: BrepIntersection
// of the microstructure paper, for curves. Design: docs/design/0078-tiles-in-solids-of-patches.md.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "interval/box.h"
#include "solids/base/box_hierarchy.h"
#include "solids/classify/patch_piece.h"
#include "solids/classify/point_answer.h"
#include "solids/patches/patch_complex.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// The points p + t (q - p), begin <= t <= end, of segment number `segment` of a polygon from p to q lie on the facet,
/// exactly, and no others of the segment do. They are one point unless the segment runs in the facet's plane.
struct PolygonCrossing {
  std::uint32_t segment = 0, facet = 0;
  Rational begin, end;
  friend bool operator==(const PolygonCrossing&, const PolygonCrossing&) = default;
};

/// Immutable: threads may share it.
class MeshCrossings {
 public:
  /// REQUIRES finite coordinates, ids in range, no degenerate facet, fewer than 2^30 of them. The mesh must outlive it.
  explicit MeshCrossings(const TriangleMesh& mesh);
  explicit MeshCrossings(TriangleMesh&&) = delete;

  /// All meetings of the open polygon p0 p1 ... and the facets, by segment, begin and facet. A point of it on an
  /// edge or at a vertex is there once for each facet there, and a vertex of the polygon once for each segment.
  /// A segment of length 0 is a point: t is 0. @cost facets whose boxes meet that of a segment, in rationals
  std::vector<PolygonCrossing> find(std::span<const ExactPoint> polygon) const;

 private:
  const TriangleMesh* mesh_;
  BoxHierarchy tree_;
};

/// A place where a curve may meet a patch.
struct CurveCrossing {
  Interval t;  ///< of the curve, in [0,1]
  std::uint32_t patch = 0;
  Box2 parameters;  ///< of the patch; a triangle's are those of PatchPiece
  Box3 point;       ///< contains the crossing
  /// Proved: the curve meets the patch in exactly one point here, and crosses it: their tangents span the space.
  bool is_proved = false;
};

struct CurveCrossings {
  /// Every meeting of the curve and the surface is in one of these; by t, then by patch. A crossing in an edge is there
  /// once for each patch, usually not proved.
  std::vector<CurveCrossing> places;
  bool is_complete = true;  ///< false: the limit of work was reached, and places are rough
};

class PatchCrossings {
 public:
  /// REQUIRES positive weights, at least one patch. Keeps nothing of the complex.
  explicit PatchCrossings(const PatchComplex& complex);

  /// Pairs of parts of the curve and of patches, halved until planes separate them, or Krawczyk's operator proves a
  /// crossing, or they are small (2^-26 of the model).
  /// @param max_pairs  the limit of work
  /// REQUIRES a curve in space of degree 1 or more, with positive weights if it is rational.
  CurveCrossings find(const BezierCurve<Rational>& curve, std::size_t max_pairs = 50000) const;

 private:
  std::vector<PatchPiece> roots_;
  BoxHierarchy tree_;
  double size_ = 0;
};

}  // namespace veritope
