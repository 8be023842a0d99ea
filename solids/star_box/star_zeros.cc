// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/star_box/star_zeros.h"

#include <algorithm>
#include <array>
#include <vector>

namespace veritope {
namespace {

using Id = PieceForest::Id;
using Vec = std::array<Rational, 3>;

std::uint32_t num_sides(const FormShape& s) { return s.is_triangle ? 3 : 4; }
int side_degree(const FormShape& s, std::uint32_t side) {
  return s.is_triangle || side % 2 == 0 ? s.p : s.q;
}
// The place of coefficient k of a side, in the side's direction of travel.
std::size_t place_on_side(const FormShape& s, std::uint32_t side, int k) {
  if (s.is_triangle)
    return side == 0   ? triangle_index(k, 0)
           : side == 1 ? triangle_index(s.p - k, k)
                       : triangle_index(0, s.p - k);
  const int i = side == 0 ? k : side == 1 ? s.p : side == 2 ? s.p - k : 0;
  const int j = side == 0 ? 0 : side == 1 ? k : side == 2 ? s.q : s.q - k;
  return static_cast<std::size_t>(i * (s.q + 1) + j);
}

// Whether the side of the patch lies on a line through c: D = P - w c has one direction, or, what is the same, any two
// of its coefficients are parallel.
bool is_on_line_through(const PieceForest& forest, std::uint32_t number, std::uint32_t side,
                        const Point3d& c) {
  const Patch& patch = forest.complex().patch(number);
  Vec direction;
  bool has_direction = false;
  for (std::size_t i = 0; i < patch.side_length(side); ++i) {
    const std::size_t at = patch.side_index(side, i);
    const Rational w = patch.is_rational() ? patch.component(3)[at] : Rational(1);
    Vec d;
    for (std::size_t k = 0; k < 3; ++k) {
      d[k] = patch.component(static_cast<int>(k))[at] - w * forest.in_model(k, c[k]);
    }
    const auto is_zero = [](const Rational& x) { return x.sign() == Sign::kZero; };
    if (!has_direction) {
      direction = d;
      has_direction = !std::all_of(d.begin(), d.end(), is_zero);
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      if (!is_zero(d[k] * direction[l] - d[l] * direction[k])) return false;
    }
  }
  return true;
}

// STAR-5.FACES: which sides and corners of the piece carry a coefficient that is not zero.
bool has_no_inner_zeros(const PieceForest& forest, const PieceForest::Node& node,
                        const std::vector<bool>& is_zero) {
  const FormShape& shape = forest.form(node.patch).determinant;
  const std::uint32_t n = num_sides(shape);
  for (std::uint32_t e = 0; e < n; ++e) {
    bool any = forest.side_of_patch(node, e);
    for (int k = 0; k <= side_degree(shape, e) && !any; ++k)
      any = !is_zero[place_on_side(shape, e, k)];
    if (!any) return false;
  }
  for (std::uint32_t corner = 0; corner < n; ++corner) {
    bool is_inner = true;
    for (std::uint32_t e = 0; e < n; ++e)
      is_inner = is_inner && !forest.is_on_side(node, corner, e);
    if (is_inner && is_zero[place_on_side(shape, corner, 0)]) return false;
  }
  return true;
}

// STAR-5.RADIAL.
bool has_light_sides(const PieceForest& forest, const PieceForest::Node& node, const Point3d& c) {
  const std::uint32_t n = num_sides(forest.form(node.patch).shape);
  for (std::uint32_t e = 0; e < n; ++e) {
    bool is_touched = false;
    for (std::uint32_t corner = 0; corner < n; ++corner)
      is_touched = is_touched || forest.is_on_side(node, corner, e);
    const bool is_collapsed = (forest.form(node.patch).collapsed >> e & 1) != 0;
    if (is_touched && !is_collapsed && is_on_line_through(forest, node.patch, e, c)) return false;
  }
  return true;
}

bool has_sign_or_zeros(PieceForest& forest, Id id, const Point3d& c, Sign wanted) {
  const auto side = forest.side_with_zeros(id, c);
  if (!side || side->sign != wanted) return false;
  // On a side that lies on a line through c all coefficients are zero.
  if (side->is_zero.empty()) return true;
  return has_no_inner_zeros(forest, forest.node(id), side->is_zero) &&
         has_light_sides(forest, forest.node(id), c);
}

}  // namespace

bool has_star_signs_or_zeros(PieceForest& forest, Id id, const CentreLine& centres) {
  return has_sign_or_zeros(forest, id, centres.inside, Sign::kPositive) &&
         has_sign_or_zeros(forest, id, centres.outside, Sign::kNegative);
}

}  // namespace veritope
