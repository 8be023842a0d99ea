// SPDX-License-Identifier: LGPL-3.0-or-later
// render/picture_font.h: a bitmap font for printable ASCII, and text on images.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "render/image.h"

namespace veritope {

/// The cell of a character, in pixels of scale 1: the glyph has 5 columns, 7 rows above the base line and 2 below it;
/// the last column and the last row of the cell are empty.
inline constexpr std::size_t kGlyphColumns = 6, kGlyphRows = 10, kGlyphRowsAboveBase = 7;

/// Where text begins, and how large it is.
struct TextPlace {
  std::size_t x = 0, y = 0;  ///< the top left corner of the first cell
  std::size_t scale = 1;     ///< the side of the square that shows a pixel of the font
};

/// The width of a text; a character of UTF-8 takes one cell.
std::size_t text_columns(std::string_view text, std::size_t scale);

/// The text if it is at most `columns` wide, else its beginning with "..." after it, as much of that as fits.
std::string shortened_text(std::string_view text, std::size_t scale, std::size_t columns);

/// Draws one line. A character of UTF-8 outside of printable ASCII is an empty box; what lies outside of the image is
/// left out.
void draw_text(const TextPlace& place, std::string_view text, Colour colour, Image* image);

}  // namespace veritope
