// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/volumes/axis_turn.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "solids/volumes/half_angle.h"
#include "tests/solids/volume_support.h"

namespace veritope {
namespace {

constexpr std::uint64_t kSeed = 2102;

Rational q(int p, int r = 1) { return Rational(Integer(p), Integer(r)); }

// With 64 bits, whatever the length of the fraction.
long double number(const Rational& x) {
  const double high = nearest_double(x);
  return static_cast<long double>(high) + nearest_double(x - Rational::from_double(high));
}

const long double kPi = std::acos(-1.0L);

CellSurface unit_square(const CellPoint& at) {
  std::vector<Rational> all;
  const std::array<CellPoint, 4> corners = {
      CellPoint{q(0), q(0), q(0)}, CellPoint{q(0), q(0), q(1)}, CellPoint{q(1), q(0), q(0)},
      CellPoint{q(1), q(0), q(1)}};
  for (std::size_t k = 0; k < 3; ++k)
    for (const CellPoint& c : corners) all.push_back(at[k] + c[k]);
  return CellSurface({unit_axis(1), unit_axis(1)}, 3, false, std::move(all));
}

TEST(HalfAngle, RangesAreNarrowAndContainTheValues) {
  const auto pi = internal::pi_range();
  EXPECT_LT(pi.hi - pi.lo, Rational::power_of_two(-120));
  EXPECT_LT(pi.lo, pi.hi);
  EXPECT_NEAR(static_cast<double>(number(pi.lo) - kPi), 0, 1e-18);
  std::mt19937_64 random(kSeed);
  for (int loop = 0; loop < 500; ++loop) {
    Rational degrees(Integer(random() % 45001), Integer(1000));
    if (loop % 5 == 0) degrees *= Rational::power_of_two(-static_cast<int>(random() % 200));
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", degrees " + degrees.to_string());
    const auto range = internal::tangent_range(degrees);
    EXPECT_LE(range.hi - range.lo, Rational::power_of_two(-90) * range.hi);
    if (degrees.sign() == Sign::kZero) {
      EXPECT_EQ(range.hi, q(0));
      continue;
    }
    const long double tangent = std::tan(number(degrees) * kPi / 180);
    EXPECT_NEAR(static_cast<double>(number(range.lo) / tangent - 1), 0, 1e-17);
  }
  EXPECT_LE(internal::tangent_range(q(45)).lo, q(1));
  EXPECT_GE(internal::tangent_range(q(45)).hi, q(1));
  EXPECT_EQ(internal::square_root_range(q(9, 4)).lo, q(3, 2));
  EXPECT_EQ(internal::square_root_range(q(9, 4)).hi, q(3, 2));
  for (int n = 2; n < 300; ++n) {
    const auto root = internal::square_root_range(q(n, 1 + n % 7));
    EXPECT_LE(root.lo * root.lo, q(n, 1 + n % 7));
    EXPECT_GE(root.hi * root.hi, q(n, 1 + n % 7));
    EXPECT_LE(root.hi - root.lo, Rational::power_of_two(-100) * root.hi);
  }
}

// The angle of the last quaternion is within the stated error, each step turns forward by less than 180 degrees.
TEST(AxisTurn, EndsAtTheAngleWithinTheStatedError) {
  std::mt19937_64 random(kSeed + 1);
  for (int loop = 0; loop < 600; ++loop) {
    CellPoint d;
    for (Rational& x : d)
      x = q(static_cast<int>(random() % 19) - 9, 1 + static_cast<int>(random() % 5));
    if (d == CellPoint{}) d[2] = q(3);
    Rational degrees(Integer(1 + random() % 360000), Integer(1000));
    if (loop % 4 == 0) degrees = q(1 + static_cast<int>(random() % 72)) * q(5);
    if (loop % 50 == 1) degrees = Rational::power_of_two(-60);
    if (loop % 50 == 2) degrees = q(360) - Rational::power_of_two(-60);
    SCOPED_TRACE("seed " + std::to_string(kSeed + 1) + ", degrees " + degrees.to_string() +
                 ", axis " + d[0].to_string() + " " + d[1].to_string() + " " + d[2].to_string());
    const Turn turn = make_turn(d, degrees).value();
    const Rational square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    const long double length = std::sqrt(number(square));
    const auto angle = [&](const HalfTurn& h) {
      return 2 * std::atan2(number(h.b) * length, number(h.a)) * 180 / kPi;
    };
    EXPECT_LE(turn.error, Rational::power_of_two(-43));
    const long double off = std::abs(angle(turn.stops.back()) - number(degrees));
    EXPECT_LE(off, number(turn.error) + 1e-16L * number(degrees));
    EXPECT_EQ(turn.stops.front(), (HalfTurn{q(1), q(0)}));
    for (std::size_t i = 1; i < turn.stops.size(); ++i) {
      const HalfTurn &p = turn.stops[i - 1], &r = turn.stops[i];
      EXPECT_EQ((p.a * r.a + p.b * r.b * square).sign(), Sign::kPositive);
      EXPECT_EQ((p.a * r.b - p.b * r.a).sign(), Sign::kPositive);
    }
  }
}

TEST(AxisTurn, QuartersAreExactWhereTheLengthIsRational) {
  for (const CellPoint& d : {CellPoint{q(0), q(0), q(7)}, CellPoint{q(1), q(2), q(2)}})
    for (const int degrees : {90, 180, 270, 360})
      EXPECT_EQ(make_turn(d, q(degrees)).value().error, q(0)) << degrees;
  const CellPoint skew = {q(1), q(1), q(0)};
  EXPECT_EQ(make_turn(skew, q(180)).value().error, q(0));
  EXPECT_EQ(make_turn(skew, q(360)).value().error, q(0));
  EXPECT_GT(make_turn(skew, q(90)).value().error, q(0));
  EXPECT_FALSE(make_turn({}, q(90)));
  EXPECT_FALSE(make_turn(skew, q(0)));
  EXPECT_FALSE(make_turn(skew, q(361)));
}

TEST(Rotation, IsExactlyARotationThatKeepsItsAxis) {
  std::mt19937_64 random(kSeed + 2);
  for (int loop = 0; loop < 100; ++loop) {
    const auto draw = [&] {
      return q(static_cast<int>(random() % 41) - 20, 1 + static_cast<int>(random() % 6));
    };
    TurnAxis axis{{draw(), draw(), draw()}, {draw(), draw(), q(1)}};
    const Rational degrees = draw() * q(37);
    SCOPED_TRACE("seed " + std::to_string(kSeed + 2) + ", loop " + std::to_string(loop));
    const Rotation rotation = make_rotation(axis, degrees).value();
    EXPECT_EQ(distance_from_rotation(rotation.placement), q(0));
    EXPECT_EQ(determinant(rotation.placement), q(1));
    const Placement back = make_rotation(axis, -degrees).value().placement;
    EXPECT_TRUE(rotation.error != q(0) || after(back, rotation.placement) == Placement{});
    for (const Rational& t : {q(0), q(5, 3)}) {
      CellPoint p = axis.point;
      for (std::size_t k = 0; k < 3; ++k) p[k] += t * axis.direction[k];
      for (std::size_t i = 0; i < 3; ++i) {
        Rational image = rotation.placement.shift[i];
        for (std::size_t j = 0; j < 3; ++j) image += rotation.placement.linear[i][j] * p[j];
        EXPECT_EQ(image, p[i]);
      }
    }
    // The trace is 1 + 2 cos.
    const auto& m = rotation.placement.linear;
    EXPECT_NEAR(static_cast<double>(number(m[0][0] + m[1][1] + m[2][2])),
                1 + 2 * std::cos(static_cast<double>(number(degrees) * kPi / 180)), 1e-12);
  }
}

// Every point of the volume is as far from the axis, and as far along it, as the profile's: polynomial identities.
TEST(Revolved, PointsStayOnTheirCircles) {
  std::mt19937_64 random(kSeed + 3);
  for (int loop = 0; loop < 40; ++loop) {
    const auto draw = [&] {
      return q(static_cast<int>(random() % 21) - 10, 1 + static_cast<int>(random() % 3));
    };
    const TurnAxis axis{{draw(), draw(), draw()}, {draw(), draw(), q(2)}};
    const CellSurface profile = unit_square({q(40), q(50), q(60)});
    const Rational degrees = loop % 3 == 0 ? q(360) : q(1 + static_cast<int>(random() % 359));
    SCOPED_TRACE("seed " + std::to_string(kSeed + 3) + ", loop " + std::to_string(loop));
    const CellVolume volume =
        revolved(profile, axis, make_turn(axis.direction, degrees).value()).value();
    const auto measures = [&](const std::vector<Rational>& p) {
      CellPoint y;
      Rational along, square;
      for (std::size_t k = 0; k < 3; ++k) {
        y[k] = p[k] - axis.point[k];
        along += y[k] * axis.direction[k];
        square += y[k] * y[k];
      }
      return std::pair(along, square);
    };
    for (int n = 0; n < 8; ++n) {
      const Rational u = q(static_cast<int>(random() % 8), 7),
                     v = q(static_cast<int>(random() % 8), 7);
      const Rational w = volume.axis(2).domain_end() * q(static_cast<int>(random() % 100), 99);
      EXPECT_EQ(measures(point(volume, {u, v, w}).value()),
                measures(point(profile, {u, v}).value()));
    }
    const CellSurface begin = side_of(volume, 2, 0), end = side_of(volume, 2, 1);
    EXPECT_TRUE(volume_test::are_equal(begin, profile));
    EXPECT_EQ(begin == end, degrees == q(360));
    for (const Rational& w : volume.component(3)) EXPECT_EQ(w.sign(), Sign::kPositive);
  }
}

TEST(Revolved, AQuarterHasTheWeightsOneOneTwo) {
  const TurnAxis z{{}, {q(0), q(0), q(1)}};
  const CellVolume half =
      revolved(unit_square({q(1), q(0), q(0)}), z, make_turn(z.direction, q(180)).value()).value();
  std::vector<Rational> weights(half.component(3).begin(), half.component(3).begin() + 5);
  EXPECT_EQ(weights, (std::vector{q(1), q(1), q(2), q(1), q(1)}));
}

TEST(Revolved, AttributesDoNotTurn) {
  const CellSurface square = unit_square({q(1), q(0), q(0)});
  std::vector<Rational> all(square.coefficients().begin(), square.coefficients().end());
  all.insert(all.end(), {q(5), q(6), q(7), q(8)});
  const CellSurface coloured(square.axes(), 4, false, all);
  const TurnAxis z{{}, {q(0), q(0), q(1)}};
  const CellVolume volume = revolved(coloured, z, make_turn(z.direction, q(360)).value()).value();
  for (const Rational& w : {q(0), q(1, 3), q(5, 2), q(4)})
    EXPECT_EQ(point(volume, {q(1, 2), q(1, 4), w}).value()[3],
              point(coloured, {q(1, 2), q(1, 4)}).value()[3]);
}

TEST(Revolved, RefusesAProfileOnOrAcrossTheAxisOnly) {
  const TurnAxis z{{}, {q(0), q(0), q(1)}};
  const Turn full = make_turn(z.direction, q(360)).value();
  EXPECT_EQ(revolved(unit_square({q(-1, 2), q(0), q(0)}), z, full).error().message,
            "surface crosses the axis of revolution: it is on one side at (u, v) = (0, 0) and on "
            "the other at "
            "(u, v) = (5/8, 0)");
  EXPECT_TRUE(revolved(unit_square({q(0), q(0), q(0)}), z, full));
  EXPECT_TRUE(revolved(unit_square({q(-1), q(0), q(0)}), z, full));
  EXPECT_TRUE(revolved(unit_square({q(-1, 2), q(1), q(0)}), z, full)) << "beside the axis";
  const CellSurface line({unit_axis(1), unit_axis(1)}, 3, false,
                         {q(0), q(0), q(0), q(0), q(0), q(0), q(0), q(0), q(0), q(1), q(2), q(3)});
  EXPECT_EQ(revolved(line, z, full).error().message, "surface lies on the axis of revolution");
  // Control points on both sides, the surface on one.
  std::vector<Rational> x = {q(1), q(1), q(-1, 2), q(-1, 2), q(1), q(1)};
  std::vector<Rational> all(x);
  all.insert(all.end(), 6, q(0));
  for (int i = 0; i < 3; ++i) all.insert(all.end(), {q(i), q(i + 10)});
  EXPECT_TRUE(revolved(CellSurface({unit_axis(2), unit_axis(1)}, 3, false, all), z, full));
}

}  // namespace
}  // namespace veritope
