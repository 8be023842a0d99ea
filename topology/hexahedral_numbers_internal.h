// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/hexahedral_numbers_internal.h: the corners, edges and faces of a cuboid by their numbers.
#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

namespace veritope::internal::hexahedral {

// The two axes beside one, ascending.
inline constexpr std::array<std::array<unsigned, 2>, 3> kOtherAxes{{{1, 2}, {0, 2}, {0, 1}}};

// The corner of a face at the ends i, j of its parameters.
inline unsigned corner_of_face(unsigned face, unsigned i, unsigned j) {
  const unsigned a = face / 2;
  return (face % 2) << a | i << kOtherAxes[a][0] | j << kOtherAxes[a][1];
}

// The edge between two corners that differ along one axis.
inline unsigned edge_between(unsigned c, unsigned d) {
  const auto axis = static_cast<unsigned>(std::countr_zero(c ^ d));
  const auto& others = kOtherAxes[axis];
  return 4 * axis + (c >> others[0] & 1u) + 2 * (c >> others[1] & 1u);
}
inline unsigned begin_of_edge(unsigned edge) {
  const auto& others = kOtherAxes[edge / 4];
  return (edge & 1u) << others[0] | (edge >> 1 & 1u) << others[1];
}
inline unsigned end_of_edge(unsigned edge) { return begin_of_edge(edge) | 1u << edge / 4; }

// The other one of the two faces at an edge.
inline unsigned other_face(unsigned edge, unsigned face) {
  const auto& others = kOtherAxes[edge / 4];
  const unsigned f = 2 * others[0] + (edge & 1u), g = 2 * others[1] + (edge >> 1 & 1u);
  return face == f ? g : f;
}
// The edge of a face that is parallel to one of its edges.
inline unsigned opposite_edge(unsigned edge, unsigned face) {
  const unsigned across = kOtherAxes[face / 2][kOtherAxes[face / 2][0] == edge / 4 ? 1 : 0];
  return edge ^ (kOtherAxes[edge / 4][0] == across ? 1u : 2u);
}

// The corners of a face in the order (0,0), (1,0), (1,1), (0,1) of its parameters.
inline std::array<unsigned, 4> ring_of_face(unsigned face) {
  return {corner_of_face(face, 0, 0), corner_of_face(face, 1, 0), corner_of_face(face, 1, 1),
          corner_of_face(face, 0, 1)};
}
// Whether that order has the face on its left from outside of a right-handed cell.
inline bool is_ring_outward(unsigned face) { return (face / 2 == 1) != (face % 2 == 1); }

// The corner of the other face that a symmetry gives to a corner of a face.
inline unsigned image_of_corner(unsigned face, unsigned corner, unsigned other,
                                std::uint32_t symmetry) {
  unsigned i = corner >> kOtherAxes[face / 2][0] & 1u, j = corner >> kOtherAxes[face / 2][1] & 1u;
  if ((symmetry & 1u) != 0) std::swap(i, j);
  if ((symmetry & 2u) != 0) i = 1 - i;
  if ((symmetry & 4u) != 0) j = 1 - j;
  return corner_of_face(other, i, j);
}

}  // namespace veritope::internal::hexahedral
