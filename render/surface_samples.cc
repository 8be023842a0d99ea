// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/surface_samples_internal.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/triangle_samples_internal.h"

namespace veritope::internal {
namespace {

// The tag of a layer says that nothing is seen behind it, and so does that of kNoKey. Layers are sorted; those after
// the first one with a tag are empty.
template <std::size_t N>
void insert_layer(std::uint64_t key, std::array<std::uint64_t, N>& layers) {
  for (std::size_t i = 0; i < N; ++i) {
    if (key < layers[i]) std::swap(key, layers[i]);
    if (tag_of(layers[i])) {
      std::fill(layers.begin() + static_cast<std::ptrdiff_t>(i) + 1, layers.end(), kNoKey);
      return;
    }
  }
}

// Linear between the corners of a triangle, at a sample that it covers.
Colour smooth_colour(const FlatScene& scene, const FlatTriangle& triangle, std::size_t column,
                     std::size_t row) {
  constexpr double kThin = 0x1p-20, kSide = 1 / static_cast<double>(kSamples);
  const std::array<Colour, 3>& colours = scene.smooth[triangle.smooth];
  const PicturePoint &a = scene.corners[triangle.corners[0]],
                     &b = scene.corners[triangle.corners[1]],
                     &c = scene.corners[triangle.corners[2]];
  const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (!(std::abs(area) > kThin)) return colours[0];
  const double x = (static_cast<double>(column) + 0.5) * kSide - a.x,
               y = (static_cast<double>(row) + 0.5) * kSide - a.y;
  const double v = std::clamp((x * (c.y - a.y) - (c.x - a.x) * y) / area, 0.0, 1.0),
               w = std::clamp(((b.x - a.x) * y - x * (b.y - a.y)) / area, 0.0, 1.0 - v);
  const auto channel = [&](std::uint8_t Colour::*of) {
    return static_cast<std::uint8_t>((1 - v - w) * colours[0].*of + v * colours[1].*of +
                                     w * colours[2].*of + 0.5);
  };
  return {channel(&Colour::red), channel(&Colour::green), channel(&Colour::blue)};
}

// Colours on top of each other, from the front. Shares are in units of 2^-16: integers, so that white over white is
// white.
class Blend {
 public:
  void add(Colour colour, unsigned opacity) {
    const std::uint32_t share = left_ * opacity / 255;
    red_ += share * colour.red, green_ += share * colour.green, blue_ += share * colour.blue;
    left_ -= share;
  }
  Colour colour() const { return {rounded(red_), rounded(green_), rounded(blue_)}; }

 private:
  static constexpr std::uint32_t kOne = 1 << 16;
  static std::uint8_t rounded(std::uint32_t c) {
    return static_cast<std::uint8_t>((c + kOne / 2) / kOne);
  }
  std::uint32_t red_ = 0, green_ = 0, blue_ = 0, left_ = kOne;
};

}  // namespace

SurfaceSamples::SurfaceSamples(const SampleRows& rows, const FlatScene& scene)
    : rows_(rows), scene_(&scene), layers_(rows.size()) {
  for (Layers& layers : layers_) layers.fill(kNoKey);
}

void SurfaceSamples::add(std::uint32_t triangle) {
  const FlatTriangle& flat = scene_->triangles[triangle];
  const PicturePoint &a = scene_->corners[flat.corners[0]], &b = scene_->corners[flat.corners[1]],
                     &c = scene_->corners[flat.corners[2]];
  const TriangleSamples samples(a, b, c);
  if (samples.is_flat()) return;
  const TriangleDepth depth(a, b, c);
  const bool is_opaque = flat.paint.opacity == 255;
  const auto first = std::max(samples.rows().first, static_cast<std::int64_t>(rows_.first)),
             last = std::min(samples.rows().last, static_cast<std::int64_t>(rows_.end()));
  for (std::int64_t row = first; row < last; ++row) {
    const auto [left, end] = samples.columns(row);
    const std::int64_t right = std::min(end, static_cast<std::int64_t>(rows_.width));
    const double in_row = depth.in_row(row);
    for (std::int64_t column = left; column < right; ++column)
      insert_layer(
          depth_key(depth.at(in_row, column), triangle, is_opaque),
          layers_[rows_.index(static_cast<std::size_t>(column), static_cast<std::size_t>(row))]);
  }
}

Colour SurfaceSamples::blended(std::size_t column, std::size_t row, Colour background) const {
  Blend blend;
  for (const std::uint64_t key : layers_[rows_.index(column, row)]) {
    if (key == kNoKey) break;
    const FlatTriangle& triangle = scene_->triangles[order_of(key)];
    const bool is_smooth = triangle.smooth != FlatTriangle::kNoSmooth;
    blend.add(is_smooth ? smooth_colour(*scene_, triangle, column, row) : triangle.paint.colour,
              triangle.paint.opacity);
  }
  blend.add(background, 255);
  return blend.colour();
}

// Whether two front layers, near each other, do not continue each other.
bool SurfaceSamples::is_step(std::uint64_t a, std::uint64_t b) const {
  constexpr auto kDeep = static_cast<std::uint64_t>(kDeepest / 64);
  constexpr int kSharp = 127 * 127 * 72 / 100;  // the cosine of 44 degrees
  if (order_of(a) == order_of(b)) return false;
  if (a == kNoKey || b == kNoKey) return true;
  if (std::max(depth_of(a), depth_of(b)) - std::min(depth_of(a), depth_of(b)) > kDeep) return true;
  const auto &m = scene_->triangles[order_of(a)].normal, &n = scene_->triangles[order_of(b)].normal;
  return m[0] * n[0] + m[1] * n[1] + m[2] * n[2] < kSharp;
}

bool SurfaceSamples::is_outline(std::size_t column, std::size_t row) const {
  const std::size_t left = column - std::min(column, kReach),
                    up = std::max(row, rows_.first + kReach) - kReach,
                    right = std::min(column + kReach, rows_.width - 1),
                    down = std::min(row + kReach, rows_.end() - 1);
  return is_step(front(left, row), front(right, row)) ||
         is_step(front(column, up), front(column, down));
}

void SurfaceSamples::draw_over(const SampleRows& rows, bool with_outlines,
                               std::span<Colour> colours) const {
  constexpr Colour kOutline{40, 40, 40};
  for (std::size_t row = rows.first; row < rows.end(); ++row)
    for (std::size_t column = 0; column < rows.width; ++column) {
      const std::uint64_t key = front(column, row);
      if (key == kNoKey) continue;
      Colour& colour = colours[rows.index(column, row)];
      colour = blended(column, row, colour);
      if (!with_outlines || !is_outline(column, row)) continue;
      Blend blend;
      blend.add(kOutline, scene_->triangles[order_of(key)].paint.opacity * 3U / 5);
      blend.add(colour, 255);
      colour = blend.colour();
    }
}

}  // namespace veritope::internal
