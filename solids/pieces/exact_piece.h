// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/pieces/exact_piece.h: one node of a PieceForest in integers: its hull, the signs of n·(S - c), its sides; used
// where doubles do not decide. Theory: docs/THEORY.md §4.
#pragma once
#include <array>
#include <vector>

#include "robust/integer.h"
#include "robust/rational.h"
#include "solids/pieces/piece_forest.h"

namespace veritope {

/// The node's homogeneous control points F = (x, y, z, w) in the forest's frame, times one positive integer; in a
/// polynomial patch w is that integer.
/// @cost of construction: O(degree^4) products of integers that grow by the degree at each level.
class ExactPiece {
 public:
  /// REQUIRES weights > 0 in the patch.
  ExactPiece(const PieceForest& forest, const PieceForest::Node& node);

  /// The tightest box of doubles around the exact hull of the control points.
  Box3d hull() const;
  /// Coordinates x, y, z, then w, of one control point.
  std::array<const Integer*, 4> control(std::size_t i) const;

  /// The coefficients of G0 .. G3, each times the binomials of its place and one positive integer: signs are those of
  /// the Bernstein coefficients. They are computed at the first call. @cost O(degree^6) products
  void make_determinants();
  bool has_determinants() const { return !determinants_[0].empty(); }
  /// The sign of coefficient i of g_c. REQUIRES has_determinants().
  class Side {
   public:
    Side(const ExactPiece& piece, const Point3d& c);
    Sign at(std::size_t i) const { return value(i).sign(); }
    /// Coefficient i itself, times 2^shift().
    Integer value(std::size_t i) const;
    std::uint64_t shift() const { return shift_; }

   private:
    const ExactPiece& piece_;
    std::array<Integer, 3> c_;  // times the piece's unit and 2^shift_
    std::uint64_t shift_ = 0;
  };
  /// Coefficient i of g_c as a function of c, up to a positive factor and rounding: (a, b) of a·(c - m) + b, with the
  /// greatest |a_k| between 1/2 and 1; zeros if it does not depend on c. REQUIRES has_determinants().
  std::array<double, 4> approx_half_space(std::size_t i, const Point3d& m) const;

 private:
  void set_control(const PieceForest& forest, const PieceForest::Node& node);
  void shorten();

  FormShape shape_;
  bool is_rational_ = false;
  std::vector<Integer> control_;  // component by component, four of them
  std::array<std::vector<Integer>, 4> determinants_;
};

namespace internal {
/// Replaces the coefficients first[0], first[stride], ... of a Bezier curve by those on [from, to] / 2^bits, times
/// 2^(bits degree).
/// @cost O(degree^3) products
void restrict_line(Integer* first, std::size_t stride, int degree, std::uint64_t from,
                   std::uint64_t to, int bits);
}  // namespace internal

}  // namespace veritope
