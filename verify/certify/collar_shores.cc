// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/collar_shores.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "robust/base/check.h"

namespace veritope {
namespace {

using Id = PieceForest::Id;
constexpr std::size_t kMostBoxes = 24;

class ShoreSearch {
 public:
  ShoreSearch(PieceForest& forest, const StarCover& cover, const OctreeRoot& root,
              const CommonSubdivision& complex, const ComplexBoundary& boundary)
      : forest_(forest), cover_(cover), root_(root), c_(complex), b_(boundary) {}

  std::optional<Shore> run(std::uint32_t component) {
    // A component's least face starts at its least vertex: the least corner of a face with that vertex is no greater.
    const CommonSubdivision::Face& first = c_.faces()[b_.components[component].first_face];
    Shore shore;
    if (leads_out(first.corner, first, &shore)) return shore;
    return along_boundary(component, first.corner);
  }

 private:
  Point3d point(std::uint32_t vertex) const {
    const auto p = c_.point(vertex);
    return {root_.plane(0, p[0]), root_.plane(1, p[1]), root_.plane(2, p[2])};
  }

  // Tries the ray downward first: nothing lies below the least vertex of an outermost component. Then tries centres of
  // boxes near the vertex (those of a box that contains it see it), and last the other rays.
  bool leads_out(std::uint32_t vertex, const CommonSubdivision::Face& near, Shore* shore) {
    const Point3d from = point(vertex);
    if (to_infinity(from, 5, shore) ||
        to_box(from, root_.unit * (OctreeKey::kGrid >> near.level), shore))
      return true;
    for (const std::uint8_t direction : {0, 1, 2, 3, 4})
      if (to_infinity(from, direction, shore)) return true;
    return false;
  }

  bool to_infinity(const Point3d& from, std::uint8_t direction, Shore* shore) {
    Point3d to = from;
    const std::size_t k = direction / 2;
    const Box3d all = root_.box();  // the surface lies inside
    to[k] = direction % 2 == 0 ? all.hi[k] + root_.edge() : all.lo[k] - root_.edge();
    if (!is_free_segment(forest_, from, to)) return false;
    shore->direction = direction, shore->winding = 0;
    return true;
  }

  bool to_box(const Point3d& from, double size, Shore* shore) {
    for (const std::uint32_t box : boxes_near(from, size))
      for (const bool outside : {true, false}) {
        if (!cover_.boxes[box].has_one_sheet()) continue;
        const StarBox& star = cover_.boxes[box].star;
        if (!is_free_segment(forest_, from, outside ? star.outside : star.inside)) continue;
        shore->direction = 6, shore->end_box = box, shore->ends_outside = outside;
        shore->winding = outside ? 0 : 1;
        return true;
      }
    return false;
  }

  static double distance(const Box3d& box, const Point3d& p) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double d = std::max({box.lo[k] - p[k], p[k] - box.hi[k], 0.0});
      sum += d * d;
    }
    return sum;
  }
  // Boxes of leaves near the point, nearest first.
  std::vector<std::uint32_t> boxes_near(const Point3d& p, double size) const {
    std::vector<std::pair<double, std::uint32_t>> found;
    for (int doublings = 0; found.empty() && doublings < 24; ++doublings, size *= 2) {
      const Box3d around{{p[0] - size, p[1] - size, p[2] - size},
                         {p[0] + size, p[1] + size, p[2] + size}};
      const auto visit = [&](auto& self, Id id) -> void {
        const PieceForest::Node& node = forest_.node(id);
        if (!meets(node.hull, around)) return;
        if (cover_.box_of_node[id] != StarCover::kNone) {
          found.push_back({distance(node.hull, p), cover_.box_of_node[id]});
          return;
        }
        for (Id k = 0; k < 4; ++k) self(self, node.first_child + k);
      };
      forest_.roots().visit([&](const Box3d& box) { return meets(box, around); },
                            [&](std::uint32_t number) { visit(visit, forest_.root(number)); });
    }
    std::sort(found.begin(), found.end());
    std::vector<std::uint32_t> out;
    for (const auto& f : found)
      if (out.size() < kMostBoxes && std::find(out.begin(), out.end(), f.second) == out.end())
        out.push_back(f.second);
    return out;
  }

  // Follows edges of the boundary, which miss the surface, to a vertex from which a shore leads out. Vertices at
  // distances 1, 2, 4, ... are tried.
  std::optional<Shore> along_boundary(std::uint32_t component, std::uint32_t start) {
    collect_edges(component);
    constexpr std::uint32_t kNone = CommonSubdivision::kNone;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> reached{
        {start, kNone}};  // vertex, position from which it was reached
    std::vector<bool> seen(c_.num_vertices());
    seen[start] = true;
    for (std::size_t at = 0, asked = 1; at < reached.size(); ++at) {
      const std::uint32_t vertex = reached[at].first;
      if (at == asked) {
        asked *= 2;
        Shore shore;
        if (leads_out(vertex, face_at(vertex), &shore) && path_to(reached, at, &shore))
          return shore;
      }
      const auto [lo, hi] =
          std::equal_range(edges_.begin(), edges_.end(), End{vertex, 0, 0},
                           [](const End& a, const End& b) { return a.vertex < b.vertex; });
      for (auto e = lo; e != hi; ++e)
        if (!seen[e->other]) {
          seen[e->other] = true;
          reached.push_back({e->other, static_cast<std::uint32_t>(at)});
        }
    }
    return std::nullopt;
  }
  struct End {
    std::uint32_t vertex, other, face;
    friend bool operator<(const End& a, const End& b) {
      return std::pair(a.vertex, a.other) < std::pair(b.vertex, b.other);
    }
  };
  void collect_edges(std::uint32_t component) {
    edges_.clear();
    for (const std::uint32_t f : b_.faces_of(component))
      for (const std::uint32_t e : c_.edges_of_face(f)) {
        const CommonSubdivision::Edge edge = c_.edges()[e];
        edges_.push_back({edge.lower, edge.upper, f});
        edges_.push_back({edge.upper, edge.lower, f});
      }
    std::sort(edges_.begin(), edges_.end());
  }
  const CommonSubdivision::Face& face_at(std::uint32_t vertex) const {
    return c_.faces()[std::lower_bound(edges_.begin(), edges_.end(), End{vertex, 0, 0})->face];
  }
  bool path_to(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& reached, std::size_t at,
               Shore* shore) {
    for (std::size_t k = at; k != 0; k = reached[k].second)
      shore->vertices.push_back(reached[k].first);
    std::reverse(shore->vertices.begin(), shore->vertices.end());
    Point3d from = point(reached[0].first);
    for (const std::uint32_t v : shore->vertices) {
      const Point3d to = point(v);
      if (!is_free_segment(forest_, from, to)) return false;
      from = to;
    }
    return true;
  }

  PieceForest& forest_;
  const StarCover& cover_;
  const OctreeRoot& root_;
  const CommonSubdivision& c_;
  const ComplexBoundary& b_;
  std::vector<End> edges_;
};

}  // namespace

std::vector<std::optional<Shore>> find_shores(PieceForest& forest, const StarCover& cover,
                                              const OctreeRoot& root,
                                              const CommonSubdivision& complex,
                                              const ComplexBoundary& boundary) {
  VT_CHECK(cover.is_complete(), "shores end at boxes of a whole cover");
  ShoreSearch search(forest, cover, root, complex, boundary);
  std::vector<std::optional<Shore>> out;
  for (std::uint32_t k = 0; k < boundary.components.size(); ++k) out.push_back(search.run(k));
  return out;
}

}  // namespace veritope
