// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/piece_neighbours.h"

#include <array>
#include <optional>

namespace veritope {
namespace {

using Node = PieceForest::Node;

// [lo, hi] in [0,1], as multiples of 2^-63: no piece is that small.
struct Span {
  std::uint64_t lo, hi;
};
constexpr std::uint64_t kOne = std::uint64_t{1} << 63;

Span span_of(std::uint64_t i, int bits) {
  const std::uint64_t unit = kOne >> bits;
  return {i * unit, (i + 1) * unit};
}
Span mirrored(const Span& s) { return {kOne - s.hi, kOne - s.lo}; }
bool meets(const Span& a, const Span& b) { return a.lo <= b.hi && b.lo <= a.hi; }

// The spans of u and v of a tensor piece; of a triangle's piece, those of the three barycentric coordinates.
std::array<Span, 3> spans_of(const PieceForest& forest, const Node& node) {
  const PieceForest::Form& form = forest.form(node.patch);
  if (!form.shape.is_triangle)
    return {span_of(node.i, form.root_bits[0] + node.level),
            span_of(node.j, form.root_bits[1] + node.level), Span{0, kOne}};
  // Upright: [a_e, a_e + 1]; upside down: [a_e - 1, a_e].
  const std::uint64_t down = node.is_upside_down ? 1 : 0;
  const std::uint64_t sum = (std::uint64_t{1} << node.level) - 1 + 2 * down;
  const std::uint64_t a = sum - node.i - node.j;
  return {span_of(a - down, node.level), span_of(node.i - down, node.level),
          span_of(node.j - down, node.level)};
}

// What the node has of side s of the patch, in that side's direction of travel: one side of the node, one corner of a
// triangle that is upside down, or nothing.
std::optional<Span> span_on_side(const PieceForest& forest, const Node& node, std::uint32_t side) {
  const std::array<Span, 3> spans = spans_of(forest, node);
  if (forest.form(node.patch).shape.is_triangle) {
    if (spans[(side + 2) % 3].lo != 0) return std::nullopt;
    const Span& along = spans[(side + 1) % 3];
    return node.is_upside_down ? Span{along.hi, along.hi} : along;
  }
  if (!forest.side_of_patch(node, side)) return std::nullopt;
  const Span& along = spans[side % 2];
  return side < 2 ? along : mirrored(along);
}

// Calls visit(vertex) for the patch's corners in the piece, and for the vertices of collapsed sides that the piece
// touches.
template <typename Visit>
void for_each_vertex(const PieceForest& forest, const Node& node, Visit visit) {
  const PieceForest::Form& form = forest.form(node.patch);
  const std::uint32_t n = form.shape.is_triangle ? 3 : 4;
  for (std::uint32_t s = 0; s < n; ++s) {
    if (!span_on_side(forest, node, s)) continue;
    const bool has_corner =
        forest.side_of_patch(node, s) && forest.side_of_patch(node, (s + n - 1) % n);
    const bool is_collapsed = (form.collapsed >> s & 1) != 0;
    if (has_corner || is_collapsed) visit(forest.complex().vertex({node.patch, s}));
  }
}

bool share_vertex(const PieceForest& forest, const Node& a, const Node& b) {
  bool found = false;
  for_each_vertex(forest, a, [&](std::uint32_t v) {
    for_each_vertex(forest, b, [&](std::uint32_t w) { found = found || v == w; });
  });
  return found;
}

bool share_edge(const PieceForest& forest, const Node& a, const Node& b) {
  const PatchComplex& complex = forest.complex();
  for (std::uint32_t s = 0; s < complex.patch(a.patch).num_sides(); ++s) {
    const std::optional<Span> here = span_on_side(forest, a, s);
    if (!here) continue;
    const auto mate = complex.mate({a.patch, s});
    if (!mate || mate->patch != b.patch) continue;
    const std::optional<Span> there = span_on_side(forest, b, mate->side);
    if (there && meets(*here, mirrored(*there))) return true;
  }
  return false;
}

bool meet_in_patch(const PieceForest& forest, const Node& a, const Node& b) {
  if (a.patch != b.patch) return false;
  const std::array<Span, 3> x = spans_of(forest, a), y = spans_of(forest, b);
  return meets(x[0], y[0]) && meets(x[1], y[1]) && meets(x[2], y[2]);
}

}  // namespace

bool are_neighbours(const PieceForest& forest, PieceForest::Id a, PieceForest::Id b) {
  const Node &x = forest.node(a), &y = forest.node(b);
  return meet_in_patch(forest, x, y) || share_edge(forest, x, y) || share_vertex(forest, x, y);
}

}  // namespace veritope
