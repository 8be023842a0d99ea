// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/sample_layer_internal.h"

#include <algorithm>
#include <cmath>

#include "render/flat_scene_internal.h"

namespace veritope::internal {
namespace {

// The difference of neighbours at the third of five heights: of the pair of neighbours, or of one side, that bends
// least. Heights that are not there are kNothing.
double least_bent(const std::array<double, 5>& h) {
  constexpr double kUnknown = 1e300;  // less than nothing at all, more than any bend
  const auto is_there = [&](std::size_t i) { return h[i] != LayerSample::kNothing; };
  const auto bend = [&](std::size_t i) {
    return is_there(i - 1) && is_there(i + 1) ? std::abs(h[i - 1] - 2 * h[i] + h[i + 1]) : kUnknown;
  };
  double best = std::numeric_limits<double>::infinity(), out = 0;
  const auto take = [&](double bent, double difference) {
    if (bent < best) best = bent, out = difference;
  };
  if (is_there(1) && is_there(3)) take(bend(2), 0.5 * (h[3] - h[1]));
  if (is_there(1)) take(bend(1), h[2] - h[1]);
  if (is_there(3)) take(bend(3), h[3] - h[2]);
  return out;
}

std::uint8_t rounded_channel(double c) {
  return static_cast<std::uint8_t>(std::clamp(c, 0.0, 255.0) + 0.5);
}

// b over a, with this share of b.
Colour mixed(Colour a, Colour b, double share) {
  const auto channel = [share](std::uint8_t x, std::uint8_t y) {
    return rounded_channel(x + (static_cast<double>(y) - x) * share);
  };
  return {channel(a.red, b.red), channel(a.green, b.green), channel(a.blue, b.blue)};
}

}  // namespace

double SampleLayer::slope(std::size_t column, std::size_t row, bool is_down) const {
  std::array<double, 5> heights;
  for (std::size_t i = 0; i < 5; ++i) {
    const std::size_t c = is_down ? column : column + i - 2, r = is_down ? row + i - 2 : row;
    const bool is_there = is_down ? rows_.first <= r && r < rows_.end() : c < rows_.width;
    heights[i] = is_there ? at(c, r).height : LayerSample::kNothing;
  }
  return least_bent(heights);
}

// Numbers of columns and rows that are negative wrap to huge ones.
void SampleLayer::find_normals() {
  for (std::size_t row = rows_.first; row < rows_.end(); ++row)
    for (std::size_t column = 0; column < rows_.width; ++column) {
      LayerSample& sample = at(column, row);
      if (!sample.is_seen()) continue;
      const double right = slope(column, row, false), down = slope(column, row, true);
      const double length = std::sqrt(1 + right * right + down * down);
      sample.normal = {static_cast<float>(-right / length), static_cast<float>(down / length),
                       static_cast<float>(1 / length)};
    }
}

bool SampleLayer::is_step(const LayerSample& a, const LayerSample& b, double step) {
  constexpr float kSharp = 0.72F;  // the cosine of 44 degrees
  if (!a.is_seen() || !b.is_seen()) return a.is_seen() != b.is_seen();
  if (std::abs(a.height - b.height) > step) return true;
  const auto &m = a.normal, &n = b.normal;
  return m[0] * n[0] + m[1] * n[1] + m[2] * n[2] < kSharp;
}

bool SampleLayer::is_outline(std::size_t column, std::size_t row, double step) const {
  const std::size_t left = column - std::min(column, kReach),
                    up = std::max(row, rows_.first + kReach) - kReach,
                    right = std::min(column + kReach, rows_.width - 1),
                    down = std::min(row + kReach, rows_.end() - 1);
  return is_step(at(left, row), at(right, row), step) ||
         is_step(at(column, up), at(column, down), step);
}

Colour SampleLayer::shaded(std::size_t column, std::size_t row, const Look& look) const {
  constexpr Colour kDark{40, 40, 40}, kWhite{255, 255, 255};
  constexpr double kOutlineShare = 0.6;
  const LayerSample& sample = at(column, row);
  const double light = light_of({sample.normal[0], sample.normal[1], sample.normal[2]});
  Colour out = mixed({0, 0, 0}, sample.colour, light);
  if (look.has_outlines && is_outline(column, row, look.step))
    out = mixed(out, kDark, kOutlineShare);
  const Haze& haze = look.haze;
  if (!(haze.lowest < haze.highest)) return out;
  const double depth = (haze.highest - sample.height) / (haze.highest - haze.lowest);
  return mixed(out, kWhite, haze.most * std::clamp(depth, 0.0, 1.0));
}

void SampleLayer::draw(std::size_t first, std::size_t last, const Look& look, Image* image) const {
  constexpr std::uint32_t kCount = kSamples * kSamples;
  for (std::size_t y = first; y < last; ++y)
    for (std::size_t x = 0; x < image->width; ++x) {
      Colour& pixel = image->at(x, y);
      std::uint32_t red = kCount / 2, green = kCount / 2, blue = kCount / 2;
      for (std::size_t row = y * kSamples; row < (y + 1) * kSamples; ++row)
        for (std::size_t column = x * kSamples; column < (x + 1) * kSamples; ++column) {
          const Colour c = at(column, row).is_seen() ? shaded(column, row, look) : pixel;
          red += c.red, green += c.green, blue += c.blue;
        }
      const auto mean = [](std::uint32_t sum) { return static_cast<std::uint8_t>(sum / kCount); };
      pixel = {mean(red), mean(green), mean(blue)};
    }
}

}  // namespace veritope::internal
