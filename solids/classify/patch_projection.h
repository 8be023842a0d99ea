// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/patch_projection.h: the nearest points of a complex of patches to a point, all of them, enclosed.
// Design: docs/design/0078-tiles-in-solids-of-patches.md.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "interval/box.h"
#include "solids/base/range_tree.h"
#include "solids/classify/patch_piece.h"
#include "solids/classify/point_answer.h"
#include "solids/patches/patch_complex.h"

namespace veritope {

/// The cell of a complex in whose closure a place lies: the smallest that is known to be one.
enum class PatchFeature : std::uint8_t { kVertex, kEdge, kPatch };

/// A place that may hold nearest points.
struct NearestPlace {
  Box3 point;  ///< contains them
  /// Contains the squares of their distances from the point.
  Interval squared_distance;
  PatchFeature feature = PatchFeature::kPatch;
  std::uint32_t number = 0;  ///< of the vertex, edge or patch, in the complex
  std::uint32_t patch = 0;   ///< one that has them: itself, or the least beside the edge or vertex
  /// Proved: the place holds at most one nearest point. Otherwise it may hold two that are very close to each other,
  /// as on a seam of smooth patches, where each has its own.
  bool is_single = false;
};

struct PatchProjectionAnswer {
  Interval squared_distance;  ///< of the nearest points
  /// Every nearest point is in one of these places, and places are disjoint; in lexicographic order of the least
  /// coordinates of their boxes, so that the first one is the answer where one is wanted. With one place only the
  /// nearest points are in it. More than one are a tie, or so close to one that enclosures cannot tell.
  std::vector<NearestPlace> places;
  bool is_decided =
      true;  ///< false: the limit of work was reached, and places are rough; all points may be nearest

  bool is_tie() const { return places.size() > 1; }
};

/// Projects points onto one complex, closed or not. Immutable: threads may share it.
class PatchProjection {
 public:
  /// REQUIRES positive weights, at least one patch. The complex must outlive it.
  explicit PatchProjection(const PatchComplex& complex);
  explicit PatchProjection(PatchComplex&&) = delete;

  /// Parts of patches in the order of their distance, each examined for where the distance can be least: inside of it,
  /// on its sides, at corners; there by Newton's method in intervals.
  /// @param max_parts  the limit of work
  /// @cost  usually some hundred parts; without bound, but for max_parts, where a whole curve or patch is nearest
  PatchProjectionAnswer project(const ExactPoint& point, std::size_t max_parts = 20000) const;

 private:
  friend class PatchProjectionSearch;
  const PatchComplex* complex_;
  std::vector<PatchPiece> roots_;
  std::vector<std::uint32_t> order_;
  RangeTree<Box3d> tree_;
  double size_ = 0;
};

}  // namespace veritope
