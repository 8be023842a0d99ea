// SPDX-License-Identifier: LGPL-3.0-or-later
// A sweep is the image S of a cap plus a curve g(w) from 0 to f. Its volume is the integral of (S_u x S_v) . g', that
// is f times the vector area of S, and this is half the integral of S x dS along the rim of S.
#include "solids/micro/measure/sweep_volume_internal.h"

#include <algorithm>
#include <utility>

#include "interval/box.h"
#include "interval/upward.h"
#include "robust/base/check.h"
#include "robust/base/parallel.h"
#include "solids/micro/sweep_start.h"
#include "splines/bezier_calculus.h"
#include "splines/bezier_domain.h"
#include "splines/bezier_product.h"
#include "splines/composition.h"

namespace veritope::internal {
namespace {

constexpr int kMostPieceLevel = 12;
constexpr int kSeriesTerms = 9;
constexpr double kSmallVariation = 1.0 / 16;

Interval hull_of_component(const BezierCurve<Interval>& curve, int c) {
  Interval out = curve.component(c)[0];
  for (const Interval& x : curve.component(c)) out = hull(out, x);
  return out;
}
Box3 box_of_integrals(const BezierCurve<Interval>& curve) {
  const std::vector<Interval> x = integral(curve);
  return Box3(x[0], x[1], x[2]);
}
BezierCurve<Interval> coordinates_of(const BezierCurve<Interval>& curve) {
  const auto all = curve.coefficients();
  const auto count = static_cast<std::ptrdiff_t>(3 * curve.grid().count());
  return {curve.degrees(), 3, false, std::vector<Interval>(all.begin(), all.begin() + count)};
}

// The integral of S x dS along a curve S = X / W, that is of X x X' / W^2. With V = W^2, 1 / V is a series in
// 1 - V / v; the curve is halved until its terms get small.
Box3 moment_along(const BezierCurve<Interval>& side, int level) {
  const BezierCurve<Interval> x = coordinates_of(side);
  const BezierCurve<Interval> area = cross(x, derivative(x, 0));
  if (!side.is_rational()) return box_of_integrals(area);
  const auto w = side.component(3);
  const BezierCurve<Interval> weight(side.degrees(), 1, false,
                                     std::vector<Interval>(w.begin(), w.end()));
  BezierCurve<Interval> change = multiplied(weight, weight);
  const Interval range = hull_of_component(change, 0);
  const Interval middle(0.5 * range.lo() + 0.5 * range.hi());
  if (!(middle.lo() > 0)) return Box3(Interval::entire(), Interval::entire(), Interval::entire());
  for (Interval& v : change.component(0)) v = Interval(1.0) - v / middle;
  const Interval most(mag(hull_of_component(change, 0)));
  if (most.hi() > kSmallVariation && level < kMostPieceLevel) {
    const Rational half = Rational(1) / Rational(2);
    return moment_along(restricted(side, 0, Rational(0), half), level + 1) +
           moment_along(restricted(side, 0, half, Rational(1)), level + 1);
  }
  if (!(most.hi() < 1)) return Box3(Interval::entire(), Interval::entire(), Interval::entire());
  Box3 sum = box_of_integrals(area);
  BezierCurve<Interval> term = area;
  Interval rest = most;
  for (int k = 1; k < kSeriesTerms; ++k) {
    term = multiplied(change, term);
    sum = sum + box_of_integrals(term);
    rest = rest * most;
  }
  rest = rest / (Interval(1.0) - most);
  for (std::size_t c = 0; c < 3; ++c) {
    const double off = (rest * Interval(mag(hull_of_component(area, static_cast<int>(c))))).hi();
    sum[c] = (sum[c] + Interval::from_bounds(-off, off)) / middle;
  }
  return sum;
}

// The patch of a tile that lies in a wall.
const TilePatch& patch_in_wall(const MicroTile& tile, int wall) {
  const auto axis = static_cast<std::size_t>(wall / 2);
  const auto lies = [&](const TilePatch& patch) {
    for (std::size_t k = 0; k < patch.points.size(); ++k)
      for (const TilePoint& p : patch.points[k])
        if (p[axis] != Rational(k == 0 ? wall % 2 : 0)) return false;
    return true;
  };
  const auto at = std::find_if(tile.patches.begin(), tile.patches.end(), lies);
  VT_CHECK(at != tile.patches.end(), "a sweep starts at a cap");
  return *at;
}

// The cap in the unit square of the wall's other axes.
BezierSurface<Interval> cap_of(const Microstructure& micro, const CapPlace& place) {
  const MicroGrid& grid = micro.grids[place.grid];
  const TilePatch& patch = patch_in_wall(micro.tiles[grid.tiles[place.cell] - 1u], place.wall);
  const auto points =
      points_at(patch, number_of(patch, grid.numbers_of(grid.shape().index_of(place.cell))));
  const auto axis = static_cast<std::size_t>(place.wall / 2);
  BezierSurface<Interval> out(patch.degrees, 2, false);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t c = 0; c < 2; ++c)
      out.component(static_cast<int>(c))[i] = enclose(points[i][c < axis ? c : c + 1]);
  return out;
}

// f times the vector area of the image of the cap.
Interval signed_volume(const Microstructure& micro, const SweepStarts& starts,
                       const MicroSweep& sweep) {
  const BezierSurface<Interval> cap = cap_of(micro, sweep.cap), wall = starts.wall(sweep.cap);
  Box3 moment;
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (int end = 0; end < 2; ++end) {
      // Around the square: along u at v = 0, along v at u = 1, back along u at v = 1, back along v at u = 0.
      const auto side = compose(wall, boundary(cap, axis, end));
      VT_CHECK(side.has_value(), "sides of caps have degrees that can be composed");
      const bool is_forward = (axis == 0) == (end == 1);
      moment = moment + Interval(is_forward ? 1.0 : -1.0) * moment_along(*side, 0);
    }
  Interval sum;
  for (std::size_t c = 0; c < 3; ++c) sum += moment[c] * enclose(sweep.axis[1][c]);
  return Interval(0.5) * sum;
}

}  // namespace

Interval volume_of_sweeps(const Microstructure& micro, const std::vector<int>& hands,
                          unsigned jobs) {
  const SweepStarts starts(micro, {});
  std::vector<Interval> volumes(micro.sweeps.size());
  parallel_for(volumes.size(), 16, jobs, [&](std::size_t, std::size_t begin, std::size_t end) {
    const ScopedUpward upward;
    for (std::size_t i = begin; i < end; ++i)
      volumes[i] = signed_volume(micro, starts, micro.sweeps[i]);
  });
  const ScopedUpward upward;
  Interval sum;
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    const std::uint32_t volume = micro.grids[micro.sweeps[i].cap.grid].volume;
    sum += hands[volume] > 0 ? volumes[i] : -volumes[i];
  }
  return sum;
}

}  // namespace veritope::internal
