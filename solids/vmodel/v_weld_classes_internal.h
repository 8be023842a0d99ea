// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/v_weld_classes_internal.h: which corners and which edges of cells become one when faces are welded.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "robust/base/disjoint_sets.h"
#include "solids/patches/tied_axes.h"
#include "solids/vmodel/v_model.h"
#include "solids/vmodel/v_near_faces_internal.h"

namespace veritope::internal {

/// Corners 8 cell + corner, and edges 12 cell + edge; those that are equal already are one from the start, such as the
/// ends of a collapsed edge and two sides of a collapsed face. Collapsed edges have no class.
class WeldClasses {
 public:
  explicit WeldClasses(const VModel& model);

  /// Makes the corners and the edges of the two faces one, unless a class of corners would then be wider than 2 eps in
  /// a coordinate, or an edge would become one with a collapsed one: then nothing changes, and the reason is returned.
  std::optional<VApartReason> tie(const NearPair& pair, const Rational& eps);

  std::uint32_t corner_class(std::uint32_t corner) { return corners_.find(corner); }
  TiedAxes::Root edge_class(std::uint32_t edge) { return edges_.find(edge); }
  /// Whether the edge runs against itself.
  bool is_reversible(std::uint32_t edge_class) const { return edges_.is_symmetric(edge_class); }
  /// Whether a pair was tied here.
  bool is_tied_corner(std::uint32_t corner_class) const { return is_tied_corner_[corner_class]; }
  bool is_tied_edge(std::uint32_t edge_class) const { return is_tied_edge_[edge_class]; }

 private:
  struct Range {
    std::array<Rational, 3> low, high;
  };
  void tie_sides(VFaceNumber f, VFaceNumber g, unsigned symmetry);
  void tie_equal_corners();
  void tie_equal_edges();
  Range range_of(std::uint32_t corner_class) const;

  const VModel* model_;
  DisjointSets<> corners_;
  TiedAxes edges_;
  std::vector<bool> is_tied_corner_, is_tied_edge_;
  std::unordered_map<std::uint32_t, Range> ranges_;  // of classes of corners where a pair was tied
};

}  // namespace veritope::internal
