// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/patches/pn_mesh.h: a smooth surface over a triangle mesh with vertex normals: a cubic patch and a quadratic
// normal field for every triangle (splines/pn_triangle.h). Edges are computed once, so that both sides share their
// control points bit for bit.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "robust/dyadic.h"
#include "solids/polyhedron/triangle_mesh.h"
#include "splines/pn_triangle.h"

namespace veritope {

/// Made by make_pn_mesh and rounded.
template <Ring R>
class PnMesh {
 public:
  using Point = std::array<R, 3>;
  /// An undirected edge a < b.
  struct Edge {
    std::uint32_t a, b;
    std::array<Point, 2> points;  ///< the control points next to a and next to b
    Point normal;                 ///< the middle coefficient of the normals along it
  };

  std::size_t num_faces() const { return faces_.size(); }
  /// Each edge once, in the order of (a, b).
  std::span<const Edge> edges() const { return edges_; }
  /// The patch of a face; its corners are the face's, in the same order. On a common edge two faces have the same
  /// control points.
  BezierTriangle<R> points(std::size_t face) const;
  /// The normals of a face's patch: not normalised, and equal for both faces on a common edge.
  BezierTriangle<R> normals(std::size_t face) const;

 private:
  friend class PnMeshBuilder;
  std::vector<Point> corners_, corner_normals_;
  std::vector<std::array<std::uint32_t, 3>> faces_,
      edges_of_face_;  // edge e is opposite to corner e
  std::vector<Edge> edges_;
  std::vector<Point> centres_;
};

/// The exact patches. normals: of any length, one for each vertex; those of vertices that no face has are ignored.
/// @error kBadArgument with the face, the vertex and its corner: a degenerate triangle, a normal that is zero or 90
///        degrees or more off a triangle at the vertex; or the number of normals is not that of vertices. kNotFinite,
///        kIndexOutOfRange with the place.
/// @cost  approximately 50 microseconds per face for coordinates of all 53 bits
Result<PnMesh<Rational>> make_pn_mesh(const TriangleMesh& mesh, std::span<const Vec3d> normals);

/// A direction with exact coordinates.
using PnDirection = std::array<Dyadic, 3>;
/// Likewise.
Result<PnMesh<Rational>> make_pn_mesh(const TriangleMesh& mesh,
                                      std::span<const PnDirection> normals);

/// For each vertex the exact sum of (b - a) x (c - a) over its triangles (a, b, c): normals whose lengths are twice the
/// areas. REQUIRES ids in range, finite coordinates.
std::vector<PnDirection> area_normals(const TriangleMesh& mesh);

/// Rounds every number to nearest once: a control point has one value, whichever face asks.
/// @error kNotFinite with the face, if a control point is beyond the largest double.
Result<PnMesh<double>> rounded(const PnMesh<Rational>& mesh);

extern template class PnMesh<Rational>;
extern template class PnMesh<double>;

}  // namespace veritope
