// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/functions.h: elementary functions of intervals. Laws, for every function f here:
//   (1) x in a and f(x) defined implies f(x) in f(a);
//   (2) each bound is the nearest binary64 number outside of the range, unless said otherwise;
//   (3) f(a) is empty iff f is defined nowhere on a.
// They work in any floating-point environment and leave it as it was. Cost: 1 to 20 us in MPFR [FHL07], with
// allocations; no predicate uses them. Definitions: [IEEE1788] table 9.1, 10.5.
#pragma once
#include <cstdint>

#include "interval/interval.h"

namespace veritope {

/// a * b + c with one rounding of each bound.
Interval fma(const Interval& a, const Interval& b, const Interval& c);
/// x^n for every integer n; 1 for n = 0; undefined at 0 for n < 0.
Interval pown(const Interval& x, std::int64_t n);
/// The real n-th root, x^(1/n). For even n it is defined for x >= 0 only, for n = 0 nowhere, for n < 0 not at 0.
Interval rootn(const Interval& x, std::int64_t n);
/// x^y = exp(y log x) for x > 0, and 0 for x = 0, y > 0.
Interval pow(const Interval& x, const Interval& y);

Interval exp(const Interval& x);
Interval exp2(const Interval& x);
Interval exp10(const Interval& x);
/// e^x - 1.
Interval expm1(const Interval& x);
Interval log(const Interval& x);
Interval log2(const Interval& x);
Interval log10(const Interval& x);
/// log(1 + x).
Interval logp1(const Interval& x);

Interval sin(const Interval& x);
Interval cos(const Interval& x);
Interval tan(const Interval& x);
Interval cot(const Interval& x);
Interval sec(const Interval& x);
Interval csc(const Interval& x);
Interval asin(const Interval& x);
Interval acos(const Interval& x);
Interval atan(const Interval& x);
/// In (0, pi), continuous at 0.
Interval acot(const Interval& x);
/// The angle of the point (x, y), in (-pi, pi]; undefined at the origin.
Interval atan2(const Interval& y, const Interval& x);

Interval sinh(const Interval& x);
Interval cosh(const Interval& x);
Interval tanh(const Interval& x);
Interval coth(const Interval& x);
Interval sech(const Interval& x);
Interval csch(const Interval& x);
Interval asinh(const Interval& x);
Interval acosh(const Interval& x);
Interval atanh(const Interval& x);
Interval acoth(const Interval& x);

Interval cbrt(const Interval& x);
/// The square root of x^2 + y^2.
Interval hypot(const Interval& x, const Interval& y);

/// The step function with the values -1, 0 and 1; Interval::sign is what decides a sign.
Interval sign_function(const Interval& x);
Interval ceil(const Interval& x);
Interval floor(const Interval& x);
Interval trunc(const Interval& x);
Interval round_ties_to_even(const Interval& x);
Interval round_ties_to_away(const Interval& x);

}  // namespace veritope
