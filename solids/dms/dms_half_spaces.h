// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_half_spaces.h: whether half-spaces have a common point, exactly: a rational point of all of them, or
// at most four of them that have none, with weights that show it.
// Source: the simplex method on the dual of: maximise the least h; Bland's rule ends it. Helly's theorem says why four
// are enough.
#pragma once
#include <cstddef>
#include <span>
#include <variant>
#include <vector>

#include "solids/dms/dms_knots.h"

namespace veritope {

/// h(u) = vector . u + number; its half-space is where h >= 0, or h > 0 if it is open.
struct DmsHalfSpace {
  DmsPoint vector;
  Rational number;
};
Rational height_in(const DmsHalfSpace& half_space, const DmsPoint& point);

/// One of a few half-spaces without a common point: the sum of weight times h is a constant.
struct DmsWeightedHalfSpace {
  std::size_t number = 0;  ///< of the half-space
  Rational weight;         ///< > 0
};

enum class DmsHalfSpaceKind {
  kOpen,    ///< the constant is <= 0
  kClosed,  ///< the constant is < 0
};

/// A common point, or one to four half-spaces that have none.
/// REQUIRES at least four half-spaces; the vectors of the first four span space, and 0 is a sum of them with four
/// weights > 0: they bound a tetrahedron, or what is left of one turned inside out.
/// @cost  a few steps, each of which looks at all half-spaces
std::variant<DmsPoint, std::vector<DmsWeightedHalfSpace>> meet_half_spaces(
    std::span<const DmsHalfSpace> all, DmsHalfSpaceKind kind);

}  // namespace veritope
