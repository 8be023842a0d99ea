// SPDX-License-Identifier: LGPL-3.0-or-later
// The count k of docs/bounds/jacobian_net.md, by running the formulas on counts in the place of doubles.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "solids/vmodel/jacobian_formulas_internal.h"
#include "solids/vmodel/jacobian_net.h"
#include "splines/polynomial_filter.h"

namespace veritope {
namespace {

// The most roundings of any term of a sum of products. A sum begun with nothing has no rounding.
struct TermCount {
  int roundings = -1;  // -1: nothing

  TermCount() = default;
  explicit TermCount(int n) : roundings(n) {}
  friend TermCount operator*(TermCount a, TermCount b) {
    return TermCount(a.roundings + b.roundings + 1);
  }
  friend TermCount operator-(TermCount a) { return a; }
  TermCount& operator+=(TermCount b) {
    roundings = roundings < 0 ? b.roundings : std::max(roundings, b.roundings) + 1;
    return *this;
  }
};

struct TermCountLanes {
  using Scalar = TermCount;
  static constexpr std::size_t kLanes = 3;
  TermCount p[kLanes];

  void add(const TermCountLanes& b) {
    for (std::size_t i = 0; i < kLanes; ++i) p[i] += b.p[i];
  }
  template <bool Add>
  void multiply(const TermCount* from, TermCount factor) {
    for (std::size_t i = 0; i < kLanes; ++i) {
      if (!Add) p[i] = TermCount();
      p[i] += from[i] * factor;
    }
  }
  void store(TermCount* to, std::size_t count) const { std::copy(p, p + count, to); }
};

// Rows whose coefficients went through the two roundings of a difference and of its product with a binomial.
internal::JacobianRow<TermCount> counted_row(Grid<3> grid, std::size_t axis,
                                             std::size_t components) {
  if (axis < 3) --grid.size[axis];
  return {components, {grid, std::vector<TermCount>(grid.count(), TermCount(2))}};
}
int counted(const Grid<3>& grid, bool is_rational) {
  const internal::FilterAlgebra<TermCountLanes> algebra;
  const std::size_t n = is_rational ? 4 : 3;
  const auto u = counted_row(grid, 0, n), v = counted_row(grid, 1, n), w = counted_row(grid, 2, n);
  const auto result = is_rational
                          ? internal::determinant4(algebra, counted_row(grid, 3, n), u, v, w)
                          : internal::determinant3(algebra, u, v, w);
  int most = 0;
  for (const TermCount& c : result.c) most = std::max(most, c.roundings);
  return most;
}

TEST(JacobianBound, CountsTheRoundingsOfTheFormulasThemselves) {
  for (std::size_t p = 1; p <= 3; ++p)
    for (std::size_t q = 1; q <= 3; ++q)
      for (std::size_t r = 1; r <= 3; ++r) {
        const Grid<3> grid{{p + 1, q + 1, r + 1}};
        SCOPED_TRACE(std::to_string(p) + " " + std::to_string(q) + " " + std::to_string(r));
        EXPECT_EQ(internal::jacobian_roundings(grid, false), counted(grid, false));
        EXPECT_EQ(internal::jacobian_roundings(grid, true), counted(grid, true));
      }
}

}  // namespace
}  // namespace veritope
