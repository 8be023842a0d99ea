// SPDX-License-Identifier: LGPL-3.0-or-later
// named_predicates/number_reader.h: one binary64 number as people and printf write it.
#pragma once
#include <string_view>

#include "io/base/decimal.h"
#include "robust/base/result.h"

namespace veritope {

/// Two grammars, case of letters ignored:
///   decimal      [+-]? ( digits [ . digits? ] | . digits ) ( e [+-]? digits )?, rounded to nearest, ties to even;
///   hexadecimal  [+-]? 0x ( hexdigits [ . hexdigits? ] | . hexdigits ) ( p [+-]? digits )?, exact or refused:
///                it means itself, and rounding would make it another number.
/// -0 becomes +0.
class NumberReader {
 public:
  NumberReader();

  /// `token` is the whole token. REQUIRES that 8 bytes after it may be read (io/base/scan.h).
  /// @error kSyntax; kNotFinite; kLossy for a hexadecimal number between two binary64 numbers; kOverLimit for
  ///        a decimal exponent beyond 2^32 - 1. The sentence has the token, and fits after "column 3: ".
  Result<double> read(std::string_view token) const;

 private:
  DecimalReader decimals_;
};

}  // namespace veritope
