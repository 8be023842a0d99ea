// SPDX-License-Identifier: LGPL-3.0-or-later
// Seed paper 000, figure 13: a closed surface as the four side faces of a volume.
#include <algorithm>
#include <optional>
#include <utility>

#include "solids/volumes/boolean_sum.h"
#include "solids/volumes/swept.h"
#include "splines/bspline_domain.h"

namespace veritope {
namespace {

std::array<Rational, 5> cuts_of(const KnotAxis<Rational>& axis) {
  const Rational &begin = axis.domain_begin(), &end = axis.domain_end();
  const Rational length = end - begin;
  std::array<Rational, 5> cuts{begin, {}, {}, {}, end};
  for (int k = 1; k < 4; ++k) {
    const Rational quarter = begin + length * Rational(k) / Rational(4);
    Rational& cut = cuts[static_cast<std::size_t>(k)] = quarter;
    Rational nearest = length / Rational(8);
    for (const Rational& u : internal::breaks_of(axis))
      if (Rational off = abs(u - quarter); off < nearest) cut = u, nearest = std::move(off);
  }
  return cuts;
}

}  // namespace

Result<CellVolume> tube(const CellSurface& surface) {
  if (const Status in = check_cell_surface(surface); !in) return in.error();
  CellSurface s = clamped(clamped(surface, 0), 1);
  const auto is_closed = [&](std::size_t a) { return side_of(s, a, 0) == side_of(s, a, 1); };
  if (!is_closed(0)) {
    if (!is_closed(1)) return bad_argument("surface is closed along neither of its axes");
    s = swapped(s, 0, 1);
  }
  const std::array<Rational, 5> cuts = cuts_of(s.axis(0));
  std::vector<CellSurface> strips;
  for (std::size_t k = 0; k < 4; ++k) {
    CellSurface strip = internal::clamped_part(s, 0, cuts[k], cuts[k + 1]);
    strips.push_back(k < 2 ? std::move(strip) : reversed(strip, 0));
  }
  std::vector<CellSurface> caps;
  for (std::size_t end = 0; end < 2; ++end) {
    std::array<CellCurve, 4> sides = {side_of(strips[0], 1, end), side_of(strips[2], 1, end),
                                      side_of(strips[3], 1, end), side_of(strips[1], 1, end)};
    Result<CellSurface> cap = boolean_sum(std::move(sides));
    if (!cap) return cap.error();
    caps.push_back(std::move(*cap));
  }
  Result<CellVolume> volume =
      boolean_sum({strips[3], strips[1], strips[0], strips[2], caps[0], caps[1]});
  if (volume && hand_in_the_middle(*volume) == Sign::kNegative) return swapped(*volume, 0, 1);
  return volume;
}

}  // namespace veritope
