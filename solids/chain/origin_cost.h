// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/origin_cost.h: how many cells of a normal chain a point must be tested against, by the chain's origin:
// the question that seed 001 [GRF03] leaves open in section 4.  Theory: docs/THEORY.md, CHAIN-7.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "robust/base/box3d.h"
#include "solids/classify/point_answer.h"
#include "solids/patches/patch_complex.h"

namespace veritope {

/// The expected number of cells of the chain whose box holds a point that is uniformly distributed in the box M of the
/// model's control points: the sum of |box and M| / |M| over the boxes of all simplices, whatever their coefficient,
/// and of all patches that are not their base. The boxes are those of corners and of control points, rounded outward
/// to binary64.
struct CellTests {
  double value = 0;
  double error = 0;  ///< |value - exact| is at most this
};

struct OriginCost {
  ExactPoint origin;
  CellTests tests;
};

class OriginCosts {
 public:
  /// REQUIRES that the box of the control points has positive sides: the patches bound a solid.
  explicit OriginCosts(const PatchComplex& complex);

  /// @cost O(bases)
  CellTests at(const ExactPoint& origin) const;

  /// The candidate with the fewest expected tests. Candidates: the point 0, if it is in M; the centre of M; the
  /// componentwise median of the bounds of all bases; the centres of the eight octants of M; and the point to which a
  /// descent leads from each of these, which minimises one coordinate after the other, exactly: along an axis the sum
  /// is convex and piecewise linear, and least at a weighted median of the bounds. The first candidate stays unless
  /// another one is proved to be cheaper. Coordinates are those of binary64, or 0.
  OriginCost best() const;

  const Box3d& box() const { return model_; }

 private:
  Point3d descended(Point3d from) const;
  double best_along(std::size_t axis, const Point3d& at) const;
  Point3d median() const;
  double share(std::size_t axis, double lo, double hi) const;

  Box3d model_;
  std::vector<Box3d> bases_;
  double cells_ = 0;  ///< the part of the cells between bases and patches, which no origin changes
  std::size_t num_cells_ = 0;
  std::array<std::vector<std::uint32_t>, 3>
      order_;  ///< of the bounds along each axis: 2 base + (0: lo, 1: hi)
};

}  // namespace veritope
