// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/sweep_nodes.h: parts of sweeps and points around them. Section 7b of
// docs/certificates/microstructure.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "interval/box.h"
#include "interval/ring_numbers.h"
#include "robust/base/box3d.h"
#include "solids/micro/micro_bridge.h"
#include "splines/bezier.h"

namespace veritope {

/// The parts of one sweep, which are made as they are asked for: not for several threads. All functions REQUIRE a live
/// ScopedUpward.
class SweepNodes {
 public:
  /// @param wall  the volume's map on the wall, of the unit square
  /// @param cap   a map of the unit square into it
  SweepNodes(BezierSurface<Interval> wall, const BezierSurface<Rational>& cap,
             const std::array<TilePoint, 2>& axis);

  /// A part of the cap times a part of the curve.
  struct Node {
    std::uint32_t part = 0, step = 0;
    int level = 0;
  };
  /// A node of level l is cut along the axis l mod 3.
  std::pair<Node, Node> halves(const Node& node);
  /// The sums of these points contain the node in their hull: the map's points on the part of the cap, and the
  /// Bernstein points of the curve.
  const std::vector<Box3>& cap_points(const Node& node) const { return parts_[node.part].points; }
  const std::array<Box3, 3>& curve_points(const Node& node) const {
    return steps_[node.step].points;
  }
  /// All sums.
  void points(const Node& node, std::vector<Box3>* out) const;
  /// A box around all of them.
  Box3d box(const Node& node) const;

  /// The points of the cap's part, moved to the end of the sweep, along f; halved alternately along both axes.
  void end_points(std::uint32_t part, std::vector<Box3>* out) const;
  std::pair<std::uint32_t, std::uint32_t> halves_of_part(std::uint32_t part);

 private:
  struct Part {
    std::vector<std::array<Interval, 2>> net;
    int level = 0;
    std::vector<Box3> points;
    Box3d box = empty_box();
    std::optional<std::pair<std::uint32_t, std::uint32_t>> halves;
  };
  struct Step {
    std::array<Box3, 3> points;
    std::optional<std::pair<std::uint32_t, std::uint32_t>> halves;
  };
  std::uint32_t add_part(Part part);
  std::pair<std::uint32_t, std::uint32_t> halves_of_step(std::uint32_t step);

  BezierSurface<Interval> wall_;
  Grid<2> cap_grid_;
  Box3 end_;
  std::vector<Part> parts_;
  std::vector<Step> steps_;
};

/// A part of a sweep that halves itself, as a node of descend() (solids/micro/surface/close_descent.h).
struct SweepPart {
  SweepNodes* sweep = nullptr;
  SweepNodes::Node node;
  int level = 0;

  std::pair<SweepPart, SweepPart> halves() const {
    const auto [a, b] = sweep->halves(node);
    return {{sweep, a, level + 1}, {sweep, b, level + 1}};
  }
};

}  // namespace veritope
