// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/scaled_product.h"

#include <gtest/gtest.h>

#include <vector>

#include "splines/bezier_product.h"
#include "splines/bezier_triangle_algebra.h"
#include "splines/de_casteljau.h"
#include "splines/scaled_polynomial.h"
#include "tests/splines/draw.h"

namespace veritope {
namespace {

// Only what a ring must have: no compound assignment.
struct Bare {
  long v = 0;
  friend Bare operator+(Bare a, Bare b) { return {a.v + b.v}; }
  friend Bare operator*(Bare a, Bare b) { return {a.v * b.v}; }
};

TEST(AddProduct, IsTheSameWhateverTheNumbersOffer) {
  Integer i(5);
  internal::add_product(i, Integer(-3), Integer(4));
  EXPECT_EQ(i, Integer(-7));
  Rational q = fraction(1, 2);
  internal::add_product(q, fraction(1, 3), fraction(3, 4));
  EXPECT_EQ(q, fraction(3, 4));
  double d = 0.5;
  internal::add_product(d, 0.25, 2.0);
  EXPECT_EQ(d, 1.0);
  Bare b{7};
  internal::add_product(b, Bare{2}, Bare{-5});
  EXPECT_EQ(b.v, -3);
}

// The value at (x_1, ...) of the polynomial with these scaled coefficients, by powers.
template <std::size_t N>
Rational value_of(const std::vector<Rational>& c, const Grid<N>& grid,
                  const std::array<Rational, N>& at) {
  Rational sum;
  for (std::size_t i = 0; i < grid.count(); ++i) {
    const auto index = grid.index_of(i);
    Rational term = c[i];
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t k = 0; k + 1 < grid.size[a]; ++k)
        term *= k < index[a] ? at[a] : Rational(1) - at[a];
    sum += term;
  }
  return sum;
}

TEST(ScaledProduct, OnGridsHasTheProductOfTheValues) {
  for_all_dimensions(920, 40, [](Random& random, auto n) {
    const auto x = draw_bezier<n>(random, 3, 1), y = draw_bezier<n>(random, 3, 1);
    const std::vector<Rational> a(x.coefficients().begin(), x.coefficients().end()),
        b(y.coefficients().begin(), y.coefficients().end());
    const Grid<n> grid = internal::product_grid(x.grid(), y.grid());
    std::vector<Rational> out(grid.count(), Rational(3));  // it is added to
    internal::add_product_on_grids(a.data(), x.grid(), b.data(), y.grid(), out.data(), grid);
    const auto at = draw_point<n>(random);
    const std::vector<Rational> threes(grid.count(), Rational(3));
    EXPECT_EQ(value_of<n>(out, grid, at),
              value_of<n>(threes, grid, at) +
                  value_of<n>(a, x.grid(), at) * value_of<n>(b, y.grid(), at));
  });
}

TEST(ScaledProduct, OfBernsteinFormsHasTheProductOfTheValues) {
  for_all_dimensions(923, 30, [](Random& random, auto n) {
    const auto x = draw_bezier<n>(random, 3, 1), y = draw_bezier<n>(random, 3, 1);
    const auto at = draw_point<n>(random);
    EXPECT_EQ(evaluate(multiplied(x, y), at)[0], evaluate(x, at)[0] * evaluate(y, at)[0]);
  });
}

TEST(ScaledProduct, OnTrianglesHasTheProductOfTheValues) {
  for_loops(926, 60, [](Random& random) {
    const auto draw = [&] {
      const int degree = draw_int(random, 0, 5);
      return BezierTriangle<Rational>(
          degree, 1, false, draw_coefficients(random, num_triangle_coefficients(degree), 1, false));
    };
    const auto x = draw(), y = draw();
    const Rational u = draw_rational(random), v = draw_rational(random);
    const Barycentric<Rational> at{Rational(1) - u - v, u, v};
    EXPECT_EQ(evaluate(product(x, y), at)[0], evaluate(x, at)[0] * evaluate(y, at)[0]);
  });
}

// Doubles: terms are added in the order of the first factor's coefficients, which is what bounds and golden hashes
// rest on.
TEST(ScaledProduct, AddsInTheOrderOfTheFirstFactor) {
  const double big = 0x1p60;
  const std::vector<double> a{big, 1, -big}, b{1, 1, 1};
  std::vector<double> out(5);
  internal::add_product_on_grids<double, 1>(a.data(), {{3}}, b.data(), {{3}}, out.data(), {{5}});
  EXPECT_EQ(out[2], 0);  // (big + 1) - big
  const std::vector<double> c{big, -big, 1};
  std::vector<double> other(5);
  internal::add_product_on_grids<double, 1>(c.data(), {{3}}, b.data(), {{3}}, other.data(), {{5}});
  EXPECT_EQ(other[2], 1);  // (big - big) + 1
}

TEST(KnownBinomial, IsThatOfTheRing) {
  for (const int n : {0, 1, 7, 66, 70})
    for (int k = 0; k <= n; ++k) {
      EXPECT_EQ(internal::known_binomial<Rational>(n, k), Rational(binomial(n, k)));
      EXPECT_EQ(internal::known_binomial<Integer>(n, k), binomial(n, k));
    }
}

}  // namespace
}  // namespace veritope
