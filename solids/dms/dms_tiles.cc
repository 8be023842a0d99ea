// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_tiles.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "robust/base/parallel.h"
#include "solids/dms/dms_polygon_internal.h"

namespace veritope {
namespace {

using internal::DmsPolygon;
using internal::DmsSegment;
using Edge = std::array<std::uint32_t, 2>;
using Triangle = std::array<std::uint32_t, 3>;

constexpr std::size_t kTilesOfChunk = 32;

Edge edge_of(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

DmsPlane plane_of(const DmsPoint& a, const DmsPoint& b, const DmsPoint& c) {
  DmsPlane plane{cross_product(difference(b, a), difference(c, a)), {}};
  plane.number = dot_product(plane.vector, a);
  return plane;
}

class BoundaryTiling {
 public:
  BoundaryTiling(const DmsModel& model, const TetrahedralComplex& complex,
                 const DmsTileOptions& options)
      : model_(model), complex_(complex), options_(options), knots_(model) {
    for (std::uint32_t v = 0; v < model.clouds.size(); ++v)
      places_.push_back(points_.add(model.knot(v, 0)));
  }

  std::variant<std::vector<std::vector<DmsTile>>, DmsOpenFace> run() {
    std::size_t least = 0;  // of tiles: a polygon with n corners has n - 2 of them, or more
    for (const TetrahedronFace f : complex_.boundary()) {
      if (!cut_face(f)) return DmsOpenFace{f};
      for (const DmsPolygon& polygon : polygons_.back()) least += polygon.size() - 2;
      if (least > options_.max_tiles) return DmsOpenFace{f, true};
      collect_edge_points(f);
    }
    std::vector<Triangle> triangles;
    std::vector<std::size_t> last;  // behind the triangles of each face
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
      append_triangles(i, triangles);
      if (triangles.size() - (i == 0 ? 0 : last[i - 1]) > options_.max_tiles_of_face)
        return DmsOpenFace{complex_.boundary()[i]};
      if (triangles.size() > options_.max_tiles) return DmsOpenFace{complex_.boundary()[i], true};
      last.push_back(triangles.size());
    }
    std::vector<std::optional<DmsTile>> tiles = prove(triangles);
    std::vector<std::vector<DmsTile>> out;
    for (std::size_t i = 0, k = 0; i < last.size(); ++i) {
      out.emplace_back();
      for (; k < last[i]; ++k) {
        if (!tiles[k]) return DmsOpenFace{complex_.boundary()[i]};
        out.back().push_back(std::move(*tiles[k]));
      }
    }
    return out;
  }

 private:
  std::vector<DmsPoint> corners_of(TetrahedronFace f) const {
    std::vector<DmsPoint> out;
    for (const std::uint32_t v : complex_.vertices(f)) out.push_back(model_.knot(v, 0));
    return out;
  }
  static DmsPoint normal_of_face(const std::vector<DmsPoint>& corners) {
    return cross_product(difference(corners[1], corners[0]), difference(corners[2], corners[0]));
  }

  // Appends the polygons into which triangles of knots cut a face; false if they are too many.
  bool cut_face(TetrahedronFace f) {
    const std::vector<DmsPoint> corners = corners_of(f);
    const DmsPoint normal = normal_of_face(corners);
    const auto v = complex_.vertices(f);
    std::vector<DmsPolygon>& parts = polygons_.emplace_back();
    parts.push_back({places_[v[0]], places_[v[1]], places_[v[2]]});
    DmsRegion region(knots_, corners, upright_planes(corners));
    const internal::DmsDrawingPlane plane(points_, normal);
    for (const auto& three : region.find_cuts(region.supports()))
      if (const auto segment = trace_of(three, corners[0], normal))
        if (!cut_parts(parts, *segment, plane)) return false;
    return true;
  }
  bool cut_parts(std::vector<DmsPolygon>& parts, const DmsSegment& segment,
                 const internal::DmsDrawingPlane& plane) const {
    for (std::size_t i = 0, n = parts.size(); i < n; ++i)
      if (auto halves = plane.cut(parts[i], segment)) {
        parts[i] = std::move(halves->first);
        parts.push_back(std::move(halves->second));
      }
    return parts.size() <= options_.max_tiles_of_face;
  }
  // Where the triangle of three knots, not all in the plane, meets it: a segment or a point.
  std::optional<DmsSegment> trace_of(const std::array<std::uint32_t, 3>& three,
                                     const DmsPoint& origin, const DmsPoint& normal) {
    std::vector<std::uint32_t> found;
    const auto height = [&](const DmsPoint& p) {
      return dot_product(normal, difference(p, origin));
    };
    for (std::size_t i = 0; i < 3; ++i) {
      const DmsPoint &a = knots_.point(three[i]), &b = knots_.point(three[(i + 1) % 3]);
      const Rational here = height(a), next = height(b);
      if (here.sign() == Sign::kZero) found.push_back(points_.add(a));
      if (here.sign() * next.sign() != Sign::kNegative) continue;
      DmsPoint p;
      const Rational t = here / (here - next);
      for (std::size_t c = 0; c < 3; ++c) p[c] = a[c] + t * (b[c] - a[c]);
      found.push_back(points_.add(std::move(p)));
    }
    if (found.empty()) return std::nullopt;
    return DmsSegment{found.front(), found.back()};
  }

  // The corners of the last face's polygons on the edges of the domain.
  void collect_edge_points(TetrahedronFace f) {
    const auto v = complex_.vertices(f);
    const std::vector<std::uint32_t> all = corners_of_polygons(polygons_.back());
    for (std::size_t i = 0; i < 3; ++i) {
      const ExactPoint3 &a = points_.at(places_[v[i]]), &b = points_.at(places_[v[(i + 1) % 3]]);
      std::vector<std::uint32_t>& on_edge = on_edges_[edge_of(v[i], v[(i + 1) % 3])];
      for (const std::uint32_t p : all)
        if (internal::is_between(a, b, points_.at(p))) on_edge.push_back(p);
    }
  }
  static std::vector<std::uint32_t> corners_of_polygons(const std::vector<DmsPolygon>& polygons) {
    std::vector<std::uint32_t> out;
    for (const DmsPolygon& polygon : polygons)
      out.insert(out.end(), polygon.begin(), polygon.end());
    sort_unique(out);
    return out;
  }
  static void sort_unique(std::vector<std::uint32_t>& numbers) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  }

