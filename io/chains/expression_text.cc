// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/chains/expression_text.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "io/base/source.h"

namespace veritope {
namespace {

bool is_name_start(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; }
bool is_name_part(char c) { return is_name_start(c) || ('0' <= c && c <= '9'); }

struct Operator {
  ExpressionOperator op;
  int strength;  // operators of more strength come first
  char character;
};

std::optional<Operator> binary_operator(char c) {
  switch (c) {
    case '&': return Operator{ExpressionOperator::kIntersection, 2, c};
    case '|':
    case '+': return Operator{ExpressionOperator::kUnion, 1, c};
    case '-': return Operator{ExpressionOperator::kDifference, 1, c};
    default: return std::nullopt;
  }
}

constexpr Operator kNot = {ExpressionOperator::kComplement, 3, '!'};
constexpr int kOpen = 0;  // the strength of a parenthesis

// Dijkstra's two stacks: operators wait until a weaker one follows.
class ExpressionReader {
 public:
  explicit ExpressionReader(std::string_view text) : text_(text) {}

  Result<ExpressionText> read() {
    while (skip_gaps(), at_ < text_.size())
      if (const Status status = needs_operand_ ? take_operand() : take_operator(); !status)
        return status.error();
    if (needs_operand_) return expected("an operand");
    while (!waiting_.empty()) {
      if (waiting_.back().first.strength == kOpen)
        return error(waiting_.back().second, "this parenthesis is not closed");
      reduce();
    }
    finish();
    return std::move(out_);
  }

 private:
  using NodeId = std::uint32_t;

  Error error(std::size_t at, const std::string& what) const {
    return {Code::kSyntax, {}, "column " + std::to_string(at + 1) + ": " + what};
  }
  Error expected(const std::string& what) const {
    return error(at_, what + " expected, but there is " +
                          (at_ == text_.size() ? "the end" : quoted(text_.substr(at_, 1))));
  }
  void skip_gaps() {
    constexpr std::string_view kGaps = " \t\r\n";
    while (at_ < text_.size() && kGaps.find(text_[at_]) != kGaps.npos) ++at_;
  }

  Status take_operand() {
    const char c = text_[at_];
    if (c == '(' || c == '!') {
      waiting_.emplace_back(c == '!' ? kNot : Operator{{}, kOpen, c}, at_++);
      return ok_status();
    }
    const std::size_t begin = at_;
    std::string_view name;
    if (c == '"') {
      const std::size_t end = text_.find('"', begin + 1);
      if (end == text_.npos) return error(begin, "this quotation mark is not closed");
      name = text_.substr(begin + 1, end - begin - 1);
      if (name.empty()) return error(begin, "the name of a file must not be empty");
      at_ = end + 1;
    } else if (is_name_start(c)) {
      while (at_ < text_.size() && is_name_part(text_[at_])) ++at_;
      name = text_.substr(begin, at_ - begin);
    } else {
      return expected("a name, a file in double quotes, ! or (");
    }
    if (++num_leaves_ > kMostLeaves)
      return Error{Code::kOverLimit,
                   {},
                   "the expression has more than " + std::to_string(kMostLeaves) + " operands"};
    ExpressionNode leaf;
    leaf.operand = operand_of({std::string(name), c == '"', begin + 1});
    values_.push_back(add(std::move(leaf)));
    needs_operand_ = false;
    return ok_status();
  }

  Status take_operator() {
    const char c = text_[at_];
    if (c == ')') {
      while (!waiting_.empty() && waiting_.back().first.strength != kOpen) reduce();
      if (waiting_.empty()) return error(at_, "this parenthesis was not opened");
      waiting_.pop_back();
      ++at_;
      return ok_status();
    }
    const std::optional<Operator> op = binary_operator(c);
    if (!op) return expected("an operator");
    while (!waiting_.empty() && waiting_.back().first.strength >= op->strength) reduce();
    waiting_.emplace_back(*op, at_++);
    needs_operand_ = true;
    return ok_status();
  }

  // Applies the last operator that waits. A run of one operator becomes one node.
  void reduce() {
    const ExpressionOperator op = waiting_.back().first.op;
    waiting_.pop_back();
    const NodeId last = values_.back();
    values_.pop_back();
    if (op != ExpressionOperator::kComplement) {
      const NodeId first = values_.back();
      values_.pop_back();
      if (nodes_[first].op == op) {
        nodes_[first].children.push_back(last);
        values_.push_back(first);
        return;
      }
      values_.push_back(add({op, 0, {first, last}}));
      return;
    }
    values_.push_back(add({op, 0, {last}}));
  }

  NodeId add(ExpressionNode node) {
    nodes_.push_back(std::move(node));
    return static_cast<NodeId>(nodes_.size() - 1);
  }

  std::uint32_t operand_of(OperandName name) {
    const auto [at, is_new] = numbers_.emplace(std::pair(name.text, name.is_file),
                                               static_cast<std::uint32_t>(out_.operands.size()));
    if (is_new) out_.operands.push_back(std::move(name));
    return at->second;
  }

  // Gives the nodes their final order, children first.
  void finish() {
    std::vector<NodeId> number(nodes_.size());
    std::vector<std::pair<NodeId, std::size_t>> open = {{values_.back(), 0}};
    while (!open.empty()) {
      const auto [id, next] = open.back();
      if (next < nodes_[id].children.size()) {
        ++open.back().second;
        open.emplace_back(nodes_[id].children[next], 0);
        continue;
      }
      for (NodeId& child : nodes_[id].children) child = number[child];
      number[id] = out_.tree.add(std::move(nodes_[id]));
      open.pop_back();
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  bool needs_operand_ = true;
  std::uint64_t num_leaves_ = 0;
  std::vector<ExpressionNode> nodes_;
  std::vector<NodeId> values_;
  std::vector<std::pair<Operator, std::size_t>> waiting_;  // with their places
  std::map<std::pair<std::string, bool>, std::uint32_t> numbers_;
  ExpressionText out_;
};

int strength_of(ExpressionOperator op) {
  switch (op) {
    case ExpressionOperator::kUnion:
    case ExpressionOperator::kDifference: return 1;
    case ExpressionOperator::kIntersection: return 2;
    default: return 3;
  }
}

std::string symbol_of(ExpressionOperator op) {
  switch (op) {
    case ExpressionOperator::kUnion: return " | ";
    case ExpressionOperator::kIntersection: return " & ";
    default: return " - ";
  }
}

}  // namespace

bool is_operand_name(std::string_view text) {
  return !text.empty() && is_name_start(text[0]) &&
         std::all_of(text.begin(), text.end(), is_name_part);
}

Result<ExpressionText> read_expression(std::string_view text) {
  return ExpressionReader(text).read();
}

std::string write_expression(const ExpressionTree& tree, const std::vector<std::string>& names) {
  std::vector<std::string> of;
  const auto& nodes = tree.nodes();
  for (const ExpressionNode& node : nodes) {
    if (node.op == ExpressionOperator::kOperand) {
      of.push_back(names[node.operand]);
      continue;
    }
    const int strength = strength_of(node.op);
    std::string text = node.op == ExpressionOperator::kComplement ? "!" : "";
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      const std::uint32_t child = node.children[i];
      if (i > 0) text += symbol_of(node.op);
      const int inner = strength_of(nodes[child].op);
      const bool is_bare = inner > strength || (inner == strength && (i == 0 || strength == 3));
      text += is_bare ? of[child] : "(" + of[child] + ")";
      of[child].clear();
    }
    of.push_back(std::move(text));
  }
  return std::move(of.back());
}

}  // namespace veritope
