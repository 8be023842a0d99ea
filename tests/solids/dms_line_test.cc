// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_line_test.cc: exact integrals along segments beside their definition and beside known values, in planes
// of knots, in the boundary and outside too.
#include "solids/dms/dms_line.h"

#include <gtest/gtest.h>

#include "interval/numeric.h"
#include "splines/simplex_line.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/dms_laws.h"
#include "tests/support/dms_lines.h"

namespace veritope {
namespace {

Rational ratio(long p, long q) { return Rational(p) / Rational(q); }

// Answers about a line in a list of knots. REQUIRES that the line lies in no plane of three knots.
class LineOracle {
 public:
  LineOracle(std::vector<DmsPoint> knots, Rational begin, Rational end)
      : answers_(std::move(knots), simplex_oracle::axes_path({})),
        begin_(std::move(begin)),
        end_(std::move(end)) {}

  const SimplexFrame<Rational>* frame(const KnotSet& set) { return answers_.frame(set); }
  std::optional<std::array<Rational, 2>> inside(const SimplexFrame<Rational>&,
                                                const LineCoordinates<Rational>& c) const {
    Rational a = begin_, b = end_;
    for (std::size_t m = 0; m < 4; ++m) {
      if (c.along[m].sign() == Sign::kZero) {
        if (c.at[m].sign() == Sign::kNegative) return std::nullopt;
        continue;
      }
      const Rational t = -c.at[m] / c.along[m];
      if (c.along[m].sign() == Sign::kPositive)
        a = std::max(a, t);
      else
        b = std::min(b, t);
    }
    if (b < a) return std::nullopt;
    return std::array<Rational, 2>{a, b};
  }

