// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/picture_bands_internal.h"

#include <gtest/gtest.h>

#include "tests/render/picture_test_util.h"

namespace veritope::internal {
namespace {

using namespace picture_test;

// A sharp edge and a mark at a height, on a background.
Image edge_at(double y) {
  FlatScene scene;
  for (const auto& [top, bottom] : {std::pair{y - 8, y}, {y, y + 8}}) {
    const auto first = static_cast<std::uint32_t>(scene.corners.size());
    scene.corners.insert(scene.corners.end(),
                         {{0, top, 0}, {40, top, 0}, {40, bottom, 0}, {0, bottom, 0}});
    const std::array<std::int8_t, 3> normal = {0, first == 0 ? std::int8_t{127} : std::int8_t{0},
                                               0};
    for (const std::uint32_t turn : {1U, 2U})
      scene.triangles.push_back({{first, first + turn, first + turn + 1}, {kGrey, 255}, normal});
  }
  scene.marks.push_back({{30, y, 0}, {34, y, 0}, 3, kRed});
  Image image(40, 64, kBlue);
  draw_bands(scene, true, 1, &image);
  return image;
}

TEST(PictureBands, DoNotShow) {
  const Image reference = edge_at(24);
  for (std::size_t y = 10; y < 54; ++y) {
    const Image image = edge_at(static_cast<double>(y));
    for (std::size_t row = 0; row < 20; ++row)
      for (std::size_t x = 0; x < 40; ++x)
        EXPECT_EQ(image.at(x, y - 10 + row), reference.at(x, 14 + row)) << y << ", row " << row;
  }
}

TEST(PictureBands, KeepTheBackground) {
  Image image(70, 64, kBlue);
  draw_bands({}, true, 1, &image);
  EXPECT_EQ(count_of(image, kBlue), 70u * 64);
  const Image edge = edge_at(30);
  EXPECT_EQ(edge.at(0, 21), kBlue);
  EXPECT_EQ(edge.at(0, 38), kBlue);
  EXPECT_NE(edge.at(0, 22), kBlue);
}

TEST(PictureBands, CountTheSamplesOfEachLayer) {
  FlatScene scene;
  scene.corners = {{0, 0, 0}, {20, 0, 0}, {0, 10, 0}};
  scene.triangles.assign(5, {{0, 1, 2}, {kGrey, 255}, {0, 0, 127}});
  EXPECT_EQ(num_drawn_samples(scene), 5 * 100 * 9);
  scene.marks.assign(2, {{5, 5, 0}, {5, 15, 0}, 3, kRed});
  EXPECT_EQ(num_drawn_samples(scene), 5 * 100 * 9 + 2 * 10 * 20 * 9);
}

}  // namespace
}  // namespace veritope::internal
