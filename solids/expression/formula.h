// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/formula.h: the normal form of an expression: unions and intersections of variables with signs.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "solids/classify/value3.h"

namespace veritope {

/// A Boolean function of numbered variables, as a tree in which only variables are negated. Constants stand alone, and
/// no union is a part of a union, no intersection a part of an intersection.
class Formula {
 public:
  enum class Kind : std::uint8_t { kConstant, kLiteral, kAll, kAny };
  /// In the order of a walk from the root: a node's first part follows it, another one follows the end of the one
  /// before.
  struct Node {
    Kind kind = Kind::kConstant;
    bool is_positive = false;    ///< of a literal: not negated; of a constant: 1
    std::uint32_t variable = 0;  ///< of a literal
    std::uint32_t end = 1;       ///< the first node after this one and its parts
  };

  static Formula constant(bool value);
  static Formula variable(std::uint32_t number);
  /// REQUIRES at least one part.
  static Formula any_of(std::span<const Formula> parts) { return joined(Kind::kAny, parts); }
  static Formula all_of(std::span<const Formula> parts) { return joined(Kind::kAll, parts); }
  static Formula any_of(std::initializer_list<Formula> parts) {
    return any_of(std::span(parts.begin(), parts.size()));
  }
  static Formula all_of(std::initializer_list<Formula> parts) {
    return all_of(std::span(parts.begin(), parts.size()));
  }
  /// By De Morgan's laws: of the same size.
  Formula negated() const;

  std::span<const Node> nodes() const { return nodes_; }
  bool is_constant() const { return nodes_[0].kind == Kind::kConstant; }
  /// The variables that occur, each once, in increasing order.
  std::vector<std::uint32_t> variables() const;
  std::size_t num_literals() const;
  /// The number of unions and intersections around the innermost literal.
  std::size_t depth() const;
  /// Whether no variable occurs twice. Then it depends on each of them, unless it is constant.
  bool is_read_once() const { return variables().size() == num_literals(); }

  /// 0 or 1 if the values of some variables force it, by the rules for single operators; otherwise mixed, although it
  /// may be constant (x and not x). `value_of` is called for as few variables as these rules need, in their order.
  template <typename ValueOf>
  Value3 value(ValueOf&& value_of) const {
    return value_at(0, value_of);
  }
  /// The formula after variables with a constant value were replaced by it. Same rules.
  template <typename ValueOf>
  Formula folded(ValueOf&& value_of) const {
    Formula out;
    fold(0, value_of, out.nodes_);
    return out;
  }

  /// "x0 & (x1 | !x2)"
  std::string to_string() const;

  friend bool operator==(const Formula&, const Formula&);

 private:
  static Formula joined(Kind kind, std::span<const Formula> parts);
  static void close(std::size_t begin, Kind kind, std::vector<Node>& out);

  template <typename ValueOf>
  Value3 value_at(std::uint32_t i, ValueOf& value_of) const;
  template <typename ValueOf>
  void fold(std::uint32_t i, ValueOf& value_of, std::vector<Node>& out) const;

  std::vector<Node> nodes_;
};

// ---- bodies

template <typename ValueOf>
Value3 Formula::value_at(std::uint32_t i, ValueOf& value_of) const {
  const Node& node = nodes_[i];
  if (node.kind == Kind::kConstant) return to_value(node.is_positive);
  if (node.kind == Kind::kLiteral) {
    const Value3 v = value_of(node.variable);
    return node.is_positive ? v : complement_of(v);
  }
  const Value3 forcing = to_value(node.kind == Kind::kAny);
  Value3 out = complement_of(forcing);
  for (std::uint32_t part = i + 1; part < node.end; part = nodes_[part].end) {
    const Value3 v = value_at(part, value_of);
    if (v == forcing) return forcing;
    if (v == Value3::kMixed) out = v;
  }
  return out;
}

template <typename ValueOf>
void Formula::fold(std::uint32_t i, ValueOf& value_of, std::vector<Node>& out) const {
  const Node& node = nodes_[i];
  const auto begin = static_cast<std::uint32_t>(out.size());
  const auto put_constant = [&](bool value) {
    out.resize(begin);
    out.push_back({Kind::kConstant, value, 0, begin + 1});
  };
  if (node.kind == Kind::kConstant) return put_constant(node.is_positive);
  if (node.kind == Kind::kLiteral) {
    const Value3 v = value_of(node.variable);
    if (veritope::is_constant(v)) return put_constant((v == Value3::kOne) == node.is_positive);
    out.push_back({Kind::kLiteral, node.is_positive, node.variable, begin + 1});
    return;
  }
  out.push_back({node.kind, false, 0, 0});
  for (std::uint32_t part = i + 1; part < node.end; part = nodes_[part].end) {
    const auto at = static_cast<std::uint32_t>(out.size());
    fold(part, value_of, out);
    if (out[at].kind != Kind::kConstant) continue;
    if (out[at].is_positive == (node.kind == Kind::kAny)) return put_constant(out[at].is_positive);
    out.resize(at);
  }
  close(begin, node.kind, out);
}

}  // namespace veritope
