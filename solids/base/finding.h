// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/base/finding.h: what was found about a model, where, and what shows it: one shape for every kind of model.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robust/base/box3d.h"
#include "robust/base/result.h"
#include "robust/base/sign.h"
#include "robust/rational.h"

namespace veritope {

/// A point with rational coordinates.
struct RationalPoint {
  std::array<Rational, 3> at;
};

/// A part of an entity of a spline file: bounds of its parameters, rounded outward. A surface has two parameters, u and
/// v; a triangle has three, its barycentric coordinates; a volume has three, u, v and w.
struct EntityPart {
  std::uint64_t entity = 0;
  /// The side of the entity, in the entity's own direction, if the part lies in a side. Nothing for a volume.
  std::optional<std::uint8_t> side;
  std::vector<std::array<double, 2>> parameters;
  /// The boundary face of a volume on which the part lies, 2 axis + end; nothing for other entities.
  std::optional<std::uint8_t> face = std::nullopt;
  /// Whether the entity is a volume of which this is a part that need not lie on a face.
  bool is_of_volume = false;
};

/// Where in a model. Only what is known is set. All numbers count from 0; lengths are in the model's units.
struct ModelPlace {
  Place source;  ///< in the file: a line, a byte, an entity

  // Meshes. Ids of faces and vertices are those of the TriangleMesh.
  std::vector<std::uint32_t> faces;  ///< ascending, except M5 and M6: see SurfaceTopology
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;  ///< the edge of M3, M4, M5
  std::vector<std::uint32_t> vertices;  ///< the vertex of M6; the corners of M1 and M2
  std::optional<std::pair<std::uint32_t, std::uint32_t>>
      near_edge;  ///< M3: the open edge that is nearest to it
  /// The polygon of the file that each face was cut from; empty if all polygons are triangles.
  std::vector<std::uint32_t> polygons;

  // Patches.
  std::vector<EntityPart> parts;       ///< of the file's entities
  std::optional<std::uint32_t> patch;  ///< of a PatchComplex
  std::optional<std::uint32_t> shell;

  std::optional<Point3d> near;  ///< a point of the place, rounded
  std::optional<Box3d> box;     ///< contains what was found; may be infinite
  double size = 0;  ///< extent, rounded: edge length, diameter, length of the intersection
};

/// A point of a volume at which the Jacobian determinant of its map has a sign.
struct FoldPoint {
  std::array<Rational, 3> parameters;  ///< of the file
  RationalPoint point;
  Sign sign = Sign::kZero;
};

/// A place of a cell of a V-model. Only what is known is set.
struct CellPlace {
  std::uint64_t cell = 0;
  std::string part;  ///< "u0", "u0v1", "u0v1w0": a face, an edge, a corner; empty: none of them
  std::optional<std::array<Rational, 3>> parameters;          ///< of the file
  std::optional<std::array<std::array<Rational, 2>, 3>> box;  ///< of parameters
};

/// What shows a finding. Only what is known is set; the certificate has the whole proof.
struct Witness {
  std::optional<RationalPoint> point;  ///< an exact point of the defect
  /// Meshes: the ends of the edge (M3, M4, M5), in the order of place.edges; two points of greatest distance in the
  /// intersection of two faces (M7), if it is not a point.
  std::optional<std::array<RationalPoint, 2>> ends;
  /// The winding number on the inner side of place.shell, which is not 1.
  std::optional<int> winding;
  /// M3: the square of the gap to place.near_edge; exact.
  std::optional<Rational> squared_gap;
  /// A volume that folds: where the determinant is positive, then where it is negative.
  std::optional<std::array<FoldPoint, 2>> fold;
  /// The places of a V-model's cells where the defect shows.
  std::vector<CellPlace> cells;
  /// Between the two parts of the place, or the gap to place.near_edge; approximate.
  std::optional<double> approx_distance;
};

/// One thing that was found.
struct Finding {
  /// A stable word: a mesh rule ("M7"), what is proved wrong with patches ("side-open"), or why there is no verdict
  /// ("not-certified").
  std::string code;
  ModelPlace place;
  std::string message;  ///< one sentence
  Witness witness;
};

/// A finding with code_name(error.code), the place in the file, and the message of the error.
Finding finding_of(const Error& error);

/// "line 12: <message>": the place in the file without the file's name.
std::string text_of(const Finding& finding);

}  // namespace veritope
