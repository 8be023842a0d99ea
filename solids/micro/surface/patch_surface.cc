// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/surface/patch_surface.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <queue>

#include "interval/box_geometry.h"
#include "interval/upward.h"

namespace veritope {

namespace {

// Patches are cut in advance until there are about so many nodes.
constexpr std::size_t kManyNodes = 4096;
constexpr int kMostLevelInAdvance = 16;
constexpr int kMostReachLevel = 22;  // the page has 24
// The halves of a node are hoped to save this part of its radius; a bound that is as near to what is hoped for is not
// improved.
constexpr double kReachHope = 0.5, kReachWorth = 1 + 0x1p-6;
constexpr std::size_t kMostReachSteps = 512;

// Claim    no point of the hull of a is farther from any point of the hull of b.
// Bound    the distance of two points is a convex function of both, so it is greatest for two of the lists; middles
//          differ by the coordinates' differences, each off by a factor within 1 +- 2^-52 and then squared and added
//          with four more roundings or fewer, of which underflow takes less than 2^-1000; radii are added.
double greatest_distance(const NodePoints& a, const NodePoints& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) {
      const double x = a.middles[0][i] - b.middles[0][j], y = a.middles[1][i] - b.middles[1][j],
                   z = a.middles[2][i] - b.middles[2][j];
      most = std::max(most, x * x + y * y + z * z);
    }
  Interval out = sqrt(Interval(most) * Interval(1 + 0x1p-46) + Interval(0x1p-1000));
  for (std::size_t c = 0; c < 3; ++c) out += Interval(a.radius[c]) + Interval(b.radius[c]);
  return out.hi();
}

// Approximate: the greatest distance of one of the points from the middle of the box.
double approx_reach(const NodePoints& points, const Box3d& box) {
  const Point3d middle = approx_centre(box);
  double most = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points.middles[0][i] - middle[0], y = points.middles[1][i] - middle[1],
                 z = points.middles[2][i] - middle[2];
    most = std::max(most, x * x + y * y + z * z);
  }
  return std::sqrt(most);
}
// Approximate: half of the diagonal.
double approx_radius_of(const Box3d& box) {
  return 0.5 * std::hypot(box.hi[0] - box.lo[0], box.hi[1] - box.lo[1], box.hi[2] - box.lo[2]);
}

using ReachQueue =
    std::priority_queue<std::pair<double, std::uint32_t>,
                        std::vector<std::pair<double, std::uint32_t>>, std::greater<>>;

// The nodes of the surface, and further halves of them as they are asked for, numbered one after the other.
class PatchView final : public SurfaceView {
 public:
  explicit PatchView(const PatchSurface& surface)
      : surface_(surface), num_shared_(static_cast<std::uint32_t>(surface.nodes().size())) {}

  PartNumbers near(const Box3d& box) override {
    PartNumbers out;
    surface_.visit(box, [&](std::uint32_t p) { out.push_back(p); });
    return out;
  }
  std::uint64_t keep_close(std::span<const NodePoints> node, PartNumbers* parts) override;
  double reach(std::span<const Box3> points, double most, double enough) override;
  std::uint32_t source(std::uint32_t part) const override { return node(part).piece().patch(); }

 private:
  const SurfaceNode& node(std::uint32_t number) const {
    return number < num_shared_ ? surface_.nodes()[number] : own_[number - num_shared_];
  }
  // The number of the first half; the other one is next to it.
  std::uint32_t halves_of(std::uint32_t number) {
    const auto [at, is_new] = first_half_.try_emplace(number, 0);
    if (!is_new) return at->second;
    at->second = num_shared_ + static_cast<std::uint32_t>(own_.size());
    auto [low, high] = node(number).halves();
    own_.push_back(std::move(low));
    own_.push_back(std::move(high));
    return at->second;
  }

  const PatchSurface& surface_;
  std::uint32_t num_shared_;
  std::deque<SurfaceNode> own_;
  std::map<std::uint32_t, std::uint32_t> first_half_;
  NodePoints scratch_;
};

// A node of the surface that is larger than the other one is halved first: otherwise all parts of that would meet it.
std::uint64_t PatchView::keep_close(std::span<const NodePoints> other, PartNumbers* parts) {
  Box3d box = empty_box();
  for (const NodePoints& points : other) box = hull(box, points.box);
  const double size = extent(box);
  std::uint64_t pairs = 0;
  PartNumbers stack(parts->rbegin(), parts->rend());
  parts->clear();
  while (!stack.empty()) {
    const std::uint32_t number = stack.back();
    stack.pop_back();
    const SurfaceNode& here = node(number);
    if (!meets(here.points().box, box)) continue;
    bool is_met = false, is_apart = true;
    for (const NodePoints& points : other) {
      if (!meets(here.points().box, points.box)) continue;
      is_met = true;
      is_apart = is_apart && here.is_apart(points);
    }
    pairs += is_met;
    if (is_apart) continue;
    if (extent(here.points().box) <= size || !here.can_halve()) {
      parts->push_back(number);
      continue;
    }
    const std::uint32_t first = halves_of(number);
    stack.push_back(first + 1);
    stack.push_back(first);
  }
  return pairs;
}

