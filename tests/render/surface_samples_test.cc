// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/surface_samples_internal.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/render/picture_test_util.h"

namespace veritope::internal {
namespace {

using picture_test::kWhite;

constexpr SampleRows kRows{12, 0, 12};

// Squares that cover all samples of kRows, at these depths, with normals toward the camera.
FlatScene sheets(const std::vector<double>& depths, const std::vector<Paint>& paints) {
  FlatScene scene;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const auto first = static_cast<std::uint32_t>(scene.corners.size());
    for (const auto& [x, y] : {std::pair{0, 0}, {8, 0}, {0, 8}})
      scene.corners.push_back({static_cast<double>(x), static_cast<double>(y), depths[i]});
    scene.triangles.push_back({{first, first + 1, first + 2}, paints[i], {0, 0, 127}});
  }
  return scene;
}

Colour drawn_middle(const FlatScene& scene, const std::vector<std::uint32_t>& order) {
  SurfaceSamples samples(kRows, scene);
  for (const std::uint32_t triangle : order) samples.add(triangle);
  std::vector<Colour> colours(kRows.size(), kWhite);
  samples.draw_over(kRows, true, colours);
  return colours[kRows.index(6, 6)];
}

double over(double front, double share, double behind) {
  return share * front + (1 - share) * behind;
}

TEST(SurfaceSamples, TheFourNearestLayersShow) {
  std::vector<std::uint32_t> order(6);
  std::iota(order.begin(), order.end(), 0);
  const std::vector<double> depths = {50, 10, 60, 30, 20, 40};
  std::vector<Paint> paints;
  for (int i = 0; i < 6; ++i)
    paints.push_back({{static_cast<std::uint8_t>(40 * i), 0, 0}, 102});  // 2/5
  const FlatScene scene = sheets(depths, paints);
  double expected = 255;
  for (const double red : {5 * 40.0, 3 * 40.0, 4 * 40.0, 1 * 40.0})
    expected = over(red, 0.4, expected);
  do {
    EXPECT_NEAR(drawn_middle(scene, order).red, expected, 0.51);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(SurfaceSamples, NothingShowsBehindAnOpaqueLayer) {
  const std::vector<Paint> paints = {
      {{0, 0, 0}, 128}, {{100, 0, 0}, 255}, {{0, 200, 0}, 128}, {{0, 0, 200}, 255}};
  const FlatScene scene = sheets({30, 20, 10, 40}, paints);
  std::vector<std::uint32_t> order = {0, 1, 2, 3};
  do {
    const Colour colour = drawn_middle(scene, order);
    EXPECT_NEAR(colour.red, over(0, 128 / 255.0, 100), 0.51);
    EXPECT_NEAR(colour.green, over(200, 128 / 255.0, 0), 0.51);
    EXPECT_EQ(colour.blue, 0);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(SurfaceSamples, AtEqualDepthsTheLowerNumberIsInFront) {
  const FlatScene scene = sheets({20.2, 19.9}, {{{100, 0, 0}, 255}, {{0, 100, 0}, 255}});
  EXPECT_EQ(drawn_middle(scene, {0, 1}), (Colour{100, 0, 0})) << "depths are rounded";
  EXPECT_EQ(drawn_middle(scene, {1, 0}), (Colour{100, 0, 0}));
}

// The dark samples of two rectangles side by side, or one above the other, of which the second has this normal and this
// depth.
std::size_t num_dark(bool is_above, const std::array<std::int8_t, 3>& normal, double depth) {
  FlatScene scene;
  const auto corner = [&](double x, double y, double z) {
    scene.corners.push_back(is_above ? PicturePoint{y, x, z} : PicturePoint{x, y, z});
  };
  corner(0, 0, 0), corner(2, 0, 0), corner(2, 8, 0), corner(0, 8, 0);
  corner(2, 0, depth), corner(8, 0, depth), corner(8, 8, depth), corner(2, 8, depth);
  const Paint paint{{200, 200, 200}, 255};
  for (const std::uint32_t first : {0U, 4U})
    for (const std::uint32_t turn : {1U, 2U})
      scene.triangles.push_back({{first, first + turn, first + turn + 1}, paint, {0, 0, 127}});
  scene.triangles[2].normal = scene.triangles[3].normal = normal;
  SurfaceSamples samples(kRows, scene);
  for (std::uint32_t i = 0; i < 4; ++i) samples.add(i);
  std::vector<Colour> colours(kRows.size(), kWhite);
  samples.draw_over(kRows, true, colours);
  return static_cast<std::size_t>(
      std::count_if(colours.begin(), colours.end(), [](Colour c) { return c.red < 150; }));
}

TEST(SurfaceSamples, SharpEdgesAndStepsHaveOutlinesAndOthersNot) {
  for (const bool is_above : {false, true}) {
    EXPECT_EQ(num_dark(is_above, {0, 0, 127}, 0), 0u);
    EXPECT_EQ(num_dark(is_above, {64, 0, 110}, 0), 0u) << "30 degrees";
    EXPECT_EQ(num_dark(is_above, {90, 0, 90}, 0), 4 * 12u)
        << "45 degrees; two samples on each side";
    EXPECT_EQ(num_dark(is_above, {-127, 0, 0}, 0), 4 * 12u);
    EXPECT_EQ(num_dark(is_above, {0, 0, 127}, kDeepest / 100), 0u);
    EXPECT_EQ(num_dark(is_above, {0, 0, 127}, kDeepest / 50), 4 * 12u);
  }
}

TEST(SurfaceSamples, ColoursOfSmoothTrianglesAreLinear) {
  FlatScene scene = sheets({5}, {{{9, 9, 9}}});
  scene.smooth.push_back({Colour{0, 40, 200}, Colour{240, 40, 200}, Colour{0, 40, 80}});
  scene.triangles[0].smooth = 0;
  SurfaceSamples samples(kRows, scene);
  samples.add(0);
  std::vector<Colour> colours(kRows.size(), kWhite);
  samples.draw_over(kRows, false, colours);
  // Corners are 24 samples apart, along columns and along rows.
  for (std::size_t row = 0; row < 10; ++row)
    for (std::size_t column = 0; column < 10; ++column) {
      const Colour& c = colours[kRows.index(column, row)];
      const double x = (static_cast<double>(column) + 0.5) / 24,
                   y = (static_cast<double>(row) + 0.5) / 24;
      EXPECT_NEAR(c.red, 240 * x, 0.51);
      EXPECT_EQ(c.green, 40);
      EXPECT_NEAR(c.blue, 200 - 120 * y, 0.51);
    }
}

}  // namespace
}  // namespace veritope::internal
