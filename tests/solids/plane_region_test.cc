// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/plane_region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "predicates/vec.h"
#include "robust/base/random.h"
#include "solids/chain/associated_function.h"
#include "solids/chain/boolean_chains.h"
#include "solids/chain/plane_cell.h"

namespace veritope {
namespace {

constexpr std::uint64_t kSeed = 20261201;

Rational fraction(std::int64_t p, std::int64_t q = 1) { return Rational(p) / Rational(q); }

Rational half_of(const Rational& x) { return x / Rational(2); }

PlaneArc arc_of(const std::vector<PointIn<2>>& control, const std::vector<Rational>& weights = {}) {
  PlaneArc::Curve map({static_cast<int>(control.size()) - 1}, weights.empty() ? 2 : 3,
                      !weights.empty());
  for (std::size_t i = 0; i < control.size(); ++i) {
    const Rational w = weights.empty() ? Rational(1) : weights[i];
    for (int k = 0; k < 2; ++k) map.component(k)[i] = w * control[i][static_cast<std::size_t>(k)];
    if (!weights.empty()) map.component(2)[i] = w;
  }
  return PlaneArc::make(std::move(map)).value();
}

// Four quarters, each as points ((1 - t^2) : 2 t : 1 + t^2), moved and scaled; counter-clockwise.
std::vector<PlaneArc> circle(const PointIn<2>& centre, const Rational& radius) {
  std::vector<PlaneArc> out;
  PointIn<2> a{1, 0}, b{0, 1};
  for (int quarter = 0; quarter < 4; ++quarter) {
    const PointIn<2> corner{a[0] + b[0], a[1] + b[1]};
    std::vector<PointIn<2>> control;
    for (const PointIn<2>& p : {a, corner, b})
      control.push_back({centre[0] + radius * p[0], centre[1] + radius * p[1]});
    out.push_back(arc_of(control, {1, 1, 2}));
    a = b;
    b = {-b[1], b[0]};
  }
  return out;
}

PlaneRegion region_of(std::vector<PlaneArc> arcs) {
  return PlaneRegion::make(std::move(arcs)).value();
}

// A random closed loop of curves of degrees 1 to 4, some of them rational; it may cross itself.
std::vector<PlaneArc> random_loop(Random& random, std::int64_t grid) {
  const auto at = [&] {
    return PointIn<2>{static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(grid))),
                      static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(grid)))};
  };
  const PointIn<2> first = at();
  PointIn<2> from = first;
  std::vector<PlaneArc> out;
  const std::uint64_t n = 2 + random.below(7);
  for (std::uint64_t i = 0; i < n; ++i) {
    const PointIn<2> to = i + 1 == n ? first : at();
    std::vector<PointIn<2>> control{from};
    for (std::uint64_t k = random.below(4); k > 0; --k) control.push_back(at());
    control.push_back(to);
    std::vector<Rational> weights;
    if (random.below(2) == 0)
      for (std::size_t k = 0; k < control.size(); ++k)
        weights.push_back(Rational(1 + static_cast<std::int64_t>(random.below(4))));
    out.push_back(arc_of(control, weights));
    from = to;
  }
  return out;
}

PointIn<2> point_of_arc(const PlaneArc& arc, const Rational& t) {
  std::vector<std::vector<Rational>> rows;
  for (int c = 0; c < arc.curve().num_components(); ++c)
    rows.emplace_back(arc.curve().component(c).begin(), arc.curve().component(c).end());
  for (auto& row : rows)
    for (std::size_t n = row.size() - 1; n > 0; --n)
      for (std::size_t i = 0; i < n; ++i) row[i] = row[i] + t * (row[i + 1] - row[i]);
  const Rational w = arc.curve().is_rational() ? rows[2][0] : Rational(1);
  return {rows[0][0] / w, rows[1][0] / w};
}

using Polyline = std::vector<Vec2d>;

Polyline many_points(const std::vector<PlaneArc>& arcs) {
  constexpr int kSteps = 200;
  Polyline out;
  for (const PlaneArc& arc : arcs)
    for (int i = 0; i <= kSteps; ++i) {
      const PointIn<2> p = point_of_arc(arc, fraction(i, kSteps));
      out.push_back({nearest_double(p[0]), nearest_double(p[1])});
    }
  return out;
}

