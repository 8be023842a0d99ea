// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/crossing_solver.h: from two places of patches that lie near each other to a proved common point:
// Newton in doubles, then a box around the solution that is verified exactly.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "solids/pieces/piece_forest.h"
#include "verify/certify/crossing_witness.h"
#include "verify/certify/sheet_maps.h"

namespace veritope {

/// Keeps a reference to the forest.
class CrossingSolver {
 public:
  explicit CrossingSolver(const PieceForest& forest) : forest_(forest), maps_(forest) {}

  /// Parameters near the guess where the two sheets have approximately the same image. Method: Gauss-Newton, each step
  /// the shortest that solves the linear equations. Nothing if the iteration does not converge within `reach`, relative
  /// to the parameters' unit, of each coordinate of the guess.
  std::optional<std::array<SheetPlace, 2>> solve(const std::array<SheetPlace, 2>& guess,
                                                 double reach);

  /// A proof: a box around the approximate solution, its first sheet in the open domain, for which broken_condition
  /// finds that all conditions hold. Boxes are tried with either sheet first, from large to small. Near a solution that
  /// could not be proved no other is tried, and after kMostExactInAll exact tests no solution at all: at a contact
  /// every search ends near the same few points.
  std::optional<CrossingWitness> prove(const std::array<SheetPlace, 2>& solution);

  /// A proved common point, near the guess, of sheets that nearly coincide there: closer than an eighth of a tangent's
  /// length, with normals that differ by less than 2^-6. Nothing for other sheets, or if none is found.
  std::optional<CrossingWitness> prove_close(const std::array<SheetPlace, 2>& guess, double reach);

  SheetMaps& maps() { return maps_; }

  static constexpr std::size_t kMostExactInAll = 1024;
  /// Places that prove_close refines: sheets that coincide in a region, or touch along a curve, have places without a
  /// crossing everywhere.
  static constexpr std::size_t kMostRefinedInAll = 128;
  std::size_t num_solved = 0, num_exact = 0;  ///< calls of solve, exact tests
  std::size_t num_refined = 0;                ///< places that prove_close has refined in rationals

 private:
  struct Linear;
  struct Approach;
  using Rows = std::array<std::array<std::int64_t, 3>, 3>;
  Linear linearised(const std::array<SheetPlace, 2>& at);
  static std::optional<std::array<double, 4>> shortest_step(Linear equations);
  bool is_near_unproved(const std::array<SheetPlace, 2>& solution) const;
  std::optional<CrossingWitness> prove_in_order(const std::array<SheetPlace, 2>& solution);
  std::optional<CrossingWitness> prove_with(const std::array<SheetPlace, 2>& solution,
                                            std::size_t fixed);
  std::optional<Rows> settle(std::array<SheetPlace, 2>* solution, std::size_t fixed);
  std::optional<CrossingWitness> boxed(const std::array<SheetPlace, 2>& solution, std::size_t fixed,
                                       unsigned fixed_bits, const Rows& rows);
  bool is_forecast(const CrossingWitness& witness);
  // prove_close: the first sheet's parameters stay, the second's move to the foot of the perpendicular.
  bool drop_foot(std::array<SheetPlace, 2>* x, bool exactly);
  Linear exactly_linearised(const std::array<SheetPlace, 2>& at);
  std::optional<CrossingWitness> prove_refined(std::array<SheetPlace, 2> x);
  std::optional<CrossingWitness> boxed_close(const std::array<SheetPlace, 2>& x, std::size_t fixed);

  const PieceForest& forest_;
  SheetMaps maps_;
  std::vector<std::array<SheetPlace, 2>> unproved_;
};

}  // namespace veritope
