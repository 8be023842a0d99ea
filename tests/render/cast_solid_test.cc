// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "render/cast_solid.h"
#include "render/parallel_view_internal.h"
#include "tests/render/picture_test_util.h"
#include "tests/render/solid_probe_test_util.h"

namespace veritope {
namespace {

using namespace picture_test;

const Box3d kAroundBall{{-1, -1, -1}, {1, 1, 1}};

PictureOptions small_picture(std::size_t width = 96, std::size_t height = 80) {
  PictureOptions options;
  options.width = width, options.height = height;
  return options;
}

// Hashes do not depend on the compiler, its -O level and the number of threads.
TEST(CastSolid, PicturesHaveFixedPixels) {
  const BallProbe ball(Rational(1));
  PictureOptions options = small_picture();
  options.jobs = 2;
  EXPECT_EQ(hash_of(*cast_solid(ball, kAroundBall, options)), 3911348735247032907u);
  options.jobs = 1;
  EXPECT_EQ(hash_of(*cast_solid(ball, {{-1, -0.25, -1}, {1, 1, 0.5}}, options)),
            5674050307620895432u);
  ExactBox<3> around;
  for (ExactInterval& side : around.side) side = {Rational(-1), Rational(1)};
  PointGrid grid = classify_grid(ball, around, 12, 1);
  grid.set(0, 0, 0, GridMark::kExcess);
  grid.set(11, 3, 4, GridMark::kOn);
  EXPECT_EQ(hash_of(*draw_point_grid(grid, options)), 1940188529365599319u);
}

TEST(CastSolid, ABallFillsThePicture) {
  const BallProbe ball(Rational(1));
  const Image image = *cast_solid(ball, {{-5, -1, -7}, {3, 2, 1}}, small_picture(160, 160));
  const std::size_t shown = image.pixels.size() - count_of(image, kWhite);
  const double radius = 75 * 1.0;  // margins are 5 pixels wide
  EXPECT_NEAR(static_cast<double>(shown), 3.14159 * radius * radius, 3.14159 * radius * radius / 8);
}

TEST(CastSolid, NothingIsAnError) {
  const BallProbe ball(Rational(1));
  const auto code_of = [&](const Box3d& box, const PictureOptions& options) {
    const auto image = cast_solid(ball, box, options);
    return image ? Code::kInterrupted : image.error().code;
  };
  EXPECT_EQ(code_of({{2, 2, 2}, {3, 3, 3}}, small_picture()), Code::kEmpty);
  EXPECT_EQ(code_of(kAroundBall, small_picture(63, 80)), Code::kBadArgument);
  EXPECT_EQ(code_of({{-1e300, 0, 0}, {1, 1, 1}}, small_picture()), Code::kOverLimit);
  EXPECT_EQ(code_of({{0, 0, 0}, {1e-300, 1e-300, 1e-300}}, small_picture()), Code::kOverLimit);
  const FalseWallProbe none(0, 0.25);
  const auto empty = cast_solid(none, kAroundBall, small_picture());
  ASSERT_FALSE(empty);
  EXPECT_EQ(empty.error().code, Code::kEmpty);
}

TEST(DrawPointGrid, BallsHaveTheColoursOfTheirMarks) {
  PointGrid grid(ExactBox<3>::unit(), 4);
  const auto reds = [&] {
    const Image image = *draw_point_grid(grid, small_picture(200, 200));
    return std::count_if(image.pixels.begin(), image.pixels.end(),
                         [](Colour c) { return c.red > c.blue + 60 && c.red > c.green + 60; });
  };
  grid.set(0, 0, 0, GridMark::kIn);
  grid.set(3, 3, 3, GridMark::kIn);
  EXPECT_EQ(reds(), 0);
  grid.set(3, 0, 3, GridMark::kExcess);
  EXPECT_GT(reds(), 100);
}

// A ball in front hides the one behind it: seen along an axis, a line of points is one ball.
TEST(DrawPointGrid, NearBallsHideFarOnes) {
  PointGrid one(ExactBox<3>::unit(), 5), line(ExactBox<3>::unit(), 5);
  PictureOptions options = small_picture(120, 120);
  options.view = {0, 0, -1};
  for (const auto& [i, j] : {std::pair(0u, 0u), std::pair(4u, 4u)}) {
    one.set(i, j, 4, GridMark::kIn);
    for (std::uint32_t k = 0; k < 5; ++k)
      line.set(i, j, k, k < 4 ? GridMark::kExcess : GridMark::kIn);
  }
  EXPECT_EQ(draw_point_grid(one, options)->pixels, draw_point_grid(line, options)->pixels);
}

// The size of the box and its place do not matter.
TEST(DrawPointGrid, BoxesMayBeBeyondBinary64) {
  std::vector<Image> images;
  for (const int exponent : {0, 2000, -3000}) {
    ExactBox<3> bounds = ExactBox<3>::unit();
    const Rational scale = Rational::power_of_two(exponent);
    for (ExactInterval& side : bounds.side) side = {Rational(5) * scale, Rational(6) * scale};
    bounds[1].hi = Rational(11) / Rational(2) * scale;
    PointGrid grid(bounds, 6);
    for (std::uint32_t i = 0; i < 6; ++i) grid.set(i, i, 5 - i, GridMark::kIn);
    images.push_back(*draw_point_grid(grid, small_picture()));
  }
  EXPECT_LT(count_of(images[0], kWhite), images[0].pixels.size());
  EXPECT_EQ(images[0].pixels, images[1].pixels);
  EXPECT_EQ(images[0].pixels, images[2].pixels);
}

TEST(DrawPointGrid, AnEmptyGridIsWhite) {
  const PointGrid grid(ExactBox<3>::unit(), 4);
  const Image image = *draw_point_grid(grid, small_picture());
  EXPECT_EQ(count_of(image, kWhite), image.pixels.size());
}

TEST(ParallelView, TakesPointsToThePictureAndBack) {
  const internal::ParallelView view({{1e6, -3, 2}, {1e6 + 4, 5, 2.5}}, {-1, 2, -0.5},
                                    {10, 20, 90, 70});
  for (const Point3d& p : {Point3d{1e6, -3, 2}, {1e6 + 4, 5, 2.5}, {1e6 + 1, 0.5, 2.25}}) {
    const internal::SamplePoint at = view.to_picture(p);
    EXPECT_GE(at.x, 30 - 1e-6);
    EXPECT_LE(at.x, 270 + 1e-6);
    EXPECT_GE(at.y, 60 - 1e-6);
    EXPECT_LE(at.y, 210 + 1e-6);
    const Point3d back = view.to_space(at);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(back[k], p[k], 1e-8);
  }
  const internal::ParallelView fitted = view.fitted({60, 90, 120, 120}, {10, 20, 90, 70});
  const internal::SamplePoint corner = fitted.to_picture(view.to_space({60, 90, 3}));
  EXPECT_NEAR(corner.x, 30, 1e-6) << "the part is as wide as the room";
}

}  // namespace
}  // namespace veritope
