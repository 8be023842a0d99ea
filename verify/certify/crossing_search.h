// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/crossing_search.h: the search for two different points of a patch complex with the same image. What is
// found is proved; what is not found says nothing. Theory: docs/THEORY.md §4. Certificate:
// docs/certificates/patch-invalid.md.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "verify/certify/crossing_solver.h"

namespace veritope {

/// Refers to the forest, in which it makes nodes.
class CrossingSearch {
 public:
  explicit CrossingSearch(PieceForest& forest) : forest_(forest), solver_(forest) {}

  /// Among pairs of pieces whose hulls meet and that are no neighbours: those of patches, split level by level, where
  /// the hulls differ much only the larger one. In models of over 1,024 patches only patches that have no point in
  /// common. @cost at most 128 pairs of pieces a root (16,384 if there are few roots), and 256 calls of the solver, at
  /// each of two or three levels
  std::optional<CrossingWitness> among_patches();

  /// Searches models of any number of patches, seven levels deep. @cost 32 pairs of pieces a root and 16,384 more, and
  /// 1,024 calls of the solver, at each level
  std::optional<CrossingWitness> everywhere();

  /// Among the pieces, a quarter of this one's size, that are near it, neighbours left out. @cost at most 400 pieces,
  /// 32 calls of the solver
  std::optional<CrossingWitness> near(PieceForest::Id piece);

  std::size_t num_pairs = 0;  ///< of which the hulls were compared
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
  std::vector<Pair> split(const std::vector<Pair>& pairs, std::size_t most);
  std::optional<CrossingWitness> solve_some(const std::vector<Pair>& pairs, std::size_t most);
  std::optional<CrossingWitness> solve(const Pair& pair);
  SheetPlace middle(const PieceForest::Node& node) const;
  double reach(const PieceForest::Node& node) const;

  PieceForest& forest_;
  CrossingSolver solver_;
};

}  // namespace veritope
