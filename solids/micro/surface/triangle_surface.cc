// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/surface/triangle_surface.h"

#include <algorithm>
#include <cmath>

#include "interval/box_geometry.h"
#include "interval/upward.h"
#include "solids/classify/triangle_bound.h"

namespace veritope {

namespace {

class TriangleView final : public SurfaceView {
 public:
  explicit TriangleView(const TriangleSurface& surface) : surface_(surface) {}

  PartNumbers near(const Box3d& box) override {
    PartNumbers out;
    surface_.visit(box, [&](std::uint32_t f) { out.push_back(f); });
    return out;
  }
  std::uint64_t keep_close(std::span<const NodePoints> node, PartNumbers* parts) override {
    std::uint64_t pairs = 0;
    std::erase_if(*parts, [&](std::uint32_t f) {
      bool is_met = false, is_apart = true;
      for (const NodePoints& points : node) {
        if (!meets(surface_.box(f), points.box)) continue;
        is_met = true;
        is_apart = is_apart && surface_.is_apart(f, points);
      }
      pairs += is_met;
      return is_apart;
    });
    return pairs;
  }
  double reach(std::span<const Box3> points, double most, double enough) override;
  std::uint32_t source(std::uint32_t part) const override { return part; }

 private:
  double bound_by(std::uint32_t facet, std::span<const Box3> points, double most) const {
    const auto corners = surface_.corners(facet);
    double bound = 0;
    for (const Box3& p : points) {
      bound = std::max(bound, distance_bound(p, corners));
      if (!(bound < most)) break;
    }
    return bound;
  }

  const TriangleSurface& surface_;
};

// A growing box around the points: what it misses is no better than what it has, once it has grown by the bound.
double TriangleView::reach(std::span<const Box3> points, double most, double enough) {
  const Box3d box = box_around(points);
  const Box3d& whole = surface_.box();
  double scale = extent(whole);
  for (std::size_t c = 0; c < 3; ++c)
    scale = std::max({scale, std::abs(whole.lo[c]), std::abs(whole.hi[c])});
  const double farthest = std::min(most, 4 * scale);
  double best = HUGE_VAL, grow = std::max(extent(box), std::ldexp(scale, -40));
  while (true) {
    grow = std::min(grow, farthest);
    Box3d grown = box;
    for (std::size_t c = 0; c < 3; ++c) grown.lo[c] -= grow, grown.hi[c] += grow;
    surface_.visit(grown, [&](std::uint32_t f) {
      if (best > enough) best = std::min(best, bound_by(f, points, best));
    });
    if (best <= std::max(grow, enough) || grow >= farthest) break;
    grow = std::isfinite(best) ? std::min(best, 4 * grow) : 4 * grow;
  }
  return best <= most ? best : HUGE_VAL;
}

Box3 point_box(const Vec3d& p) { return Box3(Interval(p.x), Interval(p.y), Interval(p.z)); }

}  // namespace

TriangleSurface::TriangleSurface(const TriangleMesh& mesh) : mesh_(&mesh) {
  using internal::approx_middle;
  using internal::cross;
  const ScopedUpward upward;
  boxes_.reserve(mesh.faces.size());
  slabs_.resize(mesh.faces.size());
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    std::array<Box3, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = point_box(mesh.positions[mesh.faces[f][i]]);
    boxes_.push_back(box_around(p));
    box_ = hull(box_, boxes_.back());
    const Box3 normal = cross(p[1] - p[0], p[2] - p[0]);
    const std::array<Box3, 4> directions{normal, cross(normal, p[1] - p[0]),
                                         cross(normal, p[2] - p[1]), cross(normal, p[0] - p[2])};
    for (std::size_t k = 0; k < 4; ++k) slabs_[f][k] = slab_around(approx_middle(directions[k]), p);
  }
  tree_ = BoxHierarchy(boxes_);
}

std::unique_ptr<SurfaceView> TriangleSurface::view() const {
  return std::make_unique<TriangleView>(*this);
}

bool TriangleSurface::is_apart(std::uint32_t facet, const NodePoints& points) const {
  if (!meets(boxes_[facet], points.box)) return true;
  return std::ranges::any_of(slabs_[facet],
                             [&](const Slab& slab) { return is_beside(slab, points); });
}

}  // namespace veritope
