// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/certify/checker_numbers.h: the C++ checker's numbers as ours, for tests that compare its
// readers with the kernel's.
#pragma once
#include <cstddef>
#include <cstdint>

#include "robust/integer.h"
#include "robust/rational.h"
#include "verify/checker/patches/big.h"

namespace veritope {

inline Integer integer_of(const ::Big& n) {
  Integer out;
  for (std::size_t i = n.m.size(); i-- > 0;)
    for (const int low : {32, 0})
      out = out.shift_left(32) + Integer(static_cast<std::int64_t>(n.m[i] >> low & 0xffffffff));
  return n.neg ? -out : out;
}
inline Rational rational_of(const ::Ratio& r) { return Rational(integer_of(r.n), integer_of(r.d)); }

}  // namespace veritope
