// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/formula/quick_functions_internal.h: elementary functions of narrow intervals by Taylor series in binary64
// intervals. They enclose like those of functions.h, are a few units in the last place wider, and take 40 ns and not
// 10 us: arguments are reduced, series are summed, and remainders are added, all by operations of Interval, so that
// no rounding error needs a bound of its own.
#pragma once
#include <array>
#include <cstdint>

#include "interval/interval.h"

namespace veritope::internal {

/// REQUIRES here and below a live ScopedUpward and a nonempty x. Wide intervals (more than 2^-6) and those far from 0
/// (more than 2^20) are left to functions.h.
Interval quick_sin(const Interval& x);
Interval quick_cos(const Interval& x);
Interval quick_exp(const Interval& x);
/// x^n; products for |n| <= 64. REQUIRES that n >= 0 or 0 is not in x.
Interval quick_power(const Interval& x, std::int64_t n);

/// pi / 2 and log 2 as sums of numbers with 31, 32 and 40 bits, whose products with an integer of 20 or 12 bits are
/// exact, and an enclosure of the rest. Declared for tests.
inline constexpr double kHalfPi1 = 0x1.921fb544p+0, kHalfPi2 = 0x1.0b4611a0p-34;
inline constexpr double kHalfPiLow = 0x1.898cc51701b83p-64, kHalfPiHigh = 0x1.898cc51701b84p-64;
inline constexpr double kLog2 = 0x1.62e42fefa2p-1;
inline constexpr double kLog2Low = 0x1.9ef35793c7673p-41, kLog2High = 0x1.9ef35793c7674p-41;

/// The coefficients of the Taylor series. Each last one is widened by what the remainder adds to it, for arguments r
/// up to kMostTurn (sine, cosine) and kMostRest (exponential) in absolute value: with some members of these intervals
/// the sums are exact. Declared for tests. REQUIRES a live ScopedUpward.
struct TaylorSeries {
  static constexpr double kMostTurn = 0.8125, kMostRest = 0.375;
  std::array<Interval, 9> sine;       ///< of sin(r) / r in powers of r^2
  std::array<Interval, 10> cosine;    ///< of cos(r) in powers of r^2
  std::array<Interval, 16> exponent;  ///< of exp(r) in powers of r
  TaylorSeries();
};

}  // namespace veritope::internal
