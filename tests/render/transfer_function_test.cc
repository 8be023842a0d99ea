// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/transfer_function.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/colour_map.h"
#include "render/grey_levels.h"
#include "robust/base/random.h"

namespace veritope {
namespace {

std::vector<TransferNode> some_nodes() {
  return {{-1, {10, 20, 30}, 0.5}, {0, {200, 0, 100}, 3}, {0, {0, 250, 50}, 1}, {2, {0, 0, 90}, 4}};
}

// The mean by midpoints of many parts, from the definition.
TransferFunction::Mean mean_by_sums(const std::vector<TransferNode>& nodes, double a, double b) {
  constexpr int kParts = 20000;
  TransferFunction::Mean out;
  for (int i = 0; i < kParts; ++i) {
    const double v = a + (b - a) * (i + 0.5) / kParts;
    std::size_t k = 0;
    while (k + 2 < nodes.size() && nodes[k + 1].value <= v) ++k;
    const double width = nodes[k + 1].value - nodes[k].value;
    const double share = std::clamp((v - nodes[k].value) / width, 0.0, 1.0);
    const double e = nodes[k].extinction + share * (nodes[k + 1].extinction - nodes[k].extinction);
    out.extinction += e / kParts;
    for (std::size_t c = 0; c < 3; ++c)
      out.glow[c] +=
          e * (nodes[k].colour[c] + share * (nodes[k + 1].colour[c] - nodes[k].colour[c])) / kParts;
  }
  return out;
}

TEST(TransferFunction, MeansAreThoseOfManySamples) {
  const std::vector<TransferNode> nodes = some_nodes();
  const TransferFunction transfer(nodes);
  Random random(101);
  for (int round = 0; round < 40; ++round) {
    const double a = static_cast<double>(random.between(-300, 400)) / 100 + 0.003,
                 b = static_cast<double>(random.between(-300, 400)) / 100 + 0.003;
    const auto mean = transfer.mean(a, b), expected = mean_by_sums(nodes, a, b);
    EXPECT_NEAR(mean.extinction, expected.extinction, 1e-3) << a << " " << b;
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(mean.glow[c], expected.glow[c], 0.1) << a << " " << b;
  }
}

TEST(TransferFunction, OneValueHasTheNumbersThereAndANarrowPeakIsNotMissed) {
  const TransferFunction transfer(some_nodes());
  EXPECT_DOUBLE_EQ(transfer.mean(1, 1).extinction, 2.5);
  EXPECT_DOUBLE_EQ(transfer.mean(1, 1).glow[2], 2.5 * 70);
  EXPECT_DOUBLE_EQ(transfer.mean(-9, -9).extinction, 0.5);
  EXPECT_DOUBLE_EQ(transfer.mean(9, 9).extinction, 4);
  EXPECT_DOUBLE_EQ(transfer.mean(1, 3).extinction, transfer.mean(3, 1).extinction);
  const TransferFunction peak({{0.4999, {}, 0}, {0.5, {0, 0, 7}, 1000}, {0.5001, {}, 0}});
  EXPECT_NEAR(peak.mean(0, 1).extinction, 0.1, 1e-9);
  const TransferFunction one({{3, {1, 2, 3}, 4}});
  EXPECT_DOUBLE_EQ(one.mean(-5, 8).glow[1], 8);
}

TEST(ExpMinus, IsTheExponentialFunction) {
  for (double x = 0; x < 45; x += 0.037) EXPECT_NEAR(exp_minus(x), std::exp(-x), 1e-12) << x;
  EXPECT_EQ(exp_minus(0), 1);
  EXPECT_EQ(exp_minus(1e300), 0);
}

TEST(GreyLevels, AreRoundedIntensities) {
  const GreyLevels levels;
  for (double x = -1; x < 9; x += 0.00137) {
    const double exact = x < 0 ? 255 : 255 * std::exp(-x);
    EXPECT_LE(std::abs(levels.level(x) - exact), 0.5 + 1e-9) << x;
  }
  EXPECT_EQ(levels.level(0), 255);
  EXPECT_EQ(levels.level(-1e308), 255);
  EXPECT_EQ(levels.level(1e308), 0);
}

TEST(ColourMap, GoesThroughItsStopsAndStaysAtItsEnds) {
  EXPECT_EQ(map_colour(0), (Colour{68, 1, 84}));
  EXPECT_EQ(map_colour(0.5), (Colour{33, 145, 140}));
  EXPECT_EQ(map_colour(1), (Colour{253, 231, 37}));
  EXPECT_EQ(map_colour(-3), map_colour(0));
  EXPECT_EQ(map_colour(7), map_colour(1));
  EXPECT_EQ(map_colour(std::nan("")), map_colour(0));
  EXPECT_EQ(map_colour(0.125), (Colour{64, 42, 112}));  // (68 + 59) / 2 and so on, rounded
  const auto brightness = [](double s) {
    const Colour c = map_colour(s);
    return 0.3 * c.red + 0.59 * c.green + 0.11 * c.blue;
  };
  for (double s = 0; s < 0.99; s += 0.01) EXPECT_LT(brightness(s), brightness(s + 0.01));
}

}  // namespace
}  // namespace veritope
