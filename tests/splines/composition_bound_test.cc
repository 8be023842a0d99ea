// SPDX-License-Identifier: LGPL-3.0-or-later
// The constant k of docs/bounds/composition.md, counted by running the algorithm on counts in the place of doubles.
#include <gtest/gtest.h>

#include <algorithm>

#include "splines/composition.h"
#include "splines/composition_bounded.h"
#include "splines/polynomial_filter.h"

namespace veritope {
namespace {

// The most roundings of any term of a sum of products. A sum begun with nothing has no rounding.
struct Count {
  int roundings = -1;  // -1: nothing

  Count() = default;
  explicit Count(int n) : roundings(n) {}
  friend Count operator*(Count a, Count b) { return Count(a.roundings + b.roundings + 1); }
  Count& operator+=(Count b) {
    roundings = roundings < 0 ? b.roundings : std::max(roundings, b.roundings) + 1;
    return *this;
  }
};

struct CountLanes {
  using Scalar = Count;
  static constexpr std::size_t kLanes = 3;
  Count p[kLanes];

  void add(const CountLanes& b) {
    for (std::size_t i = 0; i < kLanes; ++i) p[i] += b.p[i];
  }
  template <bool Add>
  void multiply(const Count* from, Count factor) {
    for (std::size_t i = 0; i < kLanes; ++i) {
      if (!Add) p[i] = Count();
      p[i] += from[i] * factor;
    }
  }
  void store(Count* to, std::size_t count) const { std::copy(p, p + count, to); }
};

template <std::size_t M>
int counted(const std::array<int, M>& outer, const Grid<3>& inner, int roundings_of_x,
            int roundings_of_q, int roundings_of_end) {
  using Algebra = internal::FilterAlgebra<CountLanes>;
  // The constant polynomial 1 starts the count with no rounding, as it says with Scalar(1): one too many.
  struct FromOne : Algebra {
    Polynomial constant_one() const { return {{{1, 1, 1}}, {Count(0)}}; }
  };
  const FromOne algebra;
  internal::InnerMap<FromOne, M> map;
  for (std::size_t m = 0; m < M; ++m) {
    map.x[m] = {inner, std::vector<Count>(inner.count(), Count(roundings_of_x))};
    map.q[m] = {inner, std::vector<Count>(inner.count(), Count(roundings_of_q))};
  }
  const auto basis = internal::basis_polynomials(algebra, outer[M - 1], map.x[M - 1], map.q[M - 1]);
  std::size_t net = 1;
  for (const int a : outer) net *= static_cast<std::size_t>(a) + 1;
  const std::vector<Count> coefficients(net, Count(0));
  const auto result =
      internal::compose_component<FromOne, M>(algebra, outer, coefficients, map, basis);
  int most = 0;
  for (const Count& c : result.c) most = std::max(most, c.roundings);
  return most + roundings_of_end;
}

TEST(CompositionBound, CountsTheRoundingsOfTheAlgorithmItself) {
  for (int a = 1; a <= 3; ++a)
    for (int b = 0; b <= 3; ++b) {
      SCOPED_TRACE(std::to_string(a) + ", " + std::to_string(b));
      EXPECT_EQ((internal::composition_roundings<1, 1>({a}, {b + 1})),
                counted<1>({a}, {{1, 1, static_cast<std::size_t>(b) + 2}}, 1, 2, 1));
      EXPECT_EQ((internal::composition_roundings<2, 2>({b, a}, {2, 3})),
                counted<2>({b, a}, {{1, 3, 4}}, 1, 2, 1));
      EXPECT_EQ((internal::composition_roundings<3, 3>({1, b, a}, {2, 1, 1})),
                counted<3>({1, b, a}, {{3, 2, 2}}, 1, 2, 1));
    }
}

// C(27, 13)^3 is no double: five roundings more.
TEST(CompositionBound, CountsTheRoundingsOfLargeBinomialCoefficients) {
  EXPECT_EQ((internal::composition_roundings<3, 3>({3, 3, 3}, {3, 3, 3})),
            counted<3>({3, 3, 3}, {{4, 4, 4}}, 1, 2, 1 + 5));
  EXPECT_EQ((internal::composition_roundings<3, 3>({3, 3, 3}, {3, 3, 3})), 149);
}

}  // namespace
}  // namespace veritope
