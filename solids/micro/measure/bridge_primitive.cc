// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/measure/bridge_primitive_internal.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solids/micro/measure/cell_expansion_internal.h"
#include "solids/micro/measure/gauss_rule_internal.h"
#include "solids/micro/measure/tile_moments_internal.h"
#include "splines/blossom_weights.h"
#include "splines/knot_insertion.h"

namespace veritope::internal {
namespace {

constexpr std::size_t kMostBridgeOrder = 24;
// What an expansion leaves out, beside the greatest coefficient of the determinant.
constexpr double kSmallBridgeRest = 0x1p-40;

// The sum of c_m f_0[i] f_1[j] f_2[k], (i, j, k) the indices of moment m, up to an order.
Interval sum_of_products(const std::vector<Interval>& c, std::size_t order,
                         const std::array<std::vector<Interval>, 3>& f) {
  Interval sum;
  for (std::size_t i = 0; i <= order; ++i) {
    Interval sheet;
    for (std::size_t j = 0; i + j <= order; ++j) {
      Interval line;
      for (std::size_t k = 0; i + j + k <= order; ++k) line += c[moment_number(i, j, k)] * f[2][k];
      sheet += f[1][j] * line;
    }
    sum += f[0][i] * sheet;
  }
  return sum;
}

// Errors may be infinite.
Interval bound_of(double error) { return Interval::from_bounds(0, error); }

// The least e with x <= 2^e.
int exponent_above(double x) {
  int e = 0;
  const double m = std::frexp(x, &e);
  return m == 0.5 ? e - 1 : e;
}

}  // namespace

SpanDeterminants::Expandable SpanDeterminants::of(std::uint32_t volume, const Knots& knots,
                                                  const std::array<int, 3>& exponents) {
  const std::lock_guard lock(mutex_);
  auto known = determinants_.find({volume, knots});
  if (known == determinants_.end()) {
    CellSpan span;
    span.knots = knots;
    known = determinants_
                .try_emplace({volume, knots},
                             span_determinant(micro_.cage[volume], span, kSmallBridgeRest))
                .first;
  }
  auto errors = errors_.find({volume, knots, exponents});
  if (errors == errors_.end()) {
    std::array<double, 3> half_widths;
    for (std::size_t a = 0; a < 3; ++a) half_widths[a] = std::ldexp(1.0, exponents[a]);
    errors =
        errors_
            .try_emplace({volume, knots, exponents},
                         expansion_errors(known->second.polynomial, half_widths, kMostBridgeOrder))
            .first;
  }
  return {known->second, errors->second};
}

BridgePrimitive::BridgePrimitive(const VVolume& volume, std::uint32_t number, const TilePoint& lo,
                                 const TilePoint& hi, SpanDeterminants& determinants) {
  for (std::size_t a = 0; a < 3; ++a) {
    breaks_[a].push_back(lo[a]);
    for (const Rational& t : breaks_of(volume.axis(a)))
      if (lo[a] < t && t < hi[a]) {
        cuts_[a].push_back(enclose((t - lo[a]) / (hi[a] - lo[a])));
        breaks_[a].push_back(t);
      }
    breaks_[a].push_back(hi[a]);
    shape_.size[a] = breaks_[a].size() - 1;
    if (shape_.size[a] > shape_.size[axis_]) axis_ = a;
  }
  cells_.resize(shape_.count());
  for (std::size_t n = 0; n < cells_.size(); ++n) {
    CellNumber at = shape_.index_of(n);
    expand(volume, number, lo, hi, at, determinants);
    order_ = std::max(order_, cells_[n].order);
    if (at[axis_] == 0) {
      cells_[n].error = (bound_of(cells_[n].rest) * cells_[n].width[axis_]).hi();
      continue;
    }
    --at[axis_];
    go_on(cells_[shape_.at(at)], cells_[n]);
  }
}

void BridgePrimitive::expand(const VVolume& volume, std::uint32_t number, const TilePoint& lo,
                             const TilePoint& hi, const CellNumber& at,
                             SpanDeterminants& determinants) {
  Cell& cell = cells_[shape_.at(at)];
  SpanDeterminants::Knots knots;
  std::array<std::vector<Rational>, 3> in_span;
  std::array<int, 3> exponents;
  Interval factor(1.0);
  for (std::size_t a = 0; a < 3; ++a) {
    const KnotAxis<Rational>& axis = volume.axis(a);
    const Rational &from = breaks_[a][at[a]], &to = breaks_[a][at[a] + 1], length = hi[a] - lo[a];
    knots[a] = find_span(axis, from);
    const Rational &begin = axis.knots[knots[a]], width = axis.knots[knots[a] + 1] - begin;
    in_span[a] = {(from - begin) / width, (to - begin) / width};
    exponents[a] = exponent_above(0.5 * enclose(in_span[a][1] - in_span[a][0]).hi());
    factor *= enclose(length / width);
    cell.begin[a] = enclose((from - lo[a]) / length);
    cell.width[a] = enclose((to - from) / length);
  }
  const SpanDeterminants::Expandable found = determinants.of(number, knots, exponents);
  const double small = kSmallBridgeRest * greatest_coefficient(found.determinant.polynomial);
  while (cell.order + 1 < found.errors.size() && !(found.errors[cell.order] <= small)) ++cell.order;
  const CellExpansion expansion(found.determinant.polynomial, in_span, cell.order);
  CellExpansion::Sheet sheet;
  CellExpansion::Row row;
  expansion.enter_sheet(0, sheet);
  expansion.enter_row(sheet, 0, row);
  expansion.cell(row, 0, cell.expansion);
  for (Interval& c : cell.expansion) c *= factor;
  cell.rest =
      ((bound_of(found.errors[cell.order]) + bound_of(found.determinant.error)) * factor).hi();
}

// The integral of P_i over [-1, 1] is 0 for i > 0: along the axis a cell adds its terms with the number 0.
void BridgePrimitive::go_on(const Cell& before, Cell& cell) const {
  cell.begin_order = std::max(before.begin_order, before.order);
  cell.at_begin.resize(num_moments(cell.begin_order));
  const auto indices = moment_indices(cell.begin_order);
  for (std::size_t m = 0; m < indices.size(); ++m) {
    if (indices[m][axis_] != 0) continue;
    if (m < before.at_begin.size()) cell.at_begin[m] += before.at_begin[m];
    if (m < before.expansion.size()) cell.at_begin[m] += before.width[axis_] * before.expansion[m];
  }
  cell.error = (bound_of(before.error) + bound_of(cell.rest) * cell.width[axis_]).hi();
}

BridgePrimitive::CellRange BridgePrimitive::cells_of(const Box3& y) const {
  CellRange out;
  for (std::size_t a = 0; a < 3; ++a) {
    out[a] = {0, 0};
    for (const Interval& c : cuts_[a]) {
      out[a][0] += c.hi() <= y[a].lo();
      out[a][1] += c.lo() < y[a].hi();
    }
    out[a][1] = std::max(out[a][0], out[a][1]);
  }
  return out;
}

// Values of the polynomials P_0, P_1, ... at a point of the cell, one more than its orders.
std::array<std::vector<Interval>, 3> BridgePrimitive::legendre(const Cell& cell,
                                                               const Box3& y) const {
  std::array<std::vector<Interval>, 3> out;
  for (std::size_t a = 0; a < 3; ++a) {
    const Interval z = Interval(2.0) * (y[a] - cell.begin[a]) / cell.width[a] - Interval(1.0);
    // A box that only touches the cell may lie beyond it by a rounding: then its end is meant.
    const Interval inside =
        Interval::from_bounds(std::clamp(z.lo(), -1.0, 1.0), std::clamp(z.hi(), -1.0, 1.0));
    out[a].resize(std::max(cell.order, cell.begin_order) + 2);
    legendre_values(inside, out[a]);
  }
  return out;
}

Interval BridgePrimitive::near_begin(const CellNumber& number, const Box3& y) const {
  const Cell& cell = cell_at(number);
  if (cell.at_begin.empty()) return Interval();
  Box3 begin = y;
  begin[axis_] = cell.begin[axis_];
  auto f = legendre(cell, begin);
  std::fill(f[axis_].begin(), f[axis_].end(), Interval());
  f[axis_][0] = Interval(1.0);
  return sum_of_products(cell.at_begin, cell.begin_order, f);
}

Interval BridgePrimitive::determinant(const CellNumber& number, const Box3& y) const {
  const Cell& cell = cell_at(number);
  return sum_of_products(cell.expansion, cell.order, legendre(cell, y)) +
         Interval::from_bounds(-cell.rest, cell.rest);
}

// The integral of P_i from -1 on is (P_(i + 1) - P_(i - 1)) / (2i + 1), and that of P_0 is P_1 + 1.
Interval BridgePrimitive::near(const CellNumber& number, const Box3& y) const {
  const Cell& cell = cell_at(number);
  auto f = legendre(cell, y);
  Interval begin;
  std::vector<Interval> along = f[axis_];
  if (!cell.at_begin.empty()) {
    std::fill(f[axis_].begin(), f[axis_].end(), Interval());
    f[axis_][0] = Interval(1.0);
    begin = sum_of_products(cell.at_begin, cell.begin_order, f);
  }
  const Interval half = Interval(0.5) * cell.width[axis_];
  for (std::size_t i = 0; i <= cell.order; ++i)
    f[axis_][i] =
        half * (i == 0 ? along[1] + Interval(1.0)
                       : (along[i + 1] - along[i - 1]) / Interval(static_cast<double>(2 * i + 1)));
  return begin + sum_of_products(cell.expansion, cell.order, f);
}

}  // namespace veritope::internal
