// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_extraction.h: Bezier coefficients of splines: docs/certificates/star-box.md, section 3.
#pragma once
#include "star.h"

// The numbers times a factor > 0, as integers without a common factor. B2: the least common denominator and the numbers
// times it have at most this many bits.
std::vector<Big> integers_of(const std::vector<Ratio>& v, int64_t most);

// The Bezier coefficients on an interval of a spline of degree p are matrix times the control points first, ..., first +
// p, up to a common positive factor.
struct Extraction {
  size_t first;
  std::vector<std::vector<Big>> matrix;
};
// REQUIRES that no knot is inside of [a, b].
Extraction extraction(const std::vector<Ratio>& knots, size_t p, const Ratio& a, const Ratio& b);
