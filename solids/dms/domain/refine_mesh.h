// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/domain/refine_mesh.h: tetrahedra into which exact points are inserted one by one. The union of the
// tetrahedra stays the same set, and every vertex stays a vertex.
// Source: insertion of [Bow81], [Wat81], restricted to what the new vertex sees.
// Design: docs/design/0102-refined-domains.md.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "predicates/exact_point.h"
#include "topology/linked_tetrahedra.h"

namespace veritope {

/// Two vertices, ascending.
using VertexPair = std::pair<std::uint32_t, std::uint32_t>;
/// Two facets, ascending: the line in which they meet.
using FacetPair = std::pair<std::uint32_t, std::uint32_t>;

/// What a new vertex replaces.
struct RefineCavity {
  std::vector<std::uint32_t> ball;      ///< the tetrahedra
  std::vector<TetrahedronFace> shell;   ///< their outer faces off the planes of `opened`
  std::vector<TetrahedronFace> opened;  ///< outer faces on the boundary, in a plane with the vertex
};

/// The boundary consists of facets: triangles connected through edges whose two triangles are coplanar. The edges at
/// which two facets meet are segments.
class RefineMesh {
 public:
  static constexpr std::uint32_t kNoFacet = 0xffffffffu;

  /// REQUIRES positive tetrahedra, face to face; has_manifold_boundary(tetrahedra).
  RefineMesh(std::vector<ExactPoint3> points, std::span<const TetrahedronCorners> tetrahedra);

  const std::vector<ExactPoint3>& points() const { return points_; }
  const LinkedTetrahedra& complex() const { return complex_; }
  /// The facet of a face on the boundary.
  std::uint32_t facet(TetrahedronFace f) const { return facet_[f]; }
  bool is_on_boundary(TetrahedronFace f) const {
    return complex_.across(f) == LinkedTetrahedra::kNoFace;
  }
  bool is_segment(std::uint32_t a, std::uint32_t b) const {
    return segments_.contains(std::minmax(a, b));
  }
  const std::map<VertexPair, FacetPair>& segments() const { return segments_; }
  /// The facets that contain the vertex, ascending.
  const std::vector<std::uint32_t>& facets_at(std::uint32_t v) const { return facets_at_[v]; }
  /// Three points of the facet that are not on a line, with short numbers where it has any.
  const std::array<ExactPoint3, 3>& frame(std::uint32_t facet) const { return frames_[facet]; }
  /// The sign of d if p took the place of the corner opposite to f: positive for points inside.
  Sign side(TetrahedronFace f, const ExactPoint3& p) const;

  /// The tetrahedra around p whose spheres contain p, as far as p sees all their faces from inside, no vertex would
  /// be lost, and only facets that contain p change. Nothing if p is a vertex.
  /// REQUIRES that the closed tetrahedron t contains p.
  std::optional<RefineCavity> find_cavity(const ExactPoint3& p, std::uint32_t t) const;
  /// Replaces the cavity by a cone. Returns the new tetrahedra. REQUIRES the cavity of p in the present tetrahedra.
  std::vector<std::uint32_t> insert(ExactPoint3 p, const RefineCavity& cavity);

  /// The tetrahedra at a vertex that is a corner of some. @cost linear in their number
  std::vector<std::uint32_t> tetrahedra_at(std::uint32_t v) const;
  bool is_corner(std::uint32_t v) const { return at_vertex_[v] != kNoFacet; }
  /// Takes a vertex away: one of its neighbours replaces it in the tetrahedra that do not have both, the neighbour with
  /// which the flattest of these is least flat. False if each neighbour would turn one over, or change the boundary.
  bool remove_vertex(std::uint32_t v);

  /// The tetrahedra in the order of their slots.
  std::vector<TetrahedronCorners> tetrahedra() const;

 private:
  void find_facets();
  // Facets of faces on the boundary, before tetrahedra are replaced: of those that stay, and of edges over which new
  // ones arise.
  struct BoundaryNotes {
    std::map<std::array<std::uint32_t, 3>, std::uint32_t> kept;
    std::map<VertexPair, std::uint32_t> rim;
  };
  void note_kept(std::span<const TetrahedronFace> shell, BoundaryNotes& notes) const;
  void take_added(std::span<const std::uint32_t> added, std::uint32_t apex,
                  const BoundaryNotes& notes);
  double approx_shape_after(std::uint32_t v, std::uint32_t neighbour,
                            std::span<const std::uint32_t> star) const;
  void replace_vertex(std::uint32_t v, std::uint32_t neighbour,
                      std::span<const std::uint32_t> star);
  bool split_segment(const VertexPair& edge, std::uint32_t v);

  std::vector<ExactPoint3> points_;
  LinkedTetrahedra complex_;
  std::vector<std::uint32_t> facet_;  // for each face
  std::map<VertexPair, FacetPair> segments_;
  std::vector<std::vector<std::uint32_t>> facets_at_;
  std::vector<std::array<ExactPoint3, 3>> frames_;
  std::vector<std::uint32_t> at_vertex_;  // a tetrahedron
};

/// Whether each edge of the boundary belongs to two of its faces.
bool has_manifold_boundary(std::span<const TetrahedronCorners> tetrahedra);

/// Whether p is on the line through a and b; if so, whether strictly between them. REQUIRES a != b.
enum class LinePlace { kOff, kBetween, kBeyond };
LinePlace place_on_line(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& p);

}  // namespace veritope
