// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/crossing_search.h: the search for two different points of a patch complex with the same image. A
// crossing that is found is proved; nothing follows if no crossing is found. Theory: docs/THEORY.md §4. Certificate:
// docs/certificates/patch-invalid.md.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "verify/certify/crossing_solver.h"

namespace veritope {

/// Keeps a reference to the forest and adds nodes to it.
class CrossingSearch {
 public:
  explicit CrossingSearch(PieceForest& forest) : forest_(forest), solver_(forest) {}

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
    std::size_t most_pairs, most_solved;
  };
  std::optional<CrossingWitness> by_level(const Effort& effort);
  std::vector<Pair> root_pairs(const Effort& effort);
  static void thin_out(std::vector<Pair>* pairs, std::size_t most);
  std::vector<Pair> split(const std::vector<Pair>& pairs, std::size_t most);
  std::optional<CrossingWitness> solve_some(const std::vector<Pair>& pairs, std::size_t most);
  std::optional<CrossingWitness> solve(const Pair& pair);
  SheetPlace middle(const PieceForest::Node& node) const;
  double reach(const PieceForest::Node& node) const;

  PieceForest& forest_;
  CrossingSolver solver_;
};

}  // namespace veritope
