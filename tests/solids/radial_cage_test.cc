// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/cage/radial_cage.h"

#include <gtest/gtest.h>

#include <random>

#include "solids/volumes/placed.h"
#include "tests/solids/cage_support.h"
#include "tests/solids/volume_support.h"

namespace veritope {
namespace {

using namespace cage_test;

constexpr std::uint64_t kSeed = 2211;

RadialShape shape_of(Rational inner, Rational outer) {
  RadialShape shape;
  shape.inner = std::move(inner);
  shape.outer = std::move(outer);
  shape.low = q(-1);
  shape.high = q(2);
  return shape;
}

Rational dot_product(const CellPoint& a, const CellPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
// The square of the distance from the axis, and the place along it in terms of its direction.
std::array<Rational, 2> seen_from(const TurnAxis& axis, const CellPoint& p) {
  CellPoint from;
  for (std::size_t k = 0; k < 3; ++k) from[k] = p[k] - axis.point[k];
  const Rational square = dot_product(axis.direction, axis.direction),
                 place = dot_product(from, axis.direction) / square;
  return {dot_product(from, from) - place * place * square, place};
}

TEST(RadialCage, CirclesAreExact) {
  const RadialShape shape = shape_of(q(1, 2), q(3));
  const CellVolume cell = radial_cage(shape).value().cell;
  EXPECT_EQ(cell.axis(0).degree, 1);
  EXPECT_EQ(cell.axis(1).degree, 2);
  EXPECT_EQ(cell.axis(2).degree, 1);
  EXPECT_EQ(cell.axis(1).domain_end(), q(4));
  EXPECT_EQ(image(cell, {q(1), q(0), q(0)}), at(q(3), q(0), q(-1)));
  EXPECT_EQ(image(cell, {q(0), q(1), q(1)}), at(q(0), q(1, 2), q(2)));
  for (int i = 0; i <= 40; ++i) {
    const auto [outer, low] = seen_from(shape.axis, image(cell, {q(1), q(i, 10), q(0)}));
    const auto [inner, high] = seen_from(shape.axis, image(cell, {q(0), q(i, 10), q(1)}));
    EXPECT_EQ(outer, q(9));
    EXPECT_EQ(inner, q(1, 4));
    EXPECT_EQ(low, q(-1));
    EXPECT_EQ(high, q(2));
  }
}

TEST(RadialCage, FullTurnsAreGluedToThemselves) {
  const VModel ring = model_of({radial_cage(shape_of(q(1), q(2))).value().cell});
  EXPECT_EQ(ring.face(0, 2).mate, 3u);
  EXPECT_EQ(ring.counts().internal, 1u);
  EXPECT_EQ(volume_test::signs_of_jacobian(ring.cell(0))[0], 1);

  const VModel disc = model_of({radial_cage(shape_of(q(0), q(2))).value().cell});
  EXPECT_EQ(disc.face(0, 2).mate, 3u);
  EXPECT_TRUE(disc.face(0, 0).is_collapsed());
  EXPECT_TRUE(disc.forbidden().empty());

  RadialShape shape = shape_of(q(1), q(2));
  shape.degrees = q(100);
  const VModel sector = model_of({radial_cage(shape).value().cell});
  EXPECT_EQ(sector.counts().internal, 0u);
  EXPECT_EQ(sector.counts().boundary, 6u);
}

TEST(RadialCage, RingsDiscsAndSectorsAreCertified) {
  for (const Rational& inner : {q(0), q(1, 3)})
    for (const bool is_sector : {false, true}) {
      RadialShape shape = shape_of(inner, q(2));
      shape.axis = {at(q(1), q(0), q(-2)), at(q(1), q(2), q(3))};
      if (is_sector) shape.degrees = q(200);
      const Certified answer = certified({radial_cage(shape).value().cell});
      ASSERT_EQ(answer.verdict, Verdict::kValid);
      const PatchFacts& facts = std::get<PatchFacts>(answer.facts);
      EXPECT_EQ(facts.genus, inner.sign() == Sign::kPositive && !is_sector ? 1u : 0u);
      EXPECT_EQ(facts.vmodel->singular.empty(), inner.sign() == Sign::kPositive);
    }
}

TEST(RadialCage, IrrationalLengthsAreRoundedOutward) {
  RadialShape shape = shape_of(q(1), q(2));
  shape.axis.direction = at(q(1), q(1), q(1));
  const CellVolume cell = radial_cage(shape).value().cell;
  const Rational near = q(1) + Rational::power_of_two(-39);
  const auto [outer, low] = seen_from(shape.axis, image(cell, {q(1), q(1, 3), q(0)}));
  EXPECT_GE(outer, q(4));
  EXPECT_LE(outer, q(4) * near);
  const auto [inner, high] = seen_from(shape.axis, image(cell, {q(0), q(7, 3), q(1)}));
  EXPECT_LE(inner, q(1));
  EXPECT_GE(inner * near, q(1));
  // |direction|^2 = 3.
  EXPECT_LE(low, q(0));
  EXPECT_GE(q(3) * low * low, q(1));
  EXPECT_LE(q(3) * low * low, near);
  EXPECT_GE(q(3) * high * high, q(4));
  EXPECT_LE(q(3) * high * high, q(4) * near);
}

TEST(RadialCage, ARotationOfTheShapeRotatesTheCell) {
  Placement turn;
  turn.linear = {at(q(3, 5), q(-4, 5), q(0)), at(q(0), q(0), q(-1)), at(q(4, 5), q(3, 5), q(0))};
  turn.shift = at(q(1), q(2), q(3));
  ASSERT_EQ(distance_from_rotation(turn), q(0));
  ASSERT_EQ(determinant(turn), q(1));
  RadialShape shape = shape_of(q(1), q(2));
  shape.axis.direction = at(q(1), q(1), q(2));
  shape.start = at(q(1), q(0), q(0));
  shape.degrees = q(77);
  RadialShape turned = shape;
  const auto rotated = [&](const CellPoint& p) {
    CellPoint out;
    for (std::size_t k = 0; k < 3; ++k) out[k] = dot_product(turn.linear[k], p);
    return out;
  };
  turned.axis = {turn.shift, rotated(shape.axis.direction)};
  turned.start = rotated(*shape.start);
  EXPECT_EQ(radial_cage(turned).value().cell, placed(radial_cage(shape).value().cell, turn));
}

TEST(RadialCage, ContainsWhatItIsMadeAround) {
  std::mt19937_64 random(kSeed);
  const auto number = [&] { return Rational(Integer(random() % 2001), Integer(100)) - q(10); };
  for (int loop = 0; loop < 100; ++loop) {
    std::vector<CellPoint> points;
    for (int i = 0; i < 6; ++i) points.push_back(at(number(), number(), number()));
    RadialShape shape;
    shape.axis = {at(number(), number(), number()), at(number(), number(), q(21))};
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", loop " + std::to_string(loop));
    const Rational margin = loop % 2 == 0 ? q(0) : q(1, 8);
    shape = radial_shape_around(hull_of(points), shape, margin).value();
    const CellVolume cell = radial_cage(shape).value().cell;
    const auto [radius, low] = seen_from(shape.axis, image(cell, {q(1), q(0), q(0)}));
    const Rational high = seen_from(shape.axis, image(cell, {q(1), q(0), q(1)}))[1];
    Rational farthest;
    for (const CellPoint& p : points) {
      const auto [square, place] = seen_from(shape.axis, p);
      EXPECT_LE(square, radius);
      EXPECT_LE(low, place);
      EXPECT_LE(place, high);
      farthest = std::max(farthest, square);
    }
    if (loop % 2 == 0) {
      EXPECT_LE(radius, farthest * (q(1) + Rational::power_of_two(-38)));
    } else {
      EXPECT_GT(radius, farthest + margin * margin);
    }
  }
}

TEST(RadialCage, PointsInTheHoleAreFound) {
  RadialShape shape = shape_of(q(2), q(3));
  EXPECT_FALSE(first_in_hole(hull_of({at(q(2), q(0), q(0)), at(q(0), q(5, 2), q(1))}), shape));
  EXPECT_EQ(first_in_hole(hull_of({at(q(2), q(0), q(0)), at(q(1), q(1), q(1))}), shape), 1u);
  shape.inner = q(0);
  EXPECT_FALSE(first_in_hole(hull_of({at(q(0), q(0), q(0))}), shape));
}

TEST(RadialCage, RefusesWhatIsNoShape) {
  const auto message = [](const RadialShape& shape) {
    const auto cage = radial_cage(shape);
    return cage ? std::string() : cage.error().message;
  };
  RadialShape shape = shape_of(q(2), q(2));
  EXPECT_EQ(message(shape), "inner must be less than outer, and they are 2 and 2");
  EXPECT_EQ(message(shape_of(q(-1), q(2))), "inner must not be negative, and it is -1");
  shape = shape_of(q(1), q(2));
  shape.high = q(-1);
  EXPECT_EQ(message(shape), "low must be less than high, and they are -1 and -1");
  shape = shape_of(q(1), q(2));
  shape.degrees = q(360);
  EXPECT_EQ(message(shape), "degrees must be more than 0 and less than 360, not 360");
  shape.degrees = q(0);
  EXPECT_EQ(message(shape), "degrees must be more than 0 and less than 360, not 0");
  shape = shape_of(q(1), q(2));
  shape.start = at(q(0), q(0), q(3));
  EXPECT_EQ(message(shape), "start lies along the axis");
  shape.axis.direction = {};
  EXPECT_EQ(message(shape), "axis must not be 0");
  EXPECT_FALSE(radial_shape_around(hull_of({at(q(1), q(0), q(0))}), shape, q(0)));
}

}  // namespace
}  // namespace veritope
