// SPDX-License-Identifier: LGPL-3.0-or-later
// Pictures of fixed scenes have fixed pixels, whatever the compiler, its -O level and the number of threads. If they
// were meant to change, the failures show the new numbers: look at the pictures first.
#include <gtest/gtest.h>

#include <cmath>

#include "render/draw_scene.h"
#include "tests/render/picture_test_util.h"

namespace veritope {
namespace {

using namespace picture_test;

std::uint64_t hash_of_picture(const Scene& scene, const PictureOptions& options) {
  const Result<Image> image = draw_scene(scene, options);
  return image ? hash_of(*image) : 0;
}

// All that a picture can have.
Scene full_scene() {
  Scene scene;
  scene.surfaces = {torus_surface(160, 70, {kGrey, 140}),
                    box_surface({-0.3, -2, -0.1}, {0.4, 1.5, 0.2}, {kBlue, 230}),
                    box_surface({1, 0.3, 0.1}, {1 + 1e-9, 1.1, 1.3}, {kRed, 255})};
  SceneLine knot{{}, kRed, 4};
  for (int i = 0; i <= 240; ++i) {
    const auto [c, s] = on_circle(2 * i % 240, 240);
    const auto [u, v] = on_circle(5 * i % 240, 240);
    knot.points.push_back({(1 + 0.4 * u) * c, (1 + 0.4 * u) * s, 0.4 * v});
  }
  scene.lines = {knot, {{{1, 2, 3}}, kBlue, 6}};
  scene.markers = {{{0.1, 0.2, 0.3}, {240, 228, 66}}, {{1, 1, 1}, {0, 0, 0}, 12.5}};
  scene.title = {"A torus, a beam and a sheet", "0123456789 (+-*/=) [a_b] {c} <d> 'e' \"f\""};
  scene.legend = {{kRed, "a knot, and a sheet"},
                  {kBlue, "a beam"},
                  {{240, 228, 66}, "a point"},
                  {{0, 0, 0}, "another point"}};
  return scene;
}

TEST(DrawSceneGolden, ASceneWithEverything) {
  PictureOptions options;
  options.jobs = 2;
  EXPECT_EQ(hash_of_picture(full_scene(), options), 16465955042302127316u);
}

TEST(DrawSceneGolden, TheSameFromAboveAndSmall) {
  PictureOptions options;
  options.width = 333, options.height = 257, options.view = {1e-30, 0, -4e-30};
  EXPECT_EQ(hash_of_picture(full_scene(), options), 4003198568197446817u);
}

// Triangles of every size and direction, many of them thin.
TEST(DrawSceneGolden, RandomTriangles) {
  Random random(20251208);
  Scene scene;
  SceneSurface soup;
  const auto coordinate = [&] {
    const auto numerator = static_cast<double>(random.between(-1000000, 1000000));
    return std::ldexp(numerator, -static_cast<int>(random.below(12)));
  };
  for (std::uint32_t i = 0; i < 6000; ++i) {
    soup.points.push_back({coordinate(), coordinate(), coordinate()});
    if (i % 3 == 2) soup.triangles.push_back({i - 2, i - 1, i});
    if (i % 3 == 2)
      soup.paints.push_back({{static_cast<std::uint8_t>(random.below(256)),
                              static_cast<std::uint8_t>(random.below(256)), 90},
                             static_cast<std::uint8_t>(random.below(256))});
  }
  scene.surfaces = {soup};
  PictureOptions options;
  options.width = 600, options.height = 450;
  EXPECT_EQ(hash_of_picture(scene, options), 4396186728299707762u);
}

}  // namespace
}  // namespace veritope
