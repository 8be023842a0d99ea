// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/bridge/bridge_clearance_internal.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "interval/box_geometry.h"
#include "interval/upward.h"
#include "solids/classify/triangle_bound.h"

namespace veritope {
namespace {

using internal::HullPoints;
using internal::VolumeSpace;
using Facet = SkinFacets::Corners;

constexpr int kMostClearanceLevels = 24, kMostClearanceNodes = 4096;
constexpr int kMostEndLevels = 12, kMostEndNodes = 1024;
constexpr std::size_t kTriedFacets = 4;

Box3d outer_box_of_points(const HullPoints& points) {
  Box3d out = empty_box();
  for (const Box3& p : points)
    out = hull(out, Box3d{{p[0].lo(), p[1].lo(), p[2].lo()}, {p[0].hi(), p[1].hi(), p[2].hi()}});
  return out;
}
Point3d minus_of(const Vec3d& a, const Vec3d& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point3d cross_of(const Point3d& a, const Point3d& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot_of(const Point3d& a, const Point3d& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The hull of points, with their middles, which may be proved apart from facets.
class PointHull {
 public:
  explicit PointHull(const HullPoints& points) : points_(points) {
    for (const Box3& p : points)
      approx_.push_back({0.5 * (p[0].lo() + p[0].hi()), 0.5 * (p[1].lo() + p[1].hi()),
                         0.5 * (p[2].lo() + p[2].hi())});
  }
  // The directions of docs/certificates/micro-inside.md, section 3, but for the axes: the boxes meet.
  bool is_apart(const Facet& facet) const {
    const Point3d e0 = minus_of(facet[1], facet[0]), e1 = minus_of(facet[2], facet[1]),
                  e2 = minus_of(facet[0], facet[2]);
    const Point3d n = cross_of(e0, minus_of(facet[2], facet[0]));
    for (const Point3d& d : {n, cross_of(n, e0), cross_of(n, e1), cross_of(n, e2)})
      if (separates(d, facet) || separates({-d[0], -d[1], -d[2]}, facet)) return true;
    return false;
  }

 private:
  // Whether all points are below the facet.
  bool separates(const Point3d& d, const Facet& facet) const {
    double least = HUGE_VAL;
    for (const Vec3d& q : facet) least = std::min(least, dot_of(d, {q.x, q.y, q.z}));
    for (const Point3d& p : approx_)
      if (!(dot_of(d, p) < least)) return false;
    if (!std::isfinite(d[0] + d[1] + d[2])) return false;
    const Box3 direction{Interval(d[0]), Interval(d[1]), Interval(d[2])};
    double bound = HUGE_VAL;
    for (const Vec3d& q : facet)
      bound = std::min(
          bound, internal::dot(direction, Box3(Interval(q.x), Interval(q.y), Interval(q.z))).lo());
    return std::all_of(points_.begin(), points_.end(),
                       [&](const Box3& p) { return internal::dot(direction, p).hi() < bound; });
  }

  const HullPoints& points_;
  std::vector<Point3d> approx_;
};

// Part of a polynomial map of [0,1]^3, by its Bernstein coefficients.
struct NetNode {
  std::vector<Box3> points;
  int level = 0;
};

class NetHalver {
 public:
  NetHalver(std::array<std::size_t, 3> size) : grid_{size} {}

  Box3d box(const NetNode& node) const { return outer_box_of_points(node.points); }
  // The axis along which the net is longest, in units of `unit`.
  std::size_t longest(const NetNode& node, const Point3d& unit) const {
    std::size_t best = 0;
    double most = -1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (grid_.size[axis] < 2) continue;
      double length = 0;
      const std::size_t span = (grid_.size[axis] - 1) * grid_.stride(axis);
      grid_.for_each_line(axis, [&](std::size_t first) {
        double sum = 0;
        for (std::size_t c = 0; c < 3; ++c)
          sum += std::abs(node.points[first + span][c].hi() - node.points[first][c].hi()) / unit[c];
        length = std::max(length, sum);
      });
      if (length > most) {
        most = length;
        best = axis;
      }
    }
    return best;
  }
  std::pair<NetNode, NetNode> halves(const NetNode& node, std::size_t axis) const {
    std::pair<NetNode, NetNode> out{node, node};
    ++out.first.level;
    ++out.second.level;
    const std::size_t step = grid_.stride(axis), n = grid_.size[axis] - 1;
    const Interval half(0.5);
    grid_.for_each_line(axis, [&](std::size_t first) {
      std::vector<Box3> line;
      for (std::size_t i = 0; i <= n; ++i) line.push_back(node.points[first + i * step]);
      for (std::size_t r = 0; r <= n; ++r) {
        out.first.points[first + r * step] = line[0];
        out.second.points[first + (n - r) * step] = line[n - r];
        for (std::size_t i = 0; i + r < n; ++i) line[i] = half * (line[i] + line[i + 1]);
      }
    });
    return out;
  }

 private:
  Grid<3> grid_;
};

NetNode node_of(const MicroBridge& bridge, bool end_only) {
  NetNode out;
  for (std::size_t i = 0; i < bridge.points.size(); ++i) {
    if (end_only && i % 3 != 2) continue;
    const TilePoint& p = bridge.points[i];
    out.points.push_back(Box3(enclose(p[0]), enclose(p[1]), enclose(p[2])));
  }
  return out;
}
NetHalver halver_of(const MicroBridge& bridge, std::size_t rows) {
  return NetHalver({static_cast<std::size_t>(bridge.degrees[0]) + 1,
                    static_cast<std::size_t>(bridge.degrees[1]) + 1, rows});
}

// Approximate lengths of the volume's axes near the node, to compare them: 1 over the length of a unit in space.
Point3d unit_of(const VolumeSpace& volume, const Box3d& box) {
  Point3d unit = {1, 1, 1};
  if (const auto place = volume.place(approx_centre(box)))
    for (std::size_t a = 0; a < 3; ++a) {
      const double length = std::sqrt(dot_of(place->partial[a], place->partial[a]));
      if (length > 0 && std::isfinite(length)) unit[a] = 1 / length;
    }
  return unit;
}

bool hull_misses(const SkinFacets& skin, const HullPoints& points) {
  const PointHull hull(points);
  bool is_apart = true;
  skin.visit(outer_box_of_points(points),
             [&](std::uint32_t f) { is_apart = is_apart && hull.is_apart(skin.corners(f)); });
  return is_apart;
}
bool node_misses(const SkinFacets& skin, const VolumeSpace& volume, const Box3d& box,
                 std::vector<HullPoints>& hulls) {
  hulls.clear();
  if (!volume.hulls(box, &hulls)) return false;
  return std::all_of(hulls.begin(), hulls.end(),
                     [&](const HullPoints& points) { return hull_misses(skin, points); });
}

// The least bound that holds for all points and one facet, if it is at most `most`.
std::optional<double> bound_of(const SkinFacets& skin, const HullPoints& points, double most) {
  Box3d box = outer_box_of_points(points);
  const Point3d centre = approx_centre(box);
  for (std::size_t c = 0; c < 3; ++c) {
    box.lo[c] -= most;
    box.hi[c] += most;
  }
  const Box3 middle{Interval(centre[0]), Interval(centre[1]), Interval(centre[2])};
  std::vector<std::pair<double, std::uint32_t>> near;
  skin.visit(
      box, [&](std::uint32_t f) { near.emplace_back(distance_bound(middle, skin.corners(f)), f); });
  const std::size_t n = std::min(kTriedFacets, near.size());
  std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(n), near.end());
  std::optional<double> best;
  for (std::size_t i = 0; i < n; ++i) {
    double worst = 0;
    for (const Box3& p : points) {
      worst = std::max(worst, distance_bound(p, skin.corners(near[i].second)));
      if (!(worst <= most)) break;
    }
    if (worst <= most && (!best || worst < *best)) best = worst;
  }
  return best;
}

// Raises `worst` to what holds for all points of each hull; false if no bound up to `most` is proved for one of them.
bool raise_bound(const SkinFacets& skin, const std::vector<HullPoints>& hulls, double most,
                 double* worst) {
  double here = 0;
  for (const HullPoints& points : hulls) {
    const auto bound = bound_of(skin, points, most);
    if (!bound) return false;
    here = std::max(here, *bound);
  }
  *worst = std::max(*worst, here);
  return true;
}

// Whether the root is dropped, or all of its parts are, after so few halvings.
template <typename Node, typename Drops, typename Halves>
bool drops_all(Node root, int most_levels, int most_halvings, Drops drops, Halves halves) {
  std::vector<Node> stack;
  stack.push_back(std::move(root));
  while (!stack.empty()) {
    const Node node = std::move(stack.back());
    stack.pop_back();
    if (drops(node)) continue;
    if (node.level >= most_levels || --most_halvings < 0) return false;
    auto [low, high] = halves(node);
    stack.push_back(std::move(low));
    stack.push_back(std::move(high));
  }
  return true;
}

}  // namespace

SkinFacets::SkinFacets(const TriangleMesh& mesh) {
  std::vector<Box3d> boxes;
  for (const auto& t : mesh.faces) {
    corners_.push_back({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
    Box3d box = empty_box();
    for (const Vec3d& p : corners_.back()) add({p.x, p.y, p.z}, &box);
    boxes.push_back(box);
  }
  tree_ = BoxHierarchy(boxes);
}

bool misses_facets(const SkinFacets& skin, const VolumeSpace& volume, const MicroBridge& bridge) {
  const ScopedUpward upward;
  const NetHalver halver = halver_of(bridge, 3);
  NetNode root = node_of(bridge, false);
  const Point3d unit = unit_of(volume, halver.box(root));
  std::vector<HullPoints> hulls;
  return drops_all(
      std::move(root), kMostClearanceLevels, kMostClearanceNodes,
      [&](const NetNode& node) { return node_misses(skin, volume, halver.box(node), hulls); },
      [&](const NetNode& node) { return halver.halves(node, halver.longest(node, unit)); });
}

bool misses_facets(const SkinFacets& skin, SweepNodes& sweep) {
  const ScopedUpward upward;
  HullPoints points;
  return drops_all(
      SweepNodes::Node(), kMostClearanceLevels, kMostClearanceNodes,
      [&](const SweepNodes::Node& node) {
        sweep.points(node, &points);
        return hull_misses(skin, points);
      },
      [&](const SweepNodes::Node& node) { return sweep.halves(node); });
}

std::optional<double> end_distance(const SkinFacets& skin, const VolumeSpace& volume,
                                   const MicroBridge& bridge, double most) {
  const ScopedUpward upward;
  const NetHalver halver = halver_of(bridge, 1);
  NetNode root = node_of(bridge, true);
  const Point3d unit = unit_of(volume, halver.box(root));
  std::vector<HullPoints> hulls;
  double worst = 0;
  const bool are_bounded = drops_all(
      std::move(root), kMostEndLevels, kMostEndNodes,
      [&](const NetNode& node) {
        hulls.clear();
        return volume.hulls(halver.box(node), &hulls) && raise_bound(skin, hulls, most, &worst);
      },
      [&](const NetNode& node) { return halver.halves(node, halver.longest(node, unit)); });
  return are_bounded ? std::optional(worst) : std::nullopt;
}

std::optional<double> end_distance(const SkinFacets& skin, SweepNodes& sweep, double most) {
  const ScopedUpward upward;
  struct EndPart {
    std::uint32_t part = 0;
    int level = 0;
  };
  std::vector<HullPoints> hulls(1);
  double worst = 0;
  const bool are_bounded = drops_all(
      EndPart(), kMostEndLevels, kMostEndNodes,
      [&](const EndPart& node) {
        sweep.end_points(node.part, &hulls[0]);
        return raise_bound(skin, hulls, most, &worst);
      },
      [&](const EndPart& node) {
        const auto [low, high] = sweep.halves_of_part(node.part);
        return std::pair(EndPart{low, node.level + 1}, EndPart{high, node.level + 1});
      });
  return are_bounded ? std::optional(worst) : std::nullopt;
}

}  // namespace veritope
