// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/mesh/mesh_lanes_internal.h: the inner loops of a mesh, several points or quadrilaterals in one
// instruction: vertices in the unit cube, their images, and how flat quadrilaterals are. Every instruction set
// computes the same bits. Bounds: docs/bounds/micro_mesh.md. Internal to solids/micro/mesh.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solids/micro/mesh/rounded_cage_internal.h"

namespace veritope::internal {

/// Tables have this many elements more than points, so that a loop may read past the last one.
inline constexpr std::size_t kSpareLanes = 4;

/// Points, coordinate by coordinate.
struct PointColumns {
  std::array<std::vector<double>, 3> at;

  void resize(std::size_t n) {
    if (at[0].size() < n + kSpareLanes)
      for (std::vector<double>& x : at) x.resize(n + kSpareLanes);
  }
};

/// Points of the unit cube that are polynomials of the number of a wall, t = number / 2^20.
struct PointTable {
  static constexpr std::uint8_t kNoWall = 6;
  std::vector<std::uint8_t> wall;      ///< or kNoWall
  std::vector<PointColumns> of_power;  ///< the coefficients of 1, t, t^2, ...
  double error = 0;  ///< of the coordinates that place_points computes, for t in [0, 1]
};

/// By walls: t; at the end, 0.
using WallParameters = std::array<double, 7>;

/// Points begin, ..., end - 1 of the table, clamped to the unit cube, as the first ones of the result.
void place_points(const PointTable& table, std::size_t begin, std::size_t end,
                  const WallParameters& t, PointColumns& out);

/// Replaces the first n points, of the unit cube, by their images. The errors: RoundedCage::value_error.
void map_points(const RoundedCell& map, std::size_t n, PointColumns& points);

/// The roundings of map_points along an axis on which the map has this degree.
constexpr int map_roundings(int degree) { return (degree <= 1 ? degree : 2 * degree) + 1 + degree; }

/// out[i]: a bound as quad_gap (quad_gap_internal.h) has it for quadrilateral i, whose corners are points.
void quad_gaps(const PointColumns& points, const std::array<std::uint32_t, 4>* quads, std::size_t n,
               double* out);

/// Sets for this process whether no instruction is used that some x86-64 processor lacks: for tests.
void use_baseline_lanes(bool only_baseline);

}  // namespace veritope::internal
