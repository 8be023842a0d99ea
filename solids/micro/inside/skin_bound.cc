// SPDX-License-Identifier: LGPL-3.0-or-later
// I4: how far the end faces of bridges and sweeps are from the surface of the solid, at most.
#include <algorithm>
#include <cmath>
#include <queue>
#include <string>
#include <tuple>
#include <utility>

#include "interval/box_geometry.h"
#include "interval/upward.h"
#include "robust/base/check.h"
#include "solids/classify/triangle_bound.h"
#include "solids/micro/inside/descent_internal.h"
#include "solids/micro/inside/inside_parts_internal.h"
#include "solids/micro/sweep_nodes.h"
#include "solids/micro/sweep_start.h"

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
  PatchNode part;                // of a bridge
  std::uint32_t sweep_part = 0;  // of a sweep
  int level = 0;
};
struct IsNearer {
  bool operator()(const SkinNode& a, const SkinNode& b) const {
    return a.bound != b.bound ? a.bound < b.bound : a.bridge > b.bridge;
  }
};

class SkinSearch {
 public:
  explicit SkinSearch(const InsideParts& parts)
      : parts_(parts), num_nodes_(parts.micro.num_bridges()) {
    const SweepStarts starts(parts.micro, parts.tiles);
    for (const MicroSweep& s : parts.micro.sweeps)
      sweeps_.emplace_back(starts.wall(s.cap), starts.cap(s.cap).value(), s.axis);
  }

  // The number of the bridge whose bound is infinite, if there is one.
  std::optional<std::uint32_t> run() {
    for (std::uint32_t b = 0; b < parts_.micro.bridges.size(); ++b) {
      push({0, b, end_face(parts_.micro.bridges[b]), 0, 0});
      if (!std::isfinite(nodes_.top().bound)) return b;
    }
    for (std::uint32_t s = 0; s < sweeps_.size(); ++s) {
      push({0, s, {}, 0, 0});
      if (!std::isfinite(nodes_.top().bound)) return s;
    }
    while (nodes_.top().bound > kWorth * least_) {
      const SkinNode top = nodes_.top();
      if (top.level >= kMostLevel || num_nodes_[top.bridge] + 2 > kMostNodes ||
          num_all_ > kAllSkinNodes + kMoreNodes * num_nodes_.size())
        break;
      nodes_.pop();
      auto halves = halves_of(top);
      push(std::move(halves.first));
      push(std::move(halves.second));
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

  std::pair<SkinNode, SkinNode> halves_of(const SkinNode& node) {
    std::pair<SkinNode, SkinNode> out;
    out.first.bridge = out.second.bridge = node.bridge;
    out.first.level = out.second.level = node.level + 1;
    if (sweeps_.empty())
      std::tie(out.first.part, out.second.part) = node.part.halves();
    else
      std::tie(out.first.sweep_part, out.second.sweep_part) =
          sweeps_[node.bridge].halves_of_part(node.sweep_part);
    return out;
  }
  // Finds the bound.
  void push(SkinNode node) {
    ++num_nodes_[node.bridge];
    std::vector<std::vector<Box3>> all;
    if (!sweeps_.empty())
      sweeps_[node.bridge].end_points(node.sweep_part, &all.emplace_back());
    else if (!BridgeMaps(parts_.volumes[parts_.micro.bridges[node.bridge].volume])
                  .boxes(node.part.box(), &all))
      node.bound = HUGE_VAL;
    for (const auto& points : all) node.bound = std::max(node.bound, bound_of(points));
    num_all_ += all.size();
    nodes_.push(std::move(node));
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
  std::vector<SweepNodes> sweeps_;      // then there are no bridges
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
  if (parts.micro.num_bridges() == 0) return std::nullopt;
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