// The winding number by the angles of many points, in doubles; nothing near the loop.
std::optional<int> winding_by_angles(const Polyline& loop, double x, double y) {
  double sum = 0, last = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double dx = loop[i].x - x, dy = loop[i].y - y;
    if (std::hypot(dx, dy) < 0.15) return std::nullopt;
    const double angle = std::atan2(dy, dx);
    if (i > 0) sum += std::remainder(angle - last, 2 * M_PI);
    last = angle;
  }
  return static_cast<int>(std::lround(sum / (2 * M_PI)));
}

// PROVES CHAIN-5
TEST(PlaneRegion, DecidesADiskByItsEquation) {
  const PointIn<2> centre{fraction(1, 3), fraction(-2, 7)};
  const Rational radius = fraction(5, 4);
  const PlaneRegion disk = region_of(circle(centre, radius));
  Random random(kSeed);
  int inside = 0;
  for (int i = 0; i < 2000; ++i) {
    PointIn<2> q;
    if (i % 3 == 0) {  // on rays through the ends of arcs, along the axes
      q = {centre[0] + radius * fraction(static_cast<std::int64_t>(random.below(81)) - 40, 20),
           centre[1]};
      if (i % 2 == 0) q = {centre[0] + q[1] - centre[1], centre[1] + q[0] - centre[0]};
    } else {
      q = {Rational::from_double(4 * random.unit() - 2),
           Rational::from_double(4 * random.unit() - 2)};
    }
    const Rational dx = q[0] - centre[0], dy = q[1] - centre[1];
    const Sign side = (dx * dx + dy * dy - radius * radius).sign();
    const PlaneAnswer a = disk.classify(q);
    EXPECT_EQ(a.is_on(), side == 0) << "seed " << kSeed << " point " << i;
    EXPECT_EQ(a.winding, side < 0 ? 1 : 0) << "seed " << kSeed << " point " << i;
    EXPECT_EQ(a.is_in(), side < 0);
    inside += side < 0 ? 1 : 0;
  }
  EXPECT_GT(inside, 300);
}

// PROVES CHAIN-5
TEST(PlaneRegion, FindsPointsOnCurvesAndBesideThem) {
  Random random(kSeed + 1);
  const PlaneRegion disk = region_of(circle({0, 0}, 1));
  for (int i = 0; i < 100; ++i) {
    const Rational t = fraction(static_cast<std::int64_t>(random.below(1000)), 999);
    const std::uint32_t number = static_cast<std::uint32_t>(random.below(4));
    const PointIn<2> p = point_of_arc(disk.arcs()[number], t);
    const PlaneAnswer a = disk.classify(p);
    ASSERT_TRUE(a.is_on());
    EXPECT_EQ(a.winding, 0);
    EXPECT_EQ(point_of_arc(disk.arcs()[*a.arc], a.parameter[0]), p);
    for (const int bits : {60, 300, 1000})
      for (const int side : {-1, 1}) {
        const Rational scale = Rational(1) + Rational(side) * Rational::power_of_two(-bits);
        const PlaneAnswer off = disk.classify({p[0] * scale, p[1] * scale});
        EXPECT_FALSE(off.is_on());
        EXPECT_EQ(off.winding, side < 0 ? 1 : 0) << "t = " << t.to_string() << " bits " << bits;
      }
  }
}

// x = t^3, y = t^2 ...: the point (1/2, 2^(-2/3)) is rational nowhere, but (1/2, v) is on y = x at an irrational t.
TEST(PlaneRegion, FindsPointsAtIrrationalParameters) {
  // x = 2 t^2 and y = 4 t^4 = x^2, closed by two segments; (1, 1) is at t = 1 / sqrt 2.
  const PlaneArc curve = arc_of({{0, 0}, {0, 0}, {fraction(1, 3), 0}, {1, 0}, {2, 4}});
  const PlaneRegion region = region_of({curve, arc_of({{2, 4}, {0, 4}}), arc_of({{0, 4}, {0, 0}})});
  const PlaneAnswer a = region.classify({1, 1});
  ASSERT_EQ(a.arc, 0u);
  EXPECT_LT(a.parameter[0], a.parameter[1]);
  EXPECT_LT(a.parameter[0] * a.parameter[0], fraction(1, 2));
  EXPECT_GT(a.parameter[1] * a.parameter[1], fraction(1, 2));
  const Rational tiny = Rational::power_of_two(-500);
  EXPECT_EQ(region.classify({1, Rational(1) + tiny}).winding, 1);
  EXPECT_EQ(region.classify({1, Rational(1) - tiny}).winding, 0);
  EXPECT_FALSE(region.classify({1, Rational(1) + tiny}).is_on());
}

