// SPDX-License-Identifier: LGPL-3.0-or-later
// render/colour.h: a colour of pictures.
#pragma once
#include <cstdint>

namespace veritope {

/// sRGB.
struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;
  friend bool operator==(const Colour&, const Colour&) = default;
};

}  // namespace veritope