// Nodes in the order of the distances of their middles, of which large ones may be better than they look; those in a
// growing box around the points: what it misses is no better than what it has, once it has grown by the bound.
double PatchView::reach(std::span<const Box3> points, double most, double enough) {
  scratch_.assign(points);
  ReachQueue queue;
  const auto add = [&](std::uint32_t number) {
    const SurfaceNode& here = node(number);
    const double off = approx_reach(scratch_, here.points().box),
                 radius = approx_radius_of(here.points().box);
    if (off - radius <= most && here.level() <= kMostReachLevel)
      queue.emplace(off - kReachHope * radius, number);
  };
  const Box3d& box = scratch_.box;
  const double farthest = std::min(most, 2 * extent(hull(box, surface_.box())));
  double best = HUGE_VAL, grow = std::max(extent(box), 0x1p-6 * extent(surface_.box()));
  while (true) {
    grow = std::min(grow, farthest);
    Box3d grown = box;
    for (std::size_t c = 0; c < 3; ++c) grown.lo[c] -= grow, grown.hi[c] += grow;
    queue = {};
    surface_.visit(grown, add);
    for (std::size_t step = 0; step < kMostReachSteps && !queue.empty(); ++step) {
      const auto [least, number] = queue.top();
      queue.pop();
      best = std::min(best, greatest_distance(scratch_, node(number).points()));
      if (best <= enough) return best;
      if (best <= kReachWorth * least) break;
      if (node(number).level() >= kMostReachLevel) continue;
      const std::uint32_t first = halves_of(number);
      add(first);
      add(first + 1);
    }
    if (best <= grow || grow >= farthest) break;
    grow *= 4;
  }
  return best <= most ? best : HUGE_VAL;
}

}  // namespace

SurfaceNode::SurfaceNode(PatchPiece piece, int level) : piece_(std::move(piece)), level_(level) {
  using namespace internal;
  const BezierSurface<Interval>& net = piece_.net();
  std::vector<Box3> points(net.grid().count());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      points[i][c] = net.component(static_cast<int>(c))[i];
      if (net.is_rational()) points[i][c] = points[i][c] / net.component(3)[i];
    }
  points_.assign(points);
  std::array<Point3d, 4> p;
  for (std::size_t i = 0; i < 4; ++i) p[i] = approx_middle(piece_.corners()[i]);
  Point3d u, v;
  for (std::size_t c = 0; c < 3; ++c) {
    u[c] = (p[1][c] - p[0][c]) + (p[3][c] - p[2][c]);
    v[c] = (p[2][c] - p[0][c]) + (p[3][c] - p[1][c]);
  }
  slab_ = slab_around(
      {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]}, points);
}

std::pair<SurfaceNode, SurfaceNode> SurfaceNode::halves() const {
  auto [low, high] = piece_.halves(static_cast<std::size_t>(level_) % 2);
  return {SurfaceNode(std::move(low), level_ + 1), SurfaceNode(std::move(high), level_ + 1)};
}

PatchSurface::PatchSurface(const PatchComplex& complex) {
  const ScopedUpward upward;
  const auto is_smaller = [](const SurfaceNode& a, const SurfaceNode& b) {
    return extent(a.points().box) < extent(b.points().box);
  };
  for (std::uint32_t p = 0; p < complex.patches().size(); ++p)
    nodes_.emplace_back(PatchPiece(complex.patch(p), p));
  std::make_heap(nodes_.begin(), nodes_.end(), is_smaller);
  while (nodes_.size() < kManyNodes && nodes_.front().level() < kMostLevelInAdvance) {
    std::pop_heap(nodes_.begin(), nodes_.end(), is_smaller);
    auto [low, high] = nodes_.back().halves();
    nodes_.back() = std::move(low);
    std::push_heap(nodes_.begin(), nodes_.end(), is_smaller);
    nodes_.push_back(std::move(high));
    std::push_heap(nodes_.begin(), nodes_.end(), is_smaller);
  }
  std::vector<Box3d> boxes;
  for (const SurfaceNode& node : nodes_) {
    boxes.push_back(node.points().box);
    box_ = hull(box_, boxes.back());
  }
  tree_ = BoxHierarchy(boxes);
}

std::unique_ptr<SurfaceView> PatchSurface::view() const {
  return std::make_unique<PatchView>(*this);
}

}  // namespace veritope
