// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/surface/close_descent.h: the descent of docs/certificates/micro-inside.md, section 3: nodes are halved
// until they are apart from all parts of a surface.
#pragma once
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "solids/micro/surface/solid_surface.h"

namespace veritope {

/// Nodes that were visited, and pairs of a node and a part of the surface whose boxes meet.
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
  void add_nodes(std::uint64_t count) { counts_.nodes += count; }
  void add_pairs(std::uint64_t count) { counts_.pairs += count; }
  bool is_spent() const { return !counts_.is_within(most_); }
  const DescentCounts& counts() const { return counts_; }

 private:
  DescentCounts most_, counts_;
};

/// Visits nodes, depth first. A Node has `level` and halves(). close_to(node, &parts) leaves those parts from which the
/// node is not shown to be apart.
/// @return  nothing if all nodes are dropped or the budget is spent; else a part that stays close to a node of the
///          greatest level
template <typename Node, typename CloseTo>
std::optional<std::uint32_t> descend(Node root, PartNumbers parts, int most_level,
                                     DescentBudget& budget, CloseTo close_to) {
  std::vector<std::pair<Node, PartNumbers>> stack;
  const auto visit = [&](Node node, PartNumbers from) {
    budget.add_nodes(1);
    close_to(node, &from);
    if (!from.empty()) stack.emplace_back(std::move(node), std::move(from));
  };
  visit(std::move(root), std::move(parts));
  while (!stack.empty() && !budget.is_spent()) {
    auto [node, close] = std::move(stack.back());
    stack.pop_back();
    if (node.level >= most_level) return close.front();
    auto halves = node.halves();
    visit(std::move(halves.second), close);
    visit(std::move(halves.first), std::move(close));
  }
  return std::nullopt;
}

}  // namespace veritope
