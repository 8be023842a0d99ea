// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/solvers/spline_pieces.h: exact B-splines as the solvers take them: cut into Bezier pieces, in global
// parameters.
#pragma once
#include <array>
#include <vector>

#include "interval/solvers/exact_bernstein.h"
#include "robust/base/result.h"
#include "splines/knot_insertion.h"

namespace veritope {

template <std::size_t N>
using ExactPieces = BezierPieces<Rational, N>;

/// A part of a map between neighbouring breaks of multiplicity >= degree: by the multiplicities of its knots the map is
/// continuously differentiable there. `is_first`: no part before it along that axis shares its low border.
template <std::size_t N>
struct SmoothPart {
  ExactPieces<N> pieces;
  std::array<bool, N> is_first;
};
template <std::size_t N>
std::vector<SmoothPart<N>> smooth_parts(const BSpline<Rational, N>& map);
/// The parts between breaks of multiplicity degree + 1, where the map may be torn: each is continuous.
template <std::size_t N>
std::vector<ExactPieces<N>> connected_parts(const BSpline<Rational, N>& map);
/// @error kBadArgument: a weight is not positive
template <std::size_t N>
Status check_weights(const BSpline<Rational, N>& map);

/// The map on the border of an axis, low (false) or high.
template <std::size_t N>
requires(N > 1) ExactPieces<N - 1> border(const ExactPieces<N>& map, std::size_t axis, bool high);

/// The place of a piece in global parameters.
template <std::size_t N>
ExactBox<N> place_of(const ExactPieces<N>& map, const std::array<std::size_t, N>& cell);

/// The coordinates (divided by the weight) of the points with parameters in the box, as far as it lies in the
/// domain; empty intervals if it does not meet it. Sides may be points. REQUIRES a live ScopedUpward. An interval is
/// entire where a weight's enclosure contains 0.
template <std::size_t N>
std::vector<Interval> points_of(const ExactPieces<N>& map, const ExactBox<N>& box);

/// The control points' hull of one piece. REQUIRES a live ScopedUpward.
template <std::size_t N>
std::vector<Interval> hull_of(const Bezier<Interval, N>& piece);
template <std::size_t N>
Bezier<Interval, N> enclosed(const Bezier<Rational, N>& map);

}  // namespace veritope
