// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/interval_boxes/c3_exceptions.h: why C3 fails at a pair of boxes, which of the paper's four exceptions it is,
// and what mends it: the sub-collection of Remark 3.1, or a dyadic step. Source: [SSP01] 3. Design:
// docs/design/0019-paper-conditions.md.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "solids/interval_boxes/conditions.h"

namespace veritope {

/// The four exceptions to C3, with the paper's numbers.
enum class C3Exception {
  /// in the surroundings of both (half the smaller one's size around them), V is not (proved to be) connected: two
  /// parts of it come near each other
  kSelfDistance = 1,
  /// one part of V (or not decided); boxes as small as the smaller one around the same middles would not meet
  /// (figure 5a)
  kVaryingSize = 2,
  kSmallFeature = 3,  ///< one part of V (or not decided), and they would (figure 5b)
  kContact = 4,       ///< they meet in a face, an edge or a point only
};
/// "self-distance", "varying size", "small feature", "contact".
const char* to_string(C3Exception exception);

/// A pair at which C3 is refuted.
struct C3Failure {
  std::uint32_t i = 0, j = 0;
  C3Exception exception = C3Exception::kSmallFeature;
  /// Remark 3.1: B_k such that |B_k| is a closed ball with C2, |B_k|∩b_ij is a closed ball, |B_k|∩b_i and |B_k|∩b_j
  /// have C2. It is searched for only where V misses b_ij, and empty if none was found. It mends C3 as the paper reads
  /// it; it makes no certificate.
  std::vector<std::uint32_t> sub_collection;
  /// kContact: box i with its sides moved by `step`, a power of two, so that C3 holds at (i, j), or they are apart, C2
  /// holds of box i, it meets the same other boxes, A and C3 hold wherever they held, and, if it shrank, C1 still
  /// holds.
  struct Resized {
    Box3d box;
    double step;  ///< negative: it shrank
  };
  std::optional<Resized> resized;
};

struct ExceptionOptions {
  ConditionOptions conditions;
  /// Boxes that a sub-collection is chosen from, the nearest ones.
  std::size_t max_candidates = 12;
  std::size_t max_sub_collection = 3;  ///< its size
  int max_halvings = 20;               ///< steps from 1/4 of the box down
  std::size_t max_failures = 1000;
};

/// Explains the refuted pairs among `c3.offences`, in order. REQUIRES c3 = decide_conditions(model, boxes)[kC3].
std::vector<C3Failure> explain_c3(BoundaryModel& model, std::span<const Box3d> boxes,
                                  const ConditionResult& c3, const ExceptionOptions& options = {});

inline constexpr std::size_t kMaxBallBoxes = 10;
/// Whether the union of a few boxes (forest's coordinates) is a closed ball that V cuts in a disk: the link test says
/// it is a ball; V in it is a surface, connected, with the Euler characteristic 1 (by inclusion and exclusion over the
/// intersections, each traced). False means that this is not proved, or that there are more than kMaxBallBoxes boxes.
bool is_ball_with_c2(BoundaryModel& model, std::span<const Box3d> boxes,
                     const TraceOptions& options = {});

/// The least distance of parts of V that are not neighbours: patches without a common vertex. Model units.
struct SelfDistance {
  double lo = 0, hi = 0;
  bool is_as_asked = false;  ///< hi <= (1 + 2^-6) lo; otherwise the budget was spent
  /// Footnote 3 of [SSP01]: boxes of size below d / sqrt(3) that each hold a point of their part of V at the middle
  /// never meet for patches that are not neighbours: exception 1 does not happen between them. It uses the lower bound.
  double box_bound() const;
};
/// The result is empty if all patches are neighbours. @cost branch and bound over pairs of pieces
std::optional<SelfDistance> self_distance(BoundaryModel& model,
                                          std::uint64_t max_pairs = 1'000'000);

}  // namespace veritope
