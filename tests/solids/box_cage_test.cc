// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/cage/box_cage.h"

#include <gtest/gtest.h>

#include <random>

#include "solids/micro/cage/short_numbers_internal.h"
#include "solids/vmodel/jacobian_sign.h"
#include "tests/solids/cage_support.h"

namespace veritope {
namespace {

using namespace cage_test;

constexpr std::uint64_t kSeed = 2210;

TEST(BoxCage, TheMapIsAffineForEveryDegreeAndNumberOfSpans) {
  const CageBox box{at(q(-1), q(1, 3), q(2)), at(q(2), q(1), q(9, 4))};
  for (const CageGrid& grid :
       {CageGrid{}, CageGrid{{3, 1, 2}, {1, 5, 4}}, CageGrid{{15, 4, 7}, {1, 2, 3}}}) {
    const CellVolume cell = box_cage(box, grid).value();
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(cell.axis(k).degree, grid.degrees[k]);
      EXPECT_EQ(cell.axis(k).num_control(),
                grid.spans[k] + static_cast<std::uint64_t>(grid.degrees[k]));
    }
    for (const auto& part : {at(q(0), q(0), q(0)), at(q(1), q(1), q(1)),
                             at(q(1, 3), q(5, 7), q(9, 10)), at(q(1, 2), q(0), q(2, 3))}) {
      std::array<Rational, 3> parameters;
      CellPoint expected;
      for (std::size_t k = 0; k < 3; ++k) {
        parameters[k] = part[k] * Rational(grid.spans[k]);
        expected[k] = box.min[k] + part[k] * (box.max[k] - box.min[k]);
      }
      EXPECT_EQ(image(cell, parameters), expected);
    }
    EXPECT_TRUE(decide_determinants(model_of({cell})).is_proved());
  }
}

TEST(BoxCage, IsCertified) {
  const CellVolume cell =
      box_cage({at(q(0), q(0), q(0)), at(q(1), q(2), q(1, 3))}, {{3, 3, 3}, {2, 2, 2}}).value();
  const Certified answer = certified({cell});
  EXPECT_EQ(answer.verdict, Verdict::kValid);
  EXPECT_EQ(std::get<PatchFacts>(answer.facts).vmodel->volume, q(2, 3));
}

TEST(BoxCage, RefusesWhatIsNoBoxOrNoGrid) {
  const CageBox unit{at(q(0), q(0), q(0)), at(q(1), q(1), q(1))};
  const auto message = [](const CageBox& box, const CageGrid& grid) {
    const auto cell = box_cage(box, grid);
    return cell ? std::string() : cell.error().message;
  };
  EXPECT_EQ(message({unit.min, at(q(1), q(0), q(1))}, {}),
            "min must be less than max, and in y they are 0 and 0");
  EXPECT_EQ(message(unit, {{1, 16, 1}, {1, 1, 1}}), "degrees must be from 1 to 15, and one is 16");
  EXPECT_EQ(message(unit, {{1, 0, 1}, {1, 1, 1}}), "degrees must be from 1 to 15, and one is 0");
  EXPECT_EQ(message(unit, {{1, 1, 1}, {1, 1, 0}}), "spans must be from 1 to 4096, and one is 0");
  const auto large = box_cage(unit, {{1, 1, 1}, {4096, 4096, 4096}});
  EXPECT_EQ(large.error().code, Code::kOverLimit);
}

TEST(CageContent, TheBoxOfAMeshIsExact) {
  TriangleMesh mesh = box_mesh({-1, 0.1, 3}, {2, 5, 0x1p60});
  mesh.positions.push_back({100, 100, 100});  // no face has it
  const CageContent content = content_of(mesh);
  EXPECT_EQ(content.num_parts(), 12u);
  EXPECT_EQ(content.points.size(), 8u);
  const CageBox box = box_of(content);
  EXPECT_EQ(box.min, at(q(-1), Rational::from_double(0.1), q(3)));
  EXPECT_EQ(box.max, at(q(2), q(5), Rational::power_of_two(60)));
}

TEST(CageContent, PatchesLieInTheHullsOfTheirParts) {
  const std::vector<Patch> patches{
      make_patch(BezierSurface<Rational>(
                     {2, 1}, 4, true,
                     {q(0), q(0), q(3), q(3), q(2), q(2), q(0), q(1), q(0), q(1), q(0), q(2),
                      q(0), q(0), q(4), q(4), q(0), q(0), q(1), q(1), q(1), q(1), q(2), q(2)}))
          .value()};
  const CageContent content = content_of(patches);
  EXPECT_EQ(content.num_parts(), 16u);
  // Neighbours share control points, and so all parts belong together.
  EXPECT_LT(content.points.size(), content.corners.size());
  const CageBox box = box_of(content);
  for (int i = 0; i <= 8; ++i)
    for (int j = 0; j <= 8; ++j) {
      const auto p = point(patches[0].tensor(), {q(i, 8), q(j, 8)});
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_LE(box.min[k], p[k]);
        EXPECT_GE(box.max[k], p[k]);
      }
    }
}

TEST(CageContent, MarginsAreShortAndJustLargeEnough) {
  std::mt19937_64 random(kSeed);
  const auto number = [&] { return Rational(Integer(random() % 100000), Integer(997)); };
  for (int loop = 0; loop < 200; ++loop) {
    CageBox box;
    Rational square;
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational side = number();
      box.min[k] = number();
      box.max[k] = box.min[k] + side;
      square += side * side;
    }
    const Rational part = q(1, 1 + static_cast<std::int64_t>(random() % 50));
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", loop " + std::to_string(loop));
    const Rational length = margin_length(box, part);
    EXPECT_GE(length * length, square * part * part);
    const Rational less = length * q(1024, 1026);
    EXPECT_LE(less * less, square * part * part);
    EXPECT_LE(length.numerator().bit_length(), 12u);
    const CageBox larger = grown(box, length);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(larger.min[k], box.min[k] - length);
      EXPECT_EQ(larger.max[k], box.max[k] + length);
    }
  }
  EXPECT_EQ(margin_length({}, q(1)), q(0));
}

TEST(ShortNumbers, AreMultiplesNextToTheNumber) {
  EXPECT_EQ(internal::multiple_below(q(-7, 3), q(1, 2)), q(-5, 2));
  EXPECT_EQ(internal::multiple_above(q(-7, 3), q(1, 2)), q(-2));
  EXPECT_EQ(internal::multiple_above(q(3, 2), q(1, 2)), q(3, 2));
  for (const Rational& x : {q(1), q(7, 8), q(1, 3), q(1023), q(1024), q(1, 1024)}) {
    const Rational power = internal::power_of_two_below(x);
    EXPECT_LE(power, x);
    EXPECT_GT(power * q(2), x);
  }
  EXPECT_EQ(internal::short_above(q(0)), q(0));
}

}  // namespace
}  // namespace veritope
