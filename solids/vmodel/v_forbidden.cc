// SPDX-License-Identifier: LGPL-3.0-or-later
// What no certificate allows: edges and faces of pieces that are collapsed without their cell's edge or face.
#include <algorithm>
#include <utility>

#include "interval/interval.h"
#include "interval/ring_numbers.h"
#include "interval/upward.h"
#include "solids/vmodel/v_face_internal.h"
#include "splines/blossom_weights.h"
#include "splines/de_boor.h"
#include "splines/knot_insertion.h"

namespace veritope::internal {
namespace {

using Index = std::array<std::size_t, 3>;
using Breaks3 = std::array<std::vector<Rational>, 3>;

// ---- faces collapsed on some of their knot spans

struct FaceSpans {
  std::array<std::vector<Rational>, 2> knots;
  std::array<std::vector<std::size_t>, 2> first;  // control point of each span
  std::vector<VCollapse> collapse;                // of each span, the second axis fastest

  explicit FaceSpans(const FaceView& face) {
    std::array<std::size_t, 2> degree{};
    for (std::size_t k = 0; k < 2; ++k) {
      knots[k] = breaks_of(face.knots(k));
      degree[k] = static_cast<std::size_t>(face.knots(k).degree);
      for (std::size_t i = 0; i + 1 < knots[k].size(); ++i)
        first[k].push_back(find_span(face.knots(k), knots[k][i]) - degree[k]);
    }
    for (const std::size_t i : first[0])
      for (const std::size_t j : first[1])
        collapse.push_back(collapse_of(face, {i, i + degree[0]}, {j, j + degree[1]}));
  }
  std::size_t count(std::size_t k) const { return first[k].size(); }
  VCollapse at(std::size_t i, std::size_t j) const { return collapse[i * count(1) + j]; }
};

void add_splits(std::vector<VForbiddenCollapse::Split>& out, std::size_t axis,
                const std::vector<Rational>& knots, std::size_t span) {
  if (span > 0) out.push_back({axis, knots[span]});
  if (span + 2 < knots.size()) out.push_back({axis, knots[span + 1]});
}

// The first span that is collapsed. It need not be split along the axis along which the whole strip is collapsed.
void find_partial_face(const VModel& model, std::size_t cell, std::size_t k,
                       std::vector<VForbiddenCollapse>& out) {
  const FaceView face(model.cell(cell), k);
  const FaceSpans spans(face);
  for (std::size_t i = 0; i < spans.count(0); ++i)
    for (std::size_t j = 0; j < spans.count(1); ++j) {
      if (spans.at(i, j) == VCollapse::kNone) continue;
      bool whole_first = true, whole_second = true;
      for (std::size_t m = 0; m < spans.count(0); ++m)
        whole_first = whole_first && spans.at(m, j) == VCollapse::kAlongFirst;
      for (std::size_t n = 0; n < spans.count(1); ++n)
        whole_second = whole_second && spans.at(i, n) == VCollapse::kAlongSecond;
      VForbiddenCollapse found;
      found.kind = VForbiddenCollapse::Kind::kPartOfFace;
      found.cell = static_cast<std::uint32_t>(cell);
      found.face = k;
      const auto& across = model.cell(cell).axis(k / 2);
      const Rational& at = k % 2 == 0 ? across.domain_begin() : across.domain_end();
      found.box[k / 2] = {at, at};
      found.box[face.axis(0)] = {spans.knots[0][i], spans.knots[0][i + 1]};
      found.box[face.axis(1)] = {spans.knots[1][j], spans.knots[1][j + 1]};
      if (!whole_first) add_splits(found.splits, face.axis(0), spans.knots[0], i);
      if (!whole_second) add_splits(found.splits, face.axis(1), spans.knots[1], j);
      return out.push_back(std::move(found));
    }
}

// ---- edges of pieces

// Values at all products of breaks.
class CornerBoxes {
 public:
  // REQUIRES rounding upward.
  CornerBoxes(const VVolume& cell, const Breaks3& breaks) {
    Grid<3> grid = cell.grid();
    for (int c = 0; c < cell.num_components(); ++c) {
      std::vector<Interval> values;
      for (const Rational& x : cell.component(c)) values.push_back(enclose(x));
      grid = cell.grid();
      for (std::size_t a = 0; a < 3; ++a) values = along(cell.axis(a), a, breaks[a], grid, values);
      values_.push_back(std::move(values));
    }
    grid_ = grid;
  }
  bool may_be_equal(const Index& p, const Index& q) const {
    const std::size_t i = grid_.at(p), j = grid_.at(q);
    for (std::size_t c = 0; c < 3; ++c) {
      const bool is_rational = values_.size() == 4;
      const Interval d = is_rational ? values_[c][i] * values_[3][j] - values_[c][j] * values_[3][i]
                                     : values_[c][i] - values_[c][j];
      if (is_certain(d.sign()) && d.sign() != Sign3::kZero) return false;
    }
    return true;
  }

