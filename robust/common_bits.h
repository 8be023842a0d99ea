// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/common_bits.h: how long rationals become when their least common denominator brings them to integers.
#pragma once
#include <algorithm>
#include <cstdint>

#include "robust/rational.h"

namespace veritope {

/// Collects rationals. The cost of add is that of one greatest common divisor at most; equal denominators in a row, and
/// those of integers, cost a comparison. Nothing is multiplied out but the denominator, and that only up to `most`.
class CommonBits {
 public:
  /// @param most  bits beyond which only the fact matters
  explicit CommonBits(std::uint64_t most) : most_(most) {}

  void add(const Rational& x) {
    numerator_ = std::max(numerator_, x.numerator().bit_length());
    const Integer& d = x.denominator();
    if (is_long_ || d == Integer(1) || d == last_) return;
    last_ = d;
    common_ = lcm(common_, d);
    is_long_ = common_.bit_length() > most_;
  }

  /// At least the most bits of the integers and of the denominator, and at most twice as many. Beyond the limit,
  /// where denominators are not multiplied out, more than `most`.
  std::uint64_t bits() const {
    if (common_ == Integer(1)) return std::max<std::uint64_t>(1, numerator_);
    return numerator_ + common_.bit_length();
  }
  bool is_beyond() const { return is_long_ || bits() > most_; }

 private:
  std::uint64_t most_, numerator_ = 0;
  Integer common_{1}, last_{1};
  bool is_long_ = false;
};

}  // namespace veritope
