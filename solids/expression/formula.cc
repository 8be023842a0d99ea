// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/formula.h"

#include <algorithm>

#include "robust/base/check.h"

namespace veritope {

Formula Formula::constant(bool value) {
  Formula out;
  out.nodes_.push_back({Kind::kConstant, value, 0, 1});
  return out;
}

Formula Formula::variable(std::uint32_t number) {
  Formula out;
  out.nodes_.push_back({Kind::kLiteral, true, number, 1});
  return out;
}

// The parts of a node of this kind, which begins at `begin`, are complete: parts of the same kind become parts of the
// node, and a node with one part becomes that part. A node without parts is the constant of its kind.
void Formula::close(std::size_t begin, Kind kind, std::vector<Node>& out) {
  if (out.size() == begin + 1) {
    out[begin] = {Kind::kConstant, kind == Kind::kAll, 0, static_cast<std::uint32_t>(begin + 1)};
    return;
  }
  std::vector<std::size_t> same;  // parts whose own nodes go
  std::size_t num_parts = 0, last = 0;
  for (std::size_t part = begin + 1; part < out.size(); part = out[part].end) {
    ++num_parts;
    last = part;
    if (out[part].kind == kind) same.push_back(part);
  }
  if (num_parts > 1 && same.empty()) {
    out[begin].end = static_cast<std::uint32_t>(out.size());
    return;
  }
  if (num_parts == 1) {
    same.assign(1, begin);
    if (out[last].kind == kind) same.push_back(last), same.erase(same.begin());
  }
  std::size_t to = begin, next = 0, removed = 0;
  std::vector<std::uint32_t> shift(out.size() - begin + 1);
  for (std::size_t i = begin; i < out.size(); ++i) {
    shift[i - begin] = static_cast<std::uint32_t>(removed);
    if (next < same.size() && same[next] == i) ++next, ++removed;
  }
  shift.back() = static_cast<std::uint32_t>(removed);
  next = 0;
  for (std::size_t i = begin; i < out.size(); ++i) {
    if (next < same.size() && same[next] == i) {
      ++next;
      continue;
    }
    Node node = out[i];
    if (i == begin) node.end = static_cast<std::uint32_t>(out.size());
    node.end -= shift[node.end - begin];
    out[to++] = node;
  }
  out.resize(to);
}

Formula Formula::joined(Kind kind, std::span<const Formula> parts) {
  Formula out;
  out.nodes_.push_back({kind, false, 0, 0});
  for (const Formula& part : parts) {
    if (part.is_constant()) {
      if (part.nodes_[0].is_positive == (kind == Kind::kAny)) return part;
      continue;
    }
    const auto shift = static_cast<std::uint32_t>(out.nodes_.size());
    for (Node node : part.nodes_) {
      node.end += shift;
      out.nodes_.push_back(node);
    }
  }
  close(0, kind, out.nodes_);
  return out;
}

Formula Formula::negated() const {
  Formula out = *this;
  for (Node& node : out.nodes_) {
    node.is_positive = !node.is_positive && node.kind <= Kind::kLiteral;
    if (node.kind == Kind::kAll)
      node.kind = Kind::kAny;
    else if (node.kind == Kind::kAny)
      node.kind = Kind::kAll;
  }
  return out;
}

std::vector<std::uint32_t> Formula::variables() const {
  std::vector<std::uint32_t> out;
  for (const Node& node : nodes_)
    if (node.kind == Kind::kLiteral) out.push_back(node.variable);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

std::size_t Formula::num_literals() const {
  return static_cast<std::size_t>(std::count_if(
      nodes_.begin(), nodes_.end(), [](const Node& n) { return n.kind == Kind::kLiteral; }));
}

std::size_t Formula::depth() const {
  std::size_t most = 0;
  std::vector<std::uint32_t> ends;  // of the nodes that are open
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    while (!ends.empty() && ends.back() == i) ends.pop_back();
    if (nodes_[i].end == i + 1) continue;
    ends.push_back(nodes_[i].end);
    most = std::max(most, ends.size());
  }
  return most;
}

std::string Formula::to_string() const {
  std::string out;
  std::vector<std::uint32_t> ends;  // of the nodes that are open
  std::vector<Kind> kinds;
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    while (!ends.empty() && ends.back() == i) {
      if (ends.size() > 1) out += ')';
      ends.pop_back();
      kinds.pop_back();
    }
    if (!out.empty() && out.back() != '(') out += kinds.back() == Kind::kAny ? " | " : " & ";
    const Node& node = nodes_[i];
    if (node.kind == Kind::kConstant) {
      out += node.is_positive ? '1' : '0';
    } else if (node.kind == Kind::kLiteral) {
      out += (node.is_positive ? "x" : "!x") + std::to_string(node.variable);
    } else {
      if (!ends.empty()) out += '(';
      ends.push_back(node.end);
      kinds.push_back(node.kind);
    }
  }
  for (std::size_t k = 1; k < ends.size(); ++k) out += ')';
  return out;
}

bool operator==(const Formula& a, const Formula& b) {
  return std::equal(a.nodes_.begin(), a.nodes_.end(), b.nodes_.begin(), b.nodes_.end(),
                    [](const Formula::Node& x, const Formula::Node& y) {
                      return x.kind == y.kind && x.is_positive == y.is_positive &&
                             x.variable == y.variable && x.end == y.end;
                    });
}

}  // namespace veritope
