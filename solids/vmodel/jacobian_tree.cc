// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "robust/base/fp_guard.h"
#include "solids/vmodel/jacobian_tree_internal.h"
#include "splines/scaled_polynomial.h"

namespace veritope::internal {
namespace {

constexpr unsigned kMostHalvings = 60;  // a certificate allows 64
constexpr std::size_t kNodesAfterZero = 256;
constexpr unsigned kNumSubFaces = 27;

template <typename S>
struct TreeNode {
  DyadicBox box;
  std::vector<S> c;
  double error = 0;  // of rounded coefficients
};

std::array<Rational, 3> corner_point(const DyadicBox& box, unsigned corner) {
  std::array<Rational, 3> out;
  for (std::size_t a = 0; a < 3; ++a) out[a] = box.along(a)[corner >> a & 1];
  return out;
}
std::size_t corner_index(const Grid<3>& grid, unsigned corner) {
  std::array<std::size_t, 3> at{};
  for (std::size_t a = 0; a < 3; ++a) at[a] = (corner >> a & 1) != 0 ? grid.size[a] - 1 : 0;
  return grid.at(at);
}

// For each place of a coefficient, the sub-faces that it belongs to.
std::vector<std::uint32_t> sub_faces_of(const Grid<3>& grid) {
  std::vector<std::uint32_t> out;
  out.reserve(grid.count());
  for_each_index(grid, [&](const std::array<std::size_t, 3>& at, std::size_t) {
    std::uint32_t faces = 0;
    for (unsigned n = 0; n < kNumSubFaces; ++n) {
      const auto s = sub_face_places(n);
      bool is_in = true;
      for (std::size_t a = 0; a < 3; ++a)
        is_in = is_in && (s[a] == 2 || at[a] == (s[a] == 0 ? 0 : grid.size[a] - 1));
      if (is_in) faces |= std::uint32_t{1} << n;
    }
    out.push_back(faces);
  });
  return out;
}

// ---- halving

void halve_line(double* first, double* upper, std::size_t stride, std::size_t degree) {
  for (std::size_t level = 0; level <= degree; ++level) {
    upper[(degree - level) * stride] = first[degree * stride];
    for (std::size_t i = degree; i > level; --i)
      first[i * stride] = 0.5 * (first[i * stride] + first[(i - 1) * stride]);
  }
}
// All results times 2^degree.
void halve_line(Integer* first, Integer* upper, std::size_t stride, std::size_t degree) {
  for (std::size_t level = 0; level <= degree; ++level) {
    upper[(degree - level) * stride] = first[degree * stride] << (degree - level);
    for (std::size_t i = degree; i > level; --i) first[i * stride] += first[(i - 1) * stride];
    first[level * stride].shift_left(degree - level);
  }
}

void strip(std::vector<double>&) {}
// Divides by the greatest power of 2 that divides all.
void strip(std::vector<Integer>& c) {
  std::optional<std::uint64_t> common;
  for (const Integer& x : c)
    if (!x.is_zero()) {
      const std::uint64_t zeros = x.trailing_zeros();
      if (!common || zeros < *common) common = zeros;
      if (*common == 0) return;
    }
  if (!common) return;
  for (Integer& x : c) x.shift_right(*common);
}

template <typename S>
std::array<TreeNode<S>, 2> halves(TreeNode<S> node, const Grid<3>& grid, std::size_t axis) {
  TreeNode<S> upper{node.box.half(axis, 1), std::vector<S>(node.c.size()), node.error};
  node.box = node.box.half(axis, 0);
  grid.for_each_line(axis, [&](std::size_t first) {
    halve_line(node.c.data() + first, upper.c.data() + first, grid.stride(axis),
               grid.size[axis] - 1);
  });
  strip(node.c);
  strip(upper.c);
  return {std::move(node), std::move(upper)};
}

// ---- where to halve

const std::vector<double>& approx_numbers(const std::vector<double>& c) { return c; }
std::vector<double> approx_numbers(const std::vector<Integer>& c) {
  std::uint64_t bits = 0;
  for (const Integer& x : c) bits = std::max(bits, x.bit_length());
  const std::uint64_t shift = bits > 52 ? bits - 52 : 0;
  std::vector<double> out;
  for (Integer x : c) out.push_back(static_cast<double>(x.shift_right(shift).to_int64()));
  return out;
}

// The axis along which lines with coefficients that are not proved positive vary most; any choice is right.
template <typename S>
std::size_t axis_to_halve(const TreeNode<S>& node, double sign, const Grid<3>& grid) {
  const auto& c = approx_numbers(node.c);
  std::array<double, 3> total{};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t stride = grid.stride(a);
    grid.for_each_line(a, [&](std::size_t first) {
      double variation = 0, least = sign * c[first];
      for (std::size_t i = 1; i < grid.size[a]; ++i) {
        const double x = sign * c[first + i * stride];
        variation += std::abs(x - sign * c[first + (i - 1) * stride]);
        least = std::min(least, x);
      }
      if (!(least > node.error)) total[a] += variation;
    });
  }
  std::size_t best = 0;
  for (std::size_t a = 1; a < 3; ++a)
    if (total[a] > total[best] ||
        (total[a] == total[best] && node.box.level[a] < node.box.level[best]))
      best = a;
  return best;
}

// ---- what a node shows

struct NodeAnswer {
  bool is_leaf = false;
  std::optional<TreeEnd> end;
  std::array<Rational, 3> point;
};

class RoundedRule {
 public:
  RoundedRule(const Grid<3>& grid, int sign) : grid_(grid), sign_(sign) {}
  NodeAnswer operator()(const TreeNode<double>& node) const {
    NodeAnswer out;
    out.is_leaf =
        std::all_of(node.c.begin(), node.c.end(), [&](double x) { return sign_ * x > node.error; });
    for (unsigned corner = 0; !out.is_leaf && corner < 8; ++corner) {
      const double x = sign_ * node.c[corner_index(grid_, corner)];
      if (x > node.error) continue;
      out.end = x < -node.error ? TreeEnd::kNegative : TreeEnd::kUncertain;
      out.point = corner_point(node.box, corner);
      if (out.end == TreeEnd::kNegative) break;
    }
    return out;
  }

