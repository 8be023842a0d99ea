// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/intersect/intersection_search.h: covers the common points of two surfaces by tubes, by subdivision of the
// pair of parameter domains. The first half of surface_intersection.h.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "interval/intersect/intersection_tube.h"

namespace veritope {

struct IntersectionBudget {
  /// A pair of rectangles is not cut further when its sides are this fraction of their spans.
  double smallest = 0x1p-30;
  /// Pairs that are to be cut and touch each other form a cluster. A cluster is given up at its size if it has more
  /// pairs than pairs_in_cluster plus pairs_per_piece for each piece of both surfaces. Contact along an area or a curve
  /// ends so.
  std::size_t pairs_in_cluster = 1500, pairs_per_piece = 15;
  /// Limits the number of all pairs examined.
  std::uint64_t pairs = 200'000'000;
  /// Called now and then; if it returns true, the search ends, and what is left is undecided.
  std::function<bool()> stop;
};

/// Why a pair of rectangles was not decided.
enum class OpenPair {
  kSmallest,  ///< at the smallest size: close to tangential, or within rounding
  kCluster,   ///< one of very many that touch: contact along a curve or an area, or nearly so
  kBudget,    ///< the budget was spent, or the search was stopped
};

struct IntersectionCover {
  /// Every common point of the closed domains lies in a tube or in an undecided box.
  std::vector<IntersectionTube> tubes;
  std::vector<Box4> undecided;
  std::vector<OpenPair> reasons;  ///< one for each undecided box
  std::uint64_t pairs = 0;        ///< rectangles compared
  std::uint64_t proofs = 0;       ///< tubes tried
};

/// REQUIRES a live ScopedUpward.
IntersectionCover cover_intersection(const EnclosedSurface& s1, const EnclosedSurface& s2,
                                     const IntersectionBudget& budget);

/// Groups of boxes that are connected through common points, as index lists.
std::vector<std::vector<std::size_t>> clusters_of(const std::vector<Box4>& boxes);

}  // namespace veritope
