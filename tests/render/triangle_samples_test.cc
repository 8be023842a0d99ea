// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/triangle_samples_internal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "robust/base/random.h"

namespace veritope::internal {
namespace {

using Sample = std::pair<std::int64_t, std::int64_t>;

// A point given in units of 1/256 of a sample's side, so that it is not rounded.
PicturePoint at_units(std::int64_t x, std::int64_t y) {
  constexpr double kUnits = 256 * kSamples;
  return {static_cast<double>(x) / kUnits, static_cast<double>(y) / kUnits, 0};
}

template <typename Visit>
void for_each_sample(const TriangleSamples& samples, Visit visit) {
  if (samples.is_flat()) return;
  for (std::int64_t row = samples.rows().first; row < samples.rows().last; ++row)
    for (std::int64_t column = samples.columns(row).first; column < samples.columns(row).last;
         ++column)
      visit(Sample{column, row});
}

std::int64_t turn(std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by,
                  std::int64_t cx, std::int64_t cy) {
  return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
}

TEST(TriangleSamples, AreTheSamplesWhoseCentresLieInside) {
  Random random(20251130);
  int num_covered = 0;
  for (int round = 0; round < 3000; ++round) {
    std::array<std::int64_t, 6> c;
    // Coordinates are halves of a sample's side in one case of four, so that centres lie on edges.
    const std::int64_t grid = random.below(4) == 0 ? 128 : 1;
    for (std::int64_t& x : c) x = random.between(0, 256 * 12 / grid) * grid;
    const TriangleSamples samples(at_units(c[0], c[1]), at_units(c[2], c[3]), at_units(c[4], c[5]));
    std::map<Sample, int> seen;
    for_each_sample(samples, [&](Sample s) { ++seen[s]; });
    for (std::int64_t y = -1; y < 14; ++y)
      for (std::int64_t x = -1; x < 14; ++x) {
        const std::int64_t px = 256 * x + 128, py = 256 * y + 128;
        const std::int64_t a = turn(c[0], c[1], c[2], c[3], px, py),
                           b = turn(c[2], c[3], c[4], c[5], px, py),
                           d = turn(c[4], c[5], c[0], c[1], px, py);
        const bool is_inside = (a > 0 && b > 0 && d > 0) || (a < 0 && b < 0 && d < 0);
        const bool is_outside = (a < 0 || b < 0 || d < 0) && (a > 0 || b > 0 || d > 0);
        const int times = seen.contains({x, y}) ? seen[{x, y}] : 0;
        num_covered += times;
        EXPECT_LE(times, is_outside ? 0 : 1) << "seed 20251130, round " << round;
        EXPECT_GE(times, is_inside ? 1 : 0) << "seed 20251130, round " << round;
      }
  }
  EXPECT_GT(num_covered, 10000);
}

TEST(TriangleSamples, AFanCoversASquareOnceWithItsInnerEdges) {
  Random random(20251201);
  for (int round = 0; round < 300; ++round) {
    // Points around the square from (0, 0) to (8, 8) samples, and a centre, all on a grid of half samples.
    constexpr std::int64_t kSide = 16, kHalf = 128;
    std::vector<PicturePoint> border;
    const auto walk = [&](std::int64_t x, std::int64_t y, std::int64_t dx, std::int64_t dy) {
      for (std::int64_t i = 0; i < kSide; ++i)
        if (i == 0 || random.below(3) == 0)
          border.push_back(at_units((x + i * dx) * kHalf, (y + i * dy) * kHalf));
    };
    walk(0, 0, 1, 0), walk(kSide, 0, 0, 1), walk(kSide, kSide, -1, 0), walk(0, kSide, 0, -1);
    const PicturePoint centre =
        at_units(random.between(1, kSide - 1) * kHalf, random.between(1, kSide - 1) * kHalf);
    std::map<Sample, int> seen;
    for (std::size_t i = 0; i < border.size(); ++i) {
      const PicturePoint &p = border[i], &q = border[(i + 1) % border.size()];
      const bool is_turned = random.below(2) == 0;
      for_each_sample(TriangleSamples(centre, is_turned ? q : p, is_turned ? p : q),
                      [&](Sample s) { ++seen[s]; });
    }
    EXPECT_EQ(seen.size(), 64u) << "seed 20251201, round " << round;
    for (const auto& [sample, times] : seen)
      EXPECT_EQ(times, 1) << "seed 20251201, round " << round << ", sample " << sample.first << " "
                          << sample.second;
  }
}

TEST(TriangleSamples, HoldTheLargestPicture) {
  constexpr double kSide = 8192;
  const TriangleSamples samples({0, 0, 0}, {kSide, 0, 0}, {0, kSide, 0});
  constexpr auto kRows = static_cast<std::int64_t>(kSamples) * 8192;
  EXPECT_EQ(samples.rows().first, 0);
  EXPECT_EQ(samples.rows().last, kRows);
  EXPECT_EQ(samples.area(), kRows * kRows / 2);
  for (const std::int64_t row : {std::int64_t{0}, kRows / 2, kRows - 1}) {
    EXPECT_EQ(samples.columns(row).first, 0);
    // The centre of the sample at column kRows - 1 - row lies on the long edge, which is on the right.
    EXPECT_EQ(samples.columns(row).last, kRows - 1 - row);
  }
}

TEST(TriangleSamples, FlatTrianglesAreFlat) {
  EXPECT_TRUE(TriangleSamples({1, 1, 0}, {1, 1, 0}, {5, 7, 0}).is_flat());
  EXPECT_TRUE(TriangleSamples({1, 1, 0}, {2, 2, 0}, {3, 3, 0}).is_flat());
  EXPECT_TRUE(TriangleSamples({1, 1, 0}, {1 + 1e-9, 1, 0}, {1, 1 + 1e-9, 0}).is_flat());
  EXPECT_FALSE(TriangleSamples({1, 1, 0}, {2, 1, 0}, {1, 2, 0}).is_flat());
}

TEST(TriangleDepth, IsLinearBetweenItsCornersAndConstantBeyond) {
  const PicturePoint a{1, 1, 100}, b{9, 1, 900}, c{1, 9, 100};
  const TriangleDepth depth(a, b, c);
  constexpr auto kPerPixel = static_cast<std::int64_t>(kSamples);
  for (std::int64_t x = 0; x < 12; ++x)
    for (std::int64_t y = 0; y < 12; ++y) {
      // The middle of three samples a pixel is its centre.
      const double expected = std::clamp(100.0 * (static_cast<double>(x) + 0.5), 100.0, 900.0);
      EXPECT_NEAR(depth.at(depth.in_row(y * kPerPixel + 1), x * kPerPixel + 1), expected, 1e-9);
    }
}

TEST(TriangleDepth, SmallTrianglesHaveTheirSlopeToo) {
  const PicturePoint a{1, 1, 100}, b{1.01, 1, 200}, c{1, 1.01, 100};
  const TriangleDepth depth(a, b, c);
  const PicturePoint far{0.5, 0.5, 0};  // the centre of pixel 0, which is sample 1 in its row
  EXPECT_EQ(depth.at(depth.in_row(1), 1), std::max(100 + (far.x - a.x) * 1e4, 100.0));
  const TriangleDepth mirrored({0.505, 0.5, 150}, {0.495, 0.5, 50}, {0.5, 0.51, 100});
  EXPECT_NEAR(mirrored.at(mirrored.in_row(1), 1), 100, 1e-9);
}

TEST(TriangleDepth, ThinTrianglesStayBetweenTheirCorners) {
  Random random(20251202);
  const auto coordinate = [&] { return static_cast<double>(random.below(1 << 20)) / 128; };
  for (int round = 0; round < 2000; ++round) {
    const PicturePoint a{coordinate(), coordinate(), coordinate()},
        b{coordinate(), coordinate(), coordinate()};
    const double t = static_cast<double>(random.below(1 << 20)) / (1 << 20);
    const double e = std::ldexp(1.0, -static_cast<int>(random.below(60)));
    const PicturePoint c{a.x + t * (b.x - a.x) + e, a.y + t * (b.y - a.y), coordinate()};
    const TriangleDepth depth(a, b, c);
    const double at = depth.at(depth.in_row(random.between(0, 24000)), random.between(0, 24000));
    EXPECT_LE(std::min({a.depth, b.depth, c.depth}), at);
    EXPECT_GE(std::max({a.depth, b.depth, c.depth}), at);
  }
}

}  // namespace
}  // namespace veritope::internal
