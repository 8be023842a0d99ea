// SPDX-License-Identifier: LGPL-3.0-or-later
// Solids of cubes, straight and bent.
#include <set>

#include "robust/base/check.h"
#include "solids/patch_shapes.h"
#include "solids/patch_shapes_internal.h"
#include "solids/patch_transform.h"

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
