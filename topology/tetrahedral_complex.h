// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/tetrahedral_complex.h: tetrahedra with vertex ids as a cell complex: which faces they share, the boundary,
// and the links of vertices and edges. Integers only, no coordinates.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace veritope {

/// Four different vertex ids.
using TetrahedronCorners = std::array<std::uint32_t, 4>;

/// The corners of face m, the one opposite to corner m, counter-clockwise as seen from outside of a tetrahedron (p, q,
/// r, s) with det(q - p, r - p, s - p) > 0.
inline constexpr std::array<std::array<std::uint8_t, 3>, 4> kTetrahedronFaces{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// Face m of tetrahedron t is 4 * t + m.
using TetrahedronFace = std::uint32_t;
inline std::uint32_t face_tetrahedron(TetrahedronFace f) { return f >> 2; }
inline std::uint32_t face_corner(TetrahedronFace f) { return f & 3u; }

/// Three vertices that are not the face of one tetrahedron, or of two in opposite orientations.
struct FaceOveruse {
  std::array<std::uint32_t, 3> vertices{};  ///< ascending
  std::vector<TetrahedronFace> faces;       ///< all that have these vertices, ascending
};

enum class LinkKind {
  kEmpty,   ///< no tetrahedron is there
  kClosed,  ///< a sphere at a vertex, a cycle at an edge
  kOpen,    ///< a disc at a vertex, a path at an edge
  kOther,
};

/// Immutable.
class TetrahedralComplex {
 public:
  static constexpr std::size_t kMaxTetrahedra = std::size_t{1} << 29;

  /// REQUIRES ids < num_vertices, four different ones in each tetrahedron, at most kMaxTetrahedra tetrahedra.
  /// @cost a sort of the faces; 60 bytes a tetrahedron
  TetrahedralComplex(std::vector<TetrahedronCorners> tetrahedra, std::uint32_t num_vertices);

  const std::vector<TetrahedronCorners>& tetrahedra() const { return tetrahedra_; }
  std::uint32_t num_vertices() const { return static_cast<std::uint32_t>(first_.size() - 1); }

  /// The vertices of a face in the order of kTetrahedronFaces.
  std::array<std::uint32_t, 3> vertices(TetrahedronFace f) const;
  /// The other face with these vertices, if there are exactly two and their orientations are opposite.
  std::optional<TetrahedronFace> partner(TetrahedronFace f) const;
  /// All sets of vertices that are faces too often or in one orientation twice, in ascending order of the vertices.
  const std::vector<FaceOveruse>& overused() const { return overused_; }
  /// The faces whose vertices are no face of another tetrahedron, ascending.
  const std::vector<TetrahedronFace>& boundary() const { return boundary_; }

  /// The tetrahedra at a vertex, ascending. REQUIRES v < num_vertices().
  std::span<const std::uint32_t> tetrahedra_at(std::uint32_t v) const {
    return {at_vertex_.data() + first_[v], at_vertex_.data() + first_[v + 1]};
  }
  /// Those that have both vertices, ascending. @cost the lesser number of tetrahedra at one of them
  std::vector<std::uint32_t> tetrahedra_at(std::uint32_t a, std::uint32_t b) const;
  /// The faces opposite to v of the tetrahedra at v, as seen from outside of these.
  std::vector<std::array<std::uint32_t, 3>> link(std::uint32_t v) const;
  /// The pairs (c, d) such that (a, b, c, d) is an even permutation of a tetrahedron's corners.
  std::vector<std::array<std::uint32_t, 2>> link(std::uint32_t a, std::uint32_t b) const;

  /// How many vertices, edges, triangles (as sets of ids) and tetrahedra there are; vertices of no tetrahedron do not
  /// count. @cost linear, but for a sort of the edges at each vertex
  std::array<std::uint64_t, 4> counts() const;
  std::int64_t euler() const;

 private:
  void pair_faces();
  void collect_corners();

  std::vector<TetrahedronCorners> tetrahedra_;
  std::vector<std::uint32_t> first_, at_vertex_;  // of each vertex its tetrahedra
  std::vector<TetrahedronFace> partner_;          // itself: none
  std::vector<FaceOveruse> overused_;
  std::vector<TetrahedronFace> boundary_;
  std::uint64_t num_triangles_ = 0;
};

/// What the triangles of a vertex' link are: a sphere, a disc, or something else.
/// @cost n log n for n triangles
LinkKind classify_link(std::span<const std::array<std::uint32_t, 3>> triangles);
/// What the directed pairs of an edge's link are: one cycle, one path, or something else.
LinkKind classify_link(std::span<const std::array<std::uint32_t, 2>> pairs);

/// Is the permutation that sorts four different numbers even?
bool is_even(const TetrahedronCorners& corners);

}  // namespace veritope
