// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/contact_solver.h: from two pieces of patches that lie near each other to a proved common point at
// which their sheets touch: approximate parameters in doubles, then fractions that are simple, tested exactly.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "verify/certify/meeting_witness.h"
#include "verify/certify/sheet_maps.h"

namespace veritope {

/// Where the parameters of a sheet are sought: a rectangle of its tensor form.
struct SheetRange {
  std::uint32_t patch = 0;
  std::array<std::array<double, 2>, 2> at{};
};
SheetRange range_of_piece(const PieceForest& forest, PieceForest::Id piece);

/// Keeps a reference to the maps.
class ContactSolver {
 public:
  /// @param on_borders  whether places may lie on sides and corners, so that a proof needs the gluing of the surface
  explicit ContactSolver(SheetMaps& maps, bool on_borders = true)
      : maps_(maps), on_borders_(on_borders) {}

  /// A proved common point of the two patches near the ranges: of their insides, where the tangent planes agree; of the
  /// inside of one and a side or a corner of the other; or of sides and corners. A range that touches a side of its
  /// patch stands for that side, too. Points with irrational parameters, or with those of many digits, are not found,
  /// unless one of the patches is an affine image of its domain.
  /// @cost  at most kMostSolved times 16 steps of Newton's method, and kMostTested exact tests of places, in all calls
  /// since the last one of start_again
  std::optional<MeetingWitness> solve(const SheetRange& a, const SheetRange& b);

  /// Allows as much work as at first.
  void start_again() { num_solved = num_tested = 0; }

  static constexpr std::size_t kMostSolved = 4096, kMostTested = 128;
  std::size_t num_solved = 0, num_tested = 0;

 private:
  using Places = std::array<SheetPlace, 2>;
  /// Which of the four parameters stay as they are.
  using Fixed = std::array<bool, 4>;
  struct Equations;
  Equations equations_at(const Places& at, const Fixed& is_fixed);
  std::optional<MeetingWitness> solve_from(Places at, Fixed is_fixed, double reach);
  void drop_foot(Places* at);
  bool is_one_point(const std::array<PatchPlace, 2>& places);
  bool settle(Places* at, Fixed* is_fixed, double reach);
  std::optional<MeetingWitness> prove(const Places& at, const Fixed& is_fixed);

  SheetMaps& maps_;
  const bool on_borders_;
  std::optional<bool> is_glued_;
  std::vector<Places> tested_;
};

}  // namespace veritope