  // Those of the polygons of a face.
  void append_triangles(std::size_t i, std::vector<Triangle>& triangles) {
    const TetrahedronFace f = complex_.boundary()[i];
    const auto v = complex_.vertices(f);
    std::vector<std::uint32_t> points = corners_of_polygons(polygons_[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& on_edge = on_edges_[edge_of(v[k], v[(k + 1) % 3])];
      points.insert(points.end(), on_edge.begin(), on_edge.end());
    }
    sort_unique(points);
    const internal::DmsDrawingPlane plane(points_, normal_of_face(corners_of(f)));
    for (const DmsPolygon& polygon : polygons_[i]) {
      const auto of_polygon = plane.triangles(internal::with_corners(points_, polygon, points));
      triangles.insert(triangles.end(), of_polygon.begin(), of_polygon.end());
    }
  }
  std::vector<std::optional<DmsTile>> prove(const std::vector<Triangle>& triangles) const {
    std::vector<std::optional<DmsTile>> out(triangles.size());
    WorkStep step(options_.work, static_cast<double>(triangles.size()));
    parallel_for(triangles.size(), kTilesOfChunk, options_.jobs,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   for (std::size_t k = begin; k < end; ++k) {
                     const auto& [a, b, c] = triangles[k];
                     out[k] = proved({points_.at(a).at(), points_.at(b).at(), points_.at(c).at()});
                   }
                   step.add(static_cast<double>(end - begin));
                 });
    return out;
  }

  // With planes that part the triangles of knots, which do not meet it.
  std::optional<DmsTile> proved(const std::array<DmsPoint, 3>& corners) const {
    DmsTile tile{corners, {}};
    const std::vector<DmsPoint> all(corners.begin(), corners.end());
    std::optional<std::vector<DmsSupport>> supports;
    for (std::size_t tries = 0; tries < DmsRegion::kMaxPlanes; ++tries) {
      std::vector<DmsPlane> planes = upright_planes(all);
      planes.insert(planes.end(), tile.planes.begin(), tile.planes.end());
      DmsRegion region(knots_, all, planes);
      if (!supports) supports = region.supports();
      const auto cut = region.find_cut(*supports);
      if (!cut) return tile;
      auto plane = find_plane(all, *cut);
      if (!plane) return std::nullopt;
      tile.planes.push_back(std::move(*plane));
    }
    return std::nullopt;
  }
  // A plane through a side of the tile and a knot of the three that parts them from the tile.
  std::optional<DmsPlane> find_plane(const std::vector<DmsPoint>& corners,
                                     const std::array<std::uint32_t, 3>& three) const {
    for (std::size_t i = 0; i < 3; ++i)
      for (const std::uint32_t knot : three) {
        DmsPlane plane = plane_of(corners[i], corners[(i + 1) % 3], knots_.point(knot));
        const int side = side_of_plane(corners, plane);
        const bool is_parted =
            side != 0 && std::all_of(three.begin(), three.end(), [&](std::uint32_t k) {
              const Rational h = dot_product(plane.vector, knots_.point(k)) - plane.number;
              return static_cast<int>(h.sign()) * side <= 0;
            });
        if (is_parted) return plane;
      }
    return std::nullopt;
  }

  const DmsModel& model_;
  const TetrahedralComplex& complex_;
  const DmsTileOptions& options_;
  DmsKnotTable knots_;
  std::vector<std::vector<DmsPolygon>> polygons_;  // of each face
  internal::DmsPoints points_;
  std::vector<std::uint32_t> places_;  // of the vertices
  std::map<Edge, std::vector<std::uint32_t>> on_edges_;
};

}  // namespace

std::variant<std::vector<std::vector<DmsTile>>, DmsOpenFace> tile_boundary(
    const DmsModel& model, const TetrahedralComplex& complex, const DmsTileOptions& options) {
  return BoundaryTiling(model, complex, options).run();
}

}  // namespace veritope
