// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/box_search.h: a star box or a mesh box around one piece: searched in floating point, proved with
// bounds, and in exact arithmetic where the bounds do not decide. Theory: docs/THEORY.md §4.
#pragma once
#include <optional>
#include <vector>

#include "solids/star_box/flat_patch.h"
#include "verify/certify/centre_search.h"
#include "verify/certify/obstacle.h"
#include "verify/certify/star_cover.h"

namespace veritope {

class BoxSearch {
 public:
  using Id = PieceForest::Id;

  BoxSearch(PieceForest& forest, const StarCoverOptions& options)
      : forest_(forest),
        options_(options),
        flat_(forest.complex(),
              options.with_frames ? FlatPatches::Kind::kAll : FlatPatches::Kind::kTriangles) {}

  /// Whether a box that contains the piece's hull was found and proved.
  bool try_piece(Id id);
  /// After try_piece returned true: the box, and the pieces that it covers, a parent before its children.
  const CoverBox& box() const { return box_; }
  const std::vector<Id>& held() const { return held_; }
  /// After try_piece returned false: why.
  UncoveredPiece::Why why() const { return why_; }
  const Obstacle& obstacle();
  /// Whether centres in the cube may exist for S1 with zeros.
  bool may_have_zeros() const { return may_have_zeros_; }
  /// The number of pieces near it; 1, the piece itself, if even the piece alone has no centres.
  std::size_t num_looked_at() const { return num_near_; }

  std::size_t tested_pieces() const { return tested_pieces_; }
  std::size_t programs() const { return programs_; }

 private:
  bool fail(UncoveredPiece::Why why) {
    why_ = why;
    return false;
  }
  bool try_star();
  bool try_crowded_star();
  bool try_cut_star();
  std::optional<CoverBox> cut_back() const;
  bool has_star();
  bool try_mesh();
  void hold_corner(std::uint32_t patch, std::uint32_t corner);
  bool is_promising();
  bool are_centres();
  bool place_centres();
  bool search_centres();
  enum class Centres { kNone, kSomeConditions, kAllConditions };
  Centres solve_centres(std::size_t most);
  Centres no_centres(double bound);
  Point3d on_grid_near(Point3d point) const;

  PieceForest& forest_;
  const StarCoverOptions& options_;
  FlatPatches flat_;
  Id piece_ = 0;
  CoverBox box_;
  Point3d scale_{};  ///< lengths that count as 1 in the linear programs
  std::vector<Id> tested_, held_;
  std::size_t num_near_ = 0;
  bool may_have_zeros_ = false;
  bool is_marginal_ = false;  // no centres were found in the last half-spaces, by a hair
  std::optional<Obstacle> obstacle_;
  UncoveredPiece::Why why_ = UncoveredPiece::Why::kNoCentres;
  std::vector<HalfSpace> half_spaces_;
  std::size_t tested_pieces_ = 0, programs_ = 0, crowded_failures_ = 0;
};

}  // namespace veritope
