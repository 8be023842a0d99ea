// SPDX-License-Identifier: LGPL-3.0-or-later
// models/plane_shapes.h: closed plane curves for the paper's figures, exact.
#pragma once
#include <array>
#include <vector>

#include "robust/rational.h"
#include "splines/bezier.h"

namespace veritope::plane_shapes {

using Loop = std::vector<BezierCurve<Rational>>;
using Point = std::array<Rational, 2>;

/// The unit circle as four rational quadratic quarters, counterclockwise from (1, 0).
Loop circle();
/// Segments from each corner to the next. REQUIRES three corners or more.
Loop polygon(const std::vector<Point>& corners);
/// One curve with these control points, polynomial. REQUIRES two points or more.
BezierCurve<Rational> bezier(const std::vector<Point>& control);
/// x -> factor * x + shift. REQUIRES factor > 0.
Loop placed(const Loop& loop, const Rational& factor, const Point& shift);
/// The loop in the opposite direction.
Loop reversed(const Loop& loop);

}  // namespace veritope::plane_shapes
