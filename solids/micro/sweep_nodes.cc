// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/sweep_nodes.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "splines/bezier_domain.h"

namespace veritope {
namespace {

Box3 enclosed_vector(const TilePoint& p) {
  return Box3(enclose(p[0]), enclose(p[1]), enclose(p[2]));
}
Box3 half_sum(const Box3& a, const Box3& b) { return Interval(0.5) * (a + b); }

// A part of [0, 1] that contains the interval.
std::array<Rational, 2> part_around(const Interval& x) {
  double lo = std::clamp(x.lo(), 0.0, 1.0), hi = std::clamp(x.hi(), 0.0, 1.0);
  if (!(lo < hi)) {
    lo = std::max(0.0, std::nextafter(lo, 0.0));
    hi = std::min(1.0, std::nextafter(hi, 1.0));
  }
  return {Rational::from_double(lo), Rational::from_double(hi)};
}

Box3d box_around(const std::vector<Box3>& points) {
  Box3d out = empty_box();
  for (const Box3& p : points) {
    add({p[0].lo(), p[1].lo(), p[2].lo()}, &out);
    add({p[0].hi(), p[1].hi(), p[2].hi()}, &out);
  }
  return out;
}

}  // namespace

SweepNodes::SweepNodes(BezierSurface<Interval> wall, const BezierSurface<Rational>& cap,
                       const std::array<TilePoint, 2>& axis)
    : wall_(std::move(wall)), cap_grid_(cap.grid()), end_(enclosed_vector(axis[1])) {
  Part whole;
  for (std::size_t i = 0; i < cap_grid_.count(); ++i)
    whole.net.push_back({enclose(cap.component(0)[i]), enclose(cap.component(1)[i])});
  add_part(std::move(whole));
  steps_.push_back(
      {{Box3(Interval(0.0), Interval(0.0), Interval(0.0)), enclosed_vector(axis[0]), end_}, {}});
}

// Where a weight may not be positive, the point may be anywhere.
std::uint32_t SweepNodes::add_part(Part part) {
  BezierSurface<Interval> map = wall_;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    Interval x = part.net.front()[axis];
    for (const auto& p : part.net) x = hull(x, p[axis]);
    const auto [lo, hi] = part_around(x);
    map = restricted(std::move(map), axis, lo, hi);
  }
  for (std::size_t i = 0; i < map.grid().count(); ++i) {
    Box3 p(map.component(0)[i], map.component(1)[i], map.component(2)[i]);
    if (map.is_rational()) {
      const Interval& w = map.component(3)[i];
      for (std::size_t c = 0; c < 3; ++c)
        p[c] = w.sign() == Sign3::kPositive ? p[c] / w : Interval::entire();
    }
    part.points.push_back(p);
  }
  part.box = box_around(part.points);
  parts_.push_back(std::move(part));
  return static_cast<std::uint32_t>(parts_.size() - 1);
}

std::pair<std::uint32_t, std::uint32_t> SweepNodes::halves_of_part(std::uint32_t number) {
  if (parts_[number].halves) return *parts_[number].halves;
  Part low, high;
  low.level = high.level = parts_[number].level + 1;
  low.net = high.net = parts_[number].net;
  const std::size_t axis = static_cast<std::size_t>(parts_[number].level) % 2,
                    step = cap_grid_.stride(axis), n = cap_grid_.size[axis] - 1;
  const Interval half(0.5);
  cap_grid_.for_each_line(axis, [&](std::size_t first) {
    for (std::size_t r = 1; r <= n; ++r) {
      for (std::size_t i = 0; i + r <= n; ++i)
        for (std::size_t c = 0; c < 2; ++c) {
          Interval& x = high.net[first + i * step][c];
          x = half * (x + high.net[first + (i + 1) * step][c]);
        }
      low.net[first + r * step] = high.net[first];
    }
  });
  const std::uint32_t a = add_part(std::move(low)), b = add_part(std::move(high));
  parts_[number].halves = {a, b};
  return {a, b};
}

std::pair<std::uint32_t, std::uint32_t> SweepNodes::halves_of_step(std::uint32_t number) {
  if (steps_[number].halves) return *steps_[number].halves;
  const auto [p, q, r] = steps_[number].points;
  const Box3 left = half_sum(p, q), right = half_sum(q, r), middle = half_sum(left, right);
  const auto a = static_cast<std::uint32_t>(steps_.size());
  steps_.push_back({{p, left, middle}, {}});
  steps_.push_back({{middle, right, r}, {}});
  steps_[number].halves = {a, a + 1};
  return {a, a + 1};
}

std::pair<SweepNodes::Node, SweepNodes::Node> SweepNodes::halves(const Node& node) {
  std::pair<Node, Node> out{node, node};
  out.first.level = out.second.level = node.level + 1;
  if (node.level % 3 == 2)
    std::tie(out.first.step, out.second.step) = halves_of_step(node.step);
  else
    std::tie(out.first.part, out.second.part) = halves_of_part(node.part);
  return out;
}

void SweepNodes::points(const Node& node, std::vector<Box3>* out) const {
  out->clear();
  for (const Box3& t : cap_points(node))
    for (const Box3& g : curve_points(node)) out->push_back(t + g);
}

Box3d SweepNodes::box(const Node& node) const {
  const Box3d& cap = parts_[node.part].box;
  Box3d out = empty_box();
  for (const Box3& g : curve_points(node)) {
    const Box3d moved = {
        {-(-cap.lo[0] - g[0].lo()), -(-cap.lo[1] - g[1].lo()), -(-cap.lo[2] - g[2].lo())},
        {cap.hi[0] + g[0].hi(), cap.hi[1] + g[1].hi(), cap.hi[2] + g[2].hi()}};
    out = hull(out, moved);
  }
  return out;
}

void SweepNodes::end_points(std::uint32_t part, std::vector<Box3>* out) const {
  out->clear();
  for (const Box3& t : parts_[part].points) out->push_back(t + end_);
}

}  // namespace veritope
