// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/png.h"

#include <gtest/gtest.h>

#include <set>

#include "robust/base/check.h"
#include "robust/base/random.h"
#include "tests/render/png_decoder.h"

namespace veritope {
namespace {

using picture_test::decoded_png;

Image noise(std::size_t width, std::size_t height, std::uint64_t seed) {
  Random random(seed);
  Image image(width, height, Colour{});
  for (Colour& c : image.pixels)
    c = {static_cast<std::uint8_t>(random.below(256)), static_cast<std::uint8_t>(random.below(256)),
         static_cast<std::uint8_t>(random.below(256))};
  return image;
}

// Each of the five filters is the best one for some rows.
Image smooth(std::size_t width, std::size_t height) {
  Image image(width, height, Colour{});
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t kind = y / 4 % 5;
      const std::size_t value = kind == 0   ? (x * x * 37 + y * 11) % 7
                                : kind == 1 ? 3 * x
                                : kind == 2 ? x * x * 13
                                : kind == 3 ? x * x / 9 + y * y / 5
                                            : x * x / 3 + y * 7;
      image.at(x, y) = {static_cast<std::uint8_t>(value), static_cast<std::uint8_t>(value / 2),
                        static_cast<std::uint8_t>(255 - value)};
    }
  return image;
}

void expect_round_trip(const Image& image) {
  const auto back = decoded_png(png_bytes(image));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->width, image.width);
  EXPECT_EQ(back->height, image.height);
  EXPECT_EQ(back->pixels, image.pixels);
}

TEST(Png, AnIndependentDecoderReadsTheSamePixels) {
  expect_round_trip(Image(1, 1, Colour{1, 2, 3}));
  expect_round_trip(Image(300, 1, Colour{255, 0, 255}));
  expect_round_trip(Image(1, 300, Colour{0, 0, 0}));
  expect_round_trip(smooth(200, 120));
  for (std::uint64_t seed = 1; seed <= 5; ++seed) expect_round_trip(noise(17 * seed, 31, seed));
}

TEST(Png, HasTheChunksOfAnSrgbImage) {
  const auto chunks = picture_test::png_chunks(png_bytes(noise(3, 2, 7)));
  ASSERT_TRUE(chunks);
  ASSERT_EQ(chunks->size(), 4u);
  EXPECT_EQ((*chunks)[0].data, std::string("\0\0\0\x03\0\0\0\x02\x08\x02\0\0\0", 13));
  EXPECT_EQ((*chunks)[1].type, "sRGB");
  EXPECT_EQ((*chunks)[2].type, "IDAT");
  EXPECT_EQ((*chunks)[3].type, "IEND");
}

TEST(Png, AChangedByteIsNoticedByTheCheckSums) {
  const std::string bytes = png_bytes(noise(9, 9, 3));
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 0x10);
    EXPECT_FALSE(decoded_png(changed)) << "byte " << i;
  }
}

TEST(Png, ChoosesTheFilterForEachRow) {
  const Image image = smooth(64, 60);
  const auto chunks = picture_test::png_chunks(png_bytes(image));
  ASSERT_TRUE(chunks);
  const auto rows = picture_test::inflated((*chunks)[2].data, 60 * (1 + 3 * 64));
  ASSERT_TRUE(rows);
  std::set<int> filters;
  for (std::size_t y = 0; y < 60; ++y) filters.insert((*rows)[y * (1 + 3 * 64)]);
  EXPECT_GE(filters.size(), 4u);
}

TEST(Png, RefusesImagesThatPngCannotHold) {
  EXPECT_THROW((void)png_bytes(Image()), InternalError);
  EXPECT_THROW((void)png_bytes(Image(0, 5, Colour{})), InternalError);
  Image torn(2, 2, Colour{});
  torn.pixels.pop_back();
  EXPECT_THROW((void)png_bytes(torn), InternalError);
}

}  // namespace
}  // namespace veritope
