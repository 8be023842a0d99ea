// SPDX-License-Identifier: LGPL-3.0-or-later
// I4: how far the end faces of bridges are from the surface of the solid, at most.
#include <algorithm>
#include <cmath>
#include <queue>
#include <string>
#include <utility>

#include "interval/box_geometry.h"
#include "interval/upward.h"
#include "robust/base/check.h"
#include "solids/micro/inside/descent_internal.h"
#include "solids/micro/inside/inside_parts_internal.h"

namespace veritope::internal {

namespace {

constexpr std::size_t kMostNodes = 2048;  // of a bridge; the page has 4096
// The page has 2^22 nodes, and 256 more for each bridge.
constexpr std::size_t kAllSkinNodes = std::size_t{1} << 21, kMoreNodes = 128;
constexpr int kMostLevel = 22;         // the page has 24
constexpr double kWorth = 1 + 0x1p-7;  // a bound that is nearer to the least one is not improved

// A part of the end face of a bridge, with an upper bound of its points' distances from the surface.
struct SkinNode {
  double bound = 0;
  std::uint32_t bridge = 0;
  PatchNode part;
};
struct IsNearer {
  bool operator()(const SkinNode& a, const SkinNode& b) const {
    return a.bound != b.bound ? a.bound < b.bound : a.bridge > b.bridge;
  }
};

// An upper bound of the distance between any point of the box and the triangle.
double distance_bound(const Box3& point, const std::array<Vec3d, 3>& triangle) {
  const Point3d q = approx_middle(point);
  std::array<Point3d, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = to_point(triangle[i]);
  const auto minus = [](const Point3d& a, const Point3d& b) {
    return Point3d{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  };
  const auto dot = [](const Point3d& a, const Point3d& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  // Weights of the corners 1 and 2 of a point near the nearest one: any are right, these are good.
  double best = HUGE_VAL;
  std::array<double, 2> weights{};
  const auto consider = [&](double v, double w) {
    if (!(v >= 0 && w >= 0 && v + w <= 1)) return;
    Point3d d = minus(q, p[0]);
    for (std::size_t c = 0; c < 3; ++c) d[c] -= v * (p[1][c] - p[0][c]) + w * (p[2][c] - p[0][c]);
    const double square = dot(d, d);
    if (square < best) best = square, weights = {v, w};
  };
  const Point3d e1 = minus(p[1], p[0]), e2 = minus(p[2], p[0]), e3 = minus(p[2], p[1]);
  const Point3d f = minus(q, p[0]), g = minus(q, p[1]);
  const double a = dot(e1, e1), b = dot(e1, e2), c = dot(e2, e2), d = dot(e1, f), e = dot(e2, f);
  const double det = a * c - b * b;
  consider((c * d - b * e) / det, (a * e - b * d) / det);
  consider(std::clamp(d / a, 0.0, 1.0), 0);
  consider(0, std::clamp(e / c, 0.0, 1.0));
  const double s = std::clamp(dot(e3, g) / dot(e3, e3), 0.0, 1.0);
  consider(std::max(0.0, std::nextafter(1 - s, 0)), s);
  consider(0, 0);
  consider(1, 0);
  consider(0, 1);
  const Interval v(weights[0]), w(weights[1]);
  const Interval u = intersection(Interval(1.0) - v - w, Interval::from_bounds(0, 1));
  Box3 off;
  for (std::size_t k = 0; k < 3; ++k)
    off[k] = point[k] - (u * Interval(p[0][k]) + v * Interval(p[1][k]) + w * Interval(p[2][k]));
  return norm(off).hi();
}

class SkinSearch {
 public:
  explicit SkinSearch(const InsideParts& parts)
      : parts_(parts), num_nodes_(parts.micro.bridges.size()) {}

  // The number of the bridge whose bound is infinite, if there is one.
  std::optional<std::uint32_t> run() {
    for (std::uint32_t b = 0; b < parts_.micro.bridges.size(); ++b) {
      push(b, end_face(parts_.micro.bridges[b]));
      if (!std::isfinite(nodes_.top().bound)) return b;
    }
    while (nodes_.top().bound > kWorth * least_) {
      const SkinNode top = nodes_.top();
      if (top.part.level >= kMostLevel || num_nodes_[top.bridge] + 2 > kMostNodes ||
          num_all_ > kAllSkinNodes + kMoreNodes * num_nodes_.size())
        break;
      nodes_.pop();
      auto halves = top.part.halves();
      push(top.bridge, std::move(halves.first));
      push(top.bridge, std::move(halves.second));
    }
    return std::nullopt;
  }
  double bound() const { return nodes_.top().bound; }

 private:
  static PatchNode end_face(const MicroBridge& bridge) {
    PatchNode out{bridge.degrees, {}, 0};
    for (int i = 0; i <= bridge.degrees[0]; ++i)
      for (int j = 0; j <= bridge.degrees[1]; ++j) {
        const TilePoint& p = bridge.points[bridge.at(i, j, kBridgeAxisDegree)];
        out.points.emplace_back(enclose(p[0]), enclose(p[1]), enclose(p[2]));
      }
    return out;
  }

  void push(std::uint32_t bridge, PatchNode part) {
    ++num_nodes_[bridge];
    const BridgeMaps maps(parts_.volumes[parts_.micro.bridges[bridge].volume]);
    double bound = 0;
    std::vector<std::vector<Box3>> all;
    if (!maps.boxes(part.box(), &all)) bound = HUGE_VAL;
    for (const auto& points : all) bound = std::max(bound, bound_of(points));
    num_all_ += all.size();
    nodes_.push({bound, bridge, std::move(part)});
  }

  // The least bound that one triangle gives for all of the points.
  double bound_of(const std::vector<Box3>& points) {
    Box3d box = empty_box();
    for (const Box3& p : points) {
      add({p[0].lo(), p[1].lo(), p[2].lo()}, &box);
      add({p[0].hi(), p[1].hi(), p[2].hi()}, &box);
    }
    const auto bound_by = [&](std::uint32_t f, double most) {
      const auto corners = parts_.facets.corners(f);
      double bound = 0;
      for (const Box3& p : points) {
        bound = std::max(bound, distance_bound(p, corners));
        if (bound >= most) break;
      }
      return bound;
    };
    double best = HUGE_VAL;
    // A growing box around the points: what it misses is no better than what it has, once it has grown by the bound.
    double reach = std::max(extent(box), std::ldexp(scale(), -40));
    while (true) {
      Box3d grown = box;
      for (std::size_t c = 0; c < 3; ++c) grown.lo[c] -= reach, grown.hi[c] += reach;
      parts_.facets.visit(grown,
                          [&](std::uint32_t f) { best = std::min(best, bound_by(f, best)); });
      if (best <= reach || reach > 4 * scale()) break;
      reach = std::isfinite(best) ? std::min(best, 4 * reach) : 4 * reach;
    }
    // No bound is less than the distance of a point; approximately that of the first one.
    least_ = std::max(least_, nearest_to(points.front(), best));
    return best;
  }
  double nearest_to(const Box3& point, double most) const {
    Box3d box{{point[0].lo() - most, point[1].lo() - most, point[2].lo() - most},
              {point[0].hi() + most, point[1].hi() + most, point[2].hi() + most}};
    double best = most;
    parts_.facets.visit(box, [&](std::uint32_t f) {
      best = std::min(best, distance_bound(point, parts_.facets.corners(f)));
    });
    return best;
  }
  double scale() const {
    const Box3d& b = parts_.classifier.box();
    double out = extent(b);
    for (std::size_t c = 0; c < 3; ++c) out = std::max({out, std::abs(b.lo[c]), std::abs(b.hi[c])});
    return out;
  }

  const InsideParts& parts_;
  std::vector<std::size_t> num_nodes_;  // of each bridge
  std::size_t num_all_ = 0;             // each as often as it has spans
  std::priority_queue<SkinNode, std::vector<SkinNode>, IsNearer> nodes_;
  double least_ = 0;  // approximately no bound is less
};

// A number of 20 bits or fewer, greater by a factor of at least 1 + 2^-30.
Rational short_above(double bound) {
  constexpr int kBits = 20;
  const Rational least = Rational::from_double(bound) * (Rational(1) + Rational::power_of_two(-30));
  int exponent = 0;
  std::frexp(bound, &exponent);
  const Rational unit = Rational::power_of_two(exponent - kBits);
  const Rational count = least / unit;
  return Rational(-floor_divide(-count.numerator(), count.denominator())) * unit;
}

}  // namespace

std::optional<InsideDefect> skin_defect(const InsideParts& parts, std::optional<Rational>* out) {
  if (parts.micro.bridges.empty()) return std::nullopt;
  const ScopedUpward upward;
  SkinSearch search(parts);
  if (const auto bridge = search.run())
    return InsideDefect{"I4",
                        {},
                        *bridge,
                        {},
                        "the distance of the end of bridge " + std::to_string(*bridge) +
                            " from the surface of the solid has no bound"};
  *out = short_above(search.bound());
  return std::nullopt;
}

}  // namespace veritope::internal
