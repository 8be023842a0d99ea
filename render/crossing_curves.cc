// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/crossing_curves.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>

#include "solids/polyhedron/approx_overlap.h"

namespace veritope {
namespace {

struct BoxedTriangle {
  std::array<Vec3d, 3> corners;
  Box3d box;
};

Box3d box_of(const SceneSurface& surface) {
  Box3d out = empty_box();
  for (const Point3d& p : surface.points) add(p, &out);
  return out;
}

// The triangles that meet the box, by their least first coordinates.
std::vector<BoxedTriangle> triangles_in(const SceneSurface& surface, const Box3d& box) {
  std::vector<BoxedTriangle> out;
  for (const auto& triangle : surface.triangles) {
    BoxedTriangle boxed{{}, empty_box()};
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3d& p = surface.points[triangle[i]];
      boxed.corners[i] = {p[0], p[1], p[2]};
      add(p, &boxed.box);
    }
    if (meets(boxed.box, box)) out.push_back(boxed);
  }
  std::stable_sort(out.begin(), out.end(), [](const BoxedTriangle& a, const BoxedTriangle& b) {
    return a.box.lo[0] < b.box.lo[0];
  });
  return out;
}

bool are_neighbours(const SceneSurface& a, const SceneSurface& b) {
  const std::set<Point3d> points(a.points.begin(), a.points.end());
  return std::any_of(b.points.begin(), b.points.end(),
                     [&](const Point3d& p) { return points.contains(p); });
}

}  // namespace

std::vector<std::array<Point3d, 2>> approx_crossing(const SceneSurface& a, const SceneSurface& b) {
  constexpr std::uint64_t kMostPairs = std::uint64_t{1} << 26;
  const Box3d box_of_a = box_of(a), box_of_b = box_of(b);
  if (!meets(box_of_a, box_of_b) || are_neighbours(a, b)) return {};
  const Box3d both = common(box_of_a, box_of_b);
  const std::vector<BoxedTriangle> first = triangles_in(a, both), second = triangles_in(b, both);
  double widest = 0;
  for (const BoxedTriangle& u : second) widest = std::max(widest, u.box.hi[0] - u.box.lo[0]);
  std::vector<std::array<Point3d, 2>> out;
  std::uint64_t num_pairs = 0;
  for (const BoxedTriangle& t : first) {
    const auto begins_before = [](const BoxedTriangle& u, double x) { return u.box.lo[0] < x; };
    auto u = std::lower_bound(second.begin(), second.end(), t.box.lo[0] - widest, begins_before);
    for (; u != second.end() && u->box.lo[0] <= t.box.hi[0]; ++u) {
      if (++num_pairs > kMostPairs) return {};
      if (!meets(t.box, u->box)) continue;
      const auto segment = approx_common_segment(t.corners, u->corners);
      if (segment) out.push_back({to_point((*segment)[0]), to_point((*segment)[1])});
    }
  }
  return out;
}

}  // namespace veritope
