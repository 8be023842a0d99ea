// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/pieces/piece_descent.h: the pieces whose closed hulls meet a box or another region, as small as the caller
// requires: condition T of docs/THEORY.md §4.
#pragma once
#include <cstddef>

#include "solids/pieces/piece_forest.h"

namespace veritope {

enum class PieceStep {
  kTaken,  ///< this piece is small enough
  kSplit,  ///< visit its four children instead
  kStop,   ///< the descent fails
};

/// Calls step(id) for the pieces whose closed hulls meet the region, from the roots on, parents before their children.
/// meets_region(b) says whether a box may meet it; it must say so of a box that contains one of which it does.
/// Every part of V that meets the region lies in a piece that was taken. Returns false if a step stopped the descent,
/// if it visited more than max_visits pieces, or if a piece was to be split that may not be (PieceForest::may_split).
/// Hulls may be unbounded, where weights are not known to be positive, and all pieces of such a patch meet every
/// region: hence the budget.
template <typename MeetsRegion, typename Step>
class PieceDescent {
 public:
  PieceDescent(PieceForest& forest, MeetsRegion meets_region, std::size_t max_visits, Step step)
      : forest_(forest), meets_region_(meets_region), left_(max_visits), step_(step) {}

  bool run() {
    bool is_done = true;
    forest_.roots().visit(
        [&](const Box3d& b) { return is_done && meets_region_(b); },
        [&](std::uint32_t number) { is_done = is_done && visit(forest_.root(number)); });
    return is_done;
  }

 private:
  bool visit(PieceForest::Id id) {
    if (!meets_region_(forest_.node(id).hull)) return true;
    if (left_ == 0) return false;
    --left_;
    const PieceStep step = step_(id);
    if (step != PieceStep::kSplit) return step == PieceStep::kTaken;
    if (!forest_.may_split(id)) return false;
    const PieceForest::Id first = forest_.children(id);
    for (PieceForest::Id k = 0; k < 4; ++k)
      if (!visit(first + k)) return false;
    return true;
  }

  PieceForest& forest_;
  MeetsRegion meets_region_;
  std::size_t left_;
  Step step_;
};

template <typename MeetsRegion, typename Step>
bool descend_where(PieceForest& forest, MeetsRegion meets_region, std::size_t max_visits,
                   Step step) {
  return PieceDescent<MeetsRegion, Step>(forest, meets_region, max_visits, step).run();
}
template <typename Step>
bool descend_to(PieceForest& forest, const Box3d& box, std::size_t max_visits, Step step) {
  return descend_where(
      forest, [&](const Box3d& b) { return meets(b, box); }, max_visits, step);
}

}  // namespace veritope
