// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/bridge/curve_bridges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "interval/box.h"
#include "interval/functions.h"
#include "interval/ring_numbers.h"
#include "interval/upward.h"
#include "robust/base/check.h"
#include "robust/base/parallel.h"
#include "solids/micro/micro_bridge.h"

namespace veritope {
namespace {

using SpacePoint = std::array<Rational, 3>;

constexpr std::size_t kEndsInChunk = 16;
// Bits that steps and ends keep below their leading one: fewer digits, and nothing depends on the rest.
constexpr int kStepBits = 20;

// The middle control point lies `lead` times as far off as in algorithm 4, and the end at `depth` times the skin, or
// the distance of the curve's end if that is less, from the surface.
struct CurveTry {
  double lead, depth;
};
constexpr std::array<CurveTry, 8> kCurveTries = {{{1, 0.25},
                                                  {1, 0.5},
                                                  {1, 0.75},
                                                  {0.5, 0.25},
                                                  {0.5, 0.5},
                                                  {0.25, 0.25},
                                                  {0.25, 0.5},
                                                  {0.1, 0.6}}};

// All numbers are approximate but for those of curves.
Point3d approx_place(const SpacePoint& p) {
  return {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
}
double length_of_way(const Point3d& from, const Point3d& to) {
  return std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
}
// A number near x that keeps the bits of a number of the size `scale`.
Rational shortened(double x, double scale) {
  const int shift = kStepBits - std::ilogb(scale);
  return Rational::from_double(std::ldexp(std::nearbyint(std::ldexp(x, shift)), -shift));
}
bool is_number(double x) { return std::isfinite(x) && x > 0; }

// An upper bound of the square root. Infinite if no bound is known.
double root_bound(const Interval& square) {
  const ScopedUpward upward;
  const Interval root = sqrt(square);
  return root.is_empty() ? std::numeric_limits<double>::infinity() : root.hi();
}
double root_floor(const Interval& square) {
  const ScopedUpward upward;
  const Interval root = sqrt(square);
  return root.is_empty() ? 0 : std::max(0.0, root.lo());
}

// REQUIRES a live ScopedUpward.
Box3d outer_box_of(const SpacePoint& p) {
  Box3d out;
  for (std::size_t c = 0; c < 3; ++c) {
    const Interval x = enclose(p[c]);
    out.lo[c] = x.lo();
    out.hi[c] = x.hi();
  }
  return out;
}
// A box with corners in binary64 around points, of which no side is 0.
struct SpaceBox {
  SpacePoint lo, size;
};
std::optional<SpaceBox> box_around(const std::vector<SpacePoint>& points) {
  Box3d around = empty_box();
  {
    const ScopedUpward upward;
    for (const SpacePoint& p : points) around = hull(around, outer_box_of(p));
  }
  if (!is_finite(around)) return std::nullopt;
  SpaceBox out;
  for (std::size_t c = 0; c < 3; ++c) {
    out.lo[c] = Rational::from_double(around.lo[c]);
    out.size[c] = Rational::from_double(around.hi[c]) - out.lo[c];
    if (out.size[c] == Rational(0)) out.size[c] = Rational(1);
  }
  return out;
}

struct FoundCurve {
  std::optional<CurveBridge> bridge;
  BridgeRange reach;
  BridgeDrop drop = BridgeDrop::kSkin;
};

class CurveBridgeSearch {
 public:
  CurveBridgeSearch(const TileFilter& filter, const SkinFeet& feet, const BridgeOptions& options,
                    const CurveEndPlace& place)
      : filter_(filter), feet_(feet), options_(options), place_(place) {}

  FoundCurve run(const CurveEnd& end) const {
    FoundCurve out;
    const double speed = length_of_way({}, approx_place(place_.tangent));
    const double distance = root_bound(feet_(place_.at).squared_distance);
    if (!is_number(speed)) {
      out.drop = BridgeDrop::kFolded;
      return out;
    }
    if (!is_number(distance)) return out;
    for (const CurveTry& how : kCurveTries) {
      const auto points = points_of(how, speed, distance);
      if (!points) continue;
      const Interval reach = feet_((*points)[2]).squared_distance;
      out.reach = {root_floor(reach), root_bound(reach)};
      if (!(out.reach.hi <= options_.skin)) continue;
      if (!is_curve_inside(filter_, {points->begin(), points->end()})) continue;
      out.bridge = CurveBridge{end, *points};
      return out;
    }
    return out;
  }

 private:
  std::optional<std::array<SpacePoint, 3>> points_of(const CurveTry& how, double speed,
                                                     double distance) const {
    std::array<SpacePoint, 3> out;
    out[0] = out[1] = place_.at;
    const double step = how.lead * options_.alpha * distance / speed;
    if (!is_number(step)) return std::nullopt;
    const Rational along = shortened(step, step);
    for (std::size_t c = 0; c < 3; ++c) out[1][c] += along * place_.tangent[c];
    const Point3d foot = feet_(out[1]).at;
    // The end is drawn towards q, or towards p where q lies on the surface. The depth has to be seen beside the
    // coordinates.
    Point3d from = approx_place(out[1]);
    double way = length_of_way(foot, from);
    const double least = 0x1p-40 * (distance + length_of_way({}, foot));
    if (!(way > std::max(least, 0x1p-20 * distance))) {
      from = approx_place(place_.at);
      way = length_of_way(foot, from);
    }
    const double depth = std::min(how.depth * std::min(options_.skin, distance), 0.75 * way);
    if (!(depth > least) || !is_number(way)) return std::nullopt;
    for (std::size_t c = 0; c < 3; ++c)
      out[2][c] = shortened(foot[c] + depth * ((from[c] - foot[c]) / way), depth);
    return out;
  }

  const TileFilter& filter_;
  const SkinFeet& feet_;
  const BridgeOptions& options_;
  const CurveEndPlace& place_;
};

}  // namespace

bool is_curve_inside(const TileFilter& filter, const std::vector<SpacePoint>& points) {
  VT_CHECK(points.size() >= 2, "a curve has two control points or more");
  const std::optional<SpaceBox> box = box_around(points);
  if (!box) return false;
  // The curve is the tile of a cell that is this box.
  BezierVolume<Rational> map({1, 1, 1}, 3, false);
  const Grid<3> corners = map.grid();
  for (std::size_t i = 0; i < corners.count(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      map.component(static_cast<int>(c))[i] =
          corners.index_of(i)[c] == 0 ? box->lo[c] : box->lo[c] + box->size[c];
  TileShape::Surface curve({static_cast<int>(points.size()) - 1, 0}, 3, false);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      curve.component(static_cast<int>(c))[i] = (points[i][c] - box->lo[c]) / box->size[c];
  const Result<TileShape> shape = TileShape::make_open({std::move(curve)});
  VT_CHECK(shape.has_value(), "the control points lie in their box, and their number is allowed");
  return filter.status({&map}, *shape) == CellStatus::kKept;
}

Result<CurveBridges> build_curve_bridges(const TileFilter& filter, const SkinFeet& feet,
                                         const Microstructure& micro,
                                         const BridgeOptions& options) {
  const std::vector<CurveEnd> ends = free_curve_ends(micro);
  if (ends.size() > kMaxMicroBridges)
    return Error{Code::kOverLimit,
                 {},
                 "more than " + std::to_string(kMaxMicroBridges) + " ends are to be bridged"};
  std::vector<FoundCurve> found(ends.size());
  parallel_for(ends.size(), kEndsInChunk, options.jobs,
               [&](std::size_t, std::size_t begin, std::size_t end) {
                 CellPiece piece(micro);
                 for (std::size_t i = begin; i < end; ++i) {
                   const CurveEndPlace place = place_of(micro, ends[i], piece);
                   found[i] = CurveBridgeSearch(filter, feet, options, place).run(ends[i]);
                 }
               });
  CurveBridges out;
  out.report.caps = ends.size();
  for (FoundCurve& f : found) {
    if (!f.bridge) {
      ++out.report.dropped[static_cast<std::size_t>(f.drop)];
      continue;
    }
    BridgeRange& reach = out.report.reach;
    reach.lo = out.bridges.empty() ? f.reach.lo : std::min(reach.lo, f.reach.lo);
    reach.hi = out.bridges.empty() ? f.reach.hi : std::max(reach.hi, f.reach.hi);
    out.bridges.push_back(std::move(*f.bridge));
  }
  out.report.built = out.bridges.size();
  return out;
}

}  // namespace veritope
