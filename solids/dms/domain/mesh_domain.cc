// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/domain/mesh_domain.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "predicates/exact_point.h"
#include "predicates/orient3d.h"
#include "robust/base/check.h"
#include "solids/dms/dms_make.h"
#include "solids/dms/dms_validity.h"
#include "solids/dms/domain/convex_polygon.h"
#include "solids/dms/domain/mesh_cells.h"
#include "solids/dms/domain/short_vertices.h"
#include "solids/tetrahedra/delaunay.h"

namespace veritope {
namespace {

constexpr std::uint32_t kNoVertex = 0xffffffffu;

using CornerTriple = std::array<std::uint32_t, 3>;

class Filler {
 public:
  Filler(const TriangleMesh& input, const MeshCells& mesh)
      : cells_(mesh.cells), input_(input), mesh_(mesh), triangles_(mesh.cells.faces().size()) {
    number_vertices();
  }

  Result<MeshDomain> run() {
    const auto& cells = cells_.cells();
    for (std::uint32_t c = 0; c < cells.size(); ++c)
      if (mesh_.is_inside[c] != 0) fill(c);
    if (tetrahedra_.size() > kMaxDmsTetrahedra)
      return Error{Code::kOverLimit,
                   {},
                   "more than " + std::to_string(kMaxDmsTetrahedra) + " tetrahedra arise"};
    shorten_vertices(flats(), tetrahedra_, exact_);
    MeshDomain out;
    out.cuts = mesh_.cuts;
    for (const std::uint8_t i : mesh_.is_inside) out.cells += i;
    out.from_mesh = from_mesh_;
    out.steiner_on_mesh = steiner_on_mesh_;
    out.steiner_inside = exact_.size() - from_mesh_ - steiner_on_mesh_;
    for (const ExactPoint3& p : exact_) out.model.clouds.push_back({p.at()});
    for (const DmsCloud& cloud : out.model.clouds)
      for (const Rational& x : cloud[0])
        if (const Status status = check_dms_number(x); !status) return status.error();
    out.model.tetrahedra = std::move(tetrahedra_);
    set_control_by_rule(out.model, DmsControlRule::kGreville, {});
    return out;
  }

 private:
  // The vertices of cells inside, in their order.
  void number_vertices() {
    std::vector<std::uint8_t> is_used(cells_.num_vertices(), 0);
    number_.assign(is_used.size(), kNoVertex);
    triangles_at_.resize(is_used.size());
    for (std::uint32_t c = 0; c < cells_.cells().size(); ++c) {
      if (mesh_.is_inside[c] == 0) continue;
      for (const std::uint32_t f : cells_.cells()[c].faces)
        for (const std::uint32_t v : cells_.faces()[f].corners) {
          is_used[v] = 1;
          if (mesh_.triangle_at[f] != MeshCells::kOff)
            triangles_at_[v].push_back(mesh_.triangle_at[f]);
        }
    }
    for (std::uint32_t v = 0; v < is_used.size(); ++v) {
      if (is_used[v] == 0) continue;
      number_[v] = static_cast<std::uint32_t>(exact_.size());
      exact_.push_back(ExactPoint3(cells_.place(v)));
      if (cells_.is_input(v)) {
        ++from_mesh_;
      } else if (!triangles_at_[v].empty()) {
        ++steiner_on_mesh_;
      }
    }
  }

