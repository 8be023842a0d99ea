// SPDX-License-Identifier: LGPL-3.0-or-later
// Places of cells, and the exact test of an overlap.
#include "solids/vmodel/v_overlap.h"

#include <algorithm>
#include <utility>

#include "robust/base/check.h"
#include "robust/simplest.h"
#include "splines/bspline_domain.h"
#include "splines/de_boor.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

using Triple = std::array<Rational, 3>;

// The ends of a knot span.
std::array<Rational, 2> ends_of_span(const KnotAxis<Rational>& axis, std::size_t span) {
  const std::vector<Rational> breaks = internal::breaks_of(axis);
  VT_CHECK(span + 1 < breaks.size(), "a place lies in a knot span");
  return {breaks[span], breaks[span + 1]};
}
Rational between(const std::array<Rational, 2>& ends, const Rational& t) {
  return ends[0] + (ends[1] - ends[0]) * t;
}

// The control points and knots that count on a box of knot spans.
VVolume window_of(const VVolume& cell, const std::array<std::size_t, 3>& span) {
  std::array<KnotAxis<Rational>, 3> axes;
  Grid<3> local;
  std::array<std::size_t, 3> first{};
  for (std::size_t a = 0; a < 3; ++a) {
    const KnotAxis<Rational>& axis = cell.axis(a);
    const auto p = static_cast<std::size_t>(axis.degree);
    const std::size_t last = internal::find_span(axis, ends_of_span(axis, span[a])[0]);
    first[a] = last - p;
    local.size[a] = p + 1;
    const auto from = axis.knots.begin() + static_cast<std::ptrdiff_t>(first[a]);
    axes[a].degree = axis.degree;
    axes[a].knots.assign(from, from + static_cast<std::ptrdiff_t>(2 * p + 2));
  }
  std::vector<Rational> net;
  net.reserve(local.count() * static_cast<std::size_t>(cell.num_components()));
  for (int c = 0; c < cell.num_components(); ++c)
    for (std::size_t i = 0; i < local.count(); ++i) {
      auto index = local.index_of(i);
      for (std::size_t a = 0; a < 3; ++a) index[a] += first[a];
      net.push_back(cell.component(c)[cell.grid().at(index)]);
    }
  return {std::move(axes), cell.num_components(), cell.is_rational(), std::move(net)};
}

// The Bernstein coefficients on the box.
BezierVolume<Rational> piece_on(const VModel& model, const VBox& box) {
  const auto at = parameters_of(model, box);
  VVolume part = window_of(model.cell(box.cell), box.span);
  for (std::size_t a = 0; a < 3; ++a) part = internal::clamped_part(part, a, at[a][0], at[a][1]);
  return std::move(bezier_pieces(std::move(part)).pieces.front());
}

// O1.
bool is_inside(const VModel& model, const VPlace& place) {
  const Triple at = parameters_of(model, place);
  for (std::size_t a = 0; a < 3; ++a) {
    const KnotAxis<Rational>& axis = model.cell(place.cell).axis(a);
    if (!(axis.domain_begin() < at[a] && at[a] < axis.domain_end())) return false;
  }
  return true;
}
// O2.
bool are_different(const VModel& model, const VPlace& a, const VPlace& b) {
  return a.cell != b.cell || parameters_of(model, a) != parameters_of(model, b);
}
bool is_outside(const VModel& model, const VPlace& a, const VBox& b) {
  if (a.cell != b.cell) return true;
  const Triple at = parameters_of(model, a);
  const auto box = parameters_of(model, b);
  for (std::size_t i = 0; i < 3; ++i)
    if (at[i] < box[i][0] || box[i][1] < at[i]) return true;
  return false;
}