 private:
  Grid<3> grid_;
  double sign_;
};

class ExactRule {
 public:
  ExactRule(const Grid<3>& grid, int sign, std::uint32_t zeros)
      : grid_(grid),
        sign_(sign < 0 ? Sign::kNegative : Sign::kPositive),
        sub_faces_(sub_faces_of(grid)) {
    for (unsigned z = 0; z < kNumSubFaces; ++z)
      if ((zeros >> z & 1) != 0) zeros_.push_back(z);
  }
  NodeAnswer operator()(const TreeNode<Integer>& node) const {
    NodeAnswer out;
    std::uint32_t positive = 0;
    bool has_negative = false;
    for (std::size_t i = 0; i < node.c.size(); ++i) {
      const Sign s = node.c[i].sign() * sign_;
      if (s > 0) positive |= sub_faces_[i];
      has_negative = has_negative || s < 0;
    }
    for (unsigned corner = 0; has_negative && corner < 8; ++corner)
      if (node.c[corner_index(grid_, corner)].sign() * sign_ < 0) {
        out.end = TreeEnd::kNegative;
        out.point = corner_point(node.box, corner);
        return out;
      }
    // Without a negative coefficient, N is 0 on a sub-face if and only if it carries no positive one. A corner has one
    // coefficient.
    for (unsigned n = 0; n < kNumSubFaces; ++n) {
      const auto s = sub_face_places(n);
      const bool is_corner = s[0] < 2 && s[1] < 2 && s[2] < 2;
      if ((positive >> n & 1) != 0 || (has_negative && !is_corner) || is_in_zero(node.box, n))
        continue;
      out.end = TreeEnd::kZero;
      out.point = middle_of(node.box, n);
      break;
    }
    out.is_leaf = !has_negative;
    return out;
  }

