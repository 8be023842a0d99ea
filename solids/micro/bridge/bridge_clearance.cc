// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/bridge/bridge_clearance_internal.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "interval/upward.h"
#include "solids/micro/surface/close_descent.h"

namespace veritope {
namespace {

using internal::HullPoints;
using internal::VolumeSpace;

constexpr int kMostClearanceLevels = 24, kMostClearanceNodes = 4096;
constexpr std::uint64_t kMostClearancePairs = std::uint64_t{1} << 24;
constexpr int kMostEndLevels = 12, kMostEndNodes = 1024;

// How nets of bridges are halved: along the axis along which they are longest, in units of `unit`.
struct NetShape {
  Grid<3> grid;
  Point3d unit{1, 1, 1};
};
// Part of a polynomial map of [0,1]^3, by its Bernstein coefficients.
struct NetNode {
  std::vector<Box3> points;
  const NetShape* shape = nullptr;
  int level = 0;

  Box3d box() const { return box_around(points); }
  std::pair<NetNode, NetNode> halves() const;

 private:
  std::size_t longest_axis() const;
};

std::size_t NetNode::longest_axis() const {
  const Grid<3>& grid = shape->grid;
  std::size_t best = 0;
  double most = -1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (grid.size[axis] < 2) continue;
    double length = 0;
    const std::size_t span = (grid.size[axis] - 1) * grid.stride(axis);
    grid.for_each_line(axis, [&](std::size_t first) {
      double sum = 0;
      for (std::size_t c = 0; c < 3; ++c)
        sum += std::abs(points[first + span][c].hi() - points[first][c].hi()) / shape->unit[c];
      length = std::max(length, sum);
    });
    if (length > most) {
      most = length;
      best = axis;
    }
  }
  return best;
}

std::pair<NetNode, NetNode> NetNode::halves() const {
  std::pair<NetNode, NetNode> out{*this, *this};
  out.first.level = out.second.level = level + 1;
  const Grid<3>& grid = shape->grid;
  const std::size_t axis = longest_axis(), step = grid.stride(axis), n = grid.size[axis] - 1;
  const Interval half(0.5);
  grid.for_each_line(axis, [&](std::size_t first) {
    std::vector<Box3> line;
    for (std::size_t i = 0; i <= n; ++i) line.push_back(points[first + i * step]);
    for (std::size_t r = 0; r <= n; ++r) {
      out.first.points[first + r * step] = line[0];
      out.second.points[first + (n - r) * step] = line[n - r];
      for (std::size_t i = 0; i + r < n; ++i) line[i] = half * (line[i] + line[i + 1]);
    }
  });
  return out;
}

NetNode node_of(const MicroBridge& bridge, const NetShape& shape) {
  NetNode out;
  out.shape = &shape;
  const bool end_only = shape.grid.size[2] == 1;
  for (std::size_t i = 0; i < bridge.points.size(); ++i) {
    if (end_only && i % 3 != 2) continue;
    const TilePoint& p = bridge.points[i];
    out.points.push_back(Box3(enclose(p[0]), enclose(p[1]), enclose(p[2])));
  }
  return out;
}
NetShape shape_of(const MicroBridge& bridge, std::size_t rows) {
  return {{{static_cast<std::size_t>(bridge.degrees[0]) + 1,
            static_cast<std::size_t>(bridge.degrees[1]) + 1, rows}},
          {1, 1, 1}};
}

// Approximate lengths of the volume's axes near the node, to compare them: 1 over the length of a unit in space.
Point3d unit_of(const VolumeSpace& volume, const Box3d& box) {
  Point3d unit = {1, 1, 1};
  if (const auto place = volume.place(approx_centre(box)))
    for (std::size_t a = 0; a < 3; ++a) {
      const Point3d& d = place->partial[a];
      const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
      if (length > 0 && std::isfinite(length)) unit[a] = 1 / length;
    }
  return unit;
}

}  // namespace

bool misses_surface(SurfaceView& surface, const VolumeSpace& volume, const MicroBridge& bridge) {
  const ScopedUpward upward;
  NetShape shape = shape_of(bridge, 3);
  NetNode root = node_of(bridge, shape);
  shape.unit = unit_of(volume, root.box());
  std::vector<HullPoints> hulls;
  Box3d box = empty_box();
  if (volume.hulls(root.box(), &hulls))
    for (const HullPoints& points : hulls) box = hull(box, box_around(points));
  else
    box = {{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, HUGE_VAL, HUGE_VAL}};
  DescentBudget budget({kMostClearanceNodes, kMostClearancePairs});
  std::vector<NodePoints> images;
  const auto close_to = [&](const NetNode& node, PartNumbers* near) {
    hulls.clear();
    if (!volume.hulls(node.box(), &hulls)) return;
    images.resize(hulls.size());
    for (std::size_t i = 0; i < hulls.size(); ++i) images[i].assign(hulls[i]);
    budget.add_pairs(surface.keep_close(images, near));
  };
  const auto left =
      descend(std::move(root), surface.near(box), kMostClearanceLevels, budget, close_to);
  return !left && !budget.is_spent();
}

std::optional<double> end_distance(SurfaceView& surface, const VolumeSpace& volume,
                                   const MicroBridge& bridge, double most) {
  const ScopedUpward upward;
  NetShape shape = shape_of(bridge, 1);
  std::vector<NetNode> stack = {node_of(bridge, shape)};
  shape.unit = unit_of(volume, stack.back().box());
  std::vector<HullPoints> hulls;
  int left = kMostEndNodes;
  double worst = 0;
  while (!stack.empty()) {
    const NetNode node = std::move(stack.back());
    stack.pop_back();
    hulls.clear();
    if (!volume.hulls(node.box(), &hulls)) return std::nullopt;
    double here = 0;
    for (const HullPoints& points : hulls)
      if (here <= most) here = std::max(here, surface.reach(points, most));
    if (here <= most) {
      worst = std::max(worst, here);
      continue;
    }
    if (node.level >= kMostEndLevels || --left < 0) return std::nullopt;
    auto [low, high] = node.halves();
    stack.push_back(std::move(low));
    stack.push_back(std::move(high));
  }
  return worst;
}

bool misses_surface(SurfaceView& surface, SweepNodes& sweep) {
  const ScopedUpward upward;
  DescentBudget budget({kMostClearanceNodes, kMostClearancePairs});
  HullPoints points;
  NodePoints image;
  const auto close_to = [&](const SweepPart& part, PartNumbers* near) {
    sweep.points(part.node, &points);
    image.assign(points);
    budget.add_pairs(surface.keep_close({&image, 1}, near));
  };
  const auto left = descend(SweepPart{&sweep, {}, 0}, surface.near(sweep.box({})),
                            kMostClearanceLevels, budget, close_to);
  return !left && !budget.is_spent();
}

std::optional<double> end_distance(SurfaceView& surface, SweepNodes& sweep, double most) {
  const ScopedUpward upward;
  std::vector<std::pair<std::uint32_t, int>> stack = {{0, 0}};  // parts and their levels
  HullPoints points;
  int left = kMostEndNodes;
  double worst = 0;
  while (!stack.empty()) {
    const auto [part, level] = stack.back();
    stack.pop_back();
    sweep.end_points(part, &points);
    const double here = surface.reach(points, most);
    if (here <= most) {
      worst = std::max(worst, here);
      continue;
    }
    if (level >= kMostEndLevels || --left < 0) return std::nullopt;
    const auto [low, high] = sweep.halves_of_part(part);
    stack.emplace_back(low, level + 1);
    stack.emplace_back(high, level + 1);
  }
  return worst;
}

}  // namespace veritope