// PROVES CHAIN-5
TEST(PlaneRegion, HasTheWindingNumbersOfLoopsThatCross) {
  Random random(kSeed + 2);
  std::array<int, 3> seen{};
  for (int round = 0; round < 60; ++round) {
    const std::vector<PlaneArc> arcs = random_loop(random, 6);
    const PlaneRegion region = region_of(arcs);
    const Polyline loop = many_points(arcs);
    for (int i = 0; i < 60; ++i) {
      const PointIn<2> q{fraction(static_cast<std::int64_t>(random.below(25)) - 1, 4),
                         fraction(static_cast<std::int64_t>(random.below(25)) - 1, 4)};
      const auto truth = winding_by_angles(loop, nearest_double(q[0]), nearest_double(q[1]));
      if (!truth) continue;
      const PlaneAnswer a = region.classify(q);
      EXPECT_FALSE(a.is_on());
      EXPECT_EQ(a.winding, *truth) << "seed " << kSeed << " round " << round << " at "
                                   << q[0].to_string() << " " << q[1].to_string();
      ++seen[static_cast<std::size_t>(std::min(2, std::abs(*truth)))];
    }
  }
  for (const int n : seen) EXPECT_GT(n, 3);
}

// For every origin, on curved cells of both signs, mixed ones and loops that cross.  PROVES CHAIN-5
TEST(PlaneChain, IsTheWindingNumberForEveryOrigin) {
  Random random(kSeed + 3);
  int compared = 0, walls = 0;
  for (int round = 0; round < 40; ++round) {
    const std::vector<PlaneArc> arcs = random_loop(random, 6);
    const PlaneRegion region = region_of(arcs);
    for (const PointIn<2>& origin :
         {PointIn<2>{0, 0}, arcs[0].start(), PointIn<2>{fraction(13, 7), fraction(29, 11)},
          PointIn<2>{1000, -777}}) {
      const AssociatedFunction<2> f(plane_chain(arcs, origin));
      for (int i = 0; i < 20; ++i) {
        const PointIn<2> q{fraction(static_cast<std::int64_t>(random.below(49)), 8),
                           fraction(static_cast<std::int64_t>(random.below(49)), 8)};
        const auto off = f.is_off_walls(q);
        const PlaneAnswer a = region.classify(q);
        if (off != true || a.is_on()) {
          ++walls;
          continue;
        }
        ++compared;
        EXPECT_EQ(f.value(q), Integer(a.winding))
            << "seed " << kSeed << " round " << round << " at " << q[0].to_string() << " "
            << q[1].to_string();
      }
    }
  }
  EXPECT_GT(compared, 1000);
  EXPECT_GT(walls, 20);
}

// PROVES CHAIN-5
TEST(ArcCell, HasSignsAndValuesOfThePaper) {
  const PlaneArc below = arc_of({{0, 0}, {1, -1}, {2, 0}}),
                 above = arc_of({{0, 0}, {1, 1}, {2, 0}});
  for (const auto& [arc, sign] : {std::pair(below, 1), std::pair(above, -1)}) {
    const ArcCell cell(arc);
    EXPECT_EQ(cell.sign(), sign);
    EXPECT_EQ(cell.kind(), CellKind::kFreeForm);
    const auto value = [&](const Rational& y) { return cell.value(ChainPoint<2>({1, y})); };
    EXPECT_EQ(value(fraction(-sign, 4)), 1);
    EXPECT_EQ(value(fraction(-sign, 2)), std::nullopt);  // on the curve
    EXPECT_EQ(value(fraction(-sign, 1)), 0);
    EXPECT_EQ(value(fraction(sign, 4)), 0);
    EXPECT_EQ(value(0), 1);  // on the chord
    const auto germ = cell.germ(ChainPoint<2>({1, 0}));
    ASSERT_TRUE(germ);
    ASSERT_EQ(germ->half_spaces.size(), 1u);
    EXPECT_EQ(germ->inside, sign > 0 ? 0 : 1);  // to the left of the chord
    EXPECT_EQ(germ->outside, sign > 0 ? 1 : 0);
    EXPECT_FALSE(cell.germ(ChainPoint<2>({0, 0})));
  }
  // A straight curve has no cell, a closed one has no simplex.
  const PlaneArc straight = arc_of({{0, 0}, {1, 1}, {3, 3}}),
                 loop = arc_of({{0, 0}, {4, 0}, {0, 4}, {0, 0}});
  EXPECT_EQ(plane_chain(std::vector{straight}, {1, 0}).terms().size(), 1u);
  EXPECT_EQ(plane_chain(std::vector{loop}, {1, 0}).terms().size(), 1u);
}

