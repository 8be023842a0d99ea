// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/v_parts.h: the names of a cell's faces, edges and corners, in its own axes u, v, w; where corners are.
#pragma once
#include <array>
#include <cstddef>
#include <string>

#include "solids/vmodel/v_model.h"

namespace veritope {

/// "v1" for face 3, at the end of the axis v.
inline std::string v_face_name(std::size_t face) { return {"uvw"[face / 2], "01"[face % 2]}; }
/// "u0v1" for edge 10, which runs along w at u = 0, v = 1 (the ends of the domain).
inline std::string v_edge_name(std::size_t edge) {
  const auto others = v_face_axes(edge / 4);
  return v_face_name(2 * others[0] + (edge & 1)) + v_face_name(2 * others[1] + (edge >> 1 & 1));
}
/// "u0v1w0" for corner 2.
inline std::string v_corner_name(std::size_t corner) {
  return v_face_name(corner & 1) + v_face_name(2 + (corner >> 1 & 1)) +
         v_face_name(4 + (corner >> 2 & 1));
}

/// Where corner e0 + 2 e1 + 4 e2 is, exactly.
std::array<Rational, 3> v_corner_point(const VVolume& cell, std::size_t corner);

}  // namespace veritope