 private:
  simplex_oracle::Answers answers_;
  Rational begin_, end_;
};

KnotSet all_of(std::size_t count) {
  KnotSet set;
  for (std::size_t i = 0; i < count; ++i) set.insert(static_cast<KnotNumber>(i));
  return set;
}

Rational line_integral(const std::vector<DmsPoint>& knots, const DmsPoint& x, const DmsPoint& d,
                       const Rational& end) {
  LineOracle oracle(knots, Rational(0), end);
  const int degree = static_cast<int>(knots.size()) - 4;
  SimplexLineMoments<Rational, LineOracle> moments(oracle, x, d, degree);
  const auto& found = moments.moments(all_of(knots.size()));
  return found.empty() ? Rational(0) : found[0];
}

// The formula of [HHQ04], eq. 16, with the boundary term that it drops, but without jumps.
Rational formula_without_jumps(const std::vector<DmsPoint>& knots, const DmsPoint& x,
                               const DmsPoint& d, const Rational& end) {
  LineOracle oracle(knots, Rational(0), end);
  const auto integral = [&](auto&& self, const KnotSet& set) -> Rational {
    const auto* frame = oracle.frame(set);
    if (frame == nullptr) return 0;
    const LineCoordinates<Rational> c{frame->barycentric(x), frame->barycentric_direction(d)};
    if (set.size() == 4) {
      const auto part = oracle.inside(*frame, c);
      return part ? frame->height * ((*part)[1] - (*part)[0]) : Rational(0);
    }
    const Rational n(static_cast<long>(set.size()) - 4);
    Rational sum;
    for (std::size_t m = 0; m < 4; ++m) sum += c.at[m] * self(self, set.without(frame->knots[m]));
    return n / (n + Rational(1)) * sum;  // M is zero at the end, which is outside
  };
  return integral(integral, all_of(knots.size()));
}

// The value that quadrature gives. The formula without jumps is wrong.
TEST(SimplexLine, IsRightWhereAKnotIsDoubleAndTheFormulaWithoutJumpsIsNot) {
  const std::vector<DmsPoint> knots{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
  const DmsPoint x{ratio(1, 5), ratio(1, 10), ratio(-3, 10)}, d{0, ratio(1, 10), 1};
  const Rational exact = line_integral(knots, x, d, Rational(3));
  EXPECT_NEAR(nearest_double(exact), 0.2040, 5e-5);
  EXPECT_NEAR(nearest_double(formula_without_jumps(knots, x, d, Rational(3))), 0.3045, 5e-5);
  // M is the coordinate of the double knot times 1 / |d|, and the ray is inside from t = 3/10 to 10/11.
  const Rational a = ratio(3, 10), b = ratio(10, 11);
  const auto antiderivative = [](const Rational& t) {
    return ratio(10, 10) * t - ratio(11, 20) * t * t;
  };
  EXPECT_EQ(exact, antiderivative(b) - antiderivative(a));
}

// M(u|V) of two variables, of degree V.size() - 3, at points on no line through two knots.
Rational planar(const std::vector<std::array<Rational, 2>>& v, const std::array<Rational, 2>& u) {
  const auto det = [](const auto& a, const auto& b, const auto& c) {
    return Rational((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  };
  for (std::size_t i = 0; i < v.size(); ++i)
    for (std::size_t j = i + 1; j < v.size(); ++j)
      for (std::size_t k = j + 1; k < v.size(); ++k) {
        const Rational d = det(v[i], v[j], v[k]);
        if (d.sign() == Sign::kZero) continue;
        const std::array<Rational, 3> lambda{det(u, v[j], v[k]) / d, det(v[i], u, v[k]) / d,
                                             det(v[i], v[j], u) / d};
        if (v.size() == 3) {
          for (const Rational& l : lambda)
            if (l.sign() == Sign::kNegative) return 0;
          return Rational(1) / veritope::abs(d);
        }
        Rational sum;
        const std::array<std::size_t, 3> left{i, j, k};
        for (std::size_t m = 0; m < 3; ++m) {
          auto rest = v;
          rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(left[m]));
          sum += lambda[m] * planar(rest, u);
        }
        return sum;
      }
  return 0;
}

// A full line's integral is the projected spline, multiple and coplanar knots included.
TEST(SimplexLine, AgreesWithTheProjectedSplineOnFullLines) {
  Random random(11);
  for (long round = 0; round < scaled(60); ++round) {
    const std::size_t count = 4 + random.below(3);
    std::vector<DmsPoint> knots;
    std::vector<std::array<Rational, 2>> projected;
    for (std::size_t i = 0; i < count; ++i) {
      DmsPoint p{Rational(random.between(0, 5)), Rational(random.between(0, 5)),
                 Rational(random.between(0, 5))};
      if (i > 0 && random.below(4) == 0) p = knots[random.below(i)];  // a multiple knot
      if (i > 2 && random.below(3) == 0) p[2] = knots[0][2];          // coplanar ones
      projected.push_back({p[0], p[1]});
      knots.push_back(std::move(p));
    }
    if (LineOracle(knots, 0, 8).frame(all_of(count)) == nullptr) continue;  // all in one plane
    const DmsPoint x{Rational(random.between(1, 4)) + ratio(random.between(1, 96), 97),
                     Rational(random.between(1, 4)) + ratio(random.between(1, 100), 101), -1};
    const Rational degree(static_cast<long>(count) - 4);
    EXPECT_EQ(line_integral(knots, x, {0, 0, 1}, Rational(8)),
              planar(projected, {x[0], x[1]}) / (degree + Rational(1)))
        << "round " << round;
  }
}

void expect_definition(std::uint64_t first, long models, int degree) {
  std::uint64_t not_zero = 0;
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(scaled(models)); ++i) {
    const RandomDms drawn = draw_dms(first + i, degree);
    DmsEvaluator evaluator(drawn.model), other(drawn.model);
    DmsLineIntegrator integrator(evaluator);
    Random random(first + i);
    for (int k = 0; k < 2; ++k) {
      const DmsLine line = draw_dms_line(random, drawn.model);
      const std::vector<Rational> exact = integrals_by_cuts(drawn.model, other, line);
      for (std::size_t c = 0; c < exact.size(); ++c) {
        ASSERT_EQ(integrator.mean(line, c), exact[c])
            << drawn.text << ", component " << c << ", segment " << text_of(line);
        if (exact[c].sign() != Sign::kZero) ++not_zero;
      }
    }
  }
  EXPECT_GT(not_zero, 0u);
}

TEST(DmsLine, IsTheIntegralByItsDefinition) { expect_definition(1, 12, 2); }

TEST(DmsLine, IsTheIntegralByItsDefinitionOfMoreModels) { expect_definition(1000, 16, 3); }

TEST(DmsLine, IsTheIntegralByItsDefinitionForSeparateControlPoints) {
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(8)); ++seed) {
    const DmsModel model = internal::separated(draw_dms(seed, 2).model);
    DmsEvaluator evaluator(model);
    DmsLineIntegrator integrator(evaluator);
    Random random(seed);
    for (int k = 0; k < 3; ++k) {
      const DmsLine line = draw_dms_line(random, model);
      ASSERT_EQ(integrator.mean(line, 0), integrals_by_cuts(model, evaluator, line)[0])
          << "seed " << seed << ", segment " << text_of(line);
    }
  }
}

// Segments in planes of knots, along edges and in faces of the boundary, where rule H says what counts.
TEST(DmsLine, TakesTheSideOfRuleHInPlanesOfKnots) {
  DmsModel domain = kuhn_domain({2, 1, 1});
  set_control_by_rule(domain, DmsControlRule::kGreville, {});
  const Result<DmsModel> made =
      make_dms(domain, {2, DmsCloudDraw{ratio(1, 10), 5}, DmsControlRule::kGreville});
  ASSERT_TRUE(made.has_value());
  DmsModel model = internal::separated(*made);
  Random random(4);  // control points that do not agree, so that the map jumps across faces
  for (Rational& c : model.control.values) c = Rational(random.between(-9, 9));
  DmsEvaluator evaluator(model);
  DmsLineIntegrator integrator(evaluator);
  const std::vector<DmsLine> lines{
      {{0, 0, 0}, {2, 0, 0}},     // an edge of the boundary
      {{1, 0, 0}, {1, 1, 1}},     // the face between the cubes
      {{0, 0, 1}, {2, 1, 1}},     // a face of the boundary that axes leave
      {{2, 1, 0}, {2, 1, 1}},     // an edge that axes leave
      {{-1, -1, -1}, {3, 3, 3}},  // a common edge of six, and outside
      {{0, 0, 0}, {1, 1, 1}},
      {{2, 1, 1}, {2, 1, 1}},  // a point of the boundary
      {{1, ratio(1, 2), ratio(1, 2)}, {1, ratio(1, 2), ratio(1, 2)}}};
  for (const DmsLine& line : lines) {
    const std::vector<Rational> exact = integrals_by_cuts(model, evaluator, line);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_EQ(integrator.mean(line, c), exact[c]) << text_of(line);
    EXPECT_NE(exact[0], Rational(0)) << text_of(line);
  }
}

TEST(DmsLine, OfAPointIsItsValueAndOutsideOfTheDomainIsZero) {
  const RandomDms drawn = draw_dms(3, 3);
  DmsEvaluator evaluator(drawn.model);
  DmsLineIntegrator integrator(evaluator);
  Random random(3);
  for (int i = 0; i < 5; ++i) {
    const DmsPoint u = draw_dms_point(random, drawn.model);
    EXPECT_EQ(integrator.mean({u, u}, 1), evaluator.evaluate(*evaluator.locate(u)).value[1]);
  }
  EXPECT_TRUE(integrator.weights({{500, 0, 0}, {500, 1, 1}}).empty());
  EXPECT_TRUE(integrator.stretches({{500, 0, 0}, {500, 0, 0}}).empty());
}

// The weights add up to the length in the domain: in a cube with a hole, two parts.
TEST(DmsLine, WeightsAddUpToTheShareInsideOfTheDomain) {
  DmsModel domain = kuhn_domain({3, 1, 1}, [](int x, int, int) { return x != 1; });
  set_control_by_rule(domain, DmsControlRule::kGreville, {});
  const Result<DmsModel> model =
      make_dms(domain, {3, DmsCloudDraw{ratio(1, 10), 2}, DmsControlRule::kGreville});
  ASSERT_TRUE(model.has_value());
  DmsEvaluator evaluator(*model);
  DmsLineIntegrator integrator(evaluator);
  const DmsLine line{{-1, ratio(1, 3), ratio(1, 4)}, {4, ratio(1, 2), ratio(2, 3)}};
  EXPECT_EQ(integrator.stretches(line).size(), 2u);
  Rational sum;
  for (const DmsWeight& w : integrator.weights(line)) sum += w.weight;
  EXPECT_EQ(sum, ratio(2, 5));
}

TEST(DmsLine, LengthsWhoseSquaresOverflowAreRight) {
  for (const int exponent : {-3000, -700, 700, 3000}) {
    const Rational length = Rational::power_of_two(exponent);
    const DmsAbsorption a = absorption({{0, 0, 0}, {length, 2 * length, 2 * length}},
                                       -Rational::power_of_two(-exponent));
    EXPECT_TRUE(contains(a.integral, Rational(-3))) << exponent;
    EXPECT_LE(wid(a.integral), 1e-14) << exponent;
  }
}

TEST(DmsLine, AbsorptionIsEnclosed) {
  const DmsAbsorption a = absorption({{0, 0, 0}, {1, 2, 2}}, ratio(1, 3));
  EXPECT_TRUE(contains(a.integral, Rational(1)));
  EXPECT_LE(wid(a.integral), 1e-15);
  EXPECT_LE(inf(a.intensity), 0.36787944117144233);
  EXPECT_GE(sup(a.intensity), 0.36787944117144232);
  EXPECT_LE(wid(a.intensity), 1e-15);
  EXPECT_EQ(absorption({{1, 1, 1}, {1, 1, 1}}, 7).intensity, Interval(1.0));
}

}  // namespace
}  // namespace veritope
