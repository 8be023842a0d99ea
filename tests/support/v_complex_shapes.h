// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/v_complex_shapes.h: V-complexes of polyhedra, given by the V-points of their faces' loops.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "topology/hexahedral_v_complex.h"
#include "topology/v_complex_data.h"

namespace veritope::v_shapes {

using Loop = std::vector<std::uint32_t>;  // V-points, the face on the left from outside
using Face = std::vector<Loop>;
using Polyhedron = std::vector<Face>;

/// The loop from its least point on; reversed, too.
inline Loop canonical_loop(Loop loop, bool is_reversed) {
  if (is_reversed) std::reverse(loop.begin(), loop.end());
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  return loop;
}

/// One V-curve between any two points; faces with the same loops, reversed, are glued if `is_glued`.
inline VComplexData data_of(const std::vector<Polyhedron>& cells, bool is_glued = true) {
  VComplexData out;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> curves;
  std::map<std::set<Loop>, HalfVSurfacePlace> faces;
  std::uint32_t cell = 0;
  for (const Polyhedron& polyhedron : cells) {
    VCellData& data = out.cells.emplace_back();
    data.trivariates = {0};
    std::uint32_t number = 0;
    for (const Face& face : polyhedron) {
      HalfVSurfaceData& half = data.half_surfaces.emplace_back();
      std::set<Loop> here, reversed;
      for (const Loop& loop : face) {
        here.insert(canonical_loop(loop, false));
        reversed.insert(canonical_loop(loop, true));
        std::vector<CurveUseData>& uses = half.loops.emplace_back();
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const std::uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
          out.num_points = std::max({out.num_points, a + 1, b + 1});
          const auto key = std::minmax(a, b);
          const auto found = curves.try_emplace({key.first, key.second}, out.curves.size());
          if (found.second) out.curves.push_back({key.first, key.second});
          uses.push_back({found.first->second, a < b});
        }
      }
      const HalfVSurfacePlace place{cell, number++};
      if (is_glued && faces.contains(reversed)) out.glued.push_back({faces[reversed], place});
      faces[here] = place;
    }
    ++cell;
  }
  return out;
}

inline VComplex complex_of(const std::vector<Polyhedron>& cells) {
  return make_v_complex(data_of(cells)).value();
}

/// A prism over the polygon of the points `bottom` (counterclockwise from above), with the points `top`.
inline Polyhedron prism(const Loop& bottom, const Loop& top) {
  Polyhedron out{{canonical_loop(bottom, true)}, {top}};
  const std::size_t n = bottom.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    out.push_back({{bottom[i], bottom[j], top[j], top[i]}});
  }
  return out;
}
inline Polyhedron cube() { return prism({0, 1, 2, 3}, {4, 5, 6, 7}); }
inline Polyhedron triangular_prism() { return prism({0, 1, 2}, {3, 4, 5}); }
inline Polyhedron tetrahedron() { return {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}}; }

/// A cube with a square hole from bottom to top, which have two loops each.
inline Polyhedron cube_with_through_hole() {
  Polyhedron out = cube();
  out[0].push_back({8, 9, 10, 11});    // in the bottom
  out[1].push_back({15, 14, 13, 12});  // in the top
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t j = (i + 1) % 4;
    out.push_back({{8 + j, 8 + i, 12 + i, 12 + j}});
  }
  return out;
}
/// A cube with a loop inside one face, which another face fills.
inline Polyhedron cube_with_window() {
  Polyhedron out = cube();
  out[1].push_back({11, 10, 9, 8});
  out.push_back({{8, 9, 10, 11}});
  return out;
}
/// A cube with a cubical void: a cell with two boundary surfaces.
inline Polyhedron cube_with_void() {
  Polyhedron out = cube();
  for (Face face : cube()) {
    for (std::uint32_t& p : face[0]) p += 8;
    std::reverse(face[0].begin(), face[0].end());
    out.push_back(face);
  }
  return out;
}

/// Unit cubes of the lattice 8^3; points at the same place are the same.
inline std::vector<Polyhedron> polycube(const std::vector<std::array<std::uint32_t, 3>>& cubes) {
  std::map<std::uint32_t, std::uint32_t> number;  // V-points without gaps
  std::vector<Polyhedron> out;
  for (const auto& [i, j, k] : cubes) {
    const auto at = [&, x = i, y = j, z = k](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      const std::uint32_t key = (x + a) + 16 * (y + b) + 256 * (z + c);
      return number.try_emplace(key, static_cast<std::uint32_t>(number.size())).first->second;
    };
    const Loop bottom{at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0)};
    const Loop top{at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)};
    out.push_back(prism(bottom, top));
  }
  return out;
}

/// Figure 3 of [ME16]: three cubes in an L.
inline std::vector<Polyhedron> three_in_an_l() {
  return polycube({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
}

/// A cuboid for hexahedral_v_complex, with pairs of its own faces glued.
inline void glue_faces(std::vector<HexahedralCell>& cells, std::uint32_t a, std::uint32_t f,
                       std::uint32_t b, std::uint32_t g, std::uint32_t symmetry) {
  cells[a].faces[f] = {HexahedralFace::Kind::kGlued, b, g, symmetry};
  cells[b].faces[g] = {HexahedralFace::Kind::kGlued, a, f, inverse_symmetry(symmetry)};
}

}  // namespace veritope::v_shapes
