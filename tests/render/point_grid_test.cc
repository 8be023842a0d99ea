// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include "render/point_grid.h"
#include "tests/render/solid_probe_test_util.h"

namespace veritope {
namespace {

using namespace picture_test;

ExactBox<3> cube(const Rational& lo, const Rational& hi) {
  ExactBox<3> out;
  for (ExactInterval& side : out.side) side = {lo, hi};
  return out;
}

TEST(PointGrid, PointsLieInTheMiddlesOfEqualParts) {
  const PointGrid grid(cube(Rational(-1), Rational(2)), 5);
  EXPECT_EQ(grid.coordinate(0, 0), Rational(-7) / Rational(10));
  EXPECT_EQ(grid.coordinate(1, 2), Rational(1) / Rational(2));
  EXPECT_EQ(grid.coordinate(2, 4), Rational(17) / Rational(10));
}

TEST(PointGrid, KeepsMarks) {
  PointGrid grid(ExactBox<3>::unit(), 70);
  EXPECT_EQ(grid.count(GridMark::kNone), 343000u);
  grid.set(69, 0, 33, GridMark::kExcess);
  grid.set(0, 69, 31, GridMark::kIn);
  grid.set(0, 69, 32, GridMark::kIn);
  EXPECT_EQ(grid.mark(69, 0, 33), GridMark::kExcess);
  EXPECT_EQ(grid.mark(69, 0, 32), GridMark::kNone);
  EXPECT_EQ(grid.mark(0, 69, 32), GridMark::kIn);
  EXPECT_EQ(grid.count(GridMark::kIn), 2u);
  EXPECT_EQ(grid.count(GridMark::kExcess), 1u);
  EXPECT_EQ(grid.count(GridMark::kNone), 342997u);
}

GridMark expected(PointWord word) {
  return word == PointWord::kIn   ? GridMark::kIn
         : word == PointWord::kOn ? GridMark::kOn
                                  : GridMark::kNone;
}

// Each point alone, against blocks of points and boxes. The ball's radius makes points of the second grid lie on it.
TEST(ClassifyGrid, AgreesWithEachPointAlone) {
  const BallProbe ball(Rational(5));
  for (const auto& [half, n] :
       {std::pair(Rational(6), 37u), std::pair(Rational(13) / Rational(2), 13u),
        std::pair(Rational(3), 33u), std::pair(Rational(70), 34u)}) {
    const PointGrid grid = classify_grid(ball, cube(-half, half), n, 1);
    std::uint64_t on = 0;
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t k = 0; k < n; ++k) {
          const GridMark want = expected(ball.word(grid.point(i, j, k)));
          ASSERT_EQ(grid.mark(i, j, k), want) << i << " " << j << " " << k << " of " << n;
          if (want == GridMark::kOn) ++on;
        }
    EXPECT_EQ(on, n == 13 ? 30u : 0u);  // 6 of (5, 0, 0) and 24 of (3, 4, 0)
  }
}

TEST(ClassifyGrid, DoesNotDependOnThreads) {
  const BallProbe ball(Rational(1));
  const PointGrid one = classify_grid(ball, cube(Rational(-1), Rational(1)), 75, 1),
                  three = classify_grid(ball, cube(Rational(-1), Rational(1)), 75, 3);
  for (std::uint32_t i = 0; i < 75; ++i)
    for (std::uint32_t j = 0; j < 75; ++j)
      for (std::uint32_t k = 0; k < 75; ++k) ASSERT_EQ(one.mark(i, j, k), three.mark(i, j, k));
  EXPECT_EQ(one.count(GridMark::kIn), three.count(GridMark::kIn));
}

// Doubles say nothing of these bounds.
TEST(ClassifyGrid, BoundsMayBeBeyondBinary64) {
  const BallProbe ball(Rational(1));
  const Rational huge = Rational::power_of_two(2000);
  EXPECT_EQ(classify_grid(ball, cube(-huge, huge), 3, 1).count(GridMark::kIn), 1u);
  EXPECT_EQ(classify_grid(ball, cube(-huge, huge), 2, 1).count(GridMark::kIn), 0u);
  const Rational tiny = Rational::power_of_two(-2000);
  ExactBox<3> beside = cube(-tiny, tiny);
  beside[0] = {Rational(1) - tiny, Rational(1) + tiny};
  EXPECT_EQ(classify_grid(ball, beside, 2, 1).count(GridMark::kIn), 4u);
}

}  // namespace
}  // namespace veritope
