// SPDX-License-Identifier: LGPL-3.0-or-later
// report/decimal_text.h: exact numbers as text for people and programs. Integers only: nothing depends on a rounding
// mode.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "interval/interval.h"
#include "robust/base/box3d.h"
#include "robust/rational.h"

namespace veritope::report {

/// "p/q", always with the denominator: "1/1".
std::string fraction_text(const Rational& value);

/// Scientific notation with `digits` significant ones, correctly rounded (ties to even), of any magnitude:
/// "1.2350000000000000e+02", "1.0000000000000000e+450", "0.0000000000000000e+00". REQUIRES digits >= 2.
std::string scientific_text(const Rational& value, int digits = 17);

/// For people: at most `digits` significant ones without zeros at the end; plain notation for usual magnitudes:
/// "123.5", "-0.001", "1e+450". REQUIRES digits >= 2.
std::string short_decimal(const Rational& value, int digits = 6);

/// Whether short_decimal of these digits has the exact value.
bool is_short_decimal(const Rational& value, int digits = 6);

/// The double's exact value as short_decimal; "inf" for infinity.
std::string short_decimal(double value, int digits = 6);

/// "(1, 0.5, -2)", each as short_decimal; fold does not break it.
std::string point_text(const Point3d& p);

/// The ends of a range as short_decimal, of as many more digits as it takes until different numbers have different
/// texts. They are rounded to nearest, so that the texts are no enclosure.
std::array<std::string, 2> range_ends(double lo, double hi, int digits = 6);
std::array<std::string, 2> range_ends(const Rational& lo, const Rational& hi, int digits = 6);

/// "1.5 to 1.75", with range_ends; "1.5" if the bounds are equal.
std::string range_text(const Interval& a, int digits = 9);

/// "(1, 0.5, -2) to (1, 0.75, 3)", with range_ends; fold breaks neither point.
std::string box_text(const Box3d& box);

/// The text, or its start with "..." and a total of `size` characters if it is longer. REQUIRES size >= 4.
std::string cut(std::string_view text, std::size_t size);

}  // namespace veritope::report
