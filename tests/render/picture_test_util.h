// SPDX-License-Identifier: LGPL-3.0-or-later
// Scenes, and questions about images, that the tests of pictures share.
#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>

#include "render/draw_scene.h"
#include "robust/base/random.h"

namespace veritope::picture_test {

inline constexpr Colour kWhite{255, 255, 255}, kGrey{190, 190, 190}, kRed{213, 94, 0},
    kBlue{0, 114, 178};

/// The 12 triangles of a box.
inline SceneSurface box_surface(const Point3d& lo, const Point3d& hi, Paint paint) {
  SceneSurface out;
  for (int corner = 0; corner < 8; ++corner)
    out.points.push_back(
        {(corner & 1 ? hi : lo)[0], (corner & 2 ? hi : lo)[1], (corner & 4 ? hi : lo)[2]});
  out.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  out.paints = {paint};
  return out;
}

/// A point of the unit circle for every real number, by rational operations only.
inline std::array<double, 2> on_circle(double t) {
  return {(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)};
}
/// Point i of n around the whole circle, not evenly.
inline std::array<double, 2> on_circle(int i, int n) {
  const double t = 2.0 * (2 * i % n) / n - 1;
  const auto [x, y] = on_circle(t);
  return 2 * i < n ? std::array{x, y} : std::array{-x, -y};
}
/// A torus around the third axis with radii 1 and 3/8. REQUIRES even numbers.
inline SceneSurface torus_surface(int around, int across, Paint paint) {
  SceneSurface out;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const auto [c, s] = on_circle(i, around);
      const auto [u, v] = on_circle(j, across);
      out.points.push_back({(1 + 0.375 * u) * c, (1 + 0.375 * u) * s, 0.375 * v});
    }
  const auto id = [&](int i, int j) {
    return static_cast<std::uint32_t>(i % around * across + j % across);
  };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      out.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      out.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  out.paints = {paint};
  return out;
}

inline std::size_t count_of(const Image& image, Colour colour) {
  return static_cast<std::size_t>(std::count(image.pixels.begin(), image.pixels.end(), colour));
}

/// Columns [left, right) and rows [top, bottom) of pixels.
struct PixelBox {
  std::size_t left, top, right, bottom;
  std::size_t width() const { return right - left; }
  std::size_t height() const { return bottom - top; }
};
/// A box around the pixels for which is_meant(colour) holds, if there are any.
template <typename IsMeant>
std::optional<PixelBox> box_of_pixels(const Image& image, IsMeant is_meant) {
  PixelBox box{image.width, image.height, 0, 0};
  for (std::size_t y = 0; y < image.height; ++y)
    for (std::size_t x = 0; x < image.width; ++x)
      if (is_meant(image.at(x, y)))
        box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1),
               std::max(box.bottom, y + 1)};
  if (box.right == 0) return {};
  return box;
}
inline std::optional<PixelBox> box_of_colour(const Image& image, Colour colour) {
  return box_of_pixels(image, [colour](Colour c) { return c == colour; });
}
inline std::optional<PixelBox> box_of_ink(const Image& image) {
  return box_of_pixels(image, [](Colour c) { return c != kWhite; });
}

/// FNV-1a of the pixels.
inline std::uint64_t hash_of(const Image& image) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const Colour& c : image.pixels)
    for (const std::uint8_t byte : {c.red, c.green, c.blue}) hash = (hash ^ byte) * 0x100000001b3;
  return hash;
}

}  // namespace veritope::picture_test
