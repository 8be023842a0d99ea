// SPDX-License-Identifier: Apache-2.0 OR MIT
// expression.h: a chain file with the files that it names; docs/certificates/points.md, section 7.
#pragma once
#include <functional>

#include "chain_file.h"

typedef std::function<std::string(const std::string& name)> ReadFile;

struct Expression {
  struct Solid {  // a file that is no chain file
    std::string bytes, format;
  };
  struct Variable {  // number: of a solid, or of a box
    bool is_box;
    uint32_t number;
  };
  struct
      Containment {  // the operand, a solid or a chain file's box, has to lie in the interior of the box
    Bounds3 box;
    bool is_solid;
    uint32_t solid;
    Bounds3 inner;
    std::string operand;
  };
  std::vector<ExpressionNode> nodes;  // of kinds kLeaf, with a number of a variable, to kDifference
  uint32_t root = 0;
  uint64_t leaves = 0;  // occurrences of operands that are no chain files
  std::vector<Solid> solids;
  std::vector<Bounds3> boxes;
  std::vector<Variable> variables;
  std::vector<Containment> containments;
};

// The expression of the chain file with this text and name. O1, or Refused.
Expression read_expression(const std::string& text, const std::string& name, const ReadFile& read);

// The value of the root by the values of the variables, which are asked for in the order of the page.
// Algebra: a type Value; Value variable(uint32_t), bool is_all(Value, bool), Value joined(kind, Value, Value).
template <class Algebra>
typename Algebra::Value evaluate(const Expression& e, Algebra* algebra) {
  typedef typename Algebra::Value Value;
  struct Frame {
    uint32_t node;
    int parts;  // that were begun
    Value left;
  };
  std::vector<Frame> open(1, Frame{e.root, 0, Value()});
  Value last = Value();
  while (!open.empty()) {
    Frame& f = open.back();
    const ExpressionNode& n = e.nodes[f.node];
    if (n.kind != ExpressionNode::kLeaf && f.parts == 0) {
      f.parts = 1;
      open.push_back(Frame{n.left, 0, Value()});
      continue;
    }
    // A union is 1 if its first part is; the other two are 0 if it is 0.
    if (f.parts == 1 && !algebra->is_all(last, n.kind == ExpressionNode::kUnion)) {
      f.parts = 2;
      f.left = std::move(last);
      open.push_back(Frame{n.right, 0, Value()});
      continue;
    }
    if (n.kind == ExpressionNode::kLeaf) last = algebra->variable(n.left);
    if (f.parts == 2) last = algebra->joined(n.kind, f.left, last);
    open.pop_back();
  }
  return last;
}