  // Where each vertex of the tetrahedra may be.
  std::vector<VertexFlat> flats() const {
    std::vector<VertexFlat> out(exact_.size());
    for (VertexFlat& flat : out) flat.kind = VertexFlat::Kind::kFree;
    for (std::uint32_t v = 0; v < number_.size(); ++v)
      if (number_[v] != kNoVertex) out[number_[v]] = flat_of(v);
    return out;
  }
  const Vec3d& corner(std::uint32_t t, std::size_t k) const {
    return input_.positions[input_.faces[t][k % 3]];
  }
  std::array<Vec3d, 3> corners(std::uint32_t t) const {
    return {corner(t, 0), corner(t, 1), corner(t, 2)};
  }
  VertexFlat flat_of(std::uint32_t v) const {
    if (cells_.is_input(v)) return {};
    const std::vector<std::uint32_t>& at = triangles_at_[v];
    if (at.empty()) return {VertexFlat::Kind::kFree, {}};
    const auto is_in_all_planes = [&](const Vec3d& p) {
      return std::all_of(at.begin(), at.end(), [&](std::uint32_t t) {
        return orient3d(corner(t, 0), corner(t, 1), corner(t, 2), p) == Sign::kZero;
      });
    };
    const auto first = corners(at[0]);
    if (std::all_of(first.begin(), first.end(), is_in_all_planes))
      return {VertexFlat::Kind::kPlane, first};
    for (const std::uint32_t t : at)
      for (std::size_t k = 0; k < 3; ++k) {
        if (!is_in_all_planes(corner(t, k)) || !is_in_all_planes(corner(t, k + 1))) continue;
        return {VertexFlat::Kind::kLine, {corner(t, k), corner(t, k + 1), Vec3d()}};
      }
    return {};
  }

  const std::vector<CornerTriple>& triangles_of(std::uint32_t f) {
    std::vector<CornerTriple>& out = triangles_[f];
    if (!out.empty()) return out;
    const CellFace& face = cells_.faces()[f];
    std::vector<AnyPoint3> corners;
    for (const std::uint32_t v : face.corners) corners.push_back(cells_.vertex(v));
    for (const CornerTriple& t : triangulate_convex(corners, face.corners))
      out.push_back({face.corners[t[0]], face.corners[t[1]], face.corners[t[2]]});
    return out;
  }

  struct Facet {
    std::uint32_t plane;
    CornerTriple corners;
  };

  void fill(std::uint32_t c) {
    facets_.clear();
    for (const std::uint32_t f : cells_.cells()[c].faces)
      for (const CornerTriple& t : triangles_of(f)) facets_.push_back({cells_.faces()[f].plane, t});
    const std::vector<std::uint32_t> corners = cells_.skeleton(c).vertices;
    std::size_t fewest = facets_.size();
    std::uint32_t apex = kNoVertex;
    for (const std::uint32_t v : corners) {
      const std::optional<std::size_t> count = cone_size(v);
      if (count && *count < fewest) fewest = *count, apex = v;
    }
    const std::uint32_t top = apex == kNoVertex ? add_inner_point(c, corners) : number_[apex];
    if (apex != kNoVertex) mark_planes(apex);
    for (const Facet& facet : facets_)
      if (apex == kNoVertex || !is_plane_of_apex(facet.plane)) add_tetrahedron(top, facet.corners);
  }

  static bool contains(const CornerTriple& t, std::uint32_t v) {
    return std::find(t.begin(), t.end(), v) != t.end();
  }
  void mark_planes(std::uint32_t v) {
    apex_planes_.clear();
    for (const Facet& facet : facets_)
      if (contains(facet.corners, v)) apex_planes_.push_back(facet.plane);
  }
  bool is_plane_of_apex(std::uint32_t plane) const {
    return std::find(apex_planes_.begin(), apex_planes_.end(), plane) != apex_planes_.end();
  }
  // How many tetrahedra join a corner to the facets off it; nothing if triangles in a facet's plane through the corner
  // do not contain it: then the tetrahedra's faces would not be the triangles.
  std::optional<std::size_t> cone_size(std::uint32_t v) {
    mark_planes(v);
    std::size_t count = 0;
    for (const Facet& facet : facets_) {
      if (!is_plane_of_apex(facet.plane)) {
        ++count;
      } else if (!contains(facet.corners, v)) {
        return std::nullopt;
      }
    }
    return count;
  }

  void add_tetrahedron(std::uint32_t top, const CornerTriple& t) {
    TetrahedronCorners corners{top, number_[t[0]], number_[t[1]], number_[t[2]]};
    const auto& p = exact_;
    const Sign sign = orient3d(p[corners[0]], p[corners[1]], p[corners[2]], p[corners[3]]);
    VT_CHECK(sign != Sign::kZero, "tetrahedra in a convex cell have a volume");
    if (sign == Sign::kNegative) std::swap(corners[2], corners[3]);
    tetrahedra_.push_back(corners);
  }

