// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/improper_pairs.h: all pairs of facets that meet outside their common simplex (rule M7).
#pragma once
#include <cstdint>
#include <vector>

#include "solids/polyhedron/broad_phase.h"
#include "solids/polyhedron/face_copies.h"
#include "solids/polyhedron/improper_places.h"

namespace veritope {

class WorkShare;

/// The search does not compare the sizes of up to this number of pairs.
inline constexpr std::size_t kMostUnordered = std::size_t{1} << 14;

struct ImproperPairs {
  std::uint64_t count = 0;        ///< exact
  std::vector<ImproperPlace> places;  ///< of all pairs
  /// Each with first < second. If ordered, the `max_listed` largest: by approx_common_extent, and ascending where that
  /// is equal; pairs of copies come last, and a longer list begins with a shorter one. If not, all of them, from which
  /// largest_pairs chooses: there are no copies, at most kMostUnordered pairs, and max_listed is positive.
  std::vector<FacetPair> pairs;
  bool is_ordered = false;
  bool long_thin = false;         ///< the box groups gave up and the separator walk decided
};

class MeetingCollector;

/// Finds the pairs among the facets of `boxes` and their copies: a pair of facets stands for as many pairs as they have
/// copies, and the copies of one facet meet each other.
/// REQUIRES that none of the facets is degenerate, and that none is a copy of another one. The result does not depend
/// on jobs. `work` may be null; its steps are the search by boxes and, for long thin facets, the walk. The collector,
/// if there is one, takes the pairs that the boxes found; all of them unless facets are long and thin.
ImproperPairs find_improper_pairs(const TriangleMesh& mesh, const BoxGroups& boxes,
                                  const std::vector<std::uint32_t>& facets, const VertexStars& stars,
                                  std::size_t max_listed, unsigned jobs,
                                  const FaceCopies& copies = {}, WorkShare* work = nullptr,
                                  MeetingCollector* collector = nullptr);

/// The ordered list of pairs that are not ordered.
/// @cost approximately 0.5 microseconds a pair.
std::vector<FacetPair> largest_pairs(const TriangleMesh& mesh, const std::vector<FacetPair>& pairs,
                                     std::size_t max_listed);

}  // namespace veritope
