// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/reduction.h: sums with one rounding. Source: [IEEE1788] 12.12.12. The functions work in any floating-point
// environment; their cost is that of exact rationals.
#pragma once
#include <span>

namespace veritope {

/// The binary64 number nearest to the exact sum, ties to even. NaN if an operand is NaN, infinities
/// of both signs meet, or 0 meets an infinity in a product.
double sum_nearest(std::span<const double> x);
double sum_abs_nearest(std::span<const double> x);
double sum_sqr_nearest(std::span<const double> x);
/// REQUIRES that x and y have equal lengths.
double dot_nearest(std::span<const double> x, std::span<const double> y);

}  // namespace veritope