 private:
  static std::vector<Interval> along(const KnotAxis<Rational>& axis, std::size_t a,
                                     const std::vector<Rational>& breaks, Grid<3>& grid,
                                     const std::vector<Interval>& from) {
    Grid<3> to_grid = grid;
    to_grid.size[a] = breaks.size();
    std::vector<Interval> to(to_grid.count());
    for (std::size_t b = 0; b < breaks.size(); ++b) {
      const std::size_t span = find_span(axis, breaks[b]),
                        first = span - static_cast<std::size_t>(axis.degree);
      const auto weights = numbers_of_knots<Interval>(basis_values(axis, span, breaks[b]));
      for (std::size_t i = 0; i < to.size() / breaks.size(); ++i) {
        Index at{};  // of the line
        std::size_t rest = i;
        for (std::size_t k = 3; k-- > 0;)
          if (k != a) at[k] = rest % grid.size[k], rest /= grid.size[k];
        Interval sum;
        for (std::size_t j = 0; j < weights.size(); ++j) {
          at[a] = first + j;
          sum += weights[j] * from[grid.at(at)];
        }
        at[a] = b;
        to[to_grid.at(at)] = sum;
      }
    }
    grid = to_grid;
    return to;
  }

  Grid<3> grid_;
  std::vector<std::vector<Interval>> values_;
};

// Whether the edge of a piece along `axis` that begins at `from` is collapsed: all Bernstein coefficients, or, equally,
// the control points of its span, are one point.
bool is_collapsed_exactly(const VVolume& cell, std::size_t axis,
                          const std::array<Rational, 3>& from) {
  std::array<std::vector<Rational>, 3> weights;
  Index first{};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t span = find_span(cell.axis(a), from[a]);
    first[a] = span - static_cast<std::size_t>(cell.axis(a).degree);
    weights[a] = basis_values(cell.axis(a), span, from[a]);
  }
  const auto others = v_face_axes(axis);
  const auto value = [&](int c, std::size_t n) {
    Rational sum;
    for (std::size_t i = 0; i < weights[others[0]].size(); ++i)
      for (std::size_t j = 0; j < weights[others[1]].size(); ++j) {
        Index at = first;
        at[axis] += n, at[others[0]] += i, at[others[1]] += j;
        sum +=
            weights[others[0]][i] * weights[others[1]][j] * cell.component(c)[cell.grid().at(at)];
      }
    return sum;
  };
  const auto points = static_cast<std::size_t>(cell.axis(axis).degree) + 1;
  for (std::size_t n = 1; n < points; ++n)
    for (int c = 0; c < 3; ++c) {
      const Rational x = value(c, 0), y = value(c, n);
      if (cell.is_rational() ? x * value(3, n) != y * value(3, 0) : x != y) return false;
    }
  return true;
}

class PieceEdges {
 public:
  PieceEdges(const VModel& model, std::size_t cell)
      : model_(model),
        cell_(cell),
        breaks_{model.breaks(cell, 0), model.breaks(cell, 1), model.breaks(cell, 2)} {}

