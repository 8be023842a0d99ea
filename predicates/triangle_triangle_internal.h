// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/triangle_triangle_internal.h: where a triangle crosses a plane; for triangle_triangle
// and triangle_witness.
#pragma once
#include <array>

#include "robust/base/sign.h"

namespace veritope::internal {

/// An edge of a triangle that meets a plane in one point: from a corner below or on it to a corner
/// above or on it, not both on it.
struct PlaneCrossing {
  int below, above;  // corner numbers
};

/// The two ends of (triangle) n (plane), the triangle's corners having the signs s over the plane.
/// REQUIRES s is neither constant nonzero nor all zero.
///   rising   the boundary, run through in corner order, comes up here;
///   falling  it goes down here. They may be the same point.
/// Let n be the normal of the triangle (its corners turn counter-clockwise around it) and m the
/// normal of the plane on its upper side. Along l = n x m the rising point comes first: in the
/// frame (l, n x l) of the triangle's plane, "above" is the half-plane of negative second
/// coordinate, because m . (n x l) = -|l|^2, and a counter-clockwise boundary runs from there to
/// the other half, that is: falls, where the first coordinate is largest.
struct PlaneSection {
  PlaneCrossing rising, falling;
};

inline PlaneSection plane_section(const std::array<Sign, 3>& s) {
  PlaneSection section{};
  for (int i = 0; i < 3; ++i) {
    const int j = i == 2 ? 0 : i + 1;
    const int a = to_int(s[i]), b = to_int(s[j]);
    if (a == b) continue;
    if (a <= 0 && b >= 0) section.rising = {i, j};
    if (a >= 0 && b <= 0) section.falling = {j, i};
  }
  return section;
}

}  // namespace veritope::internal
