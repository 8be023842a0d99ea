// SPDX-License-Identifier: LGPL-3.0-or-later
// io/base/exact_number.h: decimals, fractions and hexadecimal floats as exact rationals, and back.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "io/base/decimal.h"
#include "robust/rational.h"

namespace veritope {

/// The exact value of a decimal of io/base/decimal.h's grammar. kNotFinite for the words that programs print for NaN
/// and infinity; kDigits and kExponent as DecimalReader has them.
/// @cost quadratic in the number of digits; the value has at most digits + exponent digits
DecimalFault read_exact_decimal(std::string_view token, const ReadLimits& limits, Rational& value);

/// Also reads "p/q" of integers, q > 0, and C99's hexadecimal floats "-0x1.8p-3". Integers and fractions may have
/// max_digits + max_exponent digits, the number of digits of the longest decimal within the limits when it is written
/// out.
DecimalFault read_exact_number(std::string_view token, const ReadLimits& limits, Rational& value);

/// A decimal, "-0.5", "1e+30", that is exactly this number and that read_exact_decimal reads within the limits; nothing
/// if no such decimal exists. Equal numbers give equal text. Every number that was read from a decimal within the
/// limits has one.
/// @cost near-linear in the digits
std::optional<std::string> exact_decimal(const Rational& value, const ReadLimits& limits = {});

/// The decimal of digits * 10^exponent in the form of exact_decimal. REQUIRES digits, the last not
/// 0 unless it is the only one.
std::optional<std::string> spell_decimal(std::string digits, std::int64_t exponent,
                                         const ReadLimits& limits);

}  // namespace veritope
