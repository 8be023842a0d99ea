// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>

#include "splines/de_casteljau.h"
#include "tests/interval/known_systems.h"

namespace veritope {
namespace {

using known::KnownSystem;
using known::Powers;
using known::Recipe;
using known::Tally;

template <std::size_t N>
RootReport<N> roots_of(const std::vector<Bezier<Rational, N>>& equations,
                       const SolverOptions& options = {}) {
  return polynomial_roots<N>(std::span<const Bezier<Rational, N>>(equations), options).value();
}

template <std::size_t N>
std::string text(const KnownSystem<N>& system) {
  std::string out;
  for (const auto& e : system.equations) {
    out += "\ndegrees";
    for (const int d : e.degrees()) out += " " + std::to_string(d);
    out += ":";
    for (const Rational& c : e.coefficients()) out += " " + c.to_string();
  }
  return out;
}

Rational decimal_power(int n) {
  Rational out(1);
  for (int i = 0; i < n; ++i) out /= Rational(10);
  return out;
}

template <std::size_t N>
void expect_all_found(const Recipe& recipe, int count, std::uint64_t seed) {
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    const KnownSystem<N> system = known::draw<N>(random, recipe);
    const RootReport<N> report = roots_of(system.equations);
    const Tally t = judge(system, report);
    const std::string where =
        "N " + std::to_string(N) + " seed " + std::to_string(seed) + " case " + std::to_string(i);
    EXPECT_EQ(t.missed, 0) << where << text(system);
    EXPECT_EQ(t.false_uniqueness, 0) << where << text(system);
    EXPECT_EQ(t.simple_isolated, t.simple) << where << text(system);
    EXPECT_EQ(t.multiple_in_clusters, t.multiple) << where << text(system);
    EXPECT_TRUE(t.multiple > 0 || report.is_complete()) << where << text(system);
  }
}

template <typename F>
void in_every_dimension(F f) {
  f.template operator()<1>(12);
  f.template operator()<2>(12);
  f.template operator()<3>(5);
  f.template operator()<4>(3);
}

TEST(PolynomialRoots, FindEverySimpleRootOnce) {
  in_every_dimension([]<std::size_t N>(int n) {
    expect_all_found<N>({2, {}, false, false}, n, 1);
  });
}
TEST(PolynomialRoots, FindEveryRootOfCurvedEquations) {
  in_every_dimension([]<std::size_t N>(int n) { expect_all_found<N>({2, {}, false, true}, n, 2); });
}
TEST(PolynomialRoots, FindRootsOnFacesAndCorners) {
  in_every_dimension([]<std::size_t N>(int n) { expect_all_found<N>({2, {}, true, false}, n, 3); });
}
TEST(PolynomialRoots, TellApartRootsThatDoubleCannot) {
  in_every_dimension([]<std::size_t N>(int n) {
    expect_all_found<N>({1, decimal_power(12), false, false}, n, 4);
    expect_all_found<N>({1, decimal_power(20), false, false}, n, 5);
  });
}
TEST(PolynomialRoots, KeepMultipleRootsInClusters) {
  in_every_dimension([]<std::size_t N>(int n) {
    expect_all_found<N>({1, Rational(0), false, false}, n, 6);
  });
}

// x = y = 1/2: a corner of every subdivision.
TEST(PolynomialRoots, ReportARootOnSubdivisionFacesOnce) {
  const Rational half = Rational(1) / Rational(2);
  const auto x = Powers<2>::variable(0), y = Powers<2>::variable(1);
  const auto c = Powers<2>::constant(Rational(-1) * half);
  const auto report = roots_of<2>({((x + c) * (x + Powers<2>::constant(Rational(2)))).bernstein(),
                                   (x + y + c + c).bernstein()});
  ASSERT_EQ(report.roots.size(), 1u);
  EXPECT_TRUE(report.is_complete());
  EXPECT_EQ(report.roots[0].place, RootPlace::kInside);
  ASSERT_TRUE(report.roots[0].exact.has_value());
  EXPECT_EQ(*report.roots[0].exact, (known::Point<2>{half, half}));
}

TEST(PolynomialRoots, SayWhetherARootIsOnTheBoundary) {
  // x^2 - 1/3 and x (x - 1) (x - 2) (3 x - 1).
  const BezierCurve<Rational> quartic =
      (Powers<1>::variable(0) * (Powers<1>::variable(0) + Powers<1>::constant(Rational(-1))) *
       (Powers<1>::variable(0) + Powers<1>::constant(Rational(-2))) *
       (Rational(3) * Powers<1>::variable(0) + Powers<1>::constant(Rational(-1))))
          .bernstein();
  const auto report = roots_of<1>({quartic});
  ASSERT_EQ(report.roots.size(), 3u);
  int on = 0;
  for (const auto& root : report.roots) on += root.place == RootPlace::kOnBoundary;
  EXPECT_EQ(on, 2);
}

// The face x = 0 carries the root y = 1/sqrt 2: no fraction shows it.
TEST(PolynomialRoots, CountAnIrrationalRootOnAFaceOnceAsAtTheBoundary) {
  const auto x = Powers<2>::variable(0), y = Powers<2>::variable(1);
  const auto report =
      roots_of<2>({(x + x * y).bernstein(),
                   (Rational(2) * (y * y) + x + Powers<2>::constant(Rational(-1))).bernstein()});
  ASSERT_EQ(report.roots.size(), 1u);
  EXPECT_TRUE(report.is_complete());
  EXPECT_EQ(report.roots[0].place, RootPlace::kAtBoundary);
}

TEST(PolynomialRoots, DropRootsThatAreOutsideByLittle) {
  const Rational tiny = decimal_power(30);
  const auto root_at = [](const Rational& r) {
    return (Powers<1>::variable(0) + Powers<1>::constant(-r)).bernstein();
  };
  EXPECT_EQ(roots_of<1>({root_at(Rational(1) + tiny)}).roots.size(), 0u);
  EXPECT_EQ(roots_of<1>({root_at(Rational(1) - tiny)}).roots.size(), 1u);
  EXPECT_EQ(roots_of<1>({root_at(-tiny)}).roots.size(), 0u);
}

TEST(PolynomialRoots, AreTheSameAfterMixingElevationAndAffineMaps) {
  Random random(7);
  for (int i = 0; i < 8; ++i) {
    const KnownSystem<2> system = known::draw<2>(random, {2, {}, false, true});
    const std::size_t count = roots_of(system.equations).roots.size();
    const auto factor = Powers<2>::constant(Rational(3)) + Powers<2>::variable(0);  // positive
    auto lifted = system.equations;
    for (auto& e : lifted) e = known::multiplied(e, factor);
    EXPECT_EQ(roots_of(lifted).roots.size(), count) << "case " << i;
    // Equations of higher degree with the same roots: one is multiplied by a positive polynomial.
    auto raised = system.equations;
    raised[0] = known::multiplied(raised[0], Powers<2>({2, 3}) + Powers<2>::constant(Rational(1)));
    EXPECT_EQ(roots_of(raised).roots.size(), count) << "case " << i;
    // x0 and x1 exchanged, x0 mirrored.
    std::vector<Bezier<Rational, 2>> turned;
    for (const auto& e : system.equations) turned.push_back(known::turned(e));
    EXPECT_EQ(roots_of(turned).roots.size(), count) << "case " << i;
    // Cut in two: 41/113 is no coordinate of a root.
    const Rational cut = Rational(41) / Rational(113);
    std::vector<Bezier<Rational, 2>> left, right;
    for (const auto& e : system.equations) {
      left.push_back(left_part(e, 0, cut));
      right.push_back(right_part(e, 0, cut));
    }
    EXPECT_EQ(roots_of(left).roots.size() + roots_of(right).roots.size(), count) << "case " << i;
  }
}

TEST(PolynomialRoots, RefineToAnyWidth) {
  // 2 x^2 - 1.
  const std::vector<BezierCurve<Rational>> equations{
      BezierCurve<Rational>({2}, 1, false, {Rational(-1), Rational(-1), Rational(1)})};
  const auto report = roots_of<1>(equations);
  ASSERT_EQ(report.roots.size(), 1u);
  const auto system =
      PolynomialSystem<1>::make(std::span<const BezierCurve<Rational>>(equations)).value();
  const Rational width = decimal_power(300);
  const IsolatedRoot<1> root = refined(system, report.roots[0], width);
  EXPECT_LE(root.box.width(), width);
  EXPECT_LT(Rational(2) * root.box[0].lo * root.box[0].lo, Rational(1));
  EXPECT_GT(Rational(2) * root.box[0].hi * root.box[0].hi, Rational(1));
}

TEST(PolynomialRoots, NameADoubleRootThatIsAFraction) {
  const auto x = Powers<2>::variable(0), y = Powers<2>::variable(1);
  const Rational third = Rational(1) / Rational(3);
  const auto u = x + Powers<2>::constant(-third), v = y + Powers<2>::constant(-third);
  const auto report = roots_of<2>({v.bernstein(), (v + u * u).bernstein()});
  EXPECT_TRUE(report.roots.empty());
  ASSERT_EQ(report.clusters.size(), 1u);
  EXPECT_EQ(report.clusters[0].reason, OpenReason::kNarrow);
  ASSERT_TRUE(report.clusters[0].exact.has_value());
  EXPECT_EQ(*report.clusters[0].exact, (known::Point<2>{third, third}));
}

TEST(PolynomialRoots, EndHonestlyWhereTheRootsAreACurve) {
  const auto x = Powers<2>::variable(0), y = Powers<2>::variable(1);
  const auto circle = x * x + y * y + Powers<2>::constant(Rational(-1) / Rational(2));
  SolverOptions options;
  options.max_boxes = 5000;
  for (const auto& other : {circle, (x + y) * circle, Rational(3) * circle}) {
    const auto report = roots_of<2>({circle.bernstein(), other.bernstein()}, options);
    EXPECT_FALSE(report.is_complete());
    EXPECT_LE(report.effort.boxes, options.max_boxes + 1000);
    for (int k = 0; k <= 4; ++k) {  // points of the circle: (3/5, 4/5)-like fractions over sqrt 2
      const Rational t = Rational(k) / Rational(4);
      const Rational d = Rational(2) * (Rational(1) + t * t);
      const known::Point<2> p{(Rational(1) - Rational(2) * t - t * t) / d,
                              (Rational(1) + Rational(2) * t - t * t) / d};
      if (!ExactBox<2>::unit().contains(p)) continue;
      EXPECT_TRUE(std::any_of(report.clusters.begin(), report.clusters.end(), [&](const auto& c) {
        return c.box.contains(p);
      })) << k;
    }
  }
}

TEST(PolynomialRoots, SayThatAnEquationIsIdenticallyZero) {
  const auto report = roots_of<2>(
      {Powers<2>::variable(0).bernstein(), Powers<2>::constant(Rational(0)).bernstein()});
  ASSERT_EQ(report.clusters.size(), 1u);
  EXPECT_EQ(report.clusters[0].reason, OpenReason::kZeroEquation);
  EXPECT_EQ(report.clusters[0].box, ExactBox<2>::unit());
}

// PROVES ROOT-2.OPEN
TEST(PolynomialRoots, AnswerUndecidedWhenTheBudgetEnds) {
  Random random(8);
  const KnownSystem<3> system = known::draw<3>(random, {2, {}, false, false});
  SolverOptions options;
  options.max_boxes = 3;
  const auto report = roots_of(system.equations, options);
  EXPECT_EQ(judge(system, report).missed, 0);
  ASSERT_FALSE(report.is_complete());
  EXPECT_EQ(report.clusters[0].reason, OpenReason::kBudget);
}

TEST(PolynomialRoots, RefuseBadInput) {
  const BezierCurve<Rational> line({1}, 1, false, {Rational(-1), Rational(1)});
  const std::vector<BezierCurve<Rational>> two{line, line};
  const auto solve = [](const std::vector<BezierCurve<Rational>>& e, const SolverOptions& o) {
    return polynomial_roots<1>(std::span<const BezierCurve<Rational>>(e), o);
  };
  EXPECT_EQ(solve(two, {}).error().code, Code::kBadArgument);
  EXPECT_EQ(solve({}, {}).error().message, "0 equations in 1 unknowns");
  const BezierCurve<Rational> rational({1}, 1, true, {Rational(-1), Rational(1)});
  EXPECT_EQ(solve({rational}, {}).error().code, Code::kBadArgument);
  SolverOptions options;
  options.least_width = Rational(0);
  EXPECT_EQ(solve({line}, options).error().code, Code::kBadArgument);
  options = {}, options.root_width = Rational(-1);
  EXPECT_EQ(solve({line}, options).error().code, Code::kBadArgument);
  options = {}, options.max_precision = 10;
  EXPECT_EQ(solve({line}, options).error().code, Code::kBadArgument);
  const std::vector<BezierCurve<double>> nan{
      BezierCurve<double>({1}, 1, false, {1, std::numeric_limits<double>::quiet_NaN()})};
  EXPECT_EQ(polynomial_roots<1>(std::span<const BezierCurve<double>>(nan)).error().code,
            Code::kNotFinite);
  const std::vector<Bezier<Rational, 4>> large{Bezier<Rational, 4>({63, 1, 1, 1}, 2, false),
                                               Bezier<Rational, 4>({1, 63, 63, 1}, 2, false)};
  EXPECT_EQ(polynomial_roots<4>(std::span<const Bezier<Rational, 4>>(large)).error().code,
            Code::kOverLimit);
}

TEST(PolynomialRoots, TakeDoublesAsTheyAre) {
  const std::vector<BezierCurve<double>> line{BezierCurve<double>({1}, 1, false, {-0.1, 0.2})};
  const auto report = polynomial_roots<1>(std::span<const BezierCurve<double>>(line)).value();
  ASSERT_EQ(report.roots.size(), 1u);
  const Rational a = Rational::from_double(0.1), b = Rational::from_double(0.2);
  EXPECT_TRUE(report.roots[0].box[0].contains(a / (a + b)));
  EXPECT_FALSE(report.roots[0].box[0].contains(Rational(1) / Rational(3) + decimal_power(10)));
}

}  // namespace
}  // namespace veritope
