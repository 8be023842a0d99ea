// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/improper_pairs.h: all pairs of facets that meet outside their common simplex (rule M7).
#pragma once
#include <cstdint>
#include <vector>

#include "solids/polyhedron/broad_phase.h"
#include "solids/polyhedron/face_copies.h"
#include "solids/polyhedron/improper_places.h"

namespace veritope {

struct ImproperPairs {
  std::uint64_t count = 0;        ///< exact
  std::vector<ImproperPlace> places;  ///< of all pairs
  /// The `max_listed` largest, each with first < second: by approx_common_extent, and ascending where that is equal.
  /// Pairs of copies come last. A longer list begins with a shorter one.
  std::vector<FacetPair> largest;
  bool long_thin = false;         ///< the box groups gave up and the separator walk decided
};

/// Finds the pairs among the facets of `boxes` and their copies: a pair of facets stands for as many pairs as they have
/// copies, and the copies of one facet meet each other.
/// REQUIRES that none of the facets is degenerate, and that none is a copy of another one. The result does not depend
/// on jobs.
ImproperPairs find_improper_pairs(const TriangleMesh& mesh, const BoxGroups& boxes,
                                  const std::vector<std::uint32_t>& facets, const VertexStars& stars,
                                  std::size_t max_listed, unsigned jobs,
                                  const FaceCopies& copies = {});

}  // namespace veritope
