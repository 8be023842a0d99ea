// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/predicates/entry_path_test.cc: rational points and the half-open tetrahedra of rule H, against rational
// polynomials in ε.
#include "predicates/entry_path.h"

#include <gtest/gtest.h>

#include "predicates/exact_point.h"
#include "robust/base/random.h"
#include "tests/predicates/test_scale.h"
#include "tests/predicates/tier_test.h"
#include "tests/support/simplex_oracle.h"

namespace veritope {
namespace {

using simplex_oracle::Point;

// Small coordinates, so that points often lie on common planes; some are no binary64 numbers, and some are far away.
Point draw(Random& random) {
  Point p;
  const auto kind = random.below(4);
  for (Rational& c : p) {
    c = Rational(random.between(-3, 3));
    if (kind == 1) c /= Rational(3);
    if (kind == 2) c += Rational::power_of_two(-60) * Rational(random.between(-2, 2));
    if (kind == 3 && random.below(4) == 0)
      c *= Rational::power_of_two(random.below(2) == 0 ? 1500 : -1500);
  }
  return p;
}
// A point of the plane of the others, one of them, or any point.
Point draw_near(Random& random, const std::vector<Point>& points) {
  if (random.below(3) == 0) return draw(random);
  Point sum{};
  Rational total;
  for (std::uint64_t i = 0, n = random.between(1, 3); i < n; ++i) {
    const Rational weight(random.between(1, 4));
    sum = simplex_oracle::plus(sum,
                               simplex_oracle::times(weight, points[random.below(points.size())]));
    total += weight;
  }
  return simplex_oracle::times(Rational(1) / total, sum);
}

struct Case {
  std::vector<Point> points;
  std::vector<ExactPoint3> exact;
  EntryPath path = EntryPath::along_axes(ExactPoint3(Point{}));
  simplex_oracle::Path oracle;
  std::string text;
};
Case draw_case(std::uint64_t seed) {
  Random random(seed);
  Case out;
  out.text = "seed " + std::to_string(seed) + ":";
  for (int i = 0; i < 4; ++i) out.points.push_back(draw(random));
  const Point u = draw_near(random, out.points);
  for (const Point& p : out.points)
    out.exact.emplace_back(p), out.text += " " + simplex_oracle::text(p);
  out.text += ", u " + simplex_oracle::text(u);
  if (random.below(2) == 0) {
    out.path = EntryPath::along_axes(ExactPoint3(u));
    out.oracle = simplex_oracle::axes_path(u);
  } else {
    const Point g = draw_near(random, out.points);
    out.text += ", g " + simplex_oracle::text(g);
    out.path = EntryPath::inward(ExactPoint3(u), ExactPoint3(g));
    out.oracle = simplex_oracle::inward_path(u, g);
  }
  return out;
}

TEST(ExactPoint, KnowsWhetherItIsBinary64) {
  const ExactPoint3 half(std::array<Rational, 3>{Rational(1) / Rational(2), 0, -7});
  EXPECT_TRUE(half.is_binary64());
  EXPECT_EQ(half.rounded(), (Vec3d{0.5, 0, -7}));
  EXPECT_EQ(half.scale(), Integer(2));
  EXPECT_EQ(half.scaled()[2], Integer(-14));
  const ExactPoint3 third(std::array<Rational, 3>{Rational(1) / Rational(3), 0, 1});
  EXPECT_FALSE(third.is_binary64());
  const ExactPoint3 far(std::array<Rational, 3>{Rational::power_of_two(1024), 0, 1});
  EXPECT_FALSE(far.is_binary64());
  EXPECT_EQ(ExactPoint3(Vec3d{0x1p-1074, 1, 2}).at()[0], Rational::power_of_two(-1074));
}

TEST(ExactPoint, OrientationsAreThoseOfRationals) {
  for (long seed = 0; seed < scaled(4000); ++seed) {
    const Case c = draw_case(static_cast<std::uint64_t>(seed));
    const Point& u = c.oracle[0];
    const ExactPoint3& x = c.path.start();
    const auto& p = c.points;
    EXPECT_EQ(orient3d(c.exact[0], c.exact[1], c.exact[2], x),
              simplex_oracle::volume6(p[0], p[1], p[2], u).sign())
        << c.text;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Point unit{};
      unit[axis] = Rational(1);
      const Sign s =
          simplex_oracle::volume6(p[0], p[1], p[2], simplex_oracle::plus(p[0], unit)).sign();
      EXPECT_EQ(orient2d_projected(c.exact[0], c.exact[1], c.exact[2], static_cast<int>(axis)), s)
          << c.text;
      EXPECT_EQ(internal::orient2d_projected_exact(c.exact[0], c.exact[1], c.exact[2],
                                                   static_cast<int>(axis)),
                s);
    }
    if (testing::Test::HasFailure()) return;
  }
}

TEST(ExactPoint, AsksTheTiersThatCanDecide) {
  const auto point = [](Rational x, Rational y, Rational z) {
    return ExactPoint3(std::array<Rational, 3>{std::move(x), std::move(y), std::move(z)});
  };
  const Rational third = Rational(1) / Rational(3);
  const ExactPoint3 a = point(0, 0, 0), b = point(1, 0, 0), c = point(0, 1, 0), d = point(0, 0, 1),
                    e = point(third, third, third), f = point(third, third, 0),
                    g = point(2 * third, third, 0);
  const auto ask = [](const ExactPoint3& p, const ExactPoint3& q, const ExactPoint3& r,
                      const ExactPoint3& s) {
    return [&](TierCounts* tally) { return orient3d(p, q, r, s, tally); };
  };
  expect_decided_by(Tier::kFilter, Sign::kPositive, ask(a, b, c, d));
  expect_decided_by(Tier::kInterval, Sign::kPositive, ask(a, b, c, e));
  expect_decided_by(Tier::kExact, Sign::kZero, ask(b, c, d, e));
  expect_decided_by(Tier::kInterval, Sign::kPositive,
                    [&](TierCounts* tally) { return orient2d_projected(a, b, f, 2, tally); });
  expect_decided_by(Tier::kExact, Sign::kZero,
                    [&](TierCounts* tally) { return orient2d_projected(b, c, g, 2, tally); });
}

TEST(EntryPath, SidesAreTheSignsOfPolynomials) {
  int on_planes = 0, entered = 0;
  for (long seed = 0; seed < scaled(6000); ++seed) {
    const Case c = draw_case(static_cast<std::uint64_t>(seed));
    const auto& p = c.points;
    const Sign s = simplex_oracle::side(p[0], p[1], p[2], c.oracle);
    EXPECT_EQ(orient3d_entered(c.exact[0], c.exact[1], c.exact[2], c.path), s) << c.text;
    EXPECT_EQ(orient3d_entered(c.exact[1], c.exact[0], c.exact[2], c.path), -s) << c.text;
    EXPECT_EQ(orient3d_entered(c.exact[1], c.exact[2], c.exact[0], c.path), s) << c.text;
    const bool in = simplex_oracle::contains({p[0], p[1], p[2], p[3]}, c.oracle);
    EXPECT_EQ(is_entered({&c.exact[0], &c.exact[1], &c.exact[2], &c.exact[3]}, c.path), in)
        << c.text;
    EXPECT_EQ(is_entered({&c.exact[3], &c.exact[1], &c.exact[2], &c.exact[0]}, c.path), in)
        << c.text;
    on_planes += simplex_oracle::volume6(p[0], p[1], p[2], c.oracle[0]).sign() == Sign::kZero;
    entered += in;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GE(on_planes, 1000);
  EXPECT_GE(entered, 300);
}

// Six tetrahedra around a diagonal tile a cube, four cubes share an edge: at any place exactly one is entered.
TEST(EntryPath, EntersExactlyOneOfTheTetrahedraAroundAPoint) {
  constexpr std::array<std::array<int, 3>, 6> kOrders{
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  std::vector<std::array<ExactPoint3, 4>> tetrahedra;
  for (long x = -1; x < 1; ++x)
    for (long y = -1; y < 1; ++y)
      for (long z = -1; z < 1; ++z)
        for (const auto& order : kOrders) {
          std::array<Rational, 3> at{x, y, z};
          std::vector<ExactPoint3> corners{ExactPoint3(at)};
          for (const int axis : order) {
            at[static_cast<std::size_t>(axis)] += Rational(1);
            corners.emplace_back(at);
          }
          tetrahedra.push_back({corners[0], corners[1], corners[2], corners[3]});
        }
  Random random(11);
  for (long i = 0; i < scaled(1000); ++i) {
    const auto denominator = static_cast<long>(random.between(1, 4));
    std::array<Rational, 3> u;
    for (Rational& c : u)
      c = Rational(random.between(-denominator + 1, denominator - 1)) / Rational(denominator);
    const EntryPath path =
        random.below(2) == 0
            ? EntryPath::along_axes(ExactPoint3(u))
            : EntryPath::inward(ExactPoint3(u), ExactPoint3(std::array<Rational, 3>{
                                                    Rational(random.between(-1, 1)),
                                                    Rational(random.between(-1, 1)),
                                                    Rational(random.between(-1, 1))}));
    int count = 0;
    for (const auto& t : tetrahedra) count += is_entered({&t[0], &t[1], &t[2], &t[3]}, path);
    ASSERT_EQ(count, 1) << simplex_oracle::text(u);
  }
}

TEST(EntryPath, NeverEntersADegenerateTetrahedron) {
  const auto point = [](long x, long y, long z) {
    return ExactPoint3(std::array<Rational, 3>{x, y, z});
  };
  const ExactPoint3 a = point(0, 0, 0), b = point(2, 0, 0), c = point(0, 2, 0), d = point(2, 2, 0);
  const EntryPath path = EntryPath::along_axes(point(1, 1, 0));
  EXPECT_FALSE(is_entered({&a, &b, &c, &d}, path));
  EXPECT_FALSE(is_entered({&a, &a, &c, &d}, path));
  EXPECT_FALSE(is_entered({&a, &a, &a, &a}, path));
}

}  // namespace
}  // namespace veritope
