// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/crossing_curves.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "solids/polyhedron/approx_overlap.h"

namespace veritope {
namespace {

struct BoxedTriangle {
  std::array<Vec3d, 3> corners;
  Box3d box;
  bool is_on_border = false;
};

bool have_common_corner(const BoxedTriangle& t, const BoxedTriangle& u) {
  const auto is_corner_of_u = [&](const Vec3d& p) {
    return std::find_if(u.corners.begin(), u.corners.end(), [&](const Vec3d& q) {
             return p.x == q.x && p.y == q.y && p.z == q.z;
           }) != u.corners.end();
  };
  return std::any_of(t.corners.begin(), t.corners.end(), is_corner_of_u);
}

// Which points lie on edges that one triangle alone has.
std::vector<bool> border_of(const SceneSurface& surface) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(3 * surface.triangles.size());
  for (const auto& t : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i) edges.push_back(std::minmax(t[i], t[(i + 1) % 3]));
  std::sort(edges.begin(), edges.end());
  std::vector<bool> out(surface.points.size());
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    while (end < edges.size() && edges[end] == edges[i]) ++end;
    if (end == i + 1) out[edges[i].first] = out[edges[i].second] = true;
  }
  return out;
}

// What is asked of a surface more than once.
struct Prepared {
  Box3d box = empty_box();
  std::vector<bool> is_border;
  std::vector<Point3d> border;  // sorted
};

Prepared prepare(const SceneSurface& surface) {
  Prepared out;
  out.is_border = border_of(surface);
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    add(surface.points[i], &out.box);
    if (out.is_border[i]) out.border.push_back(surface.points[i]);
  }
  std::sort(out.border.begin(), out.border.end());
  return out;
}

bool have_common_point(const std::vector<Point3d>& a, const std::vector<Point3d>& b) {
  auto p = a.begin();
  for (auto q = b.begin(); p != a.end() && q != b.end();) {
    if (*p == *q) return true;
    *p < *q ? ++p : ++q;
  }
  return false;
}

class CrossingSearch {
 public:
  CrossingSearch(std::span<const SceneSurface> surfaces, std::uint64_t most_steps)
      : surfaces_(surfaces), steps_left_(most_steps) {
    for (const SceneSurface& s : surfaces) prepared_.push_back(prepare(s));
  }

  CrossingCurves run(std::optional<std::pair<std::size_t, std::size_t>> first) {
    if (first && first->second < first->first) std::swap(first->first, first->second);
    if (first) compare(first->first, first->second);
    std::vector<std::size_t> order(surfaces_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return prepared_[a].box.lo[0] < prepared_[b].box.lo[0];
    });
    for (std::size_t i = 0; i < order.size() && !out_.is_cut; ++i)
      for (std::size_t j = i; j < order.size() && !out_.is_cut &&
                              prepared_[order[j]].box.lo[0] <= prepared_[order[i]].box.hi[0];
           ++j) {
        const std::pair<std::size_t, std::size_t> pair = std::minmax(order[i], order[j]);
        if (pair != first) compare(pair.first, pair.second);
      }
    return std::move(out_);
  }

 private:
  bool spend(std::uint64_t steps) {
    out_.is_cut = out_.is_cut || steps > steps_left_;
    if (!out_.is_cut) steps_left_ -= steps;
    return !out_.is_cut;
  }

  void compare(std::size_t a, std::size_t b) {
    if (!spend(1) || !meets(prepared_[a].box, prepared_[b].box)) return;
    const Box3d both = common(prepared_[a].box, prepared_[b].box);
    if (!spend(surfaces_[a].triangles.size() + surfaces_[b].triangles.size())) return;
    const bool are_neighbours =
        a == b || have_common_point(prepared_[a].border, prepared_[b].border);
    const std::vector<BoxedTriangle> first = triangles_in(a, both);
    const std::size_t before = out_.segments.size();
    sweep(first, a == b ? first : triangles_in(b, both), a == b, are_neighbours);
    out_.num_pairs += out_.segments.size() != before;
  }

  // The triangles that meet the box, by their least first coordinates.
  std::vector<BoxedTriangle> triangles_in(std::size_t number, const Box3d& box) const {
    const SceneSurface& surface = surfaces_[number];
    std::vector<BoxedTriangle> out;
    for (const auto& triangle : surface.triangles) {
      BoxedTriangle boxed{{}, empty_box(), false};
      for (std::size_t i = 0; i < 3; ++i) {
        const Point3d& p = surface.points[triangle[i]];
        boxed.corners[i] = {p[0], p[1], p[2]};
        boxed.is_on_border = boxed.is_on_border || prepared_[number].is_border[triangle[i]];
        add(p, &boxed.box);
      }
      if (meets(boxed.box, box)) out.push_back(boxed);
    }
    std::stable_sort(out.begin(), out.end(), [](const BoxedTriangle& a, const BoxedTriangle& b) {
      return a.box.lo[0] < b.box.lo[0];
    });
    return out;
  }

  void sweep(const std::vector<BoxedTriangle>& first, const std::vector<BoxedTriangle>& second,
             bool is_one_surface, bool are_neighbours) {
    double widest = 0;
    for (const BoxedTriangle& u : second) widest = std::max(widest, u.box.hi[0] - u.box.lo[0]);
    for (const BoxedTriangle& t : first) {
      const auto begins_before = [](const BoxedTriangle& u, double x) { return u.box.lo[0] < x; };
      auto u = is_one_surface ? second.begin() + (&t - first.data()) + 1
                              : std::lower_bound(second.begin(), second.end(), t.box.lo[0] - widest,
                                                 begins_before);
      for (; u != second.end() && u->box.lo[0] <= t.box.hi[0]; ++u) {
        if (!spend(1)) return;
        if (meets(t.box, u->box)) add_segment(t, *u, are_neighbours);
      }
    }
  }

  void add_segment(const BoxedTriangle& t, const BoxedTriangle& u, bool are_neighbours) {
    if (are_neighbours && ((t.is_on_border && u.is_on_border) || have_common_corner(t, u))) return;
    const auto segment = approx_common_segment(t.corners, u.corners);
    if (segment) out_.segments.push_back({to_point((*segment)[0]), to_point((*segment)[1])});
  }

  const std::span<const SceneSurface> surfaces_;
  std::uint64_t steps_left_;
  std::vector<Prepared> prepared_;
  CrossingCurves out_;
};

}  // namespace

CrossingCurves approx_crossings(std::span<const SceneSurface> surfaces,
                                std::optional<std::pair<std::size_t, std::size_t>> first,
                                std::uint64_t most_steps) {
  return CrossingSearch(surfaces, most_steps).run(first);
}

}  // namespace veritope
