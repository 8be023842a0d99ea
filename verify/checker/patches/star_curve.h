// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_curve.h: curves on the sides of patches, homogeneous Bernstein coefficients, and their parts.
#pragma once
#include "star.h"

typedef std::vector<Big> Curve;  // homogeneous points, X Y Z W each

Curve side_curve(const Patch& p, int e, bool reversed);  // in the patch's own direction of travel
bool is_point(const Curve& c);                           // all its points are equal
// The curve in its lowest degree, without a common factor: two curves are the same, up to one positive factor of their
// coefficients, iff these are equal, and so are their texts.
Curve canonical(Curve c);
std::string text(const Curve& c, bool reversed);

struct Part {  // [a, b] / 2^k, a <= b <= 2^k, k <= 62
  int k;
  int64_t a, b;
  bool is_point() const { return a == b; }
};
// The coefficients on a part of [0, 1], up to a positive factor; on a point they are all equal. The row has this many
// coefficients, each of the same number of numbers.
std::vector<Big> restricted(std::vector<Big> row, size_t points, const Part& t);
void halve(const Curve& c, Curve* lower, Curve* upper);
