// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/v_face_parts_internal.h: which corners and edges of a cell are those of a face, and its hand. Numbers
// as in docs/certificates/vmodel.md, section 3.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "solids/vmodel/v_model.h"

namespace veritope::internal {

/// Corner e0 + 2 e1 + 4 e2 of the cell, from a corner (x, y) of its face k.
inline std::uint32_t corner_of_face(std::size_t k, std::array<unsigned, 2> at) {
  const auto axes = v_face_axes(k / 2);
  return static_cast<std::uint32_t>((k % 2) << (k / 2) | at[0] << axes[0] | at[1] << axes[1]);
}
/// Edge 4 axis + e + 2 f between two corners.
inline std::uint32_t edge_between(std::uint32_t c, std::uint32_t d) {
  const std::uint32_t axis = (c ^ d) == 1 ? 0 : (c ^ d) == 2 ? 1 : 2;
  const auto others = v_face_axes(axis);
  return 4 * axis + (c >> others[0] & 1) + 2 * (c >> others[1] & 1);
}
/// The corners of the four sides: those along the first parameter, then those along the second one.
inline constexpr std::array<std::array<std::array<unsigned, 2>, 2>, 4> kSidesOfFace = {{
    {{{0, 0}, {1, 0}}},
    {{{0, 1}, {1, 1}}},
    {{{0, 0}, {0, 1}}},
    {{{1, 0}, {1, 1}}},
}};
/// The edge of the cell that is side n of its face k. It runs as the side does.
inline std::uint32_t edge_of_side(std::size_t k, std::size_t n) {
  return edge_between(corner_of_face(k, kSidesOfFace[n][0]), corner_of_face(k, kSidesOfFace[n][1]));
}

/// The corners where the edge begins and ends.
inline std::array<std::uint32_t, 2> ends_of_edge(std::size_t edge) {
  const std::size_t axis = edge / 4;
  const auto others = v_face_axes(axis);
  const auto low =
      static_cast<std::uint32_t>((edge & 1) << others[0] | (edge >> 1 & 1) << others[1]);
  return {low, low | 1u << axis};
}

/// -1 or 1, as section 4 of the page defines it.
inline int hand_of_face(VFaceNumber f, bool is_cell_reversed) {
  const std::size_t k = f % 6;
  int hand = k % 2 == 0 ? -1 : 1;
  if (k / 2 == 1) hand = -hand;
  return is_cell_reversed ? -hand : hand;
}
/// Bit s for the symmetries that glue faces with these hands.
inline unsigned gluing_symmetries(int hand_f, int hand_g) {
  const bool is_odd = hand_f * hand_g == 1;
  unsigned out = 0;
  for (unsigned s = 0; s < 8; ++s)
    if (is_v_symmetry_odd(s) == is_odd) out |= 1u << s;
  return out;
}

}  // namespace veritope::internal
