// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/collar/collar_mesh.h"

#include <algorithm>
#include <cmath>

#include "robust/base/check.h"

namespace veritope {
namespace {

using GridPoint = std::array<std::uint32_t, 3>;
constexpr std::uint32_t kNone = CommonSubdivision::kNone;

class Builder {
 public:
  Builder(const CommonSubdivision& complex, const OctreeRoot& root, int scale)
      : c_(complex), root_(root), scale_(scale), number_(complex.num_vertices(), kNone) {}

  void add(std::uint32_t face, CellSide side) {
    ring_.clear();
    for (const std::uint32_t e : c_.edges_of_face(face))
      ring_.push_back(c_.edges()[e].lower), ring_.push_back(c_.edges()[e].upper);
    const CommonSubdivision::Face& f = c_.faces()[face];
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
      return way_around(f, a) < way_around(f, b);
    };
    std::sort(ring_.begin(), ring_.end(), before);
    ring_.erase(std::unique(ring_.begin(), ring_.end()), ring_.end());
    // Seen from where the normal of its axis points, it runs counter-clockwise.
    const bool is_outward = f.below != kNone;
    if (is_outward != (side == CellSide::kOut)) std::reverse(ring_.begin(), ring_.end());
    fill(f);
  }

  Result<TriangleMesh> take() {
    if (is_rounded_)
      return Error{Code::kNotFinite,
                   {},
                   "a corner of a cell is no binary64 number in the units of the model"};
    if (mesh_.faces.empty()) return Error{Code::kEmpty, {}, "there is no face of a cell"};
    return std::move(mesh_);
  }

 private:
  // The distance from the least corner along the border of the face, first along the axis after its normal's.
  std::uint64_t way_around(const CommonSubdivision::Face& f, std::uint32_t vertex) const {
    const GridPoint low = c_.point(f.corner), at = c_.point(vertex);
    const std::uint64_t s = at[(f.axis + 1) % 3] - low[(f.axis + 1) % 3],
                        t = at[(f.axis + 2) % 3] - low[(f.axis + 2) % 3];
    const std::uint64_t edge = OctreeKey::kGrid >> f.level;
    if (t == 0) return s;
    if (s == edge) return edge + t;
    return t == edge ? 3 * edge - s : 4 * edge - t;
  }

  void fill(const CommonSubdivision::Face& f) {
    std::vector<std::uint32_t> ids;
    for (const std::uint32_t v : ring_) ids.push_back(id_of(v));
    if (ids.size() == 4) {
      mesh_.faces.push_back({ids[0], ids[1], ids[2]});
      mesh_.faces.push_back({ids[0], ids[2], ids[3]});
      return;
    }
    Point3d middle;
    const GridPoint low = c_.point(f.corner);
    const double half = 0.5 * (OctreeKey::kGrid >> f.level);
    for (std::size_t k = 0; k < 3; ++k)
      middle[k] = root_.plane(k, low[k]) + (k == f.axis ? 0 : half * root_.unit);
    const std::uint32_t centre = add_point(middle);
    for (std::size_t i = 0; i < ids.size(); ++i)
      mesh_.faces.push_back({centre, ids[i], ids[(i + 1) % ids.size()]});
  }

  std::uint32_t id_of(std::uint32_t vertex) {
    if (number_[vertex] == kNone) {
      const GridPoint p = c_.point(vertex);
      number_[vertex] =
          add_point({root_.plane(0, p[0]), root_.plane(1, p[1]), root_.plane(2, p[2])});
    }
    return number_[vertex];
  }
  std::uint32_t add_point(const Point3d& p) {
    double out[3];
    for (std::size_t k = 0; k < 3; ++k) {
      out[k] = std::ldexp(p[k], -scale_);
      if (!std::isfinite(out[k]) || std::ldexp(out[k], scale_) != p[k]) is_rounded_ = true;
    }
    mesh_.positions.push_back({out[0], out[1], out[2]});
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
  }

  const CommonSubdivision& c_;
  const OctreeRoot& root_;
  int scale_;
  std::vector<std::uint32_t> number_, ring_;
  bool is_rounded_ = false;
  TriangleMesh mesh_;
};

}  // namespace

Result<TriangleMesh> boundary_mesh(const CommonSubdivision& complex,
                                   const ComplexBoundary& boundary, const std::vector<bool>& which,
                                   CellSide side, const OctreeRoot& root, int scale) {
  VT_CHECK(which.size() == boundary.components.size(),
           "one flag for each component of the boundary");
  Builder builder(complex, root, scale);
  for (std::uint32_t f = 0; f < complex.num_faces(); ++f) {
    const std::uint32_t component = boundary.component_of_face[f];
    if (component != kNone && which[component]) builder.add(f, side);
  }
  return builder.take();
}

}  // namespace veritope
