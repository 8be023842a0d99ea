// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/exact_double_internal.h: numbers that are doubles, which most numbers of files are, without a division.
#pragma once
#include <cmath>
#include <cstdint>
#include <optional>

#include "robust/rational.h"

namespace veritope::internal {

/// The double that the number is, if it is one of moderate size.
inline std::optional<double> as_double(const Rational& x) {
  const Integer &n = x.numerator(), &d = x.denominator();
  if (n.bit_length() > 53) return std::nullopt;
  const std::uint64_t exponent = d.bit_length() - 1;
  if (exponent > 512 || (exponent > 0 && d.trailing_zeros() != exponent)) return std::nullopt;
  return std::ldexp(static_cast<double>(n.to_int64()), -static_cast<int>(exponent));
}

}  // namespace veritope::internal
