// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/mark_samples_internal.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/render/picture_test_util.h"

namespace veritope::internal {
namespace {

using namespace picture_test;

constexpr std::size_t kSide = 40;  // of the pictures here, in pixels
constexpr SampleRows kRows{kSide * kSamples, 0, kSide* kSamples};

std::vector<Colour> drawn_marks(const FlatScene& scene, const SampleRows& rows = kRows) {
  MarkSamples samples(rows, scene);
  for (std::uint32_t i = 0; i < scene.marks.size(); ++i) samples.add(i);
  std::vector<Colour> colours(rows.size(), kGrey);
  samples.draw_over(colours);
  return colours;
}

// The distance from a point to a segment, from 4000 of its points: too large by at most 1/100 here.
double slow_distance(const FlatMark& m, double x, double y) {
  double least = HUGE_VAL;
  for (int i = 0; i <= 4000; ++i) {
    const double t = i / 4000.0;
    least = std::min(least,
                     std::hypot(x - m.a.x - t * (m.b.x - m.a.x), y - m.a.y - t * (m.b.y - m.a.y)));
  }
  return least;
}

TEST(MarkSamples, AreThoseWithinTheRadiusAndThenTheRim) {
  Random random(20251209);
  const auto coordinate = [&] { return static_cast<double>(random.between(-500, 4500)) / 100; };
  for (int round = 0; round < 12; ++round) {
    FlatMark mark{{coordinate(), coordinate(), 1}, {coordinate(), coordinate(), 5}, 1, kRed};
    mark.radius = static_cast<double>(random.between(50, 900)) / 100;
    if (round % 3 == 0) mark.b = mark.a;
    if (round % 4 == 1) mark.b.y = mark.a.y;
    const auto colours = drawn_marks({{}, {}, {mark}});
    for (std::size_t i = 0; i < colours.size(); i += 1 + random.below(5)) {
      const double x = (static_cast<double>(i % kRows.width) + 0.5) / kSamples,
                   y = (static_cast<double>(i / kRows.width) + 0.5) / kSamples,
                   distance = slow_distance(mark, x, y);
      if (std::abs(distance - mark.radius) < 0.02 || std::abs(distance - mark.radius - kRim) < 0.02)
        continue;
      const Colour expected = distance < mark.radius          ? kRed
                              : distance < mark.radius + kRim ? kWhite
                                                              : kGrey;
      EXPECT_EQ(colours[i], expected)
          << "seed 20251209, round " << round << ", at " << x << " " << y;
    }
  }
}

TEST(MarkSamples, BandsOfRowsGiveTheSame) {
  const FlatScene scene{
      {}, {}, {{{3, 2, 0}, {30, 33, 900}, 3, kRed}, {{30, 1, 500}, {5, 38, 500}, 4, kBlue}}};
  const auto whole = drawn_marks(scene);
  for (std::size_t first = 0; first < kRows.count; first += 24) {
    const SampleRows band{kRows.width, first, 24};
    const auto part = drawn_marks(scene, band);
    EXPECT_TRUE(std::equal(part.begin(), part.end(),
                           whole.begin() + static_cast<std::ptrdiff_t>(first * kRows.width)));
  }
}

Colour at_pixel(const std::vector<Colour>& colours, std::size_t x, std::size_t y) {
  return colours[kRows.index(x * kSamples + 1, y * kSamples + 1)];
}

TEST(MarkSamples, DepthRunsAlongALine) {
  // The two lines cross twice in depth: each is in front at its near end.
  const FlatScene scene{
      {},
      {},
      {{{2, 18, 0}, {38, 18, kDeepest}, 3, kRed}, {{2, 20, kDeepest}, {38, 20, 0}, 3, kBlue}}};
  const auto colours = drawn_marks(scene);
  EXPECT_EQ(at_pixel(colours, 5, 19), kRed);
  EXPECT_EQ(at_pixel(colours, 35, 19), kBlue);
}

TEST(MarkSamples, OnlyTheRimOfAMarkWellInFrontHidesAMark) {
  const auto beside = [](double depth) {
    const FlatScene scene{{},
                          {},
                          {{{10, 20, depth}, {10, 20, depth}, 5, kRed},
                           {{20, 20, kDeepest / 2}, {20, 20, kDeepest / 2}, 5, kBlue}}};
    return at_pixel(drawn_marks(scene), 15,
                    20);  // in the disc of the second and in the rim of the first
  };
  EXPECT_EQ(beside(kDeepest / 2), kBlue);
  EXPECT_EQ(beside(kDeepest * 0.48), kBlue);
  EXPECT_EQ(beside(kDeepest * 0.45), kWhite);
  EXPECT_EQ(beside(kDeepest * 0.9), kBlue);
}

TEST(MarkSamples, ALineSeenFromItsEndShowsItsNearEnd) {
  for (const bool is_turned : {false, true}) {
    FlatMark line{{20, 20, 0}, {20, 20, kDeepest}, 4, kRed};
    if (is_turned) std::swap(line.a, line.b);
    const FlatScene scene{
        {}, {}, {line, {{20, 20, kDeepest / 2}, {20, 20, kDeepest / 2}, 4, kBlue}}};
    EXPECT_EQ(at_pixel(drawn_marks(scene), 20, 20), kRed);
  }
}

TEST(RimColour, ContrastsWithTheMark) {
  EXPECT_EQ(rim_colour({0, 0, 0}), kWhite);
  EXPECT_EQ(rim_colour(kRed), kWhite);
  EXPECT_EQ(rim_colour({255, 255, 255}), rim_colour({240, 228, 66}));
  EXPECT_NE(rim_colour({240, 228, 66}), kWhite);
}

}  // namespace
}  // namespace veritope::internal
