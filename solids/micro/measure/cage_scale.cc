// SPDX-License-Identifier: LGPL-3.0-or-later
// Branch and bound over boxes of cells: a box is as good as the least of its Bernstein coefficients; a value of the
// determinant at the corner of a cell with a tile is attained.
#include "solids/micro/measure/cage_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "interval/numeric.h"
#include "interval/upward.h"
#include "solids/micro/measure/span_determinant_internal.h"
#include "splines/de_casteljau_line.h"

namespace veritope {
namespace {

using internal::CellSpan;

constexpr std::size_t kMostBoxes = std::size_t{1} << 14;
constexpr std::size_t kMostCoefficients = std::size_t{1} << 23;  // of all boxes
constexpr std::size_t kMostKept = std::size_t{1} << 22;          // coefficients of whole spans
// An error of the determinant beside which 1 % is large.
constexpr double kSmallError = 0x1p-10;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

using Cells = std::array<std::array<std::size_t, 2>, 3>;

// A box of cells, or a part of one cell, and the determinant there, in the parameters of the volume brought to [0, 1]
// and with the sign for which the least value is looked for.
struct ScaleBox {
  std::size_t span = 0;
  Cells cells{};
  double bound = 0;
  std::array<int, 3> halvings{};       // of one cell
  Grid<3> shape;                       // of the coefficients
  std::vector<Interval> coefficients;  // none: not computed yet
  double error = 0;                    // of each, which halving does not lessen
};

class ScaleSearch {
 public:
  ScaleSearch(const Microstructure& micro, const VModel& cage) : micro_(micro), cage_(cage) {
    for (std::size_t g = 0; g < micro.grids.size(); ++g)
      for (const CellSpan& s :
           internal::spans_of(micro.cage[micro.grids[g].volume], micro.grids[g]))
        if (num_tiles(g, s.cells) > 0) spans_.push_back({g, s});
  }

  Result<CageScale> run() {
    CageScale out;
    if (spans_.empty()) return out;
    const ScopedUpward upward;
    std::array<std::vector<double>, 2> bounds;  // of the least and of the greatest value, by spans
    std::size_t num_kept = 0;
    kept_.resize(spans_.size());
    for (std::size_t s = 0; s < spans_.size(); ++s) {
      ScaleBox box = make_box(s);
      bounds[0].push_back(box.bound);
      bounds[1].push_back(bound_of(turned(box).coefficients));
      num_kept += box.coefficients.size();
      if (num_kept <= kMostKept) kept_[s] = std::move(box);
    }
    for (const auto& of_end : bounds)
      for (const double b : of_end)
        if (!(b > -kInfinite))
          return Error{Code::kNotFinite, {}, "the determinant of the cage is not bounded"};
    most_ = -*std::min_element(bounds[1].begin(), bounds[1].end());
    out.lo = std::max(0.0, least(bounds[0], 1));
    out.hi = -least(bounds[1], -1);
    return out;
  }

 private:
  struct PlacedSpan {
    std::size_t grid;
    CellSpan span;
  };

  std::size_t num_tiles(std::size_t grid, const Cells& cells) const {
    const MicroGrid& g = micro_.grids[grid];
    const Grid<3> shape = g.shape();
    std::size_t count = 0;
    for (std::size_t i = cells[0][0]; i < cells[0][1]; ++i)
      for (std::size_t j = cells[1][0]; j < cells[1][1]; ++j)
        for (std::size_t k = cells[2][0]; k < cells[2][1]; ++k)
          count += g.tiles[shape.at({i, j, k})] != 0;
    return count;
  }
  static std::size_t num_cells(const Cells& cells) {
    std::size_t count = 1;
    for (const auto& c : cells) count *= c[1] - c[0];
    return count;
  }
  static double bound_of(const std::vector<Interval>& coefficients) {
    double least = kInfinite;
    for (const Interval& c : coefficients) least = std::min(least, c.lo());
    return least;
  }

