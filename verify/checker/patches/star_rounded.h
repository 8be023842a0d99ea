// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_rounded.h: polynomials on nodes whose Bernstein coefficients are rounded to 64 bits, with a bound of the error.
#pragma once
#include "star_node.h"

const int kUnknown = 2;

// All coefficients times one positive factor; what is in c is at most `error` off.
struct Rounded {
  std::vector<int64_t> c;  // at most 2^61 in absolute value
  int64_t error;
};
Rounded rounded(const Shape& s, const Block& b);  // b: the coefficients times the binomials of their places
Rounded quarter(const Shape& s, const Rounded& r, int child);
// The sign of all coefficients, 0 if they surely do not have one sign, or kUnknown.
int sign_of(const Rounded& r);
