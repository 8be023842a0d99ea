// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/byte_stream.h"

#include <gtest/gtest.h>

#include <random>

namespace veritope::certificate::internal {
namespace {

using Bytes = std::vector<unsigned char>;

TEST(ByteStream, FixedNumbersAreLittleEndian) {
  ByteWriter w;
  w.u8(7);
  w.u32(0x01020304u);
  w.i32(-2);
  const Bytes bytes = w.take();
  EXPECT_EQ(bytes, (Bytes{7, 4, 3, 2, 1, 0xfe, 0xff, 0xff, 0xff}));
  ByteReader r(bytes);
  EXPECT_EQ(r.u8(), 7);
  EXPECT_EQ(r.u32(), 0x01020304u);
  EXPECT_EQ(r.i32(), -2);
  EXPECT_TRUE(r.at_end());
}

TEST(ByteStream, VarintsAreBase128LowGroupFirst) {
  for (const auto& [value, bytes] : std::vector<std::pair<std::uint64_t, Bytes>>{{0, {0}},
                                                                                {1, {1}},
                                                                                {127, {127}},
                                                                                {128, {128, 1}},
                                                                                {300, {0xac, 2}},
                                                                                {16383, {255, 127}},
                                                                                {16384, {128, 128, 1}},
                                                                                {~std::uint64_t{0}, {255, 255, 255, 255, 255, 255, 255, 255, 255, 1}}}) {
    ByteWriter w;
    w.varint(value);
    EXPECT_EQ(w.take(), bytes) << value;
    ByteReader r(bytes);
    EXPECT_EQ(r.varint(), value);
    EXPECT_TRUE(r.at_end());
  }
}

TEST(ByteStream, ZigzagAlternatesSigns) {
  for (const auto& [value, code] : std::vector<std::pair<std::int64_t, std::uint64_t>>{
           {0, 0}, {-1, 1}, {1, 2}, {-2, 3}, {2147483647, 4294967294u}, {-2147483647, 4294967293u}, {INT64_MIN, ~std::uint64_t{0}}, {INT64_MAX, ~std::uint64_t{1}}}) {
    ByteWriter w, same;
    w.zigzag(value);
    same.varint(code);
    const Bytes bytes = w.take();
    EXPECT_EQ(bytes, same.take()) << value;
    ByteReader r(bytes);
    EXPECT_EQ(r.zigzag(), value);
    EXPECT_TRUE(r.at_end());
  }
}

TEST(ByteStream, RefusesLongFormsAndOverflow) {
  for (const Bytes& bytes : {Bytes{128, 0}, Bytes{129, 128, 0}, Bytes{255, 255, 255, 255, 255, 255, 255, 255, 255, 2},
                             Bytes{128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 1}, Bytes{128}, Bytes{}}) {
    ByteReader r(bytes);
    EXPECT_EQ(r.varint(), 0u);
    EXPECT_FALSE(r.ok());
    EXPECT_FALSE(r.at_end());
  }
}

TEST(ByteStream, AfterAFailureEverythingIsZero) {
  const Bytes bytes{1, 2, 3};
  ByteReader r(bytes);
  EXPECT_EQ(r.u32(), 0u);
  EXPECT_FALSE(r.ok());
  EXPECT_EQ(r.u8(), 0);
  EXPECT_EQ(r.count(1), 0u);
  EXPECT_TRUE(r.raw(1).empty());
  EXPECT_EQ(r.varint(), 0u);
}

TEST(ByteStream, CountsAreComparedWithTheBytesLeft) {
  ByteWriter w;
  w.u32(3);
  for (int i = 0; i < 12; ++i) w.u8(1);
  const Bytes bytes = w.take();
  EXPECT_EQ(ByteReader(bytes).count(4), 3u);
  EXPECT_EQ(ByteReader(bytes).count(5), 0u);
  ByteWriter huge;
  huge.u32(0xffffffffu);
  const Bytes most = huge.take();
  ByteReader r(most);
  EXPECT_EQ(r.count(1), 0u);
  EXPECT_FALSE(r.ok());
}

TEST(ByteStreamLaw, NumbersSurvive) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t u = random() >> random() % 64;
    const auto z = static_cast<std::int64_t>(random()) >> random() % 64;
    ByteWriter w;
    w.varint(u);
    w.zigzag(z);
    w.varint(u / 3);
    const Bytes bytes = w.take();
    ByteReader r(bytes);
    ASSERT_EQ(r.varint(), u);
    ASSERT_EQ(r.zigzag(), z);
    ASSERT_EQ(r.varint(), u / 3);
    ASSERT_TRUE(r.at_end());
  }
}

}  // namespace
}  // namespace veritope::certificate::internal
