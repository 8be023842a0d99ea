// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/picture_font.h"

#include <algorithm>
#include <array>

namespace veritope {
namespace {

constexpr std::size_t kGlyphsPerBand = 12, kRowsPerBand = 9, kNumBands = 8;

// The glyphs in the order of ASCII from the space on, twelve side by side; the last stands for all other characters.
constexpr std::array<std::string_view, kNumBands* kRowsPerBand> kBands = {
    //       !     "     #     $     %     &     '     (     )     *     +
    "        #    # #   # #    #   ##  #  ##     #      #   #               ",
    "        #    # #   # #   #### ##  # #  #    #     #     #     #     #  ",
    "        #         ##### # #      #  # #          #       #  # # #   #  ",
    "        #          # #   ###    #    #           #       #   ###  #####",
    "        #         #####   # #  #    # # #        #       #  # # #   #  ",
    "                   # #  ####  #  ## #  #          #     #     #     #  ",
    "        #          # #    #   #  ##  ## #          #   #               ",
    "                                                                       ",
    "                                                                       ",
    // ,     -     .     /     0     1     2     3     4     5     6     7
    "                      #  ###    #    ###   ###     #  #####   ##  #####",
    "                      # #   #  ##   #   # #   #   ##  #      #        #",
    "                     #  #  ##   #       #     #  # #  ####  #        # ",
    "      #####         #   # # #   #     ##    ##  #  #      # ####    #  ",
    "                   #    ##  #   #    #        # #####     # #   #   #  ",
    "  #           #   #     #   #   #   #     #   #    #  #   # #   #  #   ",
    "  #           #   #      ###   ###  #####  ###     #   ###   ###   #   ",
    " #                                                                     ",
    "                                                                       ",
    // 8     9     :     ;     <     =     >     ?     @     A     B     C
    " ###   ###                  #       #      ###   ###    #   ####   ### ",
    "#   # #   #                #         #    #   # #   #  # #  #   # #   #",
    "#   # #   #   #     #     #   #####   #       # # ### #   # #   # #    ",
    " ###   ####   #     #    #             #     #  # # # #   # ####  #    ",
    "#   #     #               #   #####   #     #   # ### ##### #   # #    ",
    "#   #    #    #     #      #         #          #     #   # #   # #   #",
    " ###   ##     #     #       #       #       #    #### #   # ####   ### ",
    "                   #                                                   ",
    "                                                                       ",
    // D     E     F     G     H     I     J     K     L     M     N     O
    "####  ##### #####  ###  #   #  ###    ### #   # #     #   # #   #  ### ",
    "#   # #     #     #   # #   #   #      #  #  #  #     ## ## ##  # #   #",
    "#   # #     #     #     #   #   #      #  # #   #     # # # ##  # #   #",
    "#   # ####  ####  #  ## #####   #      #  ##    #     # # # # # # #   #",
    "#   # #     #     #   # #   #   #      #  # #   #     #   # #  ## #   #",
    "#   # #     #     #   # #   #   #   #  #  #  #  #     #   # #  ## #   #",
    "####  ##### #      #### #   #  ###   ##   #   # ##### #   # #   #  ### ",
    "                                                                       ",
    "                                                                       ",
    // P     Q     R     S     T     U     V     W     X     Y     Z     [
    "####   ###  ####   #### ##### #   # #   # #   # #   # #   # #####  ### ",
    "#   # #   # #   # #       #   #   # #   # #   # #   # #   #     #  #   ",
    "#   # #   # #   # #       #   #   # #   # #   #  # #   # #     #   #   ",
    "####  #   # ####   ###    #   #   # #   # # # #   #     #     #    #   ",
    "#     # # # # #       #   #   #   #  # #  # # #  # #    #    #     #   ",
    "#     #  #  #  #      #   #   #   #  # #  ## ## #   #   #   #      #   ",
    "#      ## # #   # ####    #    ###    #   #   # #   #   #   #####  ### ",
    "                                                                       ",
    "                                                                       ",
    // \     ]     ^     _     `     a     b     c     d     e     f     g
    "#      ###    #          #          #               #         ##       ",
    "#        #   # #          #         #               #        #  #      ",
    " #       #  #   #              ###  ####   ####  ####  ###   #     ####",
    "  #      #                        # #   # #     #   # #   # ###   #   #",
    "   #     #                     #### #   # #     #   # #####  #    #   #",
    "    #    #                    #   # #   # #     #   # #      #    #   #",
    "    #  ###                     #### ####   ####  ####  ###   #     ####",
    "                  #####                                               #",
    "                                                                   ### ",
    // h     i     j     k     l     m     n     o     p     q     r     s
    "#       #      #  #      ##                                            ",
    "#                 #       #                                            ",
    "####   ##     ##  #  #    #   ## #  ####   ###  ####   #### # ##   ####",
    "#   #   #      #  # #     #   # # # #   # #   # #   # #   # ##  # #    ",
    "#   #   #      #  ##      #   # # # #   # #   # #   # #   # #      ### ",
    "#   #   #      #  # #     #   # # # #   # #   # #   # #   # #         #",
    "#   #  ###     #  #  #   ###  # # # #   #  ###  ####   #### #     #### ",
    "            #  #                                #         #            ",
    "             ##                                 #         #            ",
    // t     u     v     w     x     y     z     {     |     }     ~     (any other)
    " #                                           ##   #   ##          #####",
    " #                                          #     #     #         #   #",
    "####  #   # #   # #   # #   # #   # #####   #     #     #    #  # #   #",
    " #    #   # #   # # # #  # #  #   #    #   #      #      #  # # # #   #",
    " #    #   #  # #  # # #   #   #   #   #     #     #     #   #  #  #   #",
    " #  # #   #  # #  # # #  # #  #   #  #      #     #     #         #   #",
    "  ##   ####   #    # #  #   #  #### #####    ##   #   ##          #####",
    "                                  #               #                    ",
    "                               ###                                     "};

// Whether the byte continues a character of UTF-8.
bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

std::size_t glyph_of(char c) {
  constexpr std::size_t kOther = kNumBands * kGlyphsPerBand - 1;
  return c >= ' ' && c <= '~' ? static_cast<std::size_t>(c - ' ') : kOther;
}

bool is_set(std::size_t glyph, std::size_t column, std::size_t row) {
  const std::string_view line = kBands[glyph / kGlyphsPerBand * kRowsPerBand + row];
  return line[glyph % kGlyphsPerBand * kGlyphColumns + column] == '#';
}

void fill_square(std::size_t x, std::size_t y, std::size_t side, Colour colour, Image* image) {
  for (std::size_t j = y; j < std::min(y + side, image->height); ++j)
    for (std::size_t i = x; i < std::min(x + side, image->width); ++i) image->at(i, j) = colour;
}

void draw_glyph(const TextPlace& place, std::size_t glyph, Colour colour, Image* image) {
  for (std::size_t row = 0; row < kRowsPerBand; ++row)
    for (std::size_t column = 0; column + 1 < kGlyphColumns; ++column)
      if (is_set(glyph, column, row))
        fill_square(place.x + column * place.scale, place.y + row * place.scale, place.scale,
                    colour, image);
}

}  // namespace

std::size_t text_columns(std::string_view text, std::size_t scale) {
  const auto characters = text.size() - static_cast<std::size_t>(std::count_if(
                                            text.begin(), text.end(), is_continuation));
  return characters * kGlyphColumns * scale;
}

std::string shortened_text(std::string_view text, std::size_t scale, std::size_t columns) {
  if (text_columns(text, scale) <= columns) return std::string(text);
  constexpr std::string_view kDots = "...";
  const std::size_t room = columns / (kGlyphColumns * scale);
  if (room <= kDots.size()) return std::string(kDots.substr(0, room));
  std::size_t kept = 0, characters = 0;
  while (characters + kDots.size() < room || is_continuation(text[kept]))
    if (!is_continuation(text[kept++])) ++characters;
  return std::string(text.substr(0, kept)).append(kDots);
}

void draw_text(const TextPlace& place, std::string_view text, Colour colour, Image* image) {
  TextPlace cell = place;
  for (const char c : text) {
    if (is_continuation(c)) continue;
    draw_glyph(cell, glyph_of(c), colour, image);
    cell.x += kGlyphColumns * cell.scale;
  }
}

}  // namespace veritope
