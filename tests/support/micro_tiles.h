// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/micro_tiles.h: tiles and cages of microstructures by hand and at random.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "robust/base/random.h"
#include "solids/micro/filter/tile_shape.h"
#include "splines/bezier_degree.h"
#include "splines/bezier_domain.h"

namespace veritope::micro_tiles {

using Surface = TileShape::Surface;
using Point = std::array<Rational, 3>;
/// A convex part of a body: the corner with the bits (x, y, z) of its number.
using Hexahedron = std::array<Point, 8>;

/// A tile; volumes whose union is its body; and, where its patches are flat, these as convex parts.
struct Tile {
  std::vector<Surface> patches;
  std::vector<BezierVolume<Rational>> volumes;
  std::vector<Hexahedron> parts;
};

inline Rational half() { return Rational(1) / Rational(2); }

/// The bilinear patch of four corners, (0,0), (1,0), (0,1), (1,1).
inline Surface bilinear(const std::array<Point, 4>& p) {
  Surface out({1, 1}, 3, false);
  for (std::size_t c = 0; c < 3; ++c) {
    const auto net = out.component(static_cast<int>(c));
    net[0] = p[0][c], net[1] = p[2][c], net[2] = p[1][c], net[3] = p[3][c];
  }
  return out;
}

/// The six faces of a hexahedron, outward if its corners lie as those of a cube.
inline std::vector<Surface> faces_of(const Hexahedron& h) {
  std::vector<Surface> out;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t end = 0; end < 2; ++end) {
      const std::size_t b = std::size_t{1} << (a + 1) % 3, c = std::size_t{1} << (a + 2) % 3,
                        at = end << a;
      const std::size_t u = end == 1 ? b : c, v = end == 1 ? c : b;
      out.push_back(bilinear({h[at], h[at | u], h[at | v], h[at | u | v]}));
    }
  return out;
}

inline Hexahedron hexahedron(const Point& lo, const Point& hi) {
  Hexahedron out;
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t c = 0; c < 3; ++c) out[i][c] = (i >> c & 1) != 0 ? hi[c] : lo[c];
  return out;
}

inline BezierVolume<Rational> volume_of(const Hexahedron& h) {
  BezierVolume<Rational> out({1, 1, 1}, 3, false);
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      out.component(static_cast<int>(c))[out.grid().at({i & 1, i >> 1 & 1, i >> 2})] = h[i][c];
  return out;
}

inline Tile box(const Point& lo, const Point& hi) {
  const Hexahedron h = hexahedron(lo, hi);
  return {faces_of(h), {volume_of(h)}, {h}};
}

/// A node of half-width `node` in the middle with an arm to each wall, which ends in a cap of half-width
/// caps[2 a + end] at the wall `end` of axis a. Arms are frusta (degree 1), or have the profile (node, node, cap, cap) of degree 3.
/// 30 patches, outward.
inline Tile jack(const Rational& node, const std::array<Rational, 6>& caps, int degree) {
  VT_CHECK(degree == 1 || degree == 3, "a jack has the degree 1 or 3");
  const Point low{half() - node, half() - node, half() - node},
      high{half() + node, half() + node, half() + node};
  Tile out;
  out.parts.push_back(hexahedron(low, high));
  out.volumes.push_back(volume_of(out.parts.front()));
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t end = 0; end < 2; ++end) {
      const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
      const Rational& cap = caps[2 * a + end];
      const Rational wall(end), base = end == 1 ? high[a] : low[a];
      Hexahedron arm;
      for (std::size_t i = 0; i < 8; ++i) {
        const bool is_at_wall = (i >> a & 1) == end;
        const Rational& width = is_at_wall ? cap : node;
        arm[i][a] = is_at_wall ? wall : base;
        for (const std::size_t k : {b, c})
          arm[i][k] = (i >> k & 1) != 0 ? half() + width : half() - width;
      }
      out.parts.push_back(arm);
      out.volumes.push_back(volume_of(arm));
      if (degree == 3) {
        // Along the arm the rows across it are those of the ends: (node, node, cap, cap).
        BezierVolume<Rational>& volume = out.volumes.back();
        volume = elevate(volume, a, 2);
        for (const std::size_t k : {b, c}) {
          const auto net = volume.component(static_cast<int>(k));
          volume.grid().for_each_line(a, [&](std::size_t first) {
            const std::size_t step = volume.grid().stride(a);
            net[first + step] = net[first];
            net[first + 2 * step] = net[first + 3 * step];
          });
        }
      }
      const std::vector<Surface> faces = faces_of(arm);
      for (std::size_t f = 0; f < 6; ++f) {
        if (f == 2 * a + 1 - end) continue;  // inside
        Surface face = faces[f];
        if (degree == 3 && f / 2 != a) {
          for (std::size_t axis = 0; axis < 2; ++axis) face = elevate(face, axis, 2);
          // The profile is that of the rows across the arm, which are the images of one row of the frustum.
          const auto x = face.component(static_cast<int>(a));
          const std::size_t step = x[0] == x[1] ? 4 : 1, across = 5 - step;
          for (const std::size_t k : {b, c}) {
            const auto y = face.component(static_cast<int>(k));
            for (std::size_t i = 0; i < 4; ++i) {
              Rational* const line = &y[i * across];
              line[step] = line[0];
              line[2 * step] = line[3 * step];
            }
          }
        }
        out.patches.push_back(std::move(face));
      }
    }
  if (degree == 3) out.parts.clear();
  return out;
}
inline Tile jack(int degree) {
  const Rational cap = Rational(1) / Rational(8);
  return jack(Rational(1) / Rational(5), {cap, cap, cap, cap, cap, cap}, degree);
}

inline TileShape shape_of(const Tile& tile) {
  return std::move(TileShape::make(tile.patches).value());
}

/// The map of degrees (l, m, n) whose control point (i, j, k) is point(i/l, j/m, k/n).
template <typename AtParameter>
BezierVolume<Rational> cage(std::array<int, 3> degrees, AtParameter point) {
  BezierVolume<Rational> out(degrees, 3, false);
  const Grid<3> grid = out.grid();
  for (std::size_t n = 0; n < grid.count(); ++n) {
    const auto at = grid.index_of(n);
    Point u;
    for (std::size_t a = 0; a < 3; ++a) u[a] = Rational(at[a]) / Rational(degrees[a]);
    const Point p = point(u);
    for (std::size_t c = 0; c < 3; ++c) out.component(static_cast<int>(c))[n] = p[c];
  }
  return out;
}

}  // namespace veritope::micro_tiles
