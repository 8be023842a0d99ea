// SPDX-License-Identifier: LGPL-3.0-or-later
// Solids of cubes, straight and bent.
#include <set>

#include "models/patch_shapes.h"
#include "models/patch_shapes_internal.h"
#include "robust/base/check.h"
#include "solids/patches/patch_transform.h"

namespace veritope::patch_shapes {

using Cube = std::array<int, 3>;

// The face of `cube` at its low or high end of `axis`, seen from outside: see box.
std::array<Cube, 4> internal::cube_face(const Cube& cube, std::size_t axis, bool at_high) {
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  std::array<Cube, 4> corners;
  corners.fill(cube);
  if (at_high)
    for (Cube& p : corners) ++p[axis];
  ++corners[1][i], ++corners[2][i], ++corners[2][j], ++corners[3][j];
  if (!at_high) std::swap(corners[1], corners[3]);
  return corners;
}

Patches internal::block_faces(const std::vector<Cube>& cubes,
                              const std::function<Point(const Cube&)>& place) {
  const std::set<Cube> all(cubes.begin(), cubes.end());
  Patches out;
  for (const Cube& cube : all)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const bool at_high : {false, true}) {
        Cube next = cube;
        next[axis] += at_high ? 1 : -1;
        if (all.count(next) != 0) continue;
        std::array<Point, 4> corners;
        const auto face = cube_face(cube, axis, at_high);
        for (std::size_t k = 0; k < 4; ++k) corners[k] = place(face[k]);
        add(out, bilinear(corners));
      }
  return out;
}

Point internal::at_integers(const Cube& p) { return {p[0], p[1], p[2]}; }

Patches blocks(const std::vector<Cube>& cubes) {
  return internal::block_faces(cubes, internal::at_integers);
}

Patches wrinkled_cube() {
  // In the plane of the top: the fold p, q, m1, m2 with o in its middle; then the boundary, counterclockwise from E.
  constexpr int kHigh = 4;
  const int xy[][2] = {{-2, 0}, {2, 0},  {0, 1},  {0, -1},  {0, 0},  {4, 0}, {4, 4},
                       {0, 4},  {-4, 4}, {-4, 0}, {-4, -4}, {0, -4}, {4, -4}};
  enum {
    p,
    q,
    m1,
    m2,
    o,
    kEast,
    kNorthEast,
    kNorth,
    kNorthWest,
    kWest,
    kSouthWest,
    kSouth,
    kSouthEast
  };
  Patches out;
  const auto add_triangle = [&](const std::array<int, 3>& corners,
                                const std::array<int, 3>& heights) {
    Patch::Triangle map(1, 3, false);
    for (std::size_t i = 0; i < 3; ++i) {
      map.component(0)[i] = xy[corners[i]][0];
      map.component(1)[i] = xy[corners[i]][1];
      map.component(2)[i] = heights[i];
    }
    internal::add(out, std::move(map));
  };
  const std::array<int, 3> top{kHigh, kHigh, kHigh}, bottom{-kHigh, -kHigh, -kHigh};
  const std::array<int, 3> upper[] = {{p, m2, kNorth},
                                      {m2, q, kNorth},
                                      {p, kNorth, kNorthWest},
                                      {p, kNorthWest, kWest},
                                      {q, kEast, kNorthEast},
                                      {q, kNorthEast, kNorth},  // the upper sheet
                                      {o, q, m1},
                                      {o, m1, p},
                                      {o, p, kSouth},
                                      {o, kSouth, q},
                                      {p, kWest, kSouthWest},
                                      {p, kSouthWest, kSouth},
                                      {q, kSouth, kSouthEast},
                                      {q, kSouthEast, kEast},  // the lower one
                                      {p, m1, q},
                                      {p, q, m2}};  // between them, facing down
  for (const auto& corners : upper) add_triangle(corners, top);
  for (int i = 0; i < 8; ++i) {
    const int a = kEast + i, b = kEast + (i + 1) % 8;
    add_triangle({b, a, a}, {kHigh, kHigh, -kHigh});
    add_triangle({b, a, b}, {kHigh, -kHigh, -kHigh});
    if (a != kNorth && b != kNorth) add_triangle({kNorth, b, a}, bottom);
  }
  return out;
}

std::vector<Cube> internal::plate_cubes(int g) {
  VT_CHECK(g >= 0, "a plate with a negative number of holes");
  std::vector<Cube> cubes;
  for (int x = 0; x < 2 * g + 1; ++x)
    for (int y = 0; y < 3; ++y)
      if (x % 2 == 0 || y != 1) cubes.push_back({x, y, 0});
  return cubes;
}

Patches plate(int g) {
  const Patches straight = blocks(internal::plate_cubes(g));
  return sheared(sheared(straight, {2, 0, 0, Rational(1) / 16}), {1, 0, 2, Rational(1) / 32});
}

}  // namespace veritope::patch_shapes
