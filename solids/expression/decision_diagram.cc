// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/decision_diagram.h"

#include <algorithm>
#include <map>
#include <utility>

namespace veritope {

class DecisionDiagram::Builder {
 public:
  explicit Builder(std::size_t max_nodes) : max_nodes_(max_nodes) {}

  std::uint32_t build(const Formula& formula) {
    std::uint32_t next = 0;
    return build(formula, next);
  }
  bool is_over() const { return nodes_.size() > max_nodes_; }

  void put_into(DecisionDiagram& out, std::uint32_t root) {
    out.root_ = root;
    std::vector<bool> is_seen(nodes_.size());
    std::vector<std::uint32_t> open = {root};
    while (!open.empty()) {
      const std::uint32_t at = open.back();
      open.pop_back();
      if (at < kFirst || is_seen[at - kFirst]) continue;
      is_seen[at - kFirst] = true;
      const Node& node = nodes_[at - kFirst];
      out.support_.push_back(node.variable);
      open.push_back(node.low);
      open.push_back(node.high);
    }
    std::sort(out.support_.begin(), out.support_.end());
    out.support_.erase(std::unique(out.support_.begin(), out.support_.end()), out.support_.end());
    out.nodes_ = std::move(nodes_);
  }

 private:
  // The diagram of the node `next`, which becomes the one after it.
  std::uint32_t build(const Formula& formula, std::uint32_t& next) {
    const Formula::Node& node = formula.nodes()[next++];
    switch (node.kind) {
      case Formula::Kind::kConstant: return node.is_positive ? 1 : 0;
      case Formula::Kind::kLiteral:
        return make(node.variable, node.is_positive ? 0 : 1, node.is_positive ? 1 : 0);
      default: break;
    }
    const bool is_any = node.kind == Formula::Kind::kAny;
    std::uint32_t out = is_any ? 0 : 1;
    while (next < node.end) {
      const std::uint32_t part = build(formula, next);
      out = join(is_any, out, part);
    }
    return out;
  }

  std::uint32_t make(std::uint32_t variable, std::uint32_t low, std::uint32_t high) {
    if (low == high) return low;
    const auto [at, is_new] = known_.emplace(Node{variable, low, high},
                                             static_cast<std::uint32_t>(nodes_.size()) + kFirst);
    if (is_new) nodes_.push_back({variable, low, high});
    return at->second;
  }

  // The union or the intersection. Its value is of no use once is_over().
  std::uint32_t join(bool is_any, std::uint32_t a, std::uint32_t b) {
    const std::uint32_t forcing = is_any ? 1 : 0;
    if (a == forcing || b == forcing) return forcing;
    if (a == b || b < kFirst) return a;
    if (a < kFirst || is_over()) return b;
    if (b < a) std::swap(a, b);
    auto& joins = joins_[is_any ? 1 : 0];
    if (const auto found = joins.find({a, b}); found != joins.end()) return found->second;
    const Node x = nodes_[a - kFirst], y = nodes_[b - kFirst];
    const std::uint32_t variable = std::min(x.variable, y.variable);
    const auto branch = [&](std::uint32_t all, const Node& node, bool is_high) {
      return node.variable != variable ? all : is_high ? node.high : node.low;
    };
    const std::uint32_t low = join(is_any, branch(a, x, false), branch(b, y, false));
    const std::uint32_t high = join(is_any, branch(a, x, true), branch(b, y, true));
    const std::uint32_t out = make(variable, low, high);
    joins.emplace(std::pair(a, b), out);
    return out;
  }

  const std::size_t max_nodes_;
  std::vector<Node> nodes_;
  std::map<Node, std::uint32_t> known_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> joins_[2];
};

std::optional<DecisionDiagram> DecisionDiagram::make(const Formula& formula,
                                                     std::size_t max_nodes) {
  Builder builder(max_nodes);
  const std::uint32_t root = builder.build(formula);
  if (builder.is_over()) return std::nullopt;
  DecisionDiagram out;
  builder.put_into(out, root);
  return out;
}

Formula DecisionDiagram::formula_at(std::uint32_t at) const {
  if (at < kFirst) return Formula::constant(at == 1);
  const Node& node = nodes_[at - kFirst];
  const Formula x = Formula::variable(node.variable);
  const Formula high = formula_at(node.high), low = formula_at(node.low);
  if (node.low == 1) return Formula::any_of({x.negated(), high});
  if (node.high == 1) return Formula::any_of({x, low});
  return Formula::any_of({Formula::all_of({x, high}), Formula::all_of({x.negated(), low})});
}

}  // namespace veritope
