// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/expression_tree.h"

#include <algorithm>

#include "robust/base/check.h"

namespace veritope {
namespace {

Formula joined(const ExpressionNode& node, std::vector<Formula> parts, const Formula& box) {
  switch (node.op) {
    case ExpressionOperator::kUnion: return Formula::any_of(parts);
    case ExpressionOperator::kIntersection: return Formula::all_of(parts);
    case ExpressionOperator::kDifference:
      for (std::size_t i = 1; i < parts.size(); ++i) parts[i] = parts[i].negated();
      return Formula::all_of(parts);
    case ExpressionOperator::kComplement: return Formula::all_of({box, parts[0].negated()});
    case ExpressionOperator::kOperand: break;
  }
  throw InternalError("an operand has no parts");
}

}  // namespace

bool ExpressionTree::has_complement() const {
  return std::any_of(nodes_.begin(), nodes_.end(), [](const ExpressionNode& n) {
    return n.op == ExpressionOperator::kComplement;
  });
}

ExpressionSize ExpressionTree::size(const std::vector<ExpressionSize>& operands) const {
  constexpr std::uint64_t kHuge = std::uint64_t{1} << 40;
  std::vector<ExpressionSize> of;
  for (const ExpressionNode& node : nodes_) {
    ExpressionSize size{0, 0};
    if (node.op == ExpressionOperator::kOperand) size = operands[node.operand];
    for (const std::uint32_t child : node.children) {
      size.leaves = std::min(kHuge, size.leaves + of[child].leaves);
      size.depth = std::max(size.depth, std::min(kHuge, of[child].depth + 1));
    }
    of.push_back(size);
  }
  return of.back();
}

Formula ExpressionTree::formula(const std::vector<Formula>& operands, const Formula& box) const {
  std::vector<Formula> of;
  for (const ExpressionNode& node : nodes_) {
    if (node.op == ExpressionOperator::kOperand) {
      of.push_back(operands[node.operand]);
      continue;
    }
    std::vector<Formula> parts;
    for (const std::uint32_t child : node.children) parts.push_back(std::move(of[child]));
    of.push_back(joined(node, std::move(parts), box));
  }
  return std::move(of.back());
}

}  // namespace veritope
