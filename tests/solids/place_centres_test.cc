// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/star_box/place_centres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "models/patch_shapes.h"

namespace veritope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(PlaceCentres, PutsCentresOnOppositeSidesOfTheMiddleAtTheGivenPart) {
  StarBox star{{{0, 0, 0}, {8, 4, 2}}, {}, {}};
  ASSERT_TRUE(
      place_centres({1, -2, 0}, 0.5, &star));  // in a cube: twice as far along -y as along x
  EXPECT_EQ(star.inside, (Point3d{3, 3, 1}));
  EXPECT_EQ(star.outside, (Point3d{5, 1, 1}));
}

TEST(PlaceCentres, RefusesADirectionThatDoublesDoNotHave) {
  const StarBox before{{{0, 0, 0}, {1, 1, 1}}, {7, 7, 7}, {8, 8, 8}};
  for (const Point3d& direction :
       {Point3d{0, 0, 0}, Point3d{1, kInfinity, 0}, Point3d{-kInfinity, 0, 0}}) {
    StarBox star = before;
    EXPECT_FALSE(place_centres(direction, 0.5, &star));
    EXPECT_EQ(star.inside, before.inside);
    EXPECT_EQ(star.outside, before.outside);
  }
}

// The pieces of a sphere of radius 1 around the origin, as wholes.
class OnASphere : public testing::Test {
 protected:
  PatchComplex complex_ = make_patch_complex(patch_shapes::sphere()).value();
  PieceForest forest_ = PieceForest::make(complex_).value();
};

TEST_F(OnASphere, NormalsPointOutward) {
  for (std::uint32_t n = 0; n < forest_.num_roots(); ++n) {
    const PieceForest::Id id = forest_.root(n);
    const Point3d normal = forest_.approx_normal(id), middle = approx_centre(forest_.node(id).hull);
    EXPECT_GT(normal[0] * middle[0] + normal[1] * middle[1] + normal[2] * middle[2], 0)
        << "piece " << n;
  }
}

TEST_F(OnASphere, EqualWeightsMakeEachPieceCountOne) {
  const PieceForest::Id id = forest_.root(0);
  const Point3d one = mean_normal(forest_, {id}, NormalWeight::kEqual),
                two = mean_normal(forest_, {id, id}, NormalWeight::kEqual),
                raw = mean_normal(forest_, {id}, NormalWeight::kSize);
  EXPECT_NEAR(std::hypot(one[0], one[1], one[2]), 1, 1e-12);
  EXPECT_EQ(raw, forest_.approx_normal(id));
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(two[k], 2 * one[k]);
}

TEST_F(OnASphere, CentresOnTheBorderOfTheBoxAreNone) {
  const PieceForest::Id id = forest_.root(0);
  const Box3d hull = forest_.node(id).hull;
  const double size = extent(hull);
  StarBox star{hull, {}, {}};
  for (std::size_t k = 0; k < 3; ++k) star.box.lo[k] -= size, star.box.hi[k] += size;
  ASSERT_TRUE(place_centres(mean_normal(forest_, {id}, NormalWeight::kSize), 0.75, &star));
  EXPECT_TRUE(are_centres(forest_, {id}, star));
  const StarBox good = star;
  std::swap(star.inside, star.outside);
  EXPECT_FALSE(are_centres(forest_, {id}, star));  // S1 fails: each sees the wrong side
  for (std::size_t k = 0; k < 3; ++k) {
    star = good;
    star.box.hi[k] = std::max(star.inside[k], star.outside[k]);
    EXPECT_FALSE(are_centres(forest_, {id}, star)) << "axis " << k;
  }
}

}  // namespace
}  // namespace veritope
