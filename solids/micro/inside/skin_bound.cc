// SPDX-License-Identifier: LGPL-3.0-or-later
// I4: how far the end faces of bridges and sweeps are from the surface of the solid, at most.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

#include "interval/box_geometry.h"
#include "interval/upward.h"
#include "robust/base/check.h"
#include "solids/micro/inside/descent_internal.h"
#include "solids/micro/inside/inside_parts_internal.h"
#include "solids/micro/sweep_nodes.h"
#include "solids/micro/sweep_start.h"

namespace veritope::internal {

namespace {

constexpr std::size_t kMostNodes = 2048;  // of a bridge; the page has 4096
// The page has 2^22 nodes, and 256 more for each bridge.
constexpr std::size_t kAllSkinNodes = std::size_t{1} << 21, kMoreNodes = 128;
constexpr int kMostSkinLevel = 22;  // the page has 24
constexpr int kSampleLevel = 8;     // of a part of a sweep's end that stands for a point
constexpr double kFirstSkinFactor = 1 + 0x1p-7, kMostSkinFactor = 4;

// A part of the end face of a bridge, or of a sweep.
struct EndPart {
  PatchNode part;
  std::uint32_t sweep_part = 0;
  int level = 0;
};

// Proves bounds for one bridge after the other, each at least as great as the last.
class SkinSearch {
 public:
  explicit SkinSearch(const InsideParts& parts)
      : parts_(parts), view_(parts.solid.surface().view()) {
    most_all_ = kAllSkinNodes + kMoreNodes * parts.micro.num_bridges();
    const SweepStarts starts(parts.micro, parts.tiles);
    for (const MicroSweep& s : parts.micro.sweeps)
      sweeps_.emplace_back(starts.wall(s.cap), starts.cap(s.cap).value(), s.axis);
  }

  // The number of a bridge for which no bound is proved, if there is one.
  std::optional<std::uint32_t> run() {
    const auto count = static_cast<std::uint32_t>(parts_.micro.num_bridges());
    for (std::uint32_t b = 0; b < count; ++b)
      sweeps_.empty() ? raise_to_samples(b) : raise_to_corner(sweeps_[b]);
    bound_ *= kFirstSkinFactor;
    for (std::uint32_t b = 0; b < count; ++b) {
      double factor = kFirstSkinFactor;
      std::size_t spent = 0;
      while (!is_within(b, &spent)) {
        if (!std::isfinite(bound_)) return b;
        factor = std::min(factor * factor, kMostSkinFactor);
        bound_ = std::max(bound_ * factor, std::numeric_limits<double>::min());
      }
      num_all_ += spent;
    }
    return std::nullopt;
  }
  double bound() const { return bound_; }

 private:
  PatchNode end_face(std::uint32_t number) const {
    const MicroBridge& bridge = parts_.micro.bridges[number];
    PatchNode out{bridge.degrees, {}, 0};
    for (int i = 0; i <= bridge.degrees[0]; ++i)
      for (int j = 0; j <= bridge.degrees[1]; ++j) {
        const TilePoint& p = bridge.points[bridge.at(i, j, kBridgeAxisDegree)];
        out.points.emplace_back(enclose(p[0]), enclose(p[1]), enclose(p[2]));
      }
    return out;
  }
  BridgeMaps maps_of(std::uint32_t bridge) const {
    return BridgeMaps(parts_.volumes[parts_.micro.bridges[bridge].volume]);
  }

  // The bound is not less than the distance of any point of the end face, such as its corners and its middle.
  void raise_to_samples(std::uint32_t bridge) {
    const PatchNode face = end_face(bridge);
    const std::size_t n = face.points.size(),
                      columns = static_cast<std::size_t>(face.degrees[1]) + 1;
    std::vector<Box3> samples = {face.points.front(), face.points[columns - 1],
                                 face.points[n - columns], face.points.back()};
    samples.push_back(face.halves().second.halves().second.points.front());
    for (const Box3& x : samples) {
      std::vector<std::vector<Box3>> image;
      if (!maps_of(bridge).boxes(x, &image)) continue;
      const double distance = view_->reach({image.front().data(), 1}, HUGE_VAL, bound_);
      if (std::isfinite(distance)) bound_ = std::max(bound_, distance);
    }
  }

  // The same for a small part of the end of a sweep: a bound that is close to the distance of its points.
  void raise_to_corner(SweepNodes& sweep) {
    std::uint32_t part = 0;
    for (int level = 0; level < kSampleLevel; ++level) part = sweep.halves_of_part(part).first;
    std::vector<Box3> points;
    sweep.end_points(part, &points);
    const double distance = view_->reach(points, HUGE_VAL, bound_);
    if (std::isfinite(distance)) bound_ = std::max(bound_, distance);
  }

  // The points of a part, a list for each span that it meets; false if a weight may be 0.
  bool points_of(std::uint32_t bridge, const EndPart& node, std::vector<std::vector<Box3>>* out) {
    if (sweeps_.empty()) return maps_of(bridge).boxes(node.part.box(), out);
    sweeps_[bridge].end_points(node.sweep_part, &out->emplace_back());
    return true;
  }
  std::pair<EndPart, EndPart> halves_of(std::uint32_t bridge, const EndPart& node) {
    std::pair<EndPart, EndPart> out;
    out.first.level = out.second.level = node.level + 1;
    if (sweeps_.empty())
      std::tie(out.first.part, out.second.part) = node.part.halves();
    else
      std::tie(out.first.sweep_part, out.second.sweep_part) =
          sweeps_[bridge].halves_of_part(node.sweep_part);
    return out;
  }

  // Whether the descent of I4 ends for this bridge and the bound. Sets *spent to its nodes, each as often as it has
  // spans.
  bool is_within(std::uint32_t bridge, std::size_t* spent) {
    std::size_t num_nodes = 0;
    *spent = 0;
    std::vector<EndPart> stack(1);
    if (sweeps_.empty()) stack[0].part = end_face(bridge);
    std::vector<std::vector<Box3>> all;
    while (!stack.empty()) {
      const EndPart node = std::move(stack.back());
      stack.pop_back();
      all.clear();
      const bool is_known = points_of(bridge, node, &all);
      *spent += all.size();
      if (++num_nodes > kMostNodes || num_all_ + *spent > most_all_) return false;
      if (is_known && std::ranges::all_of(all, [&](const auto& points) {
            return view_->reach(points, bound_, bound_) <= bound_;
          }))
        continue;
      if (node.level >= kMostSkinLevel) return false;
      auto halves = halves_of(bridge, node);
      stack.push_back(std::move(halves.second));
      stack.push_back(std::move(halves.first));
    }
    return true;
  }

  const InsideParts& parts_;
  std::unique_ptr<SurfaceView> view_;
  std::vector<SweepNodes> sweeps_;  // then there are no bridges
  std::size_t num_all_ = 0, most_all_ = 0;
  double bound_ = 0;
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
