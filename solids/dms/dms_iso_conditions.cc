// SPDX-License-Identifier: LGPL-3.0-or-later
// The conditions of a whole model under which bounds of an attribute by its terms hold (docs/THEORY.md, DMS-1).
#include <algorithm>
#include <map>
#include <variant>

#include "solids/dms/dms_hulls.h"
#include "solids/dms/dms_iso.h"
#include "solids/dms/dms_iso_form.h"
#include "solids/dms/dms_knots.h"
#include "solids/dms/dms_region.h"

namespace veritope {
namespace {

using FourPoints = std::array<DmsPoint, 4>;

// Whether all of a are on one closed side of the plane, and all of b on the other.
bool is_between(const DmsPlane& plane, const FourPoints& a, const FourPoints& b) {
  const int side = side_of_plane(a, plane);
  return side != 0 && side_of_plane(b, plane) == -side;
}

// Two tetrahedra have disjoint interiors iff a plane through a face of one, or along an edge of each, parts them.
bool are_apart(const FourPoints& a, const FourPoints& b) {
  for (const FourPoints* of : {&a, &b})
    for (const DmsPlane& plane : face_planes(*of))
      if (is_between(plane, a, b)) return true;
  for (const auto& [i, j] : kDmsEdges)
    for (const auto& [k, l] : kDmsEdges) {
      DmsPlane plane{cross_product(difference(a[j], a[i]), difference(b[l], b[k])), {}};
      plane.number = dot_product(plane.vector, a[i]);
      if (is_between(plane, a, b)) return true;
    }
  return false;
}

bool has_overlap(const DmsModel& model, const DmsKnotTable& knots) {
  for (std::uint32_t t = 0; t < model.tetrahedra.size(); ++t) {
    const FourPoints a = knots.corners(t);
    for (const std::uint32_t other : knots.tetrahedra_near(box_around(a)))
      if (other > t && !are_apart(a, knots.corners(other))) return true;
  }
  return false;
}

// Whether neighbourhoods of vertices and edges are balls or half balls.
bool is_pinched(const TetrahedralComplex& complex) {
  for (std::uint32_t v = 0; v < complex.num_vertices(); ++v)
    if (classify_link(complex.link(v)) == LinkKind::kOther) return true;
  for (const TetrahedronCorners& t : complex.tetrahedra())
    for (const auto& [i, j] : kDmsEdges)
      if (classify_link(complex.link(t[i], t[j])) == LinkKind::kOther) return true;
  return false;
}

bool attribute_disagrees(const DmsModel& model, std::size_t attribute) {
  std::map<std::vector<std::uint32_t>, Rational> seen;
  bool found = false;
  for (std::uint32_t t = 0; t < model.tetrahedra.size(); ++t)
    for_each_tetrahedral_index(model.degree, [&](const TetrahedralIndex& beta) {
      const Rational& value = model.value(control_of(model, t, beta))[3 + attribute];
      const auto [at, is_new] =
          seen.try_emplace(control_vertices(model.tetrahedra[t], beta), value);
      found = found || (!is_new && at->second != value);
    });
  return found;
}

}  // namespace

std::optional<std::string> find_dms_iso_obstacle(const DmsModel& model, std::size_t attribute) {
  const DmsKnotTable knots(model);
  if (has_overlap(model, knots)) return "domain-overlap";
  const TetrahedralComplex complex(model.tetrahedra,
                                   static_cast<std::uint32_t>(model.clouds.size()));
  if (is_pinched(complex)) return "domain-pinched";
  if (std::holds_alternative<DmsOpenHull>(part_hulls(model, complex))) return "cloud-inside";
  if (model.control.is_separate && attribute_disagrees(model, attribute))
    return "control-disagrees";
  return std::nullopt;
}

}  // namespace veritope
