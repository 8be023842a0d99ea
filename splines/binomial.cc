// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/binomial.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "robust/base/check.h"

namespace veritope {
namespace {

constexpr std::size_t kRows = kMaxBinomialRow + 1;

constexpr std::array<std::int64_t, kRows * kRows> pascal() {
  std::array<std::int64_t, kRows * kRows> table{};
  for (std::size_t n = 0; n < kRows; ++n) {
    table[n * kRows] = 1;
    for (std::size_t k = 1; k <= n; ++k)
      table[n * kRows + k] = table[(n - 1) * kRows + k - 1] + table[(n - 1) * kRows + k];
  }
  return table;
}
constexpr std::array<std::int64_t, kRows* kRows> kPascal = pascal();

}  // namespace

std::int64_t binomial_int64(int n, int k) {
  VT_CHECK(n >= 0 && n <= kMaxBinomialRow, "a binomial coefficient that may not fit 64 bits");
  if (k < 0 || k > n) return 0;
  return kPascal[static_cast<std::size_t>(n) * kRows + static_cast<std::size_t>(k)];
}

Integer binomial(int n, int k) {
  VT_CHECK(n >= 0, "a binomial coefficient of a negative number");
  if (k < 0 || k > n) return Integer(0);
  if (n <= kMaxBinomialRow) return Integer(binomial_int64(n, k));
  Integer product(1);
  for (int i = 1; i <= std::min(k, n - k); ++i)
    product = divide_exactly(product * Integer(n + 1 - i), Integer(i));
  return product;
}

}  // namespace veritope
