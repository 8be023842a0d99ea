// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/decision_diagram.h: a Boolean function in a form in which it depends on all variables that occur.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "solids/expression/formula.h"

namespace veritope {

/// The reduced ordered binary decision diagram of a formula ([Bry86]): no node has equal branches, and no two nodes are
/// equal. So the function depends exactly on the variables of the nodes, and it is constant iff there is no node.
class DecisionDiagram {
 public:
  /// Nothing if more than `max_nodes` nodes would be made. @cost near-linear in the nodes that are made
  static std::optional<DecisionDiagram> make(const Formula& formula, std::size_t max_nodes);

  /// The variables on which the function depends, in increasing order.
  const std::vector<std::uint32_t>& support() const { return support_; }
  bool is_constant() const { return support_.empty(); }
  /// The function as a formula, by cases: (x & high) | (!x & low). @cost up to 2^(number of variables)
  Formula formula() const { return formula_at(root_); }

  /// `bit_of` is called for the variables on one path.
  template <typename BitOf>
  bool value(BitOf&& bit_of) const {
    std::uint32_t at = root_;
    while (at >= kFirst)
      at =
          bit_of(nodes_[at - kFirst].variable) ? nodes_[at - kFirst].high : nodes_[at - kFirst].low;
    return at == 1;
  }

 private:
  class Builder;
  static constexpr std::uint32_t kFirst = 2;  // 0 and 1 are the constants
  struct Node {
    std::uint32_t variable, low, high;
    friend auto operator<=>(const Node&, const Node&) = default;
  };
  Formula formula_at(std::uint32_t at) const;

  std::vector<Node> nodes_;
  std::uint32_t root_ = 0;
  std::vector<std::uint32_t> support_;
};

}  // namespace veritope