  bool is_inside(std::uint32_t c, const ExactPoint3& p) const {
    return std::all_of(cells_.cells()[c].sides.begin(), cells_.cells()[c].sides.end(),
                       [&](const CellHalfSpace& s) {
                         const CellPlane& q = cells_.planes()[s.plane];
                         const auto at = [&](std::size_t k) {
                           return ExactPoint3(cells_.points()[q[k]]);
                         };
                         return orient3d(at(0), at(1), at(2), p) == s.side;
                       });
  }

  // The mean of the corners, rounded as far as it stays inside.
  std::uint32_t add_inner_point(std::uint32_t c, const std::vector<std::uint32_t>& corners) {
    DmsPoint mean;
    for (const std::uint32_t v : corners)
      for (std::size_t k = 0; k < 3; ++k) mean[k] += exact_[number_[v]].at()[k];
    for (Rational& x : mean) x /= Rational(corners.size());
    DmsPoint rounded = mean;
    for (Rational& x : rounded) x = Rational::from_double(nearest_double(x));
    for (std::uint64_t bits = 64; bits <= kMostInnerBits; bits *= 2) {
      if (is_inside(c, ExactPoint3(rounded))) break;
      for (std::size_t k = 0; k < 3; ++k) rounded[k] = rounded_at(mean[k], bits);
    }
    ExactPoint3 inner(rounded);
    if (!is_inside(c, inner)) inner = ExactPoint3(mean);
    exact_.push_back(std::move(inner));
    return static_cast<std::uint32_t>(exact_.size() - 1);
  }
  // With so many binary digits, from the first one on.
  static Rational rounded_at(const Rational& x, std::uint64_t bits) {
    const auto size = static_cast<std::int64_t>(x.numerator().bit_length()) -
                      static_cast<std::int64_t>(x.denominator().bit_length());
    const Rational unit = Rational::power_of_two(size - static_cast<std::int64_t>(bits));
    const Rational scaled = x / unit;
    return Rational(floor_divide(scaled.numerator(), scaled.denominator())) * unit;
  }
  static constexpr std::uint64_t kMostInnerBits = 1024;

  const ConvexCells& cells_;
  const TriangleMesh& input_;
  const MeshCells& mesh_;
  std::vector<std::vector<CornerTriple>> triangles_;  // for each face
  // For each vertex of the cells its number, and the triangles on which faces at it lie.
  std::vector<std::uint32_t> number_;
  std::vector<std::vector<std::uint32_t>> triangles_at_;
  std::vector<ExactPoint3> exact_;
  std::vector<TetrahedronCorners> tetrahedra_;
  std::vector<Facet> facets_;
  std::vector<std::uint32_t> apex_planes_;
  std::size_t from_mesh_ = 0, steiner_on_mesh_ = 0;
};

// The mesh without positions that no triangle uses.
TriangleMesh used_part(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> number(mesh.positions.size(), kNoVertex);
  for (const auto& f : mesh.faces)
    for (const std::uint32_t v : f) number[v] = 0;
  TriangleMesh out;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == kNoVertex) continue;
    number[v] = static_cast<std::uint32_t>(out.positions.size());
    out.positions.push_back(mesh.positions[v]);
  }
  for (const auto& f : mesh.faces) out.faces.push_back({number[f[0]], number[f[1]], number[f[2]]});
  return out;
}

}  // namespace

Result<MeshDomain> domain_of_mesh(const TriangleMesh& mesh, const MeshDomainOptions& options) {
  const TriangleMesh used = used_part(mesh);
  const Result<DelaunayTetrahedra> delaunay = delaunay_tetrahedra(used.positions);
  if (!delaunay) return delaunay.error();
  return domain_of_mesh(used, delaunay->tetrahedra, options);
}

Result<MeshDomain> domain_of_mesh(const TriangleMesh& mesh,
                                  std::span<const TetrahedronCorners> tetrahedra,
                                  const MeshDomainOptions& options) {
  const Result<MeshCells> cells = cut_along_mesh(mesh, tetrahedra, options.max_vertices);
  if (!cells) return cells.error();
  return Filler(mesh, *cells).run();
}

}  // namespace veritope
