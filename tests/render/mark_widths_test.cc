// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/mark_widths_internal.h"

#include <gtest/gtest.h>

#include "tests/render/picture_test_util.h"

namespace veritope {
namespace {

using namespace picture_test;
using internal::FlatMark;
using internal::FlatScene;

constexpr std::size_t kEnough = 144;

FlatMark dot(double x, double y, Colour colour, unsigned layer, double radius = 9) {
  return {{x, y, 5}, {x, y, 5}, radius, colour, layer};
}
FlatMark bar(double x, double y, double x2, double y2, Colour colour, unsigned layer) {
  return {{x, y, 5}, {x2, y2, 5}, 2, colour, layer};
}
std::vector<double> widened(std::vector<FlatMark> marks) {
  FlatScene scene;
  scene.marks = std::move(marks);
  internal::widen_hidden_marks(400, 300, &scene);
  std::vector<double> out;
  for (const FlatMark& m : scene.marks) out.push_back(m.radius);
  return out;
}

TEST(MarkWidths, OfMarksThatAreSeenDoNotChange) {
  using Radii = std::vector<double>;
  EXPECT_EQ(widened({}), Radii{});
  EXPECT_EQ(widened({dot(50, 50, kRed, 1)}), Radii{9});
  EXPECT_EQ(widened({dot(50, 50, kRed, 1), dot(80, 50, kBlue, 2)}), (Radii{9, 9}));
  EXPECT_EQ(widened({dot(50, 50, kRed, 1), dot(50, 50, kRed, 2)}), (Radii{9, 9}));  // one colour
  EXPECT_EQ(widened({bar(0, 50, 300, 50, kRed, 1), dot(150, 50, kBlue, 2)}),
            (Radii{2, 9}));  // most of it is seen
  EXPECT_EQ(widened({bar(57, 50, 62, 50, kRed, 1), dot(50, 50, kRed, 2)}),
            (Radii{2, 9}));  // under a rim of its colour
}

TEST(MarkWidths, OfLayer0AreThoseOfTheScene) {
  EXPECT_EQ(widened({dot(50, 50, kRed, 0), dot(50, 50, kBlue, 0), dot(50, 50, kGrey, 1)}),
            (std::vector<double>{9, 9, 9}));
  EXPECT_EQ(widened({bar(50, 50, 51, 50, kRed, 0)}), (std::vector<double>{2}));
}

TEST(MarkWidths, OfDiscsAtOnePlaceMakeRings) {
  const auto radii = widened({dot(50, 50, kRed, 1), dot(50, 50, kBlue, 2), dot(50, 50, kGrey, 3)});
  EXPECT_EQ(radii[2], 9);
  EXPECT_GT(radii[1], radii[2] + internal::kRim + 1);
  EXPECT_GT(radii[0], radii[1] + internal::kRim + 1);
  EXPECT_LE(radii[0], 30);
}

TEST(MarkWidths, OfALineUnderAnotherOneMakeABand) {
  const auto radii = widened({bar(20, 20, 300, 200, kRed, 1), bar(20, 20, 300, 200, kBlue, 2)});
  EXPECT_EQ(radii[1], 2);
  EXPECT_GT(radii[0], 2 + internal::kRim + 1);
}

TEST(MarkWidths, OfTheOnlyTinyLineOfAColourGrow) {
  EXPECT_GE(widened({bar(50, 50, 50.1, 50, kRed, 1)})[0], 7);
  EXPECT_EQ(widened({bar(50, 50, 50.1, 50, kRed, 1), dot(50, 50, kRed, 2)})[0],
            2);  // its disc is seen
}

TEST(MarkWidths, OfMarksThatStayHiddenOrAreEverywhereDoNotChange) {
  FlatMark wall = dot(200, 150, kBlue, 2, 64);
  EXPECT_EQ(widened({dot(200, 150, kRed, 1), wall, dot(100, 150, kRed, 3)})[0], 9);
  std::vector<FlatMark> many(3000, dot(50, 50, kRed, 1));
  many.push_back(dot(50, 50, kBlue, 2));
  many.push_back(dot(150, 50, kRed, 3));
  EXPECT_EQ(widened(many)[0], 9);
}

TEST(MarkWidths, NeverExceedTheMost) {
  std::vector<FlatMark> marks;
  for (unsigned i = 0; i < 40; ++i)
    marks.push_back(dot(200, 150, {static_cast<std::uint8_t>(6 * i), 10, 20}, i + 1));
  for (const double radius : widened(marks)) EXPECT_LE(radius, 64);
  // Partly outside of the picture.
  EXPECT_LE(widened({dot(-500, 1e5, kRed, 1), dot(0, 0, kBlue, 2)})[0], 64);
}

// What the renderer makes of it: every colour of a heap of marks at one place covers a square of 12 x 12 pixels.
TEST(MarkWidths, ShowEveryColourOfAHeap) {
  Scene scene;
  scene.surfaces = {box_surface({-1, -1, -1}, {1, 1, 1}, {kGrey, 170})};
  const std::vector<Colour> colours = {kRed,          kBlue,         {0, 0, 0},
                                       {230, 159, 0}, {0, 158, 115}, {90, 60, 20}};
  for (unsigned i = 0; i < colours.size(); ++i) {
    const double shift = i % 2 == 0 ? 0 : 0.01;
    scene.markers.push_back({{0.5 + shift, 0.25, -0.5}, colours[i], 9, 20 + i});
    scene.lines.push_back({{{0.5, 0.25, -0.5}, {0.5, 0.25, -0.499}}, colours[i], 4, 1 + i});
  }
  const Image image = draw_scene(scene, {}).value();
  for (const Colour& c : colours) EXPECT_GE(count_of(image, c), kEnough);
  PictureOptions three;
  three.jobs = 3;
  EXPECT_EQ(draw_scene(scene, three).value().pixels == image.pixels, true);
  for (SceneMarker& m : scene.markers) m.layer = 0;
  for (SceneLine& l : scene.lines) l.layer = 0;
  const Image flat = draw_scene(scene, {}).value();
  EXPECT_EQ(std::all_of(colours.begin(), colours.end(),
                        [&](const Colour& c) { return count_of(flat, c) >= kEnough; }),
            false);
}

}  // namespace
}  // namespace veritope
