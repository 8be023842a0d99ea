// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/nearest_edges.h: for each of many edges the nearest other one that lies beside it like the other
// side of a crack.
#pragma once
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "interval/interval.h"
#include "solids/polyhedron/edge_gap.h"

namespace veritope {

/// An edge is near another one if their gap is at most this part of its own length. The two sides of a crack are one
/// curve that was drawn twice, with other roundings or in another tessellation, so that the gap is far smaller than an
/// edge. Across a hole the gap is as large as an edge or larger.
inline constexpr int kNearPart = 16;

/// The nearest edge of e is, among the other edges that run along e (run_along) with a gap of at most the length of e,
/// the one of least gap; on a tie it is the one of least number.
struct NearestEdge {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t edge = kNone;  ///< its number
  bool is_near = false;        ///< gap <= length of e / kNearPart, exactly
  bool is_touching = false;  ///< gap = 0, exactly: one of the two edges is a part of the other one
  /// False if the search was given up: then there may be a nearer edge, and another one of gap 0 with a lesser number.
  /// All that is said about `edge` is true all the same.
  bool is_searched = true;
  /// Contains the gap; [0, 0] if there is no nearest edge. Its width is at most 2^-40 times the gap, unless that is
  /// subnormal. squared_gap of the two edges is the exact square, and nearest_root of it the rounded gap.
  Interval gap;
};

/// A search is given up after this number of steps. A step is a comparison with an edge or with a node of the tree; an
/// exact answer, such as which of two nearly equal gaps is less, counts as a hundred. A search takes some hundred steps
/// where edges are short beside the model. Where long edges cross each other everywhere, or many edges differ in their
/// last bits only, it would otherwise look at a good part of all edges.
inline constexpr std::uint32_t kMostSearchSteps = 1 << 12;

/// One answer for each edge. Edges of length 0 (two vertices at one point) lie within every edge through that point and
/// would make it near; so they have no nearest edge, and no edge has one of them for its nearest.
/// The result does not depend on jobs; it depends on the order of the edges only where gaps are equal or a search is
/// given up.
/// REQUIRES finite coordinates, fewer than 2^30 edges. Any number of them may coincide.
/// @cost  O(n log n) for n edges that are short beside the model, 1 to 10 microseconds for each; never more than
///        max_steps steps of 0.04 microseconds for each. Approximately 200 bytes for each edge.
std::vector<NearestEdge> find_nearest_edges(std::span<const EdgeEnds> edges, unsigned jobs,
                                            std::uint32_t max_steps = kMostSearchSteps);

}  // namespace veritope