// In every direction of the chord.  PROVES CHAIN-5
TEST(ArcCell, HasItsValuesOnTheRightSidesOfChordsInAllDirections) {
  for (const PointIn<2>& along : {PointIn<2>{2, 0}, {-2, 0}, {0, 2}, {0, -2}, {1, 3}, {-2, 1}})
    for (const int right : {1, -1}) {
      const PointIn<2> to_right{along[1] * right, -along[0] * right};
      const PlaneArc arc = arc_of(
          {{0, 0}, {half_of(along[0]) + to_right[0], half_of(along[1]) + to_right[1]}, along});
      const ArcCell cell(arc);
      EXPECT_EQ(cell.sign(), right);
      const PointIn<2> middle{half_of(along[0]), half_of(along[1])};
      const auto germ = cell.germ(ChainPoint<2>(middle));
      ASSERT_TRUE(germ);
      // Inward is to the left; the curve is on the right or on the left.
      EXPECT_EQ(germ->inside, right > 0 ? 0 : 1);
      EXPECT_EQ(germ->outside, right > 0 ? 1 : 0);
      EXPECT_EQ(germ->border, 1);
      const Rational inner = germ->half_spaces[0][0] * to_right[0] * Rational(right) +
                             germ->half_spaces[0][1] * to_right[1] * Rational(right);
      EXPECT_LT(inner, Rational(0));
    }
}

// A curve that crosses its chord: its cell has the values 1 and -1, on the chord as well.  PROVES CHAIN-5
TEST(ArcCell, HasBothSignsWhereTheCurveCrossesTheChord) {
  const ArcCell cell(arc_of({{0, 0}, {1, 3}, {2, -3}, {3, 0}}));
  EXPECT_EQ(cell.sign(), 1);
  const auto value = [&](const Rational& x, const Rational& y) {
    return cell.value(ChainPoint<2>({x, y}));
  };
  const Rational tenth = fraction(1, 10);
  EXPECT_EQ(value(fraction(3, 4), tenth), -1);
  EXPECT_EQ(value(fraction(3, 4), 0), -1);
  EXPECT_EQ(value(fraction(3, 4), -tenth), 0);
  EXPECT_EQ(value(fraction(3, 2), 0), std::nullopt);
  EXPECT_EQ(value(fraction(9, 4), -tenth), 1);
  EXPECT_EQ(value(fraction(9, 4), 0), 1);
  EXPECT_EQ(value(fraction(9, 4), tenth), 0);
}

// A disk and a square with a common part; along a common chord as well.  PROVES CHAIN-3
TEST(PlaneChain, HasBooleanOperations) {
  const std::vector<PlaneArc> disk = circle({0, 0}, 1);
  const std::vector<PlaneArc> square{arc_of({{0, 0}, {2, 0}}), arc_of({{2, 0}, {2, 2}}),
                                     arc_of({{2, 2}, {0, 2}}), arc_of({{0, 2}, {0, 0}})};
  const Chain<2> a = plane_chain(disk, {fraction(1, 5), fraction(-1, 9)}),
                 b = plane_chain(square, {5, 7});
  const AssociatedFunction<2> both(intersection_of(a, b).value()), either(union_of(a, b).value()),
      without(difference_of(a, b).value()), outside(complement_of<2>(a, {-3, -3}, {3, 3}).value());
  Random random(kSeed + 4);
  for (int i = 0; i < 500; ++i) {
    const PointIn<2> q{Rational::from_double(4 * random.unit() - 2),
                       Rational::from_double(4 * random.unit() - 2)};
    const int s = (q[0] * q[0] + q[1] * q[1] - Rational(1)).sign() < 0 ? 1 : 0;
    const int t = q[0].sign() > 0 && q[1].sign() > 0 ? 1 : 0;
    EXPECT_EQ(both.value(q), Integer(s & t)) << "seed " << kSeed;
    EXPECT_EQ(either.value(q), Integer(s | t)) << "seed " << kSeed;
    EXPECT_EQ(without.value(q), Integer(s & (1 - t))) << "seed " << kSeed;
    EXPECT_EQ(outside.value(q), Integer(1 - s)) << "seed " << kSeed;
  }
}

