// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/expression_tree.h: an expression as it was written: operators over numbered operands.
#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "solids/expression/formula.h"

namespace veritope {

/// kDifference is the first operand without all others. kComplement is the box of the expression without the operand.
enum class ExpressionOperator : std::uint8_t {
  kOperand,
  kUnion,
  kIntersection,
  kDifference,
  kComplement
};

struct ExpressionNode {
  ExpressionOperator op = ExpressionOperator::kOperand;
  std::uint32_t operand = 0;  ///< of kOperand
  std::vector<std::uint32_t>
      children;  ///< nodes before this one; one of kComplement, two or more of the others
};

/// What large expressions may have; docs/cli/boolean.md.
inline constexpr std::uint64_t kMostLeaves = 10000;
inline constexpr std::uint64_t kMostDepth = 1000;

/// The size of an expression whose operands may be expressions.
struct ExpressionSize {
  std::uint64_t leaves = 1;  ///< occurrences of operands
  std::uint64_t depth =
      0;  ///< operators around the deepest of them; a run of one operator counts once
  bool is_allowed() const { return leaves <= kMostLeaves && depth <= kMostDepth; }
};

/// A tree; its root is the last node.
class ExpressionTree {
 public:
  /// REQUIRES children that are nodes already.
  std::uint32_t add(ExpressionNode node) {
    nodes_.push_back(std::move(node));
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }
  const std::vector<ExpressionNode>& nodes() const { return nodes_; }

  bool has_complement() const;
  /// Counts become huge without overflow, so that they may be compared with the limits.
  ExpressionSize size(const std::vector<ExpressionSize>& operands) const;
  /// The normal form: unions and intersections of operands with signs. !X is the box and not X.
  /// @param operands  the formulas of the operands
  /// @param box       that of the box; used for complements only
  Formula formula(const std::vector<Formula>& operands, const Formula& box) const;

 private:
  std::vector<ExpressionNode> nodes_;
};

}  // namespace veritope
