// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/colour_map.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace veritope {
namespace {

constexpr std::array<Colour, 5> kStops{
    {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};

std::uint8_t between(std::uint8_t a, std::uint8_t b, double share) {
  return static_cast<std::uint8_t>(a + (static_cast<double>(b) - a) * share + 0.5);
}

}  // namespace

Colour map_colour(double share) {
  const double place = share > 0 ? std::min(share, 1.0) * (kStops.size() - 1) : 0;
  const auto first = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
  const double rest = place - static_cast<double>(first);
  const Colour &a = kStops[first], &b = kStops[first + 1];
  return {between(a.red, b.red, rest), between(a.green, b.green, rest),
          between(a.blue, b.blue, rest)};
}

}  // namespace veritope
