// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <utility>
#include <vector>

#include "solids/vmodel/v_edge_internal.h"
#include "solids/vmodel/v_parts.h"
#include "splines/bspline_common.h"
#include "splines/bspline_domain.h"
#include "splines/de_boor.h"

namespace veritope {

std::array<Rational, 3> v_corner_point(const VVolume& cell, std::size_t corner) {
  const Grid<3> grid = cell.grid();
  std::size_t at = 0;
  for (std::size_t a = 0; a < 3; ++a)
    if ((corner >> a & 1) != 0) at += (grid.size[a] - 1) * grid.stride(a);
  std::array<Rational, 3> out{cell.component(0)[at], cell.component(1)[at], cell.component(2)[at]};
  if (cell.is_rational() && cell.component(3)[at] != Rational(1))
    for (Rational& x : out) x /= cell.component(3)[at];
  return out;
}

namespace internal {
namespace {

// Control points of a cell: first + n * step, n = 0, ..., count - 1.
struct ControlLine {
  std::size_t first, step, count;
};
ControlLine line_of_edge(const VVolume& cell, std::size_t edge) {
  const Grid<3> grid = cell.grid();
  const std::size_t axis = edge / 4;
  const auto others = v_face_axes(axis);
  ControlLine out{0, grid.stride(axis), grid.size[axis]};
  for (std::size_t k = 0; k < 2; ++k)
    if ((edge >> k & 1) != 0) out.first += (grid.size[others[k]] - 1) * grid.stride(others[k]);
  return out;
}

BSplineCurve<Rational> on_unit_interval(BSplineCurve<Rational> curve) {
  return with_domain(curve, 0, Rational(0), Rational(1)).value();
}

bool same_points(const BSplineCurve<Rational>& a, const BSplineCurve<Rational>& b) {
  const auto common = to_common_axes(a, b).value();
  const auto x = common.first.coefficients(), y = common.second.coefficients();
  if (!a.is_rational()) return std::equal(x.begin(), x.end(), y.begin(), y.end());
  const Rational &v = common.first.component(3)[0], &w = common.second.component(3)[0];
  return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                    [&](const Rational& p, const Rational& q) { return p * w == q * v; });
}

}  // namespace

BSplineCurve<Rational> curve_of_edge(const VVolume& cell, std::size_t edge, bool is_rational) {
  const ControlLine line = line_of_edge(cell, edge);
  std::vector<Rational> values;
  values.reserve(4 * line.count);
  for (int c = 0; c < (is_rational ? 4 : 3); ++c)
    for (std::size_t n = 0; n < line.count; ++n)
      values.push_back(c < 3 || cell.is_rational() ? cell.component(c)[line.first + n * line.step]
                                                   : Rational(1));
  return {{cell.axis(edge / 4)}, is_rational ? 4 : 3, is_rational, std::move(values)};
}

std::uint64_t edge_hash(const VEdge& edge) {
  const auto curve =
      on_unit_interval(curve_of_edge(*edge.cell, edge.edge, edge.cell->is_rational()));
  std::uint64_t h = 0;  // a sum: the direction does not matter
  for (const int n : {1, 2, 3, 4}) {
    const auto p = point(curve, {Rational(n) / Rational(5)}).value();
    h += point_hash({p[0], p[1], p[2]});
  }
  return h;
}

std::optional<bool> is_equal_reversed(const VEdge& a, const VEdge& b) {
  const bool is_rational = a.cell->is_rational() || b.cell->is_rational();
  const auto first = on_unit_interval(curve_of_edge(*a.cell, a.edge, is_rational)),
             second = on_unit_interval(curve_of_edge(*b.cell, b.edge, is_rational));
  if (same_points(first, second)) return false;
  if (same_points(first, reversed(second, 0))) return true;
  return std::nullopt;
}

}  // namespace internal
}  // namespace veritope
