// SPDX-License-Identifier: LGPL-3.0-or-later
// render/png.h: images as PNG files.
#pragma once
#include <string>

#include "render/image.h"

namespace veritope {

/// A PNG file of 8-bit RGB without loss, marked as sRGB. The bytes depend on the image and on the release of zlib
/// alone. REQUIRES 0 < width, height < 2^31, one colour a pixel.
/// Source: PNG (Portable Network Graphics) Specification, second edition, W3C 2003.
std::string png_bytes(const Image& image);

}  // namespace veritope
