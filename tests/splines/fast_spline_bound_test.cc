// SPDX-License-Identifier: LGPL-3.0-or-later
// The counts and terms of docs/bounds/fast_spline.md against the kernels' own formulas, run with numbers that count roundings.
#include <gtest/gtest.h>

#include <algorithm>

#include "robust/base/random.h"
#include "splines/fast_spline.h"
#include "splines/fast_spline_formulas_internal.h"
#include "splines/fast_spline_loops_internal.h"
#include "splines/fast_spline_tables_internal.h"

namespace veritope {
namespace {

using internal::Contraction;

// Factors 1 + d of the worst monomial: docs/bounds/README.md, 2. Exact: a constant of no roundings.
struct Count {
  int k = 0;
  friend Count operator+(Count a, Count b) { return {std::max(a.k, b.k) + 1}; }
  friend Count operator-(Count a, Count b) { return a + b; }
  friend Count operator-(Count a) { return a; }
  friend Count operator*(Count a, Count b) { return {a.k + b.k + 1}; }
};
struct CountWeights {
  std::vector<std::vector<Count>> b, d;
  explicit CountWeights(const std::vector<int>& degrees) {
    for (const int n : degrees) {
      std::vector<Count> weights(64), below(64), slopes(64);
      internal::bernstein_weights(n, Count{0}, Count{1}, Count{0}, weights.data(), below.data());
      internal::derivative_weights(n, below.data(), slopes.data());
      weights.resize(static_cast<std::size_t>(n) + 1), slopes.resize(weights.size());
      b.push_back(weights), d.push_back(slopes);
    }
  }
  int degree(std::size_t a) const { return static_cast<int>(b[a].size()) - 1; }
  Count value(std::size_t a, int i) const { return b[a][static_cast<std::size_t>(i)]; }
  Count slope(std::size_t a, int i) const { return d[a][static_cast<std::size_t>(i)]; }
};
struct ExactNet {
  Count next() { return {0}; }
};

template <std::size_t N>
void expect_counts(const std::array<int, N>& degrees) {
  const CountWeights weights({degrees.begin(), degrees.end()});
  ExactNet net;
  Contraction<N, Count, CountWeights, ExactNet> sum{weights, net};
  EXPECT_EQ(sum.template value<0>().k, internal::fast_value_roundings(degrees));
  const auto jet = sum.template jet<0>();
  EXPECT_EQ(jet.value.k, internal::fast_value_roundings(degrees));
  for (std::size_t a = 0; a < N; ++a)
    EXPECT_EQ(jet.partial[a].k, internal::fast_partial_roundings(degrees, a));
}

TEST(FastSplineBound, CountsEveryRoundingOfTheKernels) {
  for (int p = 1; p <= 63; ++p) expect_counts<1>({p});
  for (int p = 1; p <= 8; ++p)
    for (int q = 1; q <= 8; ++q) expect_counts<2>({p, q}), expect_counts<3>({p, 3, q});
  EXPECT_EQ(internal::fast_value_roundings<2>({3, 3}), 20);
  EXPECT_EQ(internal::fast_value_roundings<3>({3, 3, 3}), 30);
}

// The worst of three axes of degree 63, size by size: weights sum to 1 whatever s is, so that a level's error is at most
// that of its two products, and a sum's that of its 64 terms.
TEST(FastSplineBound, UnderflowTermPaysForTheHighestDegrees) {
  const Rational unit = Rational::power_of_two(-1075), one(1),
                 grow = one + Rational::power_of_two(-40);
  Rational weight;  // error of one weight
  for (int level = 2; level <= 63; ++level) weight = (weight + unit + unit) * grow;
  for (const Rational& size : {Rational(), one, Rational::power_of_two(200)}) {
    Rational error;  // of what is inside
    for (int axis = 0; axis < 3; ++axis) {
      // 64 terms b x: |b| error(x) sums to at most 2 error(x) (slopes), error(b) |x| and a product's unit come 64 times; |x| grows by 2.
      const Rational x = size * Rational::power_of_two(axis + 1) + error;
      error = (Rational(2) * error + Rational(64) * (Rational(2) * weight * x + unit)) * grow;
    }
    EXPECT_LE(error, Rational::power_of_two(-1040) * (one + size));
  }
}

TEST(FastSplineBound, ParameterErrorIsReachedWithinAFactor) {
  // a = 1/3, h = 1/7: no number of the cell is a double.
  const std::vector<Rational> breaks{Rational(1) / Rational(3), Rational(10) / Rational(21)};
  const auto axis = internal::make_fast_axis(3, breaks).value();
  const Rational a = breaks[0], h = breaks[1] - breaks[0];
  Random random(7);
  Rational most;
  for (int i = 0; i < 20000; ++i) {
    const double x = axis.breaks[0] + (axis.breaks[1] - axis.breaks[0]) * random.unit();
    const double s = std::min(1.0, (x - axis.origin[0]) * axis.rate[0]);
    const Rational error = abs(Rational::from_double(s) - (Rational::from_double(x) - a) / h);
    ASSERT_LE(error, axis.error[0]) << x;
    most = most < error ? error : most;
  }
  EXPECT_GT(Rational(4) * most, axis.error[0]);  // with one fewer term the loop above would fail
}

TEST(FastSplineBound, QuotientSlackCoversTheBoundsOwnRoundings) {
  // Section 6: at most 12 roundings in E_T and 8 in the bound, and 1 / (1 - u)^2 for |q^| instead of |X^ / w^|.
  const Rational u = Rational::power_of_two(-53), one(1);
  Rational down(1);
  for (int i = 0; i < 22; ++i) down *= one - u;
  EXPECT_GE(Rational::from_double(internal::kFastQuotientSlack) * down, one);
  EXPECT_EQ(Rational::from_double(internal::kFastQuotientSlack), one + Rational::power_of_two(-44));
  EXPECT_GE(Rational::from_double(internal::kFastQuotientRel) * down, u / (one - u));
}

// The page's E for one piece, recomputed from its definition, against the table.
TEST(FastSplineBound, TableHasTheDerivedBoundAndNotMuchMore) {
  const auto axis = make_knot_axis(3, {0, 0, 0, 0, 1, 1, 1, 1}).value();
  std::vector<Rational> c;
  for (int i = 0; i < 16; ++i) c.push_back(Rational((7 * i * i + 3) % 31 - 15) / Rational(9));
  const auto storage =
      internal::make_fast_storage(BSplineSurface<Rational>({axis, axis}, 1, false, c)).value();
  const auto larger = [](Rational a, const Rational& b) { return a < b ? b : a; };
  Rational size, conversion, du, dv;
  for (int i = 0; i < 16; ++i) {
    const Rational rounded = Rational::from_double(nearest_double(c[i]));
    size = larger(size, abs(rounded)), conversion = larger(conversion, abs(c[i] - rounded));
    if (i >= 4) du = larger(du, abs(c[i] - c[i - 4]));
    if (i % 4 != 0) dv = larger(dv, abs(c[i] - c[i - 1]));
  }
  const Rational u = Rational::power_of_two(-53), one(1);
  const Rational eps = (one + u) * (one + u) - one;  // a = 0, h = 1: e = rho = 0
  Rational power(1);
  for (int i = 0; i < 20; ++i) power *= one + u;
  const auto expect_derived = [&](const Rational& derived, double constant) {
    const Rational stored = Rational::from_double(constant);
    EXPECT_LE(derived, stored);
    EXPECT_LE(stored, derived * (one + Rational::power_of_two(-20)));
  };
  expect_derived((power - one) * size + conversion + eps * Rational(3) * (du + dv),
                 storage.bounds[0]);
  // Section 5: K' = 20 - 6 + 3 + 1; q = 3 exactly.
  Rational partial_power(1);
  for (int i = 0; i < 18; ++i) partial_power *= one + u;
  const Rational g = du, other = du < dv ? du : dv, q(3);
  const Rational sum = (partial_power - one) * Rational(2) * size + Rational(2) * conversion +
                       eps * (Rational(4) * g + Rational(6) * other);
  expect_derived(q * (one + u) * sum + g * u * q, storage.bounds[1]);
}

// Section 6 with errors so large that every term counts: exact numbers at all corners of the computed ones' errors.
TEST(FastSplineBound, QuotientsAreWithinTheirBoundsAtEveryCorner) {
  struct NoLanes {};
  Random random(9);
  internal::FastSplineTables tables{};
  double inverse = 0, closest_value = 0, closest_slope = 0;
  tables.inverse_weight = &inverse;
  const auto exactly = [](double v) { return Rational::from_double(v); };
  for (int loop = 0; loop < 1000; ++loop) {
    const auto number = [&] {
      return (2 * random.unit() - 1) * static_cast<double>(1 + random.below(9));
    };
    const double scale = random.below(2) == 0 ? 0x1p-8 : 0x1p-50;
    // [component][value, slope]: X and w; and their errors.
    double x[2][4] = {{number()}, {number()}}, w[2][4] = {{0.5 + random.unit()}, {number()}};
    double bounds[4];  // E_X, E_w, E_X', E_w'
    for (double& b : bounds) b = scale * random.unit() * static_cast<double>(random.below(3));
    inverse = round_up(Rational(1) / (exactly(w[0][0]) - exactly(bounds[1])));
    double value = 0, value_bound = 0, partial = 0, partial_bound = 0;
    internal::FastLoop<NoLanes, 1, 0>::quotients(tables, 0, 0, 0, 1, x, w, bounds,
                                                 {&value, &value_bound, &partial, &partial_bound});
    for (int corner = 0; corner < 16; ++corner) {
      const auto at = [&](double v, int k) {
        return exactly(v) + ((corner >> k & 1) != 0 ? exactly(bounds[k]) : -exactly(bounds[k]));
      };
      const Rational exact_x = at(x[0][0], 0), exact_w = at(w[0][0], 1), q = exact_x / exact_w;
      const Rational slope = (at(x[1][0], 2) - q * at(w[1][0], 3)) / exact_w;
      const Rational value_error = abs(exactly(value) - q),
                     slope_error = abs(exactly(partial) - slope);
      ASSERT_LE(value_error, exactly(value_bound)) << "loop " << loop;
      ASSERT_LE(slope_error, exactly(partial_bound)) << "loop " << loop;
      closest_value = std::max(closest_value, nearest_double(value_error) / value_bound);
      closest_slope = std::max(closest_slope, nearest_double(slope_error) / partial_bound);
    }
  }
  EXPECT_GT(closest_value, 0.95);  // one fewer term would have failed
  EXPECT_GT(closest_slope, 0.9);
}

}  // namespace
}  // namespace veritope
