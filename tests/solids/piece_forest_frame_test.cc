// SPDX-License-Identifier: LGPL-3.0-or-later
// The frame of a PieceForest, and the roots into which it cuts patches.
#include "solids/pieces/piece_forest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/solids/exact_nodes.h"

namespace veritope {
namespace {

Patches moved(Patches patches, const Rational& factor, const PatchPoint& by) {
  return patch_shapes::placed(patches, factor, by);
}

TEST(PieceForestFrame, IsPlainOnRequestAndFittedToWhatIsFarOrFlat) {
  using Choice = PieceForest::FrameChoice;
  const Rational zero, one(1), third = one / Rational(3);
  const auto frame_of = [](const Patches& patches, Choice choice) {
    const PatchComplex complex = complex_of(patches);
    return PieceForest::make(complex, choice).value().frame();
  };
  const Patches near = moved(unit_box(), third, {third, zero, zero});
  const Patches far = moved(unit_box(), one, {Rational(1000), zero, zero});
  const Patches flat_box = patch_shapes::box({zero, zero, zero}, {one, one, one / Rational(100)});
  for (const Choice choice : {Choice::kPlain, Choice::kFitted})
    EXPECT_TRUE(frame_of(near, choice).is_plain());
  EXPECT_TRUE(frame_of(far, Choice::kPlain).is_plain());
  EXPECT_TRUE(frame_of(flat_box, Choice::kPlain).is_plain());
  EXPECT_FALSE(frame_of(far, Choice::kFitted).is_plain());
  EXPECT_FALSE(frame_of(flat_box, Choice::kFitted).is_plain());
  PieceForest::Frame frame;
  EXPECT_TRUE(frame.is_plain());
  for (std::size_t k = 0; k < 3; ++k) {
    PieceForest::Frame other = frame;
    other.shift[k] = one;
    EXPECT_FALSE(other.is_plain());
    other = frame;
    other.scale[k] = 1;
    EXPECT_FALSE(other.is_plain());
  }
  const PatchComplex complex = complex_of(far);
  EXPECT_THROW((void)PieceForest::make(complex).value().scale(), InternalError);
}

TEST(PieceForestFrame, GoesToAPatchThatIsTinyBesideTheModel) {
  const Rational one(1), third = one / Rational(3);
  // A box within the model, 2^40 times smaller: its patches are the smallest.
  const Patches tiny = moved(unit_box(), Rational::power_of_two(-40), {third, third, third});
  for (const bool is_first : {false, true}) {
    const PatchComplex complex = complex_of(is_first ? patch_shapes::joined({tiny, unit_box()})
                                                     : patch_shapes::joined({unit_box(), tiny}));
    const PieceForest forest = PieceForest::make(complex).value();
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational at = forest.frame().shift[k];
      EXPECT_TRUE(third - Rational::power_of_two(-39) <= at &&
                  at <= third + Rational::power_of_two(-39))
          << k;
    }
  }
}

// A part bends by no more than its width: a half bends by a quarter.
TEST(PieceForestRoots, CutTheRimOfAThinWallAlongItsLengthOnly) {
  struct Rim {
    std::array<int, 3> x, y;  // the control points of the bent side
    Rational width;
    int bits;  // of the number of parts
  };
  const Rational wide = Rational(1) / Rational(15), narrow = Rational(1) / Rational(17);
  for (const Rim& rim :
       {Rim{{0, 1, 2}, {0, 0, 0}, wide, 0}, Rim{{0, 1, 2}, {0, 1, 0}, Rational(20), 0},
        Rim{{0, 1, 2}, {0, 1, 0}, wide, 2}, Rim{{0, 1, 2}, {0, 1, 0}, narrow, 3},
        Rim{{0, 0, 0}, {0, 1, 0}, wide, 2}})  // the ends are one point
    for (const std::array<int, 3>& weights : {std::array{1, 1, 1}, {8, 1, 1}})
      for (const std::size_t length : {0, 1}) {
        std::vector<Rational> c;
        for (std::size_t component = 0; component < 4; ++component)
          for (std::size_t n = 0; n < 6; ++n) {
            const std::size_t i = length == 0 ? n / 2 : n % 3, side = length == 0 ? n % 2 : n / 3;
            const Rational values[4] = {Rational(rim.x[i]), Rational(rim.y[i]),
                                        side == 0 ? Rational(0) : rim.width, Rational(1)};
            c.push_back(Rational(weights[i]) * values[component]);
          }
        const bool is_rational = weights[0] != 1;
        if (!is_rational) c.resize(18);
        const Patch patch =
            make_patch(BezierSurface<Rational>({length == 0 ? 2 : 1, length == 0 ? 1 : 2},
                                               is_rational ? 4 : 3, is_rational, c))
                .value();
        const PatchComplex complex = complex_of({patch});
        const PieceForest forest =
            PieceForest::make(complex, PieceForest::FrameChoice::kWhole).value();
        EXPECT_EQ(forest.form(0).root_bits[length], rim.bits);
        EXPECT_EQ(forest.form(0).root_bits[1 - length], 0);
        if (rim.width < Rational(1)) {  // elsewhere roots are as long as wide
          const PieceForest plain =
              PieceForest::make(complex, PieceForest::FrameChoice::kPlain).value();
          EXPECT_GT(plain.form(0).root_bits[length], 3);
        }
      }
}

// A straight rim, 700 times as long as wide, is cut along its length iff the wall bends.
TEST(PieceForestFrame, CutsStraightRimsAlongTheirLengthWhereWallsBend) {
  const Rational width = Rational(3) * Rational::power_of_two(-11), one(1);
  for (const bool bends : {false, true})
    for (const bool is_turned : {false, true}) {
      const Patch rim = bilinear({{{0, 0, 0}, {one, 0, 0}, {one, 0, width}, {0, 0, width}}});
      // The wall beside the rim's lower side: its other end is a parabola.
      std::vector<Rational> c;
      for (std::size_t k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 2; ++j)
            c.push_back(k == 0   ? Rational(i) / Rational(2)
                        : k == 1 ? Rational(1 - j)
                                 : Rational(bends && i == 1 && j == 0 ? 1 : 0));
      const Patch wall = make_patch(BezierSurface<Rational>({2, 1}, 3, false, c)).value();
      const Patches patches{is_turned ? turned(rim, 1) : rim, reversed(wall)};
      const PatchComplex complex = complex_of(patches);
      const PieceForest forest =
          PieceForest::make(complex, PieceForest::FrameChoice::kWhole).value();
      const auto& bits = forest.form(0).root_bits;
      EXPECT_EQ(bits[is_turned ? 1 : 0], bends ? 4 : 0) << is_turned;
      EXPECT_EQ(bits[is_turned ? 0 : 1], 0) << is_turned;
    }
}

// Coordinates in the frame are at most 2, whatever the model's are; powers of two cancel.
TEST(PieceForestFrame, TakesWeightsAndCoordinatesOfAnySize) {
  Random random(5);
  const Patch sheet = bent_sheet({false, 2, 1}, true, 0, 1, random);
  for (const int bits : {-1000, 0, 1000}) {
    Patch::Tensor map = sheet.tensor();
    for (int c = 0; c < 4; ++c)
      for (Rational& v : map.component(c)) v *= Rational::power_of_two(bits);
    const PatchComplex complex = both_sides(make_patch(std::move(map)).value());
    const auto forest = PieceForest::make(complex);
    ASSERT_TRUE(forest.has_value()) << bits;
    EXPECT_LT(extent(forest.value().node(0).hull), 4) << bits;
  }
  for (const int bits : {-900, 900}) {
    const PatchComplex complex = both_sides(moved({sheet}, Rational::power_of_two(bits), {})[0]);
    const auto forest = PieceForest::make(complex);
    ASSERT_TRUE(forest.has_value()) << bits;
    EXPECT_GT(extent(forest.value().node(0).hull), 0.125) << bits;
  }
  const PatchComplex complex = both_sides(moved({sheet}, Rational::power_of_two(1100), {})[0]);
  EXPECT_FALSE(PieceForest::make(complex).has_value());
}

TEST(PieceForestFrame, BoxesGoBackToTheModelRoundedOutward) {
  const Rational one(1), third = one / Rational(3);
  const PatchComplex complex = complex_of(moved(unit_box(), third, {Rational(100), third, third}));
  const PieceForest forest = PieceForest::make(complex).value();
  const double infinity = std::numeric_limits<double>::infinity();
  const Box3d framed{{0.1, -0.3, 0.7}, {0.3, 0.9, infinity}};
  const Box3d box = forest.in_model(framed);
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational low = forest.in_model(k, framed.lo[k]);
    EXPECT_EQ(forest.in_frame(k, low), from(framed.lo[k]));
    EXPECT_TRUE(from(box.lo[k]) <= low);
    EXPECT_TRUE(low < from(std::nextafter(box.lo[k], infinity)));
    if (k == 2) continue;
    const Rational high = forest.in_model(k, framed.hi[k]);
    EXPECT_TRUE(high <= from(box.hi[k]));
    EXPECT_TRUE(from(std::nextafter(box.hi[k], -infinity)) < high);
  }
  EXPECT_EQ(box.hi[2], infinity);
  const Box3d other = forest.in_model(Box3d{{0, 0, -infinity}, {1, 1, 1}});
  EXPECT_EQ(other.lo[2], -infinity);
}

}  // namespace
}  // namespace veritope
