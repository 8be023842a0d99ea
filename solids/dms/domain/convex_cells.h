// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/domain/convex_cells.h: a complex of convex cells, at first tetrahedra, that planes cut one by one.
// Each cut splits one cell, and the faces and edges that others share with it: both cells of a face have the same one,
// and a side of a cell may consist of several faces.
// Every plane runs through three input points. So every vertex is an input point, a point of a line through two of
// them on a plane, or a point on three planes, and no decision depends on a rounded one.
// Source: [DA21], re-derived.  Design: docs/design/0094-domains-of-meshes.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "predicates/implicit_cache.h"
#include "predicates/implicit_predicates.h"
#include "predicates/vec.h"
#include "robust/base/sign.h"
#include "solids/dms/dms_model.h"
#include "topology/tetrahedral_complex.h"

namespace veritope {

/// Three input points, not on a line.
using CellPlane = std::array<std::uint32_t, 3>;

/// Two input points, or two planes.
struct CellLine {
  bool is_explicit = true;
  std::array<std::uint32_t, 2> of{};
};

/// No cell: outside of the hull.
inline constexpr std::uint32_t kNoCell = 0xffffffffu;

struct CellEdge {
  std::array<std::uint32_t, 2> ends{};
  CellLine line;
  std::vector<std::uint32_t> faces;
};

/// A convex polygon; angles of 180 degrees are allowed. Edge i joins corners i and i + 1.
struct CellFace {
  std::vector<std::uint32_t> corners, edges;
  std::uint32_t plane = 0;
  std::array<std::uint32_t, 2> cells{kNoCell, kNoCell};
};

/// The cell lies on the side `side` of a plane, not 0.
struct CellHalfSpace {
  std::uint32_t plane = 0;
  Sign side = Sign::kPositive;
};

struct ConvexCell {
  std::vector<std::uint32_t> faces;
  std::vector<CellHalfSpace> sides;  ///< its facets: one for each plane of its faces
  std::uint32_t tetrahedron = 0;     ///< of which it is a part
};

class ConvexCells {
 public:
  /// The tetrahedra, as cells of their numbers. The first planes are `planes`, those of the tetrahedra's faces come
  /// after them. REQUIRES finite points, positively oriented tetrahedra that meet in common faces, edges and vertices;
  /// `points` outlives this.
  ConvexCells(std::span<const Vec3d> points, std::span<const TetrahedronCorners> tetrahedra,
              std::vector<CellPlane> planes);

  std::span<const Vec3d> points() const { return points_; }
  const std::vector<CellPlane>& planes() const { return planes_; }
  const std::vector<CellEdge>& edges() const { return edges_; }
  const std::vector<CellFace>& faces() const { return faces_; }
  const std::vector<ConvexCell>& cells() const { return cells_; }
  /// The input points are the first vertices.
  std::size_t num_vertices() const { return vertices_.size(); }

  AnyPoint3 vertex(std::uint32_t v) const;
  /// The exact coordinates. @cost determinants of integers, a gcd each
  DmsPoint place(std::uint32_t v) const;
  bool is_input(std::uint32_t v) const { return v < points_.size(); }

  /// The sign of orient3d of the plane's points and the vertex.
  Sign side(std::uint32_t plane, std::uint32_t v) const;
  Sign side(const std::array<Vec3d, 3>& plane, std::uint32_t v) const;
  /// The side of the point where an edge crosses a plane. REQUIRES an edge whose ends lie on different sides of
  /// `crossed`.
  Sign side_of_crossing(const std::array<Vec3d, 3>& plane, std::uint32_t edge,
                        std::uint32_t crossed) const;

  /// The vertices and the edges of a cell, each once, in the order of its faces.
  struct Skeleton {
    std::vector<std::uint32_t> vertices, edges;
  };
  const Skeleton& skeleton(std::uint32_t cell) const;

  /// Cuts the cell. It keeps its number and is the part on the positive side; the part on the negative side is
  /// returned. REQUIRES a plane with vertices of the cell strictly on both sides.
  std::uint32_t cut(std::uint32_t cell, std::uint32_t plane);

 private:
  struct Vertex {
    enum class Kind : std::uint8_t { kInput, kLinePlane, kThreePlanes } kind = Kind::kInput;
    std::array<std::uint32_t, 3> of{};  // a line's two points and a plane; three planes
    std::uint32_t number = 0;           // in line_planes_ or three_planes_
  };

  std::array<Vec3d, 3> points_of(std::uint32_t plane) const;
  LinePlanePoint line_plane(const std::array<std::uint32_t, 2>& line, std::uint32_t plane) const;
  ThreePlanePoint three_planes(const std::array<std::uint32_t, 2>& line, std::uint32_t plane) const;
  std::uint32_t add_edge(std::uint32_t a, std::uint32_t b, const CellLine& line);
  std::uint32_t add_crossing(const CellLine& line, std::uint32_t plane);
  CellLine line_of(std::uint32_t plane, std::uint32_t other) const;
  Sign& mark(std::uint32_t v) { return marks_[v]; }
  void split_edge(std::uint32_t edge, std::uint32_t plane);
  void split_face(std::uint32_t face, std::uint32_t plane);
  std::uint32_t add_section(std::uint32_t cell, std::uint32_t plane);
  std::uint32_t part_faces(std::uint32_t cell, std::uint32_t section);

  std::span<const Vec3d> points_;
  std::vector<CellPlane> planes_;
  std::vector<Vertex> vertices_;
  std::deque<CachedPoint<LinePlanePoint>> line_planes_;
  std::deque<CachedPoint<ThreePlanePoint>> three_planes_;
  std::vector<CellEdge> edges_;
  std::vector<CellFace> faces_;
  std::vector<ConvexCell> cells_;
  std::vector<Sign> marks_;  // for each vertex its side of the plane that cuts, where it is known
  mutable Skeleton skeleton_;
  mutable std::vector<std::uint32_t> vertex_seen_, edge_seen_;
  mutable std::uint32_t round_ = 0;
};

}  // namespace veritope
