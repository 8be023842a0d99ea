// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_domain.h: whether positively oriented tetrahedra whose faces are not overused are a domain: the rules
// M4, M6, M7 and M9 of docs/certificates/mesh.md for the boundary, decided exactly. (The others hold: no tetrahedron is
// flat, and a boundary has none.)
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "predicates/exact_point.h"
#include "solids/dms/dms_model.h"

namespace veritope {

/// M4: an edge of three faces of the boundary or more.
struct DmsCrowdedEdge {
  std::array<std::uint32_t, 2> vertices{};  ///< ascending
  std::vector<TetrahedronFace> faces;       ///< ascending
};
/// M6: the faces of the boundary at a vertex form more than one fan.
struct DmsPinchedVertex {
  std::uint32_t vertex = 0;
  std::size_t fans = 0;
};
/// M7: two faces of the boundary have a point in common that is not of their common vertices or edge: the mean of the
/// vertices of each with the weights, in the face's order.
struct DmsImproperFaces {
  std::array<TetrahedronFace, 2> faces{};
  /// Weights >= 0 whose sum is 1; one of the first ones is of a vertex that the second face does not have, and > 0.
  std::array<std::array<Rational, 3>, 2> weights;
  DmsPoint point;
};
/// M9: two tetrahedra with a common inner point.
struct DmsOverlap {
  std::array<std::uint32_t, 2> tetrahedra{};  ///< ascending
  DmsPoint point;
};

struct DmsDomainDefects {
  std::vector<DmsCrowdedEdge> crowded;     ///< all, ascending
  std::vector<DmsPinchedVertex> pinched;   ///< all, ascending
  std::vector<DmsImproperFaces> improper;  ///< the first ones, at most kMaxImproper
  std::vector<DmsOverlap>
      overlaps;  ///< at most one for each shell; sought if there is nothing else
  static constexpr std::size_t kMaxImproper = 1000;
};

/// REQUIRES the complex of the model, no face that is overused, d > 0 for all tetrahedra.
/// @cost near-linear: a few signs for each two faces of the boundary whose boxes meet
DmsDomainDefects find_domain_defects(const DmsModel& model, const TetrahedralComplex& complex);

namespace internal {
/// The improper common point of two triangles of different vertices; nothing if they have no such point.
/// @param ids  of the corners; equal ids are equal points. REQUIRES corners that are not on one line
struct CornersWithIds {
  std::array<std::uint32_t, 3> ids{};
  std::array<const ExactPoint3*, 3> points{};
};
struct ImproperPoint {
  bool is_swapped = false;  ///< the first weights are those of the second triangle
  std::array<std::array<Rational, 3>, 2> weights;
  DmsPoint point;
};
std::optional<ImproperPoint> find_improper_point(const CornersWithIds& f, const CornersWithIds& g);
}  // namespace internal

}  // namespace veritope