// O4.
bool holds_preimage(const VModel& model, const VPreimage& preimage, const Triple& q) {
  const BezierVolume<Rational> piece = piece_on(model, preimage.box);
  const Grid<3> grid = piece.grid();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto& y = preimage.rows[axis];
    const Rational of_q = Rational(Integer(y[0])) * q[0] + Rational(Integer(y[1])) * q[1] +
                          Rational(Integer(y[2])) * q[2];
    for (std::size_t i = 0; i < grid.count(); ++i) {
      const std::size_t k = grid.index_of(i)[axis];
      if (k != 0 && k + 1 != grid.size[axis]) continue;
      Rational value = piece.is_rational() ? -(piece.component(3)[i] * of_q) : -of_q;
      for (int c = 0; c < 3; ++c)
        value += Rational(Integer(y[static_cast<std::size_t>(c)])) * piece.component(c)[i];
      if (value.sign() != (k == 0 ? Sign::kNegative : Sign::kPositive)) return false;
    }
  }
  return true;
}

}  // namespace

Triple parameters_of(const VModel& model, const VPlace& place) {
  Triple out;
  for (std::size_t a = 0; a < 3; ++a)
    out[a] = between(ends_of_span(model.cell(place.cell).axis(a), place.span[a]), place.at[a]);
  return out;
}
std::array<std::array<Rational, 2>, 3> parameters_of(const VModel& model, const VBox& box) {
  std::array<std::array<Rational, 2>, 3> out;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto ends = ends_of_span(model.cell(box.cell).axis(a), box.span[a]);
    for (std::size_t e = 0; e < 2; ++e) out[a][e] = between(ends, box.at[a][e]);
  }
  return out;
}
Triple point_of(const VModel& model, const VPlace& place) {
  const VVolume window = window_of(model.cell(place.cell), place.span);
  std::vector<Rational> p = point(window, parameters_of(model, place)).value();
  return {std::move(p[0]), std::move(p[1]), std::move(p[2])};
}
VPlace place_at(const VModel& model, std::uint32_t cell, const Triple& at) {
  VPlace out;
  out.cell = cell;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::vector<Rational> breaks = internal::breaks_of(model.cell(cell).axis(a));
    const auto after = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, at[a]);
    out.span[a] = static_cast<std::size_t>(after - breaks.begin()) - 1;
    out.at[a] = (at[a] - *(after - 1)) / (*after - *(after - 1));
  }
  return out;
}

bool is_overlap(const VModel& model, const VOverlap& overlap) {
  if (!is_inside(model, overlap.inside)) return false;
  const Triple q = point_of(model, overlap.inside);
  if (overlap.point)
    return are_different(model, overlap.inside, *overlap.point) &&
           point_of(model, *overlap.point) == q;
  return is_outside(model, overlap.inside, overlap.somewhere->box) &&
         holds_preimage(model, *overlap.somewhere, q);
}

std::optional<VOverlap> find_collapsed_line(const VModel& model, std::uint32_t cell,
                                            const std::array<std::array<Rational, 2>, 3>& box) {
  Triple middle;
  for (std::size_t a = 0; a < 3; ++a) {
    const KnotAxis<Rational>& axis = model.cell(cell).axis(a);
    // A simple point of the box, or else of the domain, that is inside of the domain.
    const Rational length = axis.domain_end() - axis.domain_begin(),
                   margin = length / Rational(4096);
    const Rational lo = std::max(box[a][0], axis.domain_begin() + margin);
    const Rational hi = std::min(box[a][1], axis.domain_end() - margin);
    middle[a] = lo < hi    ? simplest_between(lo, hi)
                : lo == hi ? lo
                           : axis.domain_begin() + length / Rational(2);
  }
  VOverlap out;
  out.inside = place_at(model, cell, middle);
  for (std::size_t a = 0; a < 3; ++a) {
    const KnotAxis<Rational>& axis = model.cell(cell).axis(a);
    Triple other = middle;
    other[a] = (middle[a] + axis.domain_end()) / Rational(2);
    if (middle[a] < box[a][1]) other[a] = (middle[a] + box[a][1]) / Rational(2);
    out.point = place_at(model, cell, other);
    if (is_overlap(model, out)) return out;
  }
  return std::nullopt;
}

}  // namespace veritope
