// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/fast_spline.h"

#include <gtest/gtest.h>

#include <bit>
#include <cfenv>
#include <cmath>
#include <limits>

#include "tests/splines/exact_map.h"

namespace veritope {
namespace {

using exact_map::ExactMap;
using exact_map::random_bspline;
using exact_map::Shape;

// Parameters of every kind: random, the breaks and their neighbours, the ends.
template <std::size_t N>
std::array<std::vector<double>, N> draw_parameters(Random& random, const FastSpline<N>& fast,
                                                   const ExactMap<N>& exact, int count) {
  std::array<std::vector<double>, N> at;
  for (std::size_t a = 0; a < N; ++a) {
    const auto [lo, hi] = fast.domain(a);
    const auto& breaks = exact.pieces().breaks[a];
    for (int i = 0; i < count; ++i) {
      double u = lo + (hi - lo) * random.unit();
      if (i % 4 == 1) {
        u = nearest_double(breaks[random.below(breaks.size())]);
        if (i % 8 == 1) u = std::nextafter(u, random.below(2) == 0 ? -1e9 : 1e9);
      }
      if (i % 16 == 2) u = lo;
      if (i % 16 == 3) u = hi;
      at[a].push_back(std::min(std::max(u, lo), hi));
    }
  }
  return at;
}

struct Output {
  std::vector<double> value, value_bound, partial, partial_bound;
  Output(std::size_t n, std::size_t dimension, std::size_t axes)
      : value(n * dimension),
        value_bound(n * dimension),
        partial(n * dimension * axes),
        partial_bound(n * dimension * axes) {}
  FastSplineOutput all() {
    return {value.data(), value_bound.data(), partial.data(), partial_bound.data()};
  }
  FastSplineOutput values() { return {value.data(), value_bound.data(), nullptr, nullptr}; }
};

template <std::size_t N>
void expect_within_bounds(Random& random, const BSpline<Rational, N>& map, int count,
                          const std::string& text) {
  const auto fast = FastSpline<N>::prepare(map).value();
  const ExactMap<N> exact(map);
  const auto at = draw_parameters<N>(random, fast, exact, count);
  std::array<const double*, N> pointers;
  for (std::size_t a = 0; a < N; ++a) pointers[a] = at[a].data();
  const auto n = static_cast<std::size_t>(count), dimension = fast.dimension();
  Output with(n, dimension, N), without(n, dimension, N);
  fast.evaluate(pointers, n, with.all());
  fast.evaluate(pointers, n, without.values());
  const auto expect_near = [&](double computed, double bound, const Rational& truth) {
    ASSERT_LE(abs(Rational::from_double(computed) - truth), Rational::from_double(bound)) << text;
    ASSERT_LE(bound, 1e-9 * (1 + std::abs(computed))) << text;
  };
  for (std::size_t i = 0; i < n; ++i) {
    std::array<Rational, N> u;
    for (std::size_t a = 0; a < N; ++a) u[a] = Rational::from_double(at[a][i]);
    const auto truth = exact.at(u);
    for (std::size_t c = 0; c < dimension; ++c) {
      const std::size_t k = i * dimension + c;
      expect_near(with.value[k], with.value_bound[k], truth.value[c]);
      expect_near(without.value[k], without.value_bound[k], truth.value[c]);
      for (std::size_t a = 0; a < N; ++a) {
        const std::size_t j = (i * N + a) * dimension + c;
        expect_near(with.partial[j], with.partial_bound[j], truth.partial[a][c]);
      }
    }
  }
}

template <std::size_t N>
void try_shapes(std::uint64_t seed, int loops, int points, int greatest) {
  Random random(seed);
  for (int loop = 0; loop < loops; ++loop) {
    Shape<N> shape;
    const bool is_equal = loop % 2 == 0;
    const auto degree = [&] {
      return 1 + static_cast<int>(random.below(static_cast<std::uint64_t>(greatest)));
    };
    shape.degrees.fill(degree());
    for (std::size_t a = 0; a < N; ++a) {
      if (!is_equal) shape.degrees[a] = degree();
      shape.spans[a] = 1 + random.below(N == 3 ? 2 : 5);
    }
    shape.is_rational = random.below(2) == 0;
    shape.num_components = 1 + static_cast<int>(random.below(5)) + (shape.is_rational ? 1 : 0);
    // Denominators that are powers of two, and that are not: the conversion's error is in the bound.
    const auto map =
        random_bspline(random, shape, random.below(2) == 0 ? 8 : 7, random.below(2) == 0 ? 64 : 30);
    expect_within_bounds(random, map, points,
                         "seed " + std::to_string(seed) + " loop " + std::to_string(loop));
  }
}

TEST(FastSpline, ErrsByAtMostItsBoundOnCurves) { try_shapes<1>(11, 40, 48, 7); }
TEST(FastSpline, ErrsByAtMostItsBoundOnSurfaces) { try_shapes<2>(12, 30, 32, 6); }
TEST(FastSpline, ErrsByAtMostItsBoundOnVolumes) { try_shapes<3>(13, 10, 16, 4); }

TEST(FastSpline, HasOneAnswerForEveryBackEndAndControlWord) {
  if (!is_available(FastBackEnd::kAvx2)) GTEST_SKIP() << "no AVX2";
  Random random(21);
  for (int loop = 0; loop < 20; ++loop) {
    const bool is_rational = loop % 2 == 1;
    const int degree = 1 + static_cast<int>(random.below(6));
    const auto map = random_bspline<2>(
        random,
        {{degree, loop % 5 == 0 ? 2 : degree}, {3, 4}, 2 + loop % 4 + is_rational, is_rational}, 7,
        30);
    const auto fast = FastSpline<2>::prepare(map).value();
    const auto at = draw_parameters<2>(random, fast, ExactMap<2>(map), 64);
    Output a(64, fast.dimension(), 2), b = a;
    fast.evaluate_on(FastBackEnd::kBaseline, {at[0].data(), at[1].data()}, 64, a.all());
    std::fesetround(FE_UPWARD);
    fast.evaluate_on(FastBackEnd::kAvx2, {at[0].data(), at[1].data()}, 64, b.all());
    std::fesetround(FE_TONEAREST);
    for (const auto& [x, y] :
         {std::pair(&a.value, &b.value), std::pair(&a.value_bound, &b.value_bound),
          std::pair(&a.partial, &b.partial), std::pair(&a.partial_bound, &b.partial_bound)})
      for (std::size_t i = 0; i < x->size(); ++i)
        ASSERT_EQ(std::bit_cast<std::uint64_t>((*x)[i]), std::bit_cast<std::uint64_t>((*y)[i]))
            << loop;
  }
}

TEST(FastSpline, BoundsHoldAtExtremesOfScale) {
  Random random(31);
  for (const int exponent : {-900, -300, 190}) {
    auto map = random_bspline<2>(random, {{3, 3}, {3, 3}, 2, false}, 7, 30);
    for (Rational& v : map.coefficients()) v *= Rational::power_of_two(exponent);
    const auto fast = FastSpline<2>::prepare(map).value();
    const ExactMap<2> exact(map);
    const auto at = draw_parameters<2>(random, fast, exact, 32);
    Output out(32, 2, 2);
    fast.evaluate({at[0].data(), at[1].data()}, 32, out.all());
    for (std::size_t i = 0; i < 32; ++i) {
      const auto truth =
          exact.at({Rational::from_double(at[0][i]), Rational::from_double(at[1][i])});
      for (std::size_t c = 0; c < 2; ++c)
        EXPECT_LE(abs(Rational::from_double(out.value[2 * i + c]) - truth.value[c]),
                  Rational::from_double(out.value_bound[2 * i + c]));
    }
  }
}

// Parameters next to 0 make weights that underflow.
TEST(FastSpline, BoundsHoldWhereWeightsUnderflow) {
  const auto axis = make_knot_axis(3, {0, 0, 0, 0, 1, 1, 1, 1}).value();
  const BSplineCurve<Rational> map({axis}, 1, false, {0, 0, 1, Rational::power_of_two(199)});
  const auto fast = FastSpline<1>::prepare(map).value();
  const ExactMap<1> exact(map);
  for (const double u : {0x1p-1074, 0x1p-600, 0x1p-537, 0x1p-358, 0.0}) {
    Output out(1, 1, 1);
    fast.evaluate({&u}, 1, out.all());
    const auto truth = exact.at({Rational::from_double(u)});
    EXPECT_LE(abs(Rational::from_double(out.value[0]) - truth.value[0]),
              Rational::from_double(out.value_bound[0]));
    EXPECT_LE(abs(Rational::from_double(out.partial[0]) - truth.partial[0][0]),
              Rational::from_double(out.partial_bound[0]));
  }
}

TEST(FastSpline, FindsTheCellWhereBreaksCrowd) {
  std::vector<Rational> knots{0, 0};
  for (int i = 1; i <= 60; ++i) knots.push_back(Rational::power_of_two(i - 61));  // in one bucket
  knots.push_back(Rational(1) + Rational::power_of_two(-60)), knots.push_back(knots.back());
  std::vector<Rational> values;
  for (std::size_t i = 0; i + 2 < knots.size(); ++i) values.push_back(Rational(i % 2));
  const BSplineCurve<Rational> map({make_knot_axis(1, knots).value()}, 1, false, values);
  const auto fast = FastSpline<1>::prepare(map).value();
  const ExactMap<1> exact(map);
  for (std::size_t i = 1; i + 1 < knots.size(); ++i)
    for (const double u : {round_down(knots[i]), std::nextafter(nearest_double(knots[i]), 0.0),
                           0.75 * nearest_double(knots[i])}) {
      Output out(1, 1, 1);
      fast.evaluate({&u}, 1, out.all());
      const auto truth = exact.at({Rational::from_double(u)});
      EXPECT_LE(abs(Rational::from_double(out.value[0]) - truth.value[0]),
                Rational::from_double(out.value_bound[0]))
          << u;
    }
  EXPECT_EQ(fast.domain(0)[1], 1.0);
}

TEST(FastSpline, RefusesParametersOutsideTheDomainPointByPoint) {
  Random random(41);
  const auto map = random_bspline<2>(random, {{2, 2}, {2, 2}, 3, false}, 8, 8);
  const auto fast = FastSpline<2>::prepare(map).value();
  const auto [lo, hi] = fast.domain(0);
  const double v = fast.domain(1)[0], nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> us{
      std::nextafter(lo, -1e9), lo, std::nextafter(hi, 1e9), nan, 1e308, hi},
      vs(6, v);
  Output out(6, 3, 2);
  fast.evaluate({us.data(), vs.data()}, 6, out.all());
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const bool is_inside = i == 1 || i == 5;
      EXPECT_EQ(std::isnan(out.value[3 * i + c]), !is_inside);
      EXPECT_EQ(std::isinf(out.value_bound[3 * i + c]), !is_inside);
      EXPECT_EQ(std::isnan(out.partial[6 * i + 5 - c]), !is_inside);
    }
}

TEST(FastSpline, RefusesWhatItsBoundsDoNotCover) {
  const auto line = [](std::vector<Rational> knots, std::vector<Rational> values,
                       bool is_rational = false) {
    const int components = is_rational ? 2 : 1;
    return FastSpline<1>::prepare(BSplineCurve<Rational>(
        {make_knot_axis(1, std::move(knots)).value()}, components, is_rational, std::move(values)));
  };
  const Rational huge = Rational::power_of_two(201), tiny = Rational::power_of_two(-300);
  EXPECT_TRUE(line({0, 0, 1, 1}, {1, 2}));
  EXPECT_EQ(line({0, 0, 1, 1}, {1, huge}).error().code, Code::kOverLimit);
  EXPECT_EQ(line({0, 0, huge, huge}, {1, 2}).error().code, Code::kOverLimit);
  EXPECT_EQ(line({0, 0, tiny, tiny}, {1, 2}).error().code, Code::kOverLimit);
  EXPECT_EQ(line({1, 1, Rational(1) + Rational::power_of_two(-60),
                  Rational(1) + Rational::power_of_two(-60)},
                 {1, 2})
                .error()
                .code,
            Code::kOverLimit);
  EXPECT_EQ(line({0, 0, 1, 1}, {1, 2, 1, 0}, true).error().code, Code::kBadArgument);
  EXPECT_EQ(line({0, 0, 1, 1}, {1, 2, 1, Rational::power_of_two(-41)}, true).error().code,
            Code::kOverLimit);
  const KnotAxis<double> axis{1, {0, 0, 1, 1}, false};
  EXPECT_EQ(
      FastSpline<1>::prepare(BSplineCurve<double>({axis}, 1, false, {1, HUGE_VAL})).error().code,
      Code::kNotFinite);
  const KnotAxis<double> bad{1, {0, 0, -1, 1}, false};
  EXPECT_EQ(FastSpline<1>::prepare(BSplineCurve<double>({bad}, 1, false, {1, 1})).error().code,
            Code::kBadArgument);
}

// Knots between neighbouring doubles: a bound may be large, but it holds, or weights are refused.
TEST(FastSpline, BoundsHoldInSpansThatHoldOneNumber) {
  const Rational tiny = Rational::power_of_two(-80);
  const auto axis = make_knot_axis(1, {0, 0, Rational(1) - tiny, Rational(1) + tiny, 2, 2}).value();
  const BSplineCurve<Rational> map({axis}, 1, false, {0, 0, 1, 1});
  const auto fast = FastSpline<1>::prepare(map).value();
  for (const double u : {std::nextafter(1.0, 0.0), 1.0, std::nextafter(1.0, 2.0)}) {
    Output out(1, 1, 1);
    fast.evaluate({&u}, 1, out.all());
    const auto truth = ExactMap<1>(map).at({Rational::from_double(u)});
    EXPECT_LE(abs(Rational::from_double(out.value[0]) - truth.value[0]),
              Rational::from_double(out.value_bound[0]));
    EXPECT_LE(abs(Rational::from_double(out.partial[0]) - truth.partial[0][0]),
              Rational::from_double(out.partial_bound[0]));
  }
  const BSplineCurve<Rational> weighted({axis}, 2, true, {0, 0, 1, 1, 1, 1, 2, 2});
  EXPECT_EQ(FastSpline<1>::prepare(weighted).error().code, Code::kOverLimit);
}

TEST(FastSpline, TakesTheRightHandSideOfAJump) {
  const auto axis = make_knot_axis(1, {0, 0, 1, 1, 2, 2}).value();
  const auto fast =
      FastSpline<1>::prepare(BSplineCurve<Rational>({axis}, 1, false, {0, 1, 5, 7})).value();
  const double at[] = {0.5, 1.0, 1.5, 2.0}, expected[] = {0.5, 5, 6, 7};
  Output out(4, 1, 1);
  fast.evaluate({at}, 4, out.all());
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(out.value[i], expected[i]);
}

// The generic path of splines/ in doubles is a second computation of the same map.
TEST(FastSpline, AgreesWithTheRingPathInDoubles) {
  Random random(51);
  const auto exact = random_bspline<3>(random, {{3, 3, 3}, {2, 2, 2}, 3, false}, 8, 64);
  std::array<KnotAxis<double>, 3> axes;
  for (std::size_t a = 0; a < 3; ++a) {
    axes[a].degree = exact.axis(a).degree;
    for (const Rational& k : exact.axis(a).knots) axes[a].knots.push_back(nearest_double(k));
  }
  std::vector<double> coefficients;
  for (const Rational& v : exact.coefficients()) coefficients.push_back(nearest_double(v));
  const BSplineVolume<double> map(axes, 3, false, coefficients);
  const auto fast = FastSpline<3>::prepare(map).value();
  const auto pieces = bezier_pieces(map);
  for (int loop = 0; loop < 200; ++loop) {
    std::array<double, 3> u, local;
    std::array<std::size_t, 3> cell;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto& b = pieces.breaks[a];
      u[a] = b.front() + (b.back() - b.front()) * random.unit();
      cell[a] = u[a] < b[1] ? 0 : 1;
      local[a] = (u[a] - b[cell[a]]) / (b[cell[a] + 1] - b[cell[a]]);
    }
    Output out(1, 3, 3);
    fast.evaluate({&u[0], &u[1], &u[2]}, 1, out.values());
    const auto slow = evaluate(pieces.at(cell), local);
    for (std::size_t c = 0; c < 3; ++c)  // the ring path errs by its own roundings, about as many
      EXPECT_LE(std::abs(out.value[c] - slow[c]), 4 * out.value_bound[c]) << "loop " << loop;
  }
}

}  // namespace
}  // namespace veritope
