// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/implicit_point.h"

#include <gtest/gtest.h>

#include <cmath>

#include "predicates/implicit_formulas.h"
#include "predicates/orient3d.h"
#include "robust/base/check.h"
#include "robust/rational.h"
#include "tests/predicates/point_generators.h"
#include "tests/predicates/tier_test.h"

namespace veritope {
namespace {

using generate::Kind;

const Vec3d kO{0, 0, 0}, kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};
const Vec3d kBelow{0.25, 0.25, -1}, kAbove{0.25, 0.25, 3};

// ---- The oracle: the point itself, in rationals ------------------------------------------------

using Point = formulas::Triple<Rational>;

Point rational(const Vec3d& p) {
  return {Rational::from_double(p.x), Rational::from_double(p.y), Rational::from_double(p.z)};
}
Point normal(const Point& a, const Point& b, const Point& c) {
  return formulas::cross(formulas::difference(b, a), formulas::difference(c, a));
}
Sign side(const Point& a, const Point& b, const Point& c, const Point& d) {
  return formulas::dot(normal(a, b, c), formulas::difference(d, a)).sign();
}
// p + t (q - p) with n . (a - p) = t n . (q - p); false if no such point exists.
bool intersect(const std::array<Vec3d, 5>& v, Point& out) {
  const Point p = rational(v[0]), u = formulas::difference(rational(v[1]), p), a = rational(v[2]),
              n = normal(a, rational(v[3]), rational(v[4]));
  const Rational d = formulas::dot(n, u);
  if (d.sign() == Sign::kZero) return false;
  const Rational t = formulas::dot(n, formulas::difference(a, p)) / d;
  out = {p.x + t * u.x, p.y + t * u.y, p.z + t * u.z};
  return true;
}
// Cramer's rule for n_i . x = n_i . a_i.
bool intersect(const std::array<Vec3d, 9>& v, Point& out) {
  std::array<Point, 3> n;
  std::array<Rational, 3> k;
  for (int i = 0; i < 3; ++i) {
    const Point a = rational(v[3 * i]);
    n[i] = normal(a, rational(v[3 * i + 1]), rational(v[3 * i + 2]));
    k[i] = formulas::dot(n[i], a);
  }
  const auto det = [](const Point& a, const Point& b, const Point& c) {
    return formulas::dot(a, formulas::cross(b, c));
  };
  const Point x{n[0].x, n[1].x, n[2].x}, y{n[0].y, n[1].y, n[2].y}, z{n[0].z, n[1].z, n[2].z},
      right{k[0], k[1], k[2]};
  const Rational d = det(x, y, z);
  if (d.sign() == Sign::kZero) return false;
  out = {det(right, y, z) / d, det(x, right, z) / d, det(x, y, right) / d};
  return true;
}

// ---- By hand -----------------------------------------------------------------------------------

TEST(LinePlanePoint, LiesWhereTheLineMeetsThePlane) {
  const LinePlanePoint p(kBelow, kAbove, kO, kX, kY);  // (1/4, 1/4, 0)
  ASSERT_TRUE(p.is_defined());
  EXPECT_EQ(p.denominator_sign(), Sign::kPositive);
  expect_decided_by(Tier::kLattice, Sign::kZero,
                    [&](TierCounts* t) { return orient3d(kO, kX, kY, p, t); });
  expect_decided_by(Tier::kFilter, Sign::kPositive, [&](TierCounts* t) {
    return orient3d({0, 0, -1}, {1, 0, -1}, {0, 1, -1}, p, t);
  });
  expect_decided_by(Tier::kFilter, Sign::kNegative, [&](TierCounts* t) {
    return orient3d({0, 0, 1}, {1, 0, 1}, {0, 1, 1}, p, t);
  });
  EXPECT_EQ(orient3d(kX, kY, kZ, p), orient3d(kX, kY, kZ, {0.25, 0.25, 0}));
}

TEST(LinePlanePoint, DoesNotDependOnDirectionAndOrientation) {
  const Vec3d a{0.1, 0.2, 0.3}, b{0.9, 0.3, 0.1}, c{0.2, 0.8, 0.4}, q{0.3, 0.1, 0.7};
  const Sign s = orient3d(a, b, q, LinePlanePoint(kBelow, kAbove, a, b, c));
  EXPECT_NE(s, Sign::kZero);
  EXPECT_EQ(orient3d(a, b, q, LinePlanePoint(kAbove, kBelow, a, b, c)), s);
  EXPECT_EQ(orient3d(a, b, q, LinePlanePoint(kBelow, kAbove, b, a, c)), s);
  EXPECT_EQ(orient3d(b, a, q, LinePlanePoint(kBelow, kAbove, c, b, a)), -s);
  EXPECT_EQ(orient3d(a, b, c, LinePlanePoint(kBelow, kAbove, a, b, c)), Sign::kZero);
}

TEST(LinePlanePoint, IsUndefinedWhereThereIsNoSinglePoint) {
  EXPECT_FALSE(LinePlanePoint(kX, kX, kO, kX, kY).is_defined());
  EXPECT_FALSE(LinePlanePoint(kBelow, kAbove, kO, kX, {7, 0, 0}).is_defined());
  EXPECT_FALSE(LinePlanePoint({0, 0, 1}, {1, 0, 1}, kO, kX, kY).is_defined());
  EXPECT_FALSE(LinePlanePoint({0, 0, 0x1p-1074}, {1, 0, 0x1p-1074}, kO, kX, kY).is_defined());
  EXPECT_TRUE(LinePlanePoint({0, 0, 0x1p-1074}, {1, 0, 0}, kO, kX, kY).is_defined());
}

TEST(LinePlanePoint, HasNoOrientationIfItIsNotDefined) {
  const LinePlanePoint none({0, 0, 1}, {1, 0, 1}, kO, kX, kY);
  EXPECT_THROW(orient3d({0, 0, -5}, {1, 0, -5}, {0, 1, -5}, none), InternalError);
}

TEST(ThreePlanePoint, LiesWhereThePlanesMeet) {
  const ThreePlanePoint p({Vec3d{0, 0, 0.5},
                           {1, 0, 0.5},
                           {0, 1, 0.5},
                           {0, 0.25, 0},
                           {0, 0.25, 1},
                           {1, 0.25, 0},
                           {0.125, 0, 0},
                           {0.125, 1, 0},
                           {0.125, 0, 1}});  // (1/8, 1/4, 1/2)
  ASSERT_TRUE(p.is_defined());
  EXPECT_EQ(orient3d({0.125, 0.25, 0.5}, kX, kY, p), Sign::kZero);
  EXPECT_EQ(orient3d(kX, kY, kZ, p), orient3d(kX, kY, kZ, {0.125, 0.25, 0.5}));
  expect_decided_by(Tier::kFilter, Sign::kPositive,
                    [&](TierCounts* t) { return orient3d(kO, kX, kY, p, t); });
}

TEST(ThreePlanePoint, IsUndefinedWhereThereIsNoSinglePoint) {
  EXPECT_FALSE(ThreePlanePoint({kO, kX, kY, kO, kX, kY, kO, kX, kZ}).is_defined());
  EXPECT_FALSE(
      ThreePlanePoint({kO, kX, kZ, kO, kX, kY, kX, kO, {3, 4, 5}}).is_defined());  // one line
  EXPECT_FALSE(ThreePlanePoint({kO, kX, kX, kO, kX, kY, kO, kX, kZ}).is_defined());
}

// ---- Every tier against the rationals ----------------------------------------------------------

template <typename P>
void expect_every_tier(const P& p, const Point& at, const Vec3d& a, const Vec3d& b,
                       const Vec3d& c) {
  const Sign expected = side(rational(a), rational(b), rational(c), at);
  ASSERT_EQ(orient3d(a, b, c, p), expected);
  const Sign times = p.denominator_sign() * expected;
  const Sign3 filter = internal::implicit_filter(p.layer(), p.points()[0], a, b, c);
  if (is_certain(filter)) {
    ASSERT_EQ(to_sign(filter), expected);
  }
  const Sign3 lattice = internal::implicit_lattice(p, a, b, c);
  if (is_certain(lattice)) {
    ASSERT_EQ(to_sign(lattice), times);
  }
  const Sign3 interval = internal::implicit_interval(p, a, b, c);
  if (is_certain(interval)) {
    ASSERT_EQ(to_sign(interval), times);
  }
  ASSERT_EQ(internal::implicit_exact(p, a, b, c), times);
  ASSERT_EQ(internal::implicit_integer(p, a, b, c), times);
}

// Query planes: any, one through two of the defining points, and the defining plane itself.
template <typename P, std::size_t N>
void expect_signs(const std::array<Vec3d, N>& v, const P& p, const generate::Points& query) {
  Point at;
  ASSERT_EQ(p.is_defined(), intersect(v, at));
  if (!p.is_defined()) return;
  expect_every_tier(p, at, query[0], query[1], query[2]);
  expect_every_tier(p, at, query[0], v[3], v[4]);
  expect_every_tier(p, at, v[N - 3], v[N - 2], v[N - 1]);
}

TEST(ImplicitPoints, SignsAreThoseOfTheRationalPointForEveryKindOfPoints) {
  const std::uint64_t seed = 20261122;
  Random random(seed);
  for (int kind = 0; kind < generate::kNumKinds; ++kind) {
    for (int i = 0; i < 120; ++i) {
      const generate::Points one = generate::points(static_cast<Kind>(kind), random),
                             two = generate::points(static_cast<Kind>(kind), random),
                             query = generate::points(static_cast<Kind>(kind), random);
      SCOPED_TRACE(std::string(generate::kKindNames[kind]) + " seed " + std::to_string(seed) +
                   " number " + std::to_string(i) + ": " + generate::text(one) +
                   generate::text(two) + generate::text(query));
      const std::array<Vec3d, 5> line = one;
      ASSERT_NO_FATAL_FAILURE(
          expect_signs(line, LinePlanePoint(line[0], line[1], line[2], line[3], line[4]), query));
      const std::array<Vec3d, 9> planes{one[0], one[1], one[2], one[3], one[4],
                                        two[0], two[1], two[2], two[3]};
      ASSERT_NO_FATAL_FAILURE(expect_signs(planes, ThreePlanePoint(planes), query));
    }
  }
}

TEST(ImplicitPoints, FarDifferencesLeaveTheFilterAndStayRight) {
  const double far = 0x1p101;
  const LinePlanePoint p({0, 0, -far}, {0, 0, far}, {-1, -1, 1}, {1, -1, 1}, {0, 1, 1});
  ASSERT_TRUE(p.is_defined());
  EXPECT_EQ(p.layer().d, 0);
  EXPECT_EQ(orient3d(kO, kX, kY, p), Sign::kPositive);
  const LinePlanePoint near(kBelow, kAbove, kO, kX, kY);
  EXPECT_EQ(internal::implicit_filter(near.layer(), kBelow, {far, 0, -1}, {0, far, -1}, {0, 0, -1}),
            Sign3::kUncertain);
  EXPECT_EQ(orient3d({far, 0, -1}, {0, far, -1}, {0, 0, -1}, near), Sign::kPositive);
}

}  // namespace
}  // namespace veritope
