// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/interval_boxes/cover_check_internal.h: is V covered by closed boxes (B1), or by their interiors (C1)?
#pragma once
#include <cstddef>
#include <vector>

#include "solids/interval_boxes/conditions.h"

namespace veritope::internal {

/// Collects offences; refutations first.
class Findings {
 public:
  explicit Findings(std::size_t max_listed) : max_listed_(max_listed) {}
  void add(BoxOffence offence);
  void count(std::uint64_t n = 1) { result_.checked += n; }
  bool is_refuted() const { return result_.num_false > 0; }
  ConditionResult finish();

 private:
  std::size_t max_listed_;
  ConditionResult result_;
  std::vector<BoxOffence> refuted_, undecided_;
};

struct CoverOptions {
  std::size_t max_pieces, max_listed;
};

/// Decides B1. Places are in the forest's coordinates. In a planar model, V is the part of the wall at height 0. A hull
/// in the union of closed boxes is covered; a hull that meets none of them refutes B1. Undecided where V touches the
/// boundary of |B|.
ConditionResult decide_b1(BoundaryModel& model, const std::vector<Box3d>& boxes,
                          const CoverOptions& options);
/// Decides C1: a hull in the interior of one box is covered. C1 is refuted by a hull that meets no box, or by a piece
/// that runs from one side of a plane of a box's face to the other while in that plane no interior of a box meets its
/// hull.
ConditionResult decide_c1(BoundaryModel& model, const std::vector<Box3d>& boxes,
                          const CoverOptions& options);

}  // namespace veritope::internal