  void find(const std::array<bool, 6>& has_partial, std::vector<VForbiddenCollapse>& out) const {
    for (const auto& [axis, at] : suspects()) {
      const std::size_t a = axis;
      const Index place = at;
      std::array<Rational, 3> from;
      for (std::size_t k = 0; k < 3; ++k) from[k] = breaks_[k][place[k]];
      if (!is_collapsed_exactly(model_.cell(cell_), a, from) || is_allowed(a, place, has_partial))
        continue;
      out.push_back(forbidden(a, place));
    }
  }

 private:
  // Edges whose ends may be one point.
  std::vector<std::pair<std::size_t, Index>> suspects() const {
    const ScopedUpward upward;
    const CornerBoxes boxes(model_.cell(cell_), breaks_);
    const Grid<3> corners{{breaks_[0].size(), breaks_[1].size(), breaks_[2].size()}};
    std::vector<std::pair<std::size_t, Index>> out;
    for (std::size_t n = 0; n < corners.count(); ++n)
      for (std::size_t a = 0; a < 3; ++a) {
        const Index at = corners.index_of(n);
        Index next = at;
        if (++next[a] < corners.size[a] && boxes.may_be_equal(at, next)) out.emplace_back(a, at);
      }
    return out;
  }
  // 0 at the begin of the domain, 1 at its end, else 2.
  unsigned end_at(std::size_t axis, const Index& at) const {
    return at[axis] == 0 ? 0 : at[axis] + 1 == breaks_[axis].size() ? 1 : 2;
  }
  bool is_allowed(std::size_t axis, const Index& at, const std::array<bool, 6>& has_partial) const {
    const auto others = v_face_axes(axis);
    const unsigned e = end_at(others[0], at), f = end_at(others[1], at);
    if (e < 2 && f < 2 && model_.is_edge_collapsed(cell_, 4 * axis + e + 2 * f)) return true;
    for (std::size_t n = 0; n < 2; ++n) {
      const unsigned end = n == 0 ? e : f;
      if (end == 2) continue;
      const std::size_t face = 2 * others[n] + end;
      const VCollapse collapse = model_.face(cell_, face).collapse;
      const auto along =
          v_face_axes(others[n])[0] == axis ? VCollapse::kAlongFirst : VCollapse::kAlongSecond;
      if (collapse == VCollapse::kToPoint || collapse == along) return true;
      if (has_partial[face]) return true;  // it is reported as a face
    }
    return false;
  }
  VForbiddenCollapse forbidden(std::size_t axis, const Index& at) const {
    VForbiddenCollapse out;
    out.cell = static_cast<std::uint32_t>(cell_);
    const auto others = v_face_axes(axis);
    std::size_t num_walls = 0;
    for (const std::size_t k : others) {
      out.box[k] = {breaks_[k][at[k]], breaks_[k][at[k]]};
      if (const unsigned end = end_at(k, at); end < 2) out.face = 2 * k + end, ++num_walls;
    }
    out.box[axis] = {breaks_[axis][at[axis]], breaks_[axis][at[axis] + 1]};
    if (num_walls < 2) return out;
    out.kind = VForbiddenCollapse::Kind::kPartOfEdge;
    add_splits(out.splits, axis, breaks_[axis], at[axis]);
    return out;
  }

  const VModel& model_;
  std::size_t cell_;
  Breaks3 breaks_;
};

}  // namespace

void find_forbidden(const VModel& model, std::size_t cell, std::vector<VForbiddenCollapse>& out) {
  std::array<bool, 6> has_partial{};
  for (std::size_t k = 0; k < 6; ++k) {
    if (model.face(cell, k).is_collapsed()) continue;
    const std::size_t before = out.size();
    find_partial_face(model, cell, k, out);
    has_partial[k] = out.size() > before;
  }
  PieceEdges(model, cell).find(has_partial, out);
}

}  // namespace veritope::internal