  // The box with the other sign.
  static ScaleBox turned(ScaleBox box) {
    for (Interval& c : box.coefficients) c = -c;
    box.bound = bound_of(box.coefficients);
    return box;
  }
  // All cells of a span, with sign times the determinant.
  ScaleBox box_of(std::size_t number, int sign) const {
    ScaleBox out = kept_[number] ? *kept_[number] : make_box(number);
    return sign < 0 ? turned(std::move(out)) : out;
  }
  // Computed, with the sign 1.
  ScaleBox make_box(std::size_t number) const {
    const auto& [g, span] = spans_[number];
    const VVolume& volume = micro_.cage[micro_.grids[g].volume];
    const internal::SpanDeterminant d = internal::span_determinant(volume, span, kSmallError);
    const bool is_left_handed = cage_.hand(micro_.grids[g].volume) == Sign::kNegative;
    ScaleBox out;
    out.span = number;
    out.cells = span.cells;
    Interval factor(is_left_handed ? -1.0 : 1.0);
    for (std::size_t a = 0; a < 3; ++a) {
      const auto& axis = volume.axis(a);
      factor *= enclose((axis.domain_end() - axis.domain_begin()) /
                        (axis.knots[span.knots[a] + 1] - axis.knots[span.knots[a]]));
    }
    const Interval error = Interval::from_bounds(-d.error, d.error);
    out.error = mag(factor * error);
    for (const Interval& x : d.polynomial.component(0))
      out.coefficients.push_back(factor * (x + error));
    out.shape = d.polynomial.grid();
    for (std::size_t a = 0; a < 3; ++a) {
      const auto breaks = internal::breaks_in_span(volume, micro_.grids[g], span, a);
      // From the end, so that the second cut is at a part of [0, 1] that is known exactly.
      if (breaks.back() != Rational(1)) cut(out, a, breaks.back(), false);
      if (breaks.front() != Rational()) cut(out, a, breaks.front() / breaks.back(), true);
    }
    out.bound = bound_of(out.coefficients);
    return out;
  }
  // Keeps the part of [0, 1] along an axis before or after t.
  static void cut(ScaleBox& box, std::size_t axis, const Rational& t, bool keeps_upper) {
    const internal::AffineBlend<Interval> blend{enclose(Rational(1) - t), enclose(t)};
    const std::size_t step = box.shape.stride(axis);
    const auto degree = static_cast<int>(box.shape.size[axis] - 1);
    box.shape.for_each_line(axis, [&](std::size_t first) {
      Interval* const line = box.coefficients.data() + first;
      if (keeps_upper)
        internal::keep_right(line, step, degree, blend);
      else
        internal::keep_left(line, step, degree, blend);
    });
  }

  // A lower bound of the least value of sign times the determinant.
  double least(const std::vector<double>& bounds, int sign) const {
    const auto is_later = [](const ScaleBox& a, const ScaleBox& b) { return a.bound > b.bound; };
    std::priority_queue<ScaleBox, std::vector<ScaleBox>, decltype(is_later)> queue(is_later);
    for (std::size_t s = 0; s < bounds.size(); ++s)
      queue.push({s, spans_[s].span.cells, bounds[s], {}, {}, {}});
    double attained = kInfinite;
    std::size_t coefficients = 0;
    for (std::size_t boxes = 0;; ++boxes) {
      ScaleBox box = queue.top();
      if (box.coefficients.empty()) box = box_of(box.span, sign);
      reach_corners(box, attained);
      coefficients += box.coefficients.size();
      const bool is_enough = boxes >= kMostBoxes || coefficients >= kMostCoefficients;
      const Interval gap = Interval(attained) - Interval(box.bound);
      if (attained < kInfinite && (gap.hi() <= 0.01 * std::fabs(attained) ||
                                   gap.hi() <= 0x1p-20 * most_ || gap.hi() <= 4 * box.error ||
                                   is_enough))
        return std::min(box.bound, attained);
      if (boxes >= 2 * kMostBoxes || coefficients >= 2 * kMostCoefficients) return box.bound;
      queue.pop();
      for (ScaleBox& half : halves(box)) queue.push(std::move(half));
    }
  }
  // The corners of cells with tiles only.
  void reach_corners(const ScaleBox& box, double& attained) const {
    const std::size_t grid = spans_[box.span].grid;
    if (num_tiles(grid, box.cells) < num_cells(box.cells)) return;
    for (unsigned corner = 0; corner < 8; ++corner) {
      std::array<std::size_t, 3> at{};
      for (std::size_t a = 0; a < 3; ++a)
        at[a] = (corner >> a & 1) != 0 ? box.shape.size[a] - 1 : 0;
      attained = std::min(attained, box.coefficients[box.shape.at(at)].hi());
    }
  }
  std::vector<ScaleBox> halves(const ScaleBox& box) const {
    std::size_t axis = 0;
    for (std::size_t a = 1; a < 3; ++a)
      if (box.cells[a][1] - box.cells[a][0] > box.cells[axis][1] - box.cells[axis][0]) axis = a;
    Rational t = Rational(1) / Rational(2);
    std::array<ScaleBox, 2> out = {box, box};
    const auto [first, last] = box.cells[axis];
    if (last - first > 1) {
      const std::size_t middle = first + (last - first) / 2, grid = spans_[box.span].grid;
      const auto& breaks = micro_.grids[grid].breaks[axis];
      t = (breaks[middle] - breaks[first]) / (breaks[last] - breaks[first]);
      out[0].cells[axis][1] = out[1].cells[axis][0] = middle;
    } else {
      for (std::size_t a = 0; a < 3; ++a)
        if (box.halvings[a] < box.halvings[axis]) axis = a;
      for (ScaleBox& half : out) ++half.halvings[axis];
    }
    std::vector<ScaleBox> kept;
    for (std::size_t end = 0; end < 2; ++end) {
      if (num_tiles(spans_[box.span].grid, out[end].cells) == 0) continue;
      cut(out[end], axis, t, end == 1);
      out[end].bound = std::max(box.bound, bound_of(out[end].coefficients));
      kept.push_back(std::move(out[end]));
    }
    return kept;
  }

  const Microstructure& micro_;
  const VModel& cage_;
  std::vector<PlacedSpan> spans_;
  std::vector<std::optional<ScaleBox>> kept_;  // by spans, while there are few coefficients
  double most_ = 0;
};

}  // namespace

Result<CageScale> scale_of(const Microstructure& micro, const VModel& cage) {
  return ScaleSearch(micro, cage).run();
}

}  // namespace veritope
