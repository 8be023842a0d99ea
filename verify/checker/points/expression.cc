// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "expression.h"

#include "../common/sha256.h"

namespace {

const int kMostNesting = 1000;  // of chain files

class Loader {
 public:
  Loader(const ReadFile& read, Expression* to) : read_(read), to_(*to) {}

  struct Tree {
    uint32_t root = 0;
    uint64_t leaves = 1, operators = 0;  // up to one more than allowed
  };
  struct Part {  // what a file means
    Tree tree;
    bool is_solid = true;
    uint32_t solid = 0;
    Bounds3 box;  // of a chain file
  };

  Part chain(const std::string& text, const std::string& name, int depth) {
    const ChainFile file = read_chain_file(text);
    const std::string folder = name.substr(0, name.rfind('/') + 1);
    std::vector<Part> parts;
    for (const ChainOperand& o : file.operands) parts.push_back(operand(o, folder, depth));
    for (size_t i = 0; i < parts.size(); ++i)
      to_.containments.push_back(Expression::Containment{
          file.box, parts[i].is_solid, parts[i].solid, parts[i].box, file.operands[i].name});
    Part r;
    r.tree = joined(file, parts);
    r.is_solid = false;
    r.box = file.box;
    return r;
  }

 private:
  // A file whose hash and format were met before is not read again.
  Part operand(const ChainOperand& o, const std::string& folder, int depth) {
    const std::pair<std::string, std::string> key(o.hash, o.format);
    const auto found = known_.find(key);
    if (found != known_.end()) return found->second;
    const std::string name = o.path[0] == '/' ? o.path : folder + o.path, bytes = bytes_of(name);
    require(sha256(bytes.data(), bytes.size()) == o.hash, "O1",
            ("the file of the operand " + o.name + " has another hash").c_str());
    Part part;
    if (o.format == "chain") {
      if (depth == kMostNesting) throw Refused{"more than 1000 chain files in each other"};
      part = chain(bytes, name, depth + 1);
    } else {
      part.solid = uint32_t(to_.solids.size());
      to_.solids.push_back(Expression::Solid{bytes, o.format});
      part.tree.root = leaf(variable(false, part.solid));
    }
    return known_[key] = part;
  }
  std::string bytes_of(const std::string& name) const {
    if (!read_) throw Refused{"there are no files beside the model"};  // a call by a test
    try {
      return read_(name);
    } catch (const Refused& r) {
      throw Refused{name + " " + r.why};
    }
  }

  // The nodes of the file, with those of its operands in the place of their names. !X is the box - X.
  Tree joined(const ChainFile& file, const std::vector<Part>& operands) {
    std::vector<Tree> of;
    for (const ExpressionNode& node : file.nodes) {
      if (node.kind == ExpressionNode::kLeaf) {
        of.push_back(operands[node.left].tree);
        continue;
      }
      const bool is_complement = node.kind == ExpressionNode::kComplement;
      const Tree &first = of[node.left], &last = of[is_complement ? node.left : node.right];
      Tree r;
      r.leaves = std::min(kMostLeaves + 1, last.leaves + (is_complement ? 0 : first.leaves));
      r.operators =
          std::min(kMostOperators + 1, last.operators + (is_complement ? 0 : first.operators) + 1);
      r.root =
          is_complement
              ? add(ExpressionNode{ExpressionNode::kDifference, leaf(box(file.box)), last.root})
              : add(ExpressionNode{node.kind, first.root, last.root});
      of.push_back(r);
    }
    if (of.back().leaves > kMostLeaves) throw Refused{"more than 10000 operands"};
    if (of.back().operators > kMostOperators) throw Refused{"more than 100000 operators"};
    return of.back();
  }

  uint32_t add(const ExpressionNode& node) {
    to_.nodes.push_back(node);
    return uint32_t(to_.nodes.size() - 1);
  }
  uint32_t leaf(uint32_t variable) {
    return add(ExpressionNode{ExpressionNode::kLeaf, variable, 0});
  }
  uint32_t variable(bool is_box, uint32_t number) {
    to_.variables.push_back(Expression::Variable{is_box, number});
    return uint32_t(to_.variables.size() - 1);
  }
  uint32_t box(const Bounds3& bounds) {
    std::vector<uint64_t> key;  // equal for equal bounds
    for (const Ratio* side : {bounds.lo, bounds.hi})
      for (int k = 0; k < 3; ++k)
        for (const Big* x : {&side[k].n, &side[k].d}) {
          key.push_back(2 * x->m.size() + x->neg);
          key.insert(key.end(), x->m.begin(), x->m.end());
        }
    const auto found = boxes_.find(key);
    if (found != boxes_.end()) return found->second;
    to_.boxes.push_back(bounds);
    return boxes_[key] = variable(true, uint32_t(to_.boxes.size() - 1));
  }

  const ReadFile& read_;
  Expression& to_;
  std::map<std::pair<std::string, std::string>, Part> known_;
  std::map<std::vector<uint64_t>, uint32_t> boxes_;
};

}  // namespace

Expression read_expression(const std::string& text, const std::string& name, const ReadFile& read) {
  Expression e;
  const Loader::Tree whole = Loader(read, &e).chain(text, name, 1).tree;
  e.root = whole.root;
  e.leaves = whole.leaves;
  return e;
}
