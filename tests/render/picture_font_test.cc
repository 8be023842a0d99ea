// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/picture_font.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/render/picture_test_util.h"

namespace veritope {
namespace {

using picture_test::box_of_ink;
using picture_test::kWhite;

constexpr Colour kInk{40, 40, 40};

Image text_image(std::string_view text, std::size_t scale, std::size_t width, std::size_t height) {
  Image image(width, height, kWhite);
  draw_text({0, 0, scale}, text, kInk, &image);
  return image;
}

TEST(PictureFont, AllPrintableCharactersDiffer) {
  std::set<std::vector<int>> seen;
  for (char c = ' '; c <= '~'; ++c) {
    std::vector<int> glyph;
    for (const Colour& p : text_image(std::string(1, c), 1, kGlyphColumns, kGlyphRows).pixels)
      glyph.push_back(p == kInk ? 1 : 0);
    EXPECT_TRUE(seen.insert(glyph).second) << c;
  }
}

TEST(PictureFont, GlyphsLeaveTheLastColumnAndRowOfTheirCellsEmpty) {
  for (char c = '!'; c <= '~'; ++c) {
    const auto box = box_of_ink(text_image(std::string(1, c), 1, 20, 20));
    ASSERT_TRUE(box) << c;
    EXPECT_LT(box->right, kGlyphColumns) << c;
    EXPECT_LT(box->bottom, kGlyphRows) << c;
  }
  EXPECT_FALSE(box_of_ink(text_image(" ", 1, 20, 20)));
}

TEST(PictureFont, CapitalsAndDigitsStandOnTheBaseLine) {
  for (const char c : std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789")) {
    const auto box = box_of_ink(text_image(std::string(1, c), 1, 20, 20));
    ASSERT_TRUE(box);
    EXPECT_EQ(box->top, 0u) << c;
    EXPECT_EQ(box->bottom, kGlyphRowsAboveBase) << c;
  }
}

TEST(PictureFont, ScalesEachPixelToASquare) {
  const std::string_view text = "Mesh #7: g";
  const Image small = text_image(text, 1, 80, 12), large = text_image(text, 3, 240, 36);
  for (std::size_t y = 0; y < large.height; ++y)
    for (std::size_t x = 0; x < large.width; ++x) EXPECT_EQ(large.at(x, y), small.at(x / 3, y / 3));
  EXPECT_EQ(text_columns(text, 3), text.size() * kGlyphColumns * 3);
}

TEST(PictureFont, ACharacterOfUtf8IsOneBox) {
  EXPECT_EQ(text_columns("a\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80z", 1), 5 * kGlyphColumns);
  const Image euro = text_image("\xe2\x82\xac", 1, 20, 20), tab = text_image("\t", 1, 20, 20);
  EXPECT_EQ(euro.pixels, tab.pixels);
  EXPECT_EQ(picture_test::count_of(euro, kInk), 20u);
}

TEST(PictureFont, ShortensWhatIsTooWide) {
  EXPECT_EQ(shortened_text("abcdef", 1, 36), "abcdef");
  EXPECT_EQ(shortened_text("abcdefg", 1, 36), "abc...");
  EXPECT_EQ(shortened_text("abcdefg", 2, 72), "abc...");
  EXPECT_EQ(shortened_text("abcdefg", 1, 41), "abc...");
  EXPECT_EQ(shortened_text("abcdefg", 1, 18), "...");
  EXPECT_EQ(shortened_text("abcdefg", 1, 12), "..");
  EXPECT_EQ(shortened_text("abcdefg", 1, 0), "");
  EXPECT_EQ(shortened_text("\xc3\xa4\xc3\xb6\xc3\xbc\xc3\xa4\xc3\xb6\xc3\xbc\xc3\xa4", 1, 36),
            "\xc3\xa4\xc3\xb6\xc3\xbc...");
}

TEST(PictureFont, DrawsNothingOutsideOfTheImage) {
  Image image(10, 5, kWhite);
  draw_text({4, 3, 2}, "EEEEEEEE", kInk, &image);
  draw_text({400, 300, 2}, "E", kInk, &image);
  const auto box = box_of_ink(image);
  ASSERT_TRUE(box);
  EXPECT_EQ(box->left, 4u);
  EXPECT_EQ(box->right, 10u);
  EXPECT_EQ(box->bottom, 5u);
}

}  // namespace
}  // namespace veritope
