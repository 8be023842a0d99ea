// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/solvers/piecewise_roots.h"

#include <gtest/gtest.h>

#include "interval/solvers/spline_pieces.h"
#include "interval/upward.h"
#include "splines/de_casteljau.h"
#include "tests/interval/spline_shapes.h"

namespace veritope {
namespace {

using shapes::at;

ExactPolynomial<1> line(const Rational& a, const Rational& b) {
  return ExactPolynomial<1>({1}, 1, false, {a, b});
}
// Linear between (breaks[i], values[i]).
PiecewiseEquations<1> polyline(std::vector<Rational> breaks, std::vector<Rational> values) {
  PiecewiseEquations<1> out;
  out.breaks[0] = std::move(breaks);
  out.equations = [values = std::move(values)](const std::array<std::size_t, 1>& cell) {
    return std::vector<ExactPolynomial<1>>{line(values[cell[0]], values[cell[0] + 1])};
  };
  return out;
}

TEST(PiecewiseRoots, ReportARootAtABreakOnce) {
  // Slopes 1 and 3/2 on both sides of the root at 1.
  const auto report =
      piecewise_roots<1>(polyline({at(0), at(1), at(2)}, {at(-1), at(0), at(3, 2)})).value();
  EXPECT_TRUE(report.is_complete());
  ASSERT_EQ(report.roots.size(), 1u);
  EXPECT_TRUE(report.roots[0].box[0].contains(at(1)));
  EXPECT_EQ(report.roots[0].place, RootPlace::kInside);
}

TEST(PiecewiseRoots, ReportARootAtAKinkOnceAndNarrow) {
  for (const Rational& s : {at(11, 10), at(3, 2), at(2), at(5, 2), at(29, 10), at(4)}) {
    const auto report =
        piecewise_roots<1>(polyline({at(-1), at(0), at(1)}, {at(-1), at(0), s})).value();
    EXPECT_TRUE(report.is_complete()) << s.to_string();
    ASSERT_EQ(report.roots.size(), 1u) << s.to_string();
    EXPECT_TRUE(report.roots[0].box[0].contains(at(0)));
    EXPECT_LE(report.roots[0].box.width(), Rational::power_of_two(-40)) << s.to_string();
  }
}

TEST(PiecewiseRoots, KeepsAKinkThatTouchesZero) {
  const auto report =
      piecewise_roots<1>(polyline({at(0), at(1), at(2)}, {at(1), at(0), at(1)})).value();
  EXPECT_TRUE(report.roots.empty());
  ASSERT_EQ(report.clusters.size(), 1u);
  EXPECT_TRUE(report.clusters[0].box[0].contains(at(1)));
}

TEST(PiecewiseRoots, IgnoresRootsOfFormulasBeyondTheirCells) {
  // The first piece would vanish at 1 + 1e-9, where the second rules and is positive.
  const Rational tiny = at(1, 1000000000);
  const auto report =
      piecewise_roots<1>(polyline({at(0), at(1), at(2)}, {at(1) + tiny, tiny, at(1)})).value();
  EXPECT_TRUE(report.is_complete());
  EXPECT_TRUE(report.roots.empty());
}

TEST(PiecewiseRoots, AreAsManyAsSignChanges) {
  Random random(6);
  for (int loop = 0; loop < 40; ++loop) {
    std::vector<Rational> breaks, values;
    int changes = 0;
    long last = 0;
    for (int i = 0; i <= 8; ++i) {
      const long v = static_cast<long>(random.between(1, 9)) * (random.below(2) == 0 ? -1 : 1);
      changes += last * v < 0;
      last = v;
      breaks.push_back(at(3 * i + static_cast<long>(random.below(3)), 7)), values.push_back(at(v));
    }
    const auto report = piecewise_roots<1>(polyline(breaks, values)).value();
    EXPECT_EQ(static_cast<int>(report.roots.size()), changes) << "loop " << loop;
    EXPECT_TRUE(report.is_complete()) << "loop " << loop;
  }
}

TEST(PiecewiseRoots, SkipsCellsThatAreProvedFree) {
  auto system = polyline({at(0), at(1), at(2)}, {at(-1), at(1), at(2)});
  int asked = 0;
  const auto all = system.equations;
  system.equations = [&](const std::array<std::size_t, 1>& cell) {
    EXPECT_EQ(cell[0], 0u);
    ++asked;
    return all(cell);
  };
  system.is_free = [](const std::array<std::size_t, 1>& cell) { return cell[0] == 1; };
  EXPECT_EQ(piecewise_roots<1>(system).value().roots.size(), 1u);
  EXPECT_GT(asked, 0);
}

TEST(PiecewiseRoots, RefuseBadOptions) {
  SolverOptions options;
  options.least_width = at(0);
  EXPECT_EQ(piecewise_roots<1>(polyline({at(0), at(1)}, {at(1), at(2)}), options).error().code,
            Code::kBadArgument);
}

ExactPolynomial<2> drawn(Random& random, std::array<int, 2> degrees) {
  ExactPolynomial<2> out(degrees, 1, false);
  for (Rational& c : out.coefficients()) c = at(static_cast<long>(random.between(-9, 9)), 4);
  return out;
}

TEST(ExactBernstein, SumsProductsAndDerivativesAreThoseOfValues) {
  Random random(7);
  for (int loop = 0; loop < 30; ++loop) {
    const auto a = drawn(random, {2, 1}), b = drawn(random, {1, 3});
    const std::array<Rational, 2> x{at(static_cast<long>(random.below(12)), 11),
                                    at(static_cast<long>(random.below(8)), 7)};
    const Rational va = evaluate(a, x)[0], vb = evaluate(b, x)[0];
    EXPECT_EQ(evaluate(product(a, b), x)[0], va * vb) << loop;
    EXPECT_EQ(evaluate(plus(a, b, at(-3)), x)[0], va - at(3) * vb) << loop;
    EXPECT_EQ(evaluate(raised(a, 1), x)[0], va) << loop;
    // (a b)' = a' b + a b'.
    EXPECT_EQ(derivative(product(a, b), 0),
              plus(product(derivative(a, 0), b), product(a, derivative(b, 0))))
        << loop;
    EXPECT_EQ(evaluate(derivative(derivative(a, 1), 1), x)[0], at(0)) << loop;
  }
}

TEST(ExactBernstein, EnclosesRestrictionsAlsoBeyondTheDomain) {
  const ScopedUpward upward;
  Random random(8);
  for (int loop = 0; loop < 30; ++loop) {
    const auto a = drawn(random, {2, 3});
    const Rational lo = at(static_cast<long>(random.between(-3, 9)), 8),
                   w = at(1, 1 + static_cast<long>(random.below(90)));
    const ExactBox<2> box{{ExactInterval{lo, lo + w}, ExactInterval{at(1, 3), at(2, 3)}}};
    const auto part = enclosed_on(a, box, 128);
    const Rational exact = evaluate(a, {lo, at(1, 3)})[0];  // the first corner
    EXPECT_TRUE(contains(part.coefficients()[0], exact)) << loop;
    EXPECT_LT(wid(part.coefficients()[0]), 1e-12) << loop;
  }
}

TEST(SplinePieces, PartsBordersAndPoints) {
  const ScopedUpward upward;
  // Degree 2; multiplicity 2 at 1 (a crease), 3 at 2 (torn).
  const BSplineCurve<Rational> curve(
      {KnotAxis<Rational>{
          2, {at(0), at(0), at(0), at(1), at(1), at(2), at(2), at(2), at(3), at(3), at(3)}, false}},
      1, false, {at(0), at(1), at(2), at(0), at(5), at(7), at(8), at(9)});
  const auto smooth = smooth_parts(curve);
  ASSERT_EQ(smooth.size(), 3u);
  EXPECT_TRUE(smooth[0].is_first[0]);
  EXPECT_FALSE(smooth[1].is_first[0]);
  EXPECT_TRUE(smooth[2].is_first[0]);
  EXPECT_EQ(connected_parts(curve).size(), 2u);
  const auto at_one = points_of(smooth[1].pieces, ExactBox<1>{{ExactInterval{at(1), at(1)}}});
  EXPECT_TRUE(contains(at_one[0], at(2)));
  EXPECT_LT(wid(at_one[0]), 1e-12);
  const auto bowl = bezier_pieces(shapes::bowl(at(2)));
  EXPECT_EQ(evaluate(border(bowl, 0, true).pieces[0], {at(1, 2)}),
            (std::vector<Rational>{at(2), at(0), at(4)}));
}

}  // namespace
}  // namespace veritope
