// SPDX-License-Identifier: LGPL-3.0-or-later
#include <utility>

#include "robust/base/check.h"
#include "solids/chain/base_side.h"
#include "solids/chain/literal_facet_internal.h"

namespace veritope::internal {
namespace {

// The corner of the patch that is corner k of the facet.
std::uint32_t corner_of_patch(std::uint32_t half, std::uint32_t k) {
  return half == 0 || k == 0 ? k : k + 1;
}

}  // namespace

LiteralFacets::LiteralFacets(const PatchComplex& complex) {
  edges_.resize(complex.num_edges());
  for (std::uint32_t p = 0; p < complex.patches().size(); ++p) {
    const bool is_triangle = complex.patch(p).is_triangle();
    if (!is_triangle) edges_.emplace_back();  // its diagonal, for both halves
    for (std::uint32_t half = 0; half < (is_triangle ? 1u : 2u); ++half)
      add_facet(complex, p, half);
  }
  add_planes();
  for (LiteralFacet& facet : facets_) add_wedge(facet);
}

void LiteralFacets::add_facet(const PatchComplex& complex, std::uint32_t p, std::uint32_t half) {
  const Patch& patch = complex.patch(p);
  const bool is_triangle = patch.is_triangle();
  LiteralFacet facet;
  facet.patch = p;
  facet.half = half;
  for (std::uint32_t k = 0; k < 3; ++k)
    facet.corners[k] = *point_of(patch.corner(corner_of_patch(half, k)));
  facet.normal =
      cross(minus(facet.corners[1], facet.corners[0]), minus(facet.corners[2], facet.corners[0]));
  const auto number = static_cast<std::uint32_t>(facets_.size());
  const std::uint32_t diagonal_side = half == 0 ? 2 : 0;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const bool is_diagonal = !is_triangle && k == diagonal_side;
    const PatchSide side{p, is_triangle || half == 0 ? k : k + 1};
    if (!is_diagonal && complex.is_collapsed(side)) {
      facet.edges[k] = LiteralFacet::kNone;
      continue;
    }
    facet.edges[k] =
        is_diagonal ? static_cast<std::uint32_t>(edges_.size()) - 1 : complex.edge(side);
    LiteralEdge& edge = edges_[facet.edges[k]];
    const std::size_t at = edge.facets[0] == LiteralFacet::kNone ? 0 : 1;
    VT_CHECK(edge.facets[at] == LiteralFacet::kNone, "an edge of a closed surface has two sides");
    edge.facets[at] = number;
    edge.sides[at] = k;
    if (at == 0)
      edge.vertices = {complex.vertex({p, corner_of_patch(half, k)}),
                       complex.vertex({p, corner_of_patch(half, (k + 1) % 3)})};
  }
  if (!patch.is_flat_triangle()) facet.map = triangles_of(patch)[half];
  facets_.push_back(std::move(facet));
}

void LiteralFacets::add_planes() {
  for (LiteralEdge& edge : edges_) {
    const LiteralFacet& a = facets_[edge.facets[0]];
    const LiteralFacet& b = facets_[edge.facets[1]];
    const std::size_t k = edge.sides[0];
    edge.plane = cross(plus(a.normal, b.normal), minus(a.corners[(k + 1) % 3], a.corners[k]));
  }
}

void LiteralFacets::add_wedge(LiteralFacet& facet) const {
  facet.has_wedge = !is_zero(facet.normal);
  for (std::size_t k = 0; k < 3; ++k) {
    if (facet.edges[k] == LiteralFacet::kNone) {
      facet.has_wedge = false;
      continue;
    }
    facet.walls[k] = edges_[facet.edges[k]].plane;
    facet.offsets[k] = dot(facet.walls[k], facet.corners[k]);
    const Sign inward = facet.over_wall(k, facet.corners[(k + 2) % 3]).sign();
    if (inward == 0) facet.has_wedge = false;
    if (inward < 0) {
      facet.walls[k] = times(Rational(-1), facet.walls[k]);
      facet.offsets[k].negate();
    }
  }
}

Patch::Curve side_of(const LiteralFacet& facet, std::size_t k) {
  // boundary_curve's edge e is opposite to corner e.
  return boundary_curve(*facet.map, static_cast<int>((k + 2) % 3));
}

}  // namespace veritope::internal
