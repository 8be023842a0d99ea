// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/hexahedral_v_complex.h: the V-complex of cuboids whose faces are glued, collapsed, or on the boundary.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "robust/base/result.h"
#include "topology/v_complex.h"

namespace veritope {

/// Numbers in a cuboid with the axes 0, 1, 2. Face 2 a + e is at the begin (e = 0) or end (e = 1) of axis a; its two
/// parameters are the other axes, ascending. Corner e0 + 2 e1 + 4 e2. Edge 4 a + e_p + 2 e_q runs along axis a, at the
/// ends e_p, e_q of the other two, p < q.
struct HexahedralFace {
  enum class Kind {
    kBoundary,     ///< a half-V-surface without a mate
    kGlued,        ///< to a face of a cell
    kToPoint,      ///< collapsed onto a point
    kAlongFirst,   ///< collapsed onto a curve: constant in its first parameter
    kAlongSecond,  ///< ... in its second parameter
  };
  Kind kind = Kind::kBoundary;
  std::uint32_t cell = 0, face = 0;  ///< for kGlued, the other face
  /// For kGlued, the map from this face's parameters to those of the other one. Bits, in this order: 1 exchange the
  /// two, 2 reverse the first, 4 reverse the second. The other face may say kBoundary, or kGlued with the inverse map.
  std::uint32_t symmetry = 0;
};

/// A cuboid with the trivariate of its own number.
struct HexahedralCell {
  std::array<HexahedralFace, 6> faces;
  /// Edges that are collapsed onto points; those of collapsed faces need not be marked.
  std::array<bool, 12> is_collapsed{};
  /// Its axes are left-handed. The first one of connected cells decides for all of them.
  bool is_reversed = false;
};

struct HexahedralVComplex {
  VComplex complex;               ///< V-cell i is cuboid i
  std::vector<bool> is_reversed;  ///< of each cell: its axes are left-handed
  /// The elements of each cell's faces, edges and corners; none for those that are collapsed.
  std::vector<std::array<HalfVSurfaceId, 6>> half_surfaces;
  std::vector<std::array<VCurveId, 12>> curves;
  std::vector<std::array<VPointId, 8>> points;
  /// The edge runs against its V-curve, which runs as the least edge of its class (by cell, then number).
  std::vector<std::array<bool, 12>> is_edge_reversed;
};

/// V-points are the classes of corners that gluing and collapsed edges generate; V-curves those of the other edges that
/// gluing and faces collapsed along an axis generate (their two other edges become one); the faces that are not
/// collapsed are half-V-surfaces, in the order of cells and faces. V-points and V-curves are in the order of their
/// least corners and edges. The first one of connected cells is reversed if it says so, and the others where glued
/// faces demand it.
/// @error kBadArgument, place.entity = a cell; the message calls the axes u, v, w (face v1, edge u0v1): a number that
///   does not exist, a face glued twice, to itself or to a collapsed one; an edge that is collapsed on one side only; a
///   face with four collapsed edges that is not collapsed; an edge between collapsed faces only; gluings that no choice
///   of reversed cells makes orientable
/// @cost O(n)
Result<HexahedralVComplex> hexahedral_v_complex(const std::vector<HexahedralCell>& cells);

/// The symmetry of the inverse map.
std::uint32_t inverse_symmetry(std::uint32_t symmetry);

}  // namespace veritope
