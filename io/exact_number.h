// SPDX-License-Identifier: LGPL-3.0-or-later
// io/exact_number.h: decimals, fractions and hexadecimal floats as exact rationals, and back.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "io/decimal.h"
#include "robust/rational.h"

namespace veritope {

/// The exact value of a decimal of io/decimal.h's grammar. kNotFinite for the words that programs print for NaN and
/// infinity; kDigits and kExponent as DecimalReader has them.
/// @cost quadratic in the number of digits; the value has at most digits + exponent digits
DecimalFault read_exact_decimal(std::string_view token, const ReadLimits& limits, Rational& value);

/// Also "p/q" of integers, q > 0, and C99's hexadecimal floats "-0x1.8p-3". Integers and fractions may have max_digits +
/// max_exponent digits: as many as a decimal within the limits has when it is written out.
DecimalFault read_exact_number(std::string_view token, const ReadLimits& limits, Rational& value);

/// The shortest decimal that is exactly this number, "-0.5", "1e+30"; nothing if none is.
std::optional<std::string> exact_decimal(const Rational& value);

}  // namespace veritope
