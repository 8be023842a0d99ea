// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/text.h: interval literals of IEEE 1788.1 [IEEE1788] 9.7 and 12.11, read exactly and rounded outward.
#pragma once
#include <string>
#include <string_view>

#include "interval/decorated.h"

namespace veritope {

/// Reads one literal, in any case of letters, with blanks inside the brackets:
///   "[ ]" "[empty]" "[entire]" "[,]" "[x]" "[lo, hi]"   lo or hi left out, or inf, infinity: unbounded
///   numbers: decimal "-1.5e3", hexadecimal "0x1.8p-3", rational "2/3"
///   uncertain: "3.56?1" = 3.56 +- 1 unit of the last place, "3.56?" = half a unit, "??" unbounded, then
///   "u" or "d" for upward or downward only, then "e4" as exponent of both.
/// The bounds are compared exactly before they are rounded outward to the nearest binary64 numbers, so that the
/// standard's PossiblyUndefinedOperation never occurs.
/// @error  kUndefinedOperation with the empty set, if the text is no such literal, lo > hi, a denominator is not a
///         positive integer, or the number of digits or an exponent exceeds kMaxLiteralDigits.
/// @cost   quadratic in the number of digits
Signalled<Interval> text_to_interval(std::string_view text);

/// Reads a literal with an optional suffix "_com", "_dac", "_def", "_trv", and with "[nai]".
/// A decoration that the written interval cannot have is an error, one that only its rounding cannot have (overflow
/// of _com) is lowered. @error kUndefinedOperation with NaI
Signalled<DecoratedInterval> text_to_decorated(std::string_view text);

inline constexpr int kMaxLiteralDigits = 5000;

/// Text that text_to_interval and text_to_decorated read back to the same value: hexadecimal bounds.
std::string exact_text(const Interval& x);
std::string exact_text(const DecoratedInterval& x);

}  // namespace veritope
