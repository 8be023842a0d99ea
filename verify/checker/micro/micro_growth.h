// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_growth.h: the matrix D of docs/certificates/microstructure.md, section 7b, with bounds of its error.
#pragma once
#include "micro_net.h"

// A number that differs from v by at most e. Any rounding of what is computed here is far less than 2^-48 of a result's
// size.
struct Near {
  double v, e;
};
inline Near near_of(const Span& s) { return Near{s.lo + (s.hi - s.lo) / 2, s.hi - s.lo}; }
inline Near near_of(double v, double e) {
  return Near{v, e + std::ldexp(e, -40) + std::ldexp(std::abs(v), -48) + kTiny};
}
inline Near operator*(const Near& a, const Near& b) {
  return near_of(a.v * b.v, std::abs(a.v) * b.e + std::abs(b.v) * a.e + a.e * b.e);
}
// A sum's numbers may be greater than it.
inline Near operator+(const Near& a, const Near& b) {
  return near_of(a.v + b.v, a.e + b.e + std::ldexp(std::abs(a.v) + std::abs(b.v), -48));
}
inline Near operator-(const Near& a, const Near& b) { return a + Near{-b.v, b.e}; }
inline bool is_positive(const Near& a) { return a.v > a.e; }
inline Near quotient(const Near& a, const Near& b) {  // REQUIRES is_positive(b)
  const double least = b.v - b.e, q = a.v / b.v;
  return near_of(q, (a.e + std::abs(q) * b.e) / least * (1 + std::ldexp(1.0, -40)));
}

// D on a box of the cell's parameters, and W^2: one net for each row and column.
struct Growth {
  DoubleNet d[3][3], square;
  bool is_rational;
};
// The map's homogeneous coordinates and their derivatives by the three parameters, on one box.
struct Jet {
  DoubleNet map, by[3];
};
Growth growth_of(const Jet& jet);

// The derivative by a parameter of which the net's interval has the length 1 / inverse.
DoubleNet derivative_of(const DoubleNet& net, size_t axis, const Near& inverse);
// The net where the axis has a value: one coefficient along it. REQUIRES a net on an interval that holds the value.
void flatten(DoubleNet* net, size_t axis);