 private:
  bool is_in_zero(const DyadicBox& box, unsigned sub_face) const {
    const auto s = sub_face_places(sub_face);
    return std::any_of(zeros_.begin(), zeros_.end(), [&](unsigned zero) {
      const auto z = sub_face_places(zero);
      for (std::size_t a = 0; a < 3; ++a)
        if (z[a] != 2 && (s[a] != z[a] || !(z[a] == 0 ? box.touches_begin(a) : box.touches_end(a))))
          return false;
      return true;
    });
  }
  static std::array<Rational, 3> middle_of(const DyadicBox& box, unsigned sub_face) {
    const auto s = sub_face_places(sub_face);
    std::array<Rational, 3> out;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto ends = box.along(a);
      out[a] = s[a] < 2 ? ends[s[a]] : (ends[0] + ends[1]) / Rational(2);
    }
    return out;
  }

  Grid<3> grid_;
  Sign sign_;
  std::vector<std::uint32_t> sub_faces_;
  std::vector<unsigned> zeros_;
};

template <typename S, typename Rule>
TreeResult search(const Grid<3>& grid, TreeNode<S> root, double growth, int sign, const Rule& rule,
                  std::size_t max_nodes) {
  TreeResult out, zero;  // a zero ends nothing: a negative value says more
  std::vector<TreeNode<S>> waiting;
  waiting.push_back(std::move(root));
  while (!waiting.empty()) {
    TreeNode<S> node = std::move(waiting.back());
    waiting.pop_back();
    NodeAnswer answer = rule(node);
    if (answer.end == TreeEnd::kZero) {
      if (zero.end == TreeEnd::kProved)
        zero = {TreeEnd::kZero, {}, std::move(answer.point), node.box};
      max_nodes = std::min(max_nodes, out.tree.size() + kNodesAfterZero);
      answer.end.reset();
    }
    if (!answer.is_leaf && !answer.end &&
        (out.tree.size() + waiting.size() + 3 > max_nodes || node.box.depth() >= kMostHalvings))
      answer.end = TreeEnd::kTooLarge;
    if (answer.end == TreeEnd::kTooLarge && zero.end == TreeEnd::kZero) return zero;
    if (answer.end) return {*answer.end, {}, std::move(answer.point), node.box};
    if (answer.is_leaf) {
      out.tree.push_back(0);
      continue;
    }
    const std::size_t axis = axis_to_halve(node, sign, grid);
    out.tree.push_back(static_cast<std::uint8_t>(axis + 1));
    node.error += growth * static_cast<double>(grid.size[axis]);
    auto both = halves(std::move(node), grid, axis);
    waiting.push_back(std::move(both[1]));
    waiting.push_back(std::move(both[0]));
  }
  return zero.end == TreeEnd::kZero ? zero : out;
}

}  // namespace

TreeResult search_tree(const RoundedJacobian& net, int sign, std::size_t max_nodes) {
  const ScopedDefaultFp nearest;
  double greatest = 0;
  for (const double x : net.values) greatest = std::max(greatest, std::abs(x));
  // A halving adds `degree` rounded sums to each coefficient, all at most `greatest`: docs/bounds/jacobian_net.md.
  return search(net.grid, TreeNode<double>{{}, net.values, net.error},
                greatest * 0x1p-52 + 0x1p-1000, sign, RoundedRule(net.grid, sign), max_nodes);
}

TreeResult search_tree(const ExactJacobian& net, int sign, std::uint32_t zeros,
                       std::size_t max_nodes) {
  return search(net.grid, TreeNode<Integer>{{}, net.values, 0}, 0, sign,
                ExactRule(net.grid, sign, zeros), max_nodes);
}

std::uint32_t zeros_of(const ExactJacobian& net) {
  const auto sub_faces = sub_faces_of(net.grid);
  std::uint32_t not_zero = 0;
  for (std::size_t i = 0; i < net.values.size(); ++i)
    if (!net.values[i].is_zero()) not_zero |= sub_faces[i];
  std::uint32_t out = 0;
  for (unsigned n = 0; n < kNumSubFaces; ++n) {
    if ((not_zero >> n & 1) != 0) continue;
    bool is_greatest = true;
    for (unsigned m = 0; m < kNumSubFaces; ++m)
      is_greatest = is_greatest && !(m != n && (not_zero >> m & 1) == 0 && is_sub_face_part(n, m));
    if (is_greatest) out |= std::uint32_t{1} << n;
  }
  return out;
}

}  // namespace veritope::internal
