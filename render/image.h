// SPDX-License-Identifier: LGPL-3.0-or-later
// render/image.h: a picture in memory, one colour a pixel.
#pragma once
#include <cstddef>
#include <vector>

#include "render/colour.h"

namespace veritope {

struct Image {
  Image() = default;
  Image(std::size_t columns, std::size_t rows, Colour background)
      : width(columns), height(rows), pixels(columns * rows, background) {}

  std::size_t width = 0, height = 0;
  std::vector<Colour> pixels;  ///< row after row from the top, each from the left

  /// REQUIRES x < width, y < height.
  Colour& at(std::size_t x, std::size_t y) { return pixels[y * width + x]; }
  const Colour& at(std::size_t x, std::size_t y) const { return pixels[y * width + x]; }
};

}  // namespace veritope
