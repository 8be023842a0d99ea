// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/inside/descent_internal.h: nodes of docs/certificates/micro-inside.md, section 3, and their descents.
// Internal to solids/micro/inside.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "solids/micro/inside/inside_parts_internal.h"

namespace veritope::internal {

/// Nodes that were visited, and pairs of a node and a triangle whose boxes meet.
struct DescentCounts {
  std::uint64_t nodes = 0, pairs = 0;
  void add(const DescentCounts& more) { nodes += more.nodes, pairs += more.pairs; }
  bool is_within(const DescentCounts& most) const {
    return nodes <= most.nodes && pairs <= most.pairs;
  }
};
class DescentBudget {
 public:
  explicit DescentBudget(const DescentCounts& most) : most_(most) {}
  void add_node() { ++counts_.nodes; }
  void add_pair() { ++counts_.pairs; }
  bool is_spent() const { return !counts_.is_within(most_); }
  const DescentCounts& counts() const { return counts_; }

 private:
  DescentCounts most_, counts_;
};

/// A part of a polynomial map of [0,1]^N, enclosed: Bernstein coefficients, the last axis fastest. All functions
/// REQUIRE a live ScopedUpward.
template <std::size_t N>
struct MapNode {
  std::array<int, N> degrees{};
  std::vector<Box3> points;
  int level = 0;

  Box3 box() const {
    Box3 out = points.front();
    for (const Box3& p : points)
      for (std::size_t c = 0; c < 3; ++c) out[c] = hull(out[c], p[c]);
    return out;
  }
  /// Cut at 1/2 along the axis level mod N.
  std::pair<MapNode, MapNode> halves() const;
};
using PatchNode = MapNode<2>;
using BridgeNode = MapNode<3>;

BridgeNode enclosed_bridge(const MicroBridge& bridge);

/// The ends of the sides of a box.
Box3 lower_ends(const Box3& x);
Box3 upper_ends(const Box3& x);

/// The points of nodes of one volume, in all of its knot spans that they meet.
class BridgeMaps {
 public:
  explicit BridgeMaps(const VolumeMaps& maps) : maps_(maps) {}
  /// @param x  parameters of the volume
  /// Returns false if a weight may be 0 or less. REQUIRES a live ScopedUpward.
  bool points(const Box3& x, std::vector<NodePoints>* out) const;
  /// The points, for each span.
  bool boxes(const Box3& x, std::vector<std::vector<Box3>>* out) const;

 private:
  const VolumeMaps& maps_;
};

/// Visits nodes, depth first. close_to(node, facets) are those facets from which the node is not shown to be apart.
/// @return  nothing if all nodes are dropped or the budget is spent; else a facet that stays close to a node that may
///          not be halved
template <typename Node, typename CloseTo>
std::optional<std::uint32_t> descend(Node root, const std::vector<std::uint32_t>& facets,
                                     DescentBudget& budget, CloseTo close_to) {
  constexpr int kMaxLevel = 56;  // the page has 60
  std::vector<std::pair<Node, std::vector<std::uint32_t>>> stack;
  const auto visit = [&](Node node, const std::vector<std::uint32_t>& from) {
    budget.add_node();
    std::vector<std::uint32_t> close = close_to(node, from);
    if (!close.empty()) stack.emplace_back(std::move(node), std::move(close));
  };
  visit(std::move(root), facets);
  while (!stack.empty() && !budget.is_spent()) {
    const auto [node, close] = std::move(stack.back());
    stack.pop_back();
    if (node.level >= kMaxLevel) return close.front();
    auto parts = node.halves();
    visit(std::move(parts.second), close);
    visit(std::move(parts.first), close);
  }
  return std::nullopt;
}

}  // namespace veritope::internal
