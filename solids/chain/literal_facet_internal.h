// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/literal_facet_internal.h: the base triangles of a model with the planes of definition 8 of seed 001
// [GRF03], in rationals, and the wedge between the three planes of a triangle.  Theory: docs/THEORY.md, CHAIN-6.
// Internal to solids/chain.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "solids/chain/exact_vector_internal.h"
#include "solids/patches/patch_complex.h"

namespace veritope::internal {

/// A base triangle and the patch over it. Tensor patches are cut along the diagonal of their domain from corner 0 to
/// corner 2 into two Bezier triangles, exactly; so each is two facets.
struct LiteralFacet {
  static constexpr std::uint32_t kNone = 0xffffffffu;

  std::uint32_t patch = 0, half = 0;
  std::array<ExactPoint, 3> corners;
  ExactPoint normal;  ///< of the base, not of unit length; zero: the base has no area
  /// Side k runs from corner k to corner k + 1.
  std::array<std::uint32_t, 3>
      edges{};                      ///< numbers in LiteralFacets::edges; kNone: the side is a point
  std::array<ExactPoint, 3> walls;  ///< the normal of each side's plane, to the side of the base
  std::array<Rational, 3> offsets;  ///< walls[k] . corner k
  bool has_wedge =
      false;  ///< all three planes exist, and none is that of the base, which has an area
  std::optional<Patch::Triangle> map;  ///< nothing: it is the base itself

  /// Positive on the side of the base.
  Rational over_wall(std::size_t k, const ExactPoint& p) const {
    return dot(walls[k], p) - offsets[k];
  }
  Rational height(const ExactPoint& p) const { return dot(normal, minus(p, corners[0])); }
};

/// Two base triangles that share a chord.
struct LiteralEdge {
  std::array<std::uint32_t, 2> facets{LiteralFacet::kNone, LiteralFacet::kNone};
  std::array<std::uint32_t, 2> sides{};     ///< of these facets
  std::array<std::uint32_t, 2> vertices{};  ///< of the complex, at the ends of side sides[0]
  ExactPoint
      plane;  ///< its normal; zero: the ends coincide, or the triangles' normals are opposite
};

/// REQUIRES a closed oriented surface.
class LiteralFacets {
 public:
  explicit LiteralFacets(const PatchComplex& complex);

  const std::vector<LiteralFacet>& facets() const { return facets_; }
  const std::vector<LiteralEdge>& edges() const { return edges_; }

 private:
  void add_facet(const PatchComplex& complex, std::uint32_t patch, std::uint32_t half);
  void add_planes();
  void add_wedge(LiteralFacet& facet) const;

  std::vector<LiteralFacet> facets_;
  std::vector<LiteralEdge> edges_;
};

/// The side of a facet's patch as a curve from corner k to corner k + 1. REQUIRES facet.map.
Patch::Curve side_of(const LiteralFacet& facet, std::size_t k);

}  // namespace veritope::internal
