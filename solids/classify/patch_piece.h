// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/patch_piece.h: parts of a patch in space, enclosed, each near the four images of its corners; they
// are halved as searches need them.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "interval/box.h"
#include "interval/ring_numbers.h"
#include "robust/base/box3d.h"
#include "solids/patches/patch.h"
#include "splines/bezier.h"

namespace veritope {

/// The part of a patch over [at[a], at[a] + 1] / 2^level[a], a = 0, 1. The map of a triangle is that of the square
/// S(u, v) = map(1 - u, u (1 - v), u v). All functions REQUIRE a live ScopedUpward.
class PatchPiece {
 public:
  /// The whole patch. REQUIRES positive weights.
  PatchPiece(const Patch& patch, std::uint32_t number);
  /// A curve as a patch that does not depend on v; `number` is for the caller. REQUIRES positive weights.
  PatchPiece(const Patch::Curve& curve, std::uint32_t number);

  std::uint32_t patch() const { return patch_; }
  /// Contain the images of the corners (0,0), (1,0), (0,1), (1,1) of the part.
  const std::array<Box3, 4>& corners() const { return corners_; }
  /// The hull of the corners, grown by this much in each coordinate, contains the part: all its control points are so
  /// near to the bilinear patch of the corners. Falls to a quarter, about, when both axes are halved.
  const Point3d& excess() const { return excess_; }
  /// A box around the part.
  const Box3d& box() const { return box_; }
  /// The longest side of the box; approximate.
  double size() const;

  /// The control points over [0,1]^2, homogeneous if the patch is rational.
  const BezierSurface<Interval>& net() const { return net_; }
  /// The parameters of the part along an axis, exactly: powers of two divide them.
  Interval range(std::size_t axis) const;
  bool begins_at_zero(std::size_t axis) const { return at_[axis] == 0; }
  bool ends_at_one(std::size_t axis) const {
    return at_[axis] + 1 == std::uint64_t{1} << level_[axis];
  }
  /// A corner's parameter. REQUIRES corner < 4.
  Rational parameter(std::size_t axis, std::size_t corner) const {
    return Rational(at_[axis] + (corner >> axis & 1)) * Rational::power_of_two(-level_[axis]);
  }

  static constexpr int kMaxLevel = 50;
  bool can_halve() const { return level_[0] < kMaxLevel && level_[1] < kMaxLevel; }
  /// The axis along which the part is longer; approximate.
  std::size_t longer_axis() const;
  /// Both parts, cut at the middle of the axis. REQUIRES level < kMaxLevel along it.
  std::pair<PatchPiece, PatchPiece> halves(std::size_t axis) const;

 private:
  PatchPiece(BezierSurface<Interval> net, const PatchPiece& whole, std::size_t axis,
             bool is_second);
  void find_hull();

  std::uint32_t patch_ = 0;
  std::array<std::uint64_t, 2> at_{};
  std::array<int, 2> level_{};
  BezierSurface<Interval> net_;
  std::array<Box3, 4> corners_;
  Point3d excess_{};
  Box3d box_;
};

}  // namespace veritope