// f* where a chord separates a simplex from its cell: both are closed.  PROVES CHAIN-2
TEST(PlaneChain, HasRegularValuesOnChords) {
  const AssociatedFunction<2> f(plane_chain(circle({0, 0}, 1), {0, 0}));
  const PointIn<2> on_chord{fraction(1, 3), fraction(2, 3)};
  EXPECT_EQ(f.value(on_chord), Integer(2));
  EXPECT_EQ(f.regular_value(on_chord), Integer(2));
  EXPECT_EQ(f.regular_value({fraction(3, 5), fraction(4, 5)}), std::nullopt);
  EXPECT_EQ(f.regular_value({fraction(1, 3), fraction(1, 4)}), Integer(1));
  EXPECT_EQ(f.regular_value({0, 0}), Integer(4));  // four simplices
}

TEST(PlaneRegion, NamesTheFirstOfSeveralCurvesAtAPoint) {
  const PlaneRegion disk = region_of(circle({0, 0}, 1));
  EXPECT_EQ(disk.classify({1, 0}).arc, 0u);  // the last one ends there, too
  EXPECT_EQ(disk.classify({1, 0}).parameter, (ArcParameter{0, 0}));
  EXPECT_EQ(disk.classify({0, 1}).arc, 0u);
  EXPECT_EQ(disk.classify({0, 1}).parameter, (ArcParameter{1, 1}));
  EXPECT_EQ(disk.classify({-1, 0}).arc, 1u);
  std::vector<PlaneArc> twice = circle({0, 0}, 1);
  for (int i = 0; i < 4; ++i) twice.push_back(twice[static_cast<std::size_t>(i)]);
  EXPECT_EQ(region_of(twice).classify({fraction(-3, 5), fraction(4, 5)}).arc, 1u);
  EXPECT_EQ(region_of(twice).classify({0, 0}).winding, 2);
}

TEST(PlaneRegion, NamesTheCurveAtWhichALoopIsOpen) {
  std::vector<PlaneArc> arcs = circle({0, 0}, 1);
  arcs.erase(arcs.begin() + 2);
  const auto open = PlaneRegion::make(arcs);
  ASSERT_FALSE(open);
  EXPECT_EQ(open.error().code, Code::kBadArgument);
  EXPECT_EQ(open.error().place.entity, 1u);
  EXPECT_EQ(
      open.error().message,
      "the loops are not closed: the curve ends at (-1, 0), where fewer curves start than end");
  const auto twice = PlaneRegion::make({arc_of({{0, 0}, {1, 0}}), arc_of({{0, 0}, {1, 0}})});
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().place.entity, 0u);
  EXPECT_TRUE(PlaneRegion::make({arc_of({{0, 0}, {1, 0}}), arc_of({{1, 0}, {0, 0}})}));
  EXPECT_TRUE(PlaneRegion::make({}));
  EXPECT_EQ(PlaneRegion::make({}).value().classify({0, 0}).winding, 0);
}

TEST(PlaneArc, RefusesWhatIsNoCurveOfThePlane) {
  const auto code = [](PlaneArc::Curve curve) {
    const auto made = PlaneArc::make(std::move(curve));
    return made ? std::string("made") : made.error().message;
  };
  EXPECT_EQ(code(PlaneArc::Curve({2}, 3, false)),
            "a curve of the plane has two coordinates, not 3");
  EXPECT_EQ(code(PlaneArc::Curve({0}, 2, false)), "a curve of the plane has a degree of 1 or more");
  EXPECT_EQ(code(PlaneArc::Curve({1}, 3, true)), "the weights of a curve are positive, not 0");
  EXPECT_EQ(code(PlaneArc::Curve({1}, 2, false)), "made");
  // A curve that is one point.
  const PlaneArc point = arc_of({{1, 1}, {1, 1}});
  EXPECT_EQ(point.passes(ChainPoint<2>({1, 1})), std::nullopt);
  EXPECT_EQ(point.passes(ChainPoint<2>({0, 1})), 0);
  EXPECT_EQ(point.parameter_of({1, 1}), (ArcParameter{0, 0}));
  EXPECT_FALSE(point.sides());
}

}  // namespace
}  // namespace veritope
