// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_extraction.h: Bezier coefficients of splines: docs/certificates/star-box.md, section 3.
#pragma once
#include "star.h"

// The numbers times a factor > 0, as integers without a common factor. B2: the least common denominator and the numbers
// times it have at most this many bits.
std::vector<Big> integers_of(const std::vector<Ratio>& v, int64_t most);

// What the Bezier coefficients on an interval [a, b] of a spline of this degree depend on: the 2 p knots around it and
// b, all minus a, times a factor > 0, and the first of the p + 1 control points. B2.
// REQUIRES that no knot is inside of [a, b].
struct KnotWindow {
  size_t degree, first;
  std::vector<Big> from_begin;
};
KnotWindow knot_window(const std::vector<Ratio>& knots, size_t p, const Ratio& a, const Ratio& b);

// The coefficients are matrix times the control points first, ..., first + p, up to a common positive factor.
struct Extraction {
  size_t first;
  std::vector<std::vector<Big>> matrix;
};
Extraction extraction(const KnotWindow& window);
