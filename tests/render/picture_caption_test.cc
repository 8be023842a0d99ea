// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/picture_caption_internal.h"

#include <gtest/gtest.h>

#include "tests/render/picture_test_util.h"

namespace veritope::internal {
namespace {

using namespace picture_test;

Image drawn_captions(const Scene& scene, std::size_t width, std::size_t height) {
  Image image(width, height, kWhite);
  CaptionLayout(scene, width, height).draw(&image);
  return image;
}
bool is_inside(const PixelBox& box, double left, double top, double right, double bottom) {
  return static_cast<double>(box.left) >= left && static_cast<double>(box.top) >= top &&
         static_cast<double>(box.right) <= right && static_cast<double>(box.bottom) <= bottom;
}

TEST(CaptionLayout, WithoutTextTheRoomIsThePictureWithoutItsMargin) {
  const Scene scene;
  const PictureBox room = CaptionLayout(scene, 1200, 900).room();
  EXPECT_EQ(room.left, 16);
  EXPECT_EQ(room.top, 16);
  EXPECT_EQ(room.right, 1184);
  EXPECT_EQ(room.bottom, 884);
  EXPECT_FALSE(box_of_ink(drawn_captions(scene, 1200, 900)));
}

TEST(CaptionLayout, TitleAndLegendLieOutsideOfTheRoom) {
  Scene scene;
  scene.title = {"part.stl: INVALID", "seen from the front"};
  const PictureBox with_title = CaptionLayout(scene, 600, 450).room();
  auto box = box_of_ink(drawn_captions(scene, 600, 450));
  ASSERT_TRUE(box);
  EXPECT_TRUE(is_inside(*box, 8, 8, 592, with_title.top));
  EXPECT_EQ(with_title.bottom, 442);
  scene.title.clear();
  scene.legend = {{kRed, "first"}, {kBlue, "second"}};
  const PictureBox with_legend = CaptionLayout(scene, 600, 450).room();
  box = box_of_ink(drawn_captions(scene, 600, 450));
  ASSERT_TRUE(box);
  EXPECT_TRUE(is_inside(*box, 8, with_legend.bottom, 592, 442));
  EXPECT_EQ(with_legend.top, 8);
}

TEST(CaptionLayout, EachEntryHasASquareOfExactlyItsColour) {
  Scene scene;
  scene.legend = {{kRed, "first"}, {kBlue, "second"}, {kGrey, "third"}};
  for (const std::size_t scale : {1, 2, 3}) {
    const Image image = drawn_captions(scene, 600 * scale, 450 * scale);
    for (const LegendEntry& entry : scene.legend) {
      EXPECT_EQ(count_of(image, entry.colour), 49 * scale * scale);
      const auto box = box_of_colour(image, entry.colour);
      ASSERT_TRUE(box);
      EXPECT_EQ(box->width(), 7 * scale);
    }
  }
}

TEST(CaptionLayout, TooManyEntriesEndWithTheirNumber) {
  Scene scene;
  for (int i = 0; i < 100; ++i)
    scene.legend.push_back({{static_cast<std::uint8_t>(100 + i), 0, 0},
                            "a rule with quite a long name, number " + std::to_string(i)});
  const Image image = drawn_captions(scene, 600, 450);
  int num_shown = 0;
  for (const LegendEntry& entry : scene.legend)
    if (count_of(image, entry.colour) > 0) ++num_shown;
  // 150 rows of pixels hold twelve lines of two entries; the last place has the text.
  EXPECT_EQ(num_shown, 23);
  Scene expected;
  expected.legend.assign(scene.legend.begin(), scene.legend.begin() + 23);
  expected.legend.push_back({kWhite, ""});
  Image other = drawn_captions(expected, 600, 450);
  EXPECT_NE(other.pixels, image.pixels);
  EXPECT_GE(CaptionLayout(scene, 600, 450).room().height(), 450 / 2);
}

TEST(CaptionLayout, LongTextIsShortened) {
  Scene scene;
  scene.title = {std::string(1000, 'm')};
  scene.legend = {{kRed, std::string(1000, 'w')}};
  const auto box = box_of_ink(drawn_captions(scene, 300, 200));
  ASSERT_TRUE(box);
  EXPECT_LE(box->right, 292u);
}

TEST(CaptionLayout, TheSmallestPictureHasRoomLeft) {
  Scene scene;
  scene.title.assign(50, "title");
  scene.legend.assign(50, {kRed, "a long text that has no place"});
  const PictureBox room = CaptionLayout(scene, 64, 64).room();
  EXPECT_GE(room.width(), 16);
  EXPECT_GE(room.height(), 8);
}

}  // namespace
}  // namespace veritope::internal
