// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/crossing_search.h: the search for two different points of a patch complex with the same image. A
// crossing or a contact that is found is proved; nothing follows if none is found. Theory: docs/THEORY.md §4.
// Certificates: docs/certificates/patch-invalid.md, patch-invalid-2.md.
#pragma once
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

#include "verify/certify/contact_solver.h"
#include "verify/certify/crossing_solver.h"

namespace veritope {

/// Keeps a reference to the forest and adds nodes to it.
class CrossingSearch {
 public:
  /// @param on_borders  as for ContactSolver
  explicit CrossingSearch(PieceForest& forest, bool on_borders = true)
      : forest_(forest), solver_(forest), contacts_(solver_.maps(), on_borders) {}

  /// Searches the pairs of patches' pieces whose hulls meet and that are not neighbours. Pairs are split level by
  /// level; where the sizes of the hulls differ much, only the larger piece is split. In models of over 1,024 patches,
  /// only patches without a common point are searched. @cost at most 128 pairs of pieces a root (16,384 if there are
  /// few roots) and 2^17 in all, and 256 calls of the solver, at each of two or three levels
  std::optional<CrossingWitness> among_patches();

  /// Searches models of any number of patches, seven levels deep. @cost 32 pairs of pieces a root and 16,384 more, 2^17
  /// in all, and 1,024 calls of the solver, at each level
  std::optional<CrossingWitness> everywhere();

  /// Searches the pieces near this one, a quarter of its size, neighbours left out. @cost at most 400 pieces, 32 calls
  /// of the solver
  std::optional<CrossingWitness> near(PieceForest::Id piece);

  /// Points at which sheets touch, in the same places as everywhere() and near(), but five levels deep only. @cost
  /// ContactSolver's limits, each time
  std::optional<MeetingWitness> touching_everywhere();
  std::optional<MeetingWitness> touching_near(PieceForest::Id piece);

  /// Pairs of a level that are split: a million nodes at most.
  static constexpr std::size_t kMostSplit = std::size_t{1} << 17;
  std::size_t num_pairs = 0;  ///< pairs whose hulls were compared
  const CrossingSolver& solver() const { return solver_; }

 private:
  using Id = PieceForest::Id;
  struct Pair {
    Id a, b;
  };
  struct Effort {
    bool with_neighbours;
    int levels;
    std::size_t most_pairs;
  };
  // `solve` makes a witness of a pair, or nothing; `solve_all` one of the pairs of a level.
  template <typename SolveAll>
  std::invoke_result_t<SolveAll, std::vector<Pair>> by_level(const Effort& effort,
                                                             SolveAll solve_all);
  std::optional<CrossingWitness> crossing_of(const std::vector<Pair>& pairs, std::size_t most);
  std::optional<MeetingWitness> contact_of(std::vector<Pair> pairs, std::size_t most);
  std::vector<Pair> pairs_near(Id piece);
  std::vector<Pair> root_pairs(const Effort& effort);
  static void thin_out(std::vector<Pair>* pairs, std::size_t most);
  std::vector<Pair> split(const std::vector<Pair>& pairs, std::size_t most);
  std::optional<CrossingWitness> solve(const Pair& pair);
  SheetPlace middle(const PieceForest::Node& node) const;
  double reach(const PieceForest::Node& node) const;

  PieceForest& forest_;
  CrossingSolver solver_;
  ContactSolver contacts_;
};

}  // namespace veritope
