// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/predicates/generated/same_formulas.h: are two formulas the same sequence of rounded
// operations?
#pragma once
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "predicates/formulas.h"
#include "predicates/implicit_formulas.h"
#include "robust/base/random.h"

namespace veritope {

inline constexpr auto kAbs = [](double v) { return std::abs(v); };

inline void expect_same(double a, double b) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(a), std::bit_cast<std::uint64_t>(b)) << a << ' ' << b;
}

template <std::size_t N>
formulas::Triple<double> difference(const std::array<double, N>& v, int to, int base) {
  return {v[to] - v[base], v[to + 1] - v[base + 1], v[to + 2] - v[base + 2]};
}

/// Full mantissas: another order of evaluation rounds otherwise in a good part of the cases.
template <std::size_t N, typename Check>
void on_random_operands(Check check) {
  Random random(77);
  for (int i = 0; i < 300; ++i) {
    std::array<double, N> v;
    for (double& x : v) x = std::ldexp(2 * random.unit() - 1, static_cast<int>(random.below(3)));
    check(v);
    ASSERT_FALSE(testing::Test::HasFailure()) << "seed 77, case " << i;
  }
}

}  // namespace veritope
