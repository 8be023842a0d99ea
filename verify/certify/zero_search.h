// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/zero_search.h: a star box around one piece at which S1 holds with zeros only: normals are zero in a
// corner or along a side, or both centres must lie in a tangent plane. Searched in floating point, proved with
// integers. Theory: docs/THEORY.md, STAR-5.
#pragma once
#include <optional>
#include <vector>

#include "verify/certify/centre_search.h"
#include "verify/certify/star_cover.h"

namespace veritope {

class ZeroSearch {
 public:
  using Id = PieceForest::Id;

  ZeroSearch(PieceForest& forest, const StarCoverOptions& options)
      : forest_(forest), options_(options) {}

  /// Whether a box that contains the piece's hull was found and proved. It is not sought where centres exist that need
  /// no zeros: then something else is in the way.
  bool try_piece(Id id);
  /// After try_piece returned true: the box, and the pieces that it covers, a parent before its children.
  const CoverBox& box() const { return box_; }
  const std::vector<Id>& held() const { return held_; }

 private:
  bool touches_side(Id id) const;
  bool solve(const std::vector<Id>& pieces);
  bool prove(double unit);

  PieceForest& forest_;
  const StarCoverOptions& options_;
  CoverBox box_;
  std::vector<Id> near_, held_;
  std::vector<HalfSpace> half_spaces_;
  bool has_zeros_ = false;        // some half-spaces are met without a margin, or by no centre
  Point3d inside_{}, outside_{};  // before they are rounded
};

}  // namespace veritope
