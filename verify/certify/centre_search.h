// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/centre_search.h: a search, in floating point, for points from which all pieces in a box are seen from
// one side. Nothing here decides.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "solids/pieces/piece_forest.h"

namespace veritope {

/// a·x + b with |a| = 1: a linear condition a·x + b > 0.
struct HalfSpace {
  Point3d a;
  double b;
};

/// The least a·x + b, approximately; infinity without half-spaces.
double least_depth(const std::vector<HalfSpace>& half_spaces, const Point3d& point);

/// The point of the box whose least a·x + b is greatest, and that least value; approximate, and returned only if it
/// exceeds `enough`. Half-spaces are added when a candidate violates them. *bound becomes a depth that, approximately,
/// no point exceeds. @cost O(m) a round for m half-spaces, usually a few rounds
struct DeepestPoint {
  Point3d point;
  double depth;
};
std::optional<DeepestPoint> deepest_point(const std::vector<HalfSpace>& half_spaces,
                                          const Box3d& box, double enough,
                                          double* bound = nullptr);

/// Whether deepest_point finds nothing, also with more half-spaces: no point is nearly as deep as `enough`.
bool is_surely_shallow(const std::vector<HalfSpace>& half_spaces, const Box3d& box, double enough);

/// Half-spaces that exclude each other by no more than this may have common points at their borders.
inline constexpr double kBorderDepth = 1e-9;

/// As deepest_point, but for half-spaces of which some can be met at their borders only, by no point with a margin: all
/// others are met with the margin `enough`. Nothing if half-spaces exclude each other by more than kBorderDepth, or if
/// the greatest margin of all half-spaces lies between kBorderDepth and `enough`.
struct DeepestPointOrZeros {
  Point3d point;
  bool has_zeros = false;  ///< whether some half-spaces are met at their borders
};
std::optional<DeepestPointOrZeros> deepest_point_or_zeros(
    const std::vector<HalfSpace>& half_spaces, const Box3d& box, double enough);

}  // namespace veritope
