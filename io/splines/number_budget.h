// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/number_budget.h: how much memory the exact numbers of one file may take: in proportion to its bytes.
#pragma once
#include <cstdint>
#include <string>

#include "robust/rational.h"

namespace veritope {

/// A budget is needed because seven bytes, 1e4096, are a number of 1700 bytes: such a file would fill the memory.
/// Claim  A file whose numbers are within the range of binary64 is within the budget as read: six bytes, 1e308, are 128
///        bytes, seven, 5e-324, are 135; both are less than kPerByte for each byte.
class NumberBudget {
 public:
  static constexpr std::uint64_t kFree = std::uint64_t{64} << 20, kPerByte = 32;

  explicit NumberBudget(std::uint64_t file_bytes)
      : total_(file_bytes > (~std::uint64_t{0} - kFree) / kPerByte ? ~std::uint64_t{0}
                                                                   : kFree + kPerByte * file_bytes),
        left_(total_) {}

  /// The bytes of numerator and denominator without leading zeros.
  static std::uint64_t bytes_of(const Rational& x) {
    return (x.numerator().bit_length() + x.denominator().bit_length() + 7) / 8;
  }
  /// Spends so many bytes; false if fewer are left.
  bool spend(std::uint64_t bytes) {
    if (bytes > left_) return false;
    left_ -= bytes;
    return true;
  }
  bool spend(const Rational& x) { return spend(bytes_of(x)); }
  void give_back(std::uint64_t bytes) { left_ += bytes; }
  std::uint64_t left() const { return left_; }

  /// "the file's numbers take more than N bytes when they are written out".
  std::string message() const {
    return "the file's numbers take more than " + std::to_string(total_) +
           " bytes when they are written out (64 MiB and 32 for each byte of the file)";
  }

 private:
  std::uint64_t total_, left_;
};

}  // namespace veritope
