// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "render/sample_layer_internal.h"

namespace veritope::internal {
namespace {

SampleLayer layer_of(std::size_t width, std::size_t count,
                     const std::function<double(double, double)>& height) {
  SampleLayer layer({width, 0, count});
  for (std::size_t row = 0; row < count; ++row)
    for (std::size_t column = 0; column < width; ++column) {
      LayerSample& sample = layer.at(column, row);
      sample.height = height(static_cast<double>(column), static_cast<double>(row));
      sample.colour = {200, 200, 200};
    }
  layer.find_normals();
  return layer;
}

void expect_normal(const SampleLayer& layer, std::size_t column, std::size_t row, double right,
                   double up) {
  const double length = std::sqrt(1 + right * right + up * up);
  const auto& n = layer.at(column, row).normal;
  EXPECT_NEAR(n[0], right / length, 1e-6) << column << " " << row;
  EXPECT_NEAR(n[1], up / length, 1e-6) << column << " " << row;
  EXPECT_NEAR(n[2], 1 / length, 1e-6) << column << " " << row;
}

TEST(SampleLayer, PlanesHaveOneNormalUpToTheirRims) {
  const SampleLayer layer = layer_of(12, 9, [](double x, double y) { return 0.5 * x - 0.25 * y; });
  for (std::size_t row = 0; row < 9; ++row)
    for (std::size_t column = 0; column < 12; ++column)
      expect_normal(layer, column, row, -0.5, -0.25);
}

// Heights at a ridge belong to one of its sides: no sample has a normal between them.
TEST(SampleLayer, NormalsAreNotMixedAcrossRidgesAndSteps) {
  const SampleLayer ridge =
      layer_of(20, 9, [](double x, double) { return -std::abs(x - 9.25) + 100; });
  for (std::size_t column = 0; column < 20; ++column)
    expect_normal(ridge, column, 4, column < 10 ? -1 : 1, 0);
  const SampleLayer step =
      layer_of(20, 9, [](double x, double) { return x < 9.5 ? 0.5 * x : -50 - 0.25 * x; });
  for (std::size_t column = 0; column < 20; ++column)
    expect_normal(step, column, 4, column < 10 ? -0.5 : 0.25, 0);
}

TEST(SampleLayer, EdgesOfWhatIsSeenKeepTheirSlopes) {
  const SampleLayer layer = layer_of(
      20, 9, [](double x, double) { return x < 5 || x > 11 ? LayerSample::kNothing : 2 * x; });
  for (std::size_t column = 5; column < 12; ++column) expect_normal(layer, column, 4, -2, 0);
  EXPECT_FALSE(layer.at(4, 4).is_seen());
}

Image drawn(const SampleLayer& layer, const SampleLayer::Look& look) {
  Image image(layer.rows().width / kSamples, layer.rows().count / kSamples, {255, 255, 255});
  layer.draw(0, image.height, look, &image);
  return image;
}

TEST(SampleLayer, PixelsAreTheMeansOfTheirSamples) {
  const SampleLayer layer =
      layer_of(9, 9, [](double x, double) { return x < 4 ? LayerSample::kNothing : 1; });
  const Image image = drawn(layer, {});
  const int white = image.at(0, 4 / 3).red, grey = image.at(2, 1).red, half = image.at(1, 1).red;
  EXPECT_EQ(white, 255);
  EXPECT_LT(grey, 230);
  EXPECT_NEAR(half, (255 + 2 * grey) / 3.0, 1);
}

TEST(SampleLayer, OutlinesLieAtRidgesAndStepsOnly) {
  SampleLayer::Look with;
  with.has_outlines = true, with.step = 10;
  const auto dark_columns = [&](const SampleLayer& layer) {
    const Image plain = drawn(layer, {}), lined = drawn(layer, with);
    std::size_t sum = 0;
    for (std::size_t x = 0; x < plain.width; ++x)
      if (plain.at(x, 2) != lined.at(x, 2)) ++sum;
    return sum;
  };
  EXPECT_EQ(dark_columns(layer_of(60, 15, [](double x, double) { return 0.3 * x; })), 0u);
  EXPECT_EQ(dark_columns(layer_of(60, 15, [](double x, double) { return 0.001 * x * x; })), 0u);
  const auto of_ridge =
      dark_columns(layer_of(60, 15, [](double x, double) { return -std::abs(x - 30.25); }));
  EXPECT_GE(of_ridge, 1u);
  EXPECT_LE(of_ridge, 3u);
  const auto of_step =
      dark_columns(layer_of(60, 15, [](double x, double) { return x < 30 ? 0.0 : 20.0; }));
  EXPECT_GE(of_step, 1u);
  EXPECT_LE(of_step, 3u);
}

TEST(SampleLayer, HazeMakesLowHeightsPaler) {
  const SampleLayer layer = layer_of(9, 9, [](double x, double) { return 3 * std::floor(x / 3); });
  SampleLayer::Look look;
  look.haze = {0, 6, 0.5};
  const Image plain = drawn(layer, {}), hazy = drawn(layer, look);
  EXPECT_EQ(plain.at(2, 1), hazy.at(2, 1));
  EXPECT_LT(hazy.at(1, 1).red, hazy.at(0, 1).red);
  EXPECT_NEAR(hazy.at(0, 1).red, (plain.at(0, 1).red + 255) / 2.0, 1);
}

}  // namespace
}  // namespace veritope::internal
