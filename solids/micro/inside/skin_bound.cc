// SPDX-License-Identifier: LGPL-3.0-or-later
// I4: how far the end faces of bridges are from the surface of the solid, at most.
#include <algorithm>
#include <cmath>
#include <memory>
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
constexpr int kMostSkinLevel = 22;     // the page has 24
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

class SkinSearch {
 public:
  explicit SkinSearch(const InsideParts& parts)
      : parts_(parts),
        num_nodes_(parts.micro.bridges.size()),
        view_(parts.solid.surface().view()) {}

  // The number of the bridge whose bound is infinite, if there is one.
  std::optional<std::uint32_t> run() {
    for (std::uint32_t b = 0; b < parts_.micro.bridges.size(); ++b) {
      push(b, end_face(parts_.micro.bridges[b]));
      if (!std::isfinite(nodes_.top().bound)) return b;
    }
    while (nodes_.top().bound > kWorth * least_) {
      const SkinNode top = nodes_.top();
      if (top.part.level >= kMostSkinLevel || num_nodes_[top.bridge] + 2 > kMostNodes ||
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

  // The least bound that one part of the surface gives for all of the points.
  double bound_of(const std::vector<Box3>& points) {
    const double best = view_->reach(points, HUGE_VAL);
    // No bound is less than the distance of a point; approximately that of the first one.
    least_ = std::max(least_, view_->reach({points.data(), 1}, best));
    return best;
  }

  const InsideParts& parts_;
  std::vector<std::size_t> num_nodes_;  // of each bridge
  std::size_t num_all_ = 0;             // each as often as it has spans
  std::unique_ptr<SurfaceView> view_;
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
