// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/interval_boxes/conditions.h: the paper's conditions on a finite set of boxes B and a surface V, each decided
// or reported undecided with the offending boxes: A, B1, B2, C1, C2, C3 of [SSP01] 2, and C3*, which the theorem needs
// (docs/THEORY.md §1). Design: docs/design/0019-paper-conditions.md.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "robust/base/result.h"
#include "solids/interval_boxes/box_trace.h"

namespace veritope {

enum class PaperCondition {
  kA,       ///< b_i∩b_j is empty or a box (of positive volume)
  kB1,      ///< V lies in |B|
  kB2,      ///< every b meets V
  kC1,      ///< the interiors of the boxes cover V
  kC2,      ///< b∩V is a disk that cuts b into two balls
  kC3,      ///< b_i∩b_j is empty or a box with C2
  kC3Star,  ///< every intersection of boxes of B is empty or a box with C2
};
inline constexpr std::size_t kNumPaperConditions = 7;
/// "A", "B1", ..., "C3*".
const char* name_of(PaperCondition condition);

enum class Answer { kTrue, kFalse, kUndecided };
/// "true", "false", "undecided".
const char* to_string(Answer answer);

/// What is wrong, or not decided, with the intersection of some boxes of B (one, two, or more for C3*), or with a place
/// of V.
struct BoxOffence {
  enum class Why {
    kTouching,   ///< false: two boxes that meet in a face, an edge or a point only
    kMissed,     ///< false: V misses it
    kEuler,      ///< false: V inside it has another Euler characteristic than a disk
    kUncovered,  ///< false: it holds a point of V that is not covered
    kUndecided,  ///< neither proved nor refuted
    kTooMany,    ///< C3*: more distinct intersections than the cap
  };
  Why why = Why::kUndecided;
  std::vector<std::uint32_t> boxes;  ///< ascending; those whose intersection it is about
  Box3d place{};                     ///< in the model's units
  int euler = 0;                     ///< kEuler
  bool is_refutation() const { return why != Why::kUndecided && why != Why::kTooMany; }
};
/// "boxes 0, 1, 2: V inside has the Euler characteristic 2, at [..] x [..] x [..]".
std::string to_string(const BoxOffence& offence);

struct ConditionResult {
  Answer answer = Answer::kUndecided;
  std::vector<BoxOffence> offences;  ///< the first kMaxListed; refutations before what is undecided
  std::uint64_t num_false = 0, num_undecided = 0;
  std::uint64_t checked = 0;  ///< boxes, pairs, distinct intersections, or pieces of V
};

struct PaperConditions {
  std::array<ConditionResult, kNumPaperConditions> results;
  const ConditionResult& operator[](PaperCondition c) const {
    return results[static_cast<std::size_t>(c)];
  }
};

struct ConditionOptions {
  TraceOptions trace;
  std::size_t max_pieces = 1'000'000;         ///< of V, for C1 and B1
  std::size_t max_intersections =
      1'000'000;  ///< distinct boxes for C3*; over it: undecided, unless C2 or C3 refutes it
  std::size_t max_listed = 100;               ///< offences of each condition
  /// Budget of all traces together, in cells; once it is spent, further boxes are undecided. Without it a set of many
  /// hard boxes would take very long.
  std::uint64_t max_cells = std::numeric_limits<std::uint64_t>::max();
  /// B2, C2, C3 and C3* end with their first refutation, C3* with that of C2 or C3: the answers stay, counts and lists
  /// are shorter.
  bool stops_at_refutation = false;
};

/// Decides every condition. `boxes` are in the model's units (in a planar model the third side is ignored). C1-C3 alone
/// prove nothing about M∪|B| (three boxes refute Theorem 2.5: examples/counterexample_c3): C3* does, for an embedded V.
/// @error kEmpty without a box; kBadArgument for a box with a side of length 0 or less or a coordinate out of range:
/// the message names it
Result<PaperConditions> decide_conditions(BoundaryModel& model, std::span<const Box3d> boxes,
                                          const ConditionOptions& options = {});
/// Condition A alone: it needs no surface. REQUIRES lo < hi on the first `dimension` axes.
ConditionResult decide_a(std::span<const Box3d> boxes, int dimension = 3,
                         std::size_t max_listed = 100);

/// The pairs (i < j) of closed boxes that have a common point, ascending. @cost about n log n + pairs
std::vector<std::array<std::uint32_t, 2>> meeting_pairs(std::span<const Box3d> boxes);

/// The distinct intersections of pairwise meeting boxes, those of one box included; by Helly's theorem these are all
/// non-empty ones.
struct DistinctIntersections {
  struct Item {
    Box3d box;
    std::vector<std::uint32_t> boxes;  ///< one set with this intersection, ascending
  };
  std::vector<Item> items;
  bool is_complete = true;  ///< false: the cap was reached
};
DistinctIntersections distinct_intersections(std::span<const Box3d> boxes, std::size_t cap);

}  // namespace veritope
