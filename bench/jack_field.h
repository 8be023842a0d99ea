// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/jack_field.h: jacks in a straight cage as a field on a grid, as programs for implicit
// lattices make it.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "bench/surface_peers.h"
#include "solids/micro/microstructure.h"

namespace veritope::bench {

/// The union of n x n x n jacks with the node 1/5 in the unit cube, whose arms have the degree 1 or
/// 3 and the numbers of a grid's walls as half widths. Positive inside, 0 on the surface, in units
/// of a cell.
class JackField {
 public:
  JackField(const MicroGrid& grid, int degree);

  /// A grid with `parts` steps along the cube and one or two more beside it, moved by `shift`
  /// steps, with 0 <= shift < 1. With shift = 0, points lie on the sides of the cube, and so on the
  /// caps of the outer arms.
  FieldGrid sample(int parts, double shift) const;
  /// The value at a point of the unit cube.
  double at(const Vec3d& p) const;

 private:
  // What a coordinate says: the cell, the end of its axis that is nearer, the distance from the
  // cell's middle, how far along the arm that is, from 0 to 1, as its profile has it, and how far
  // outside of the cube.
  struct Place {
    std::size_t cell = 0, end = 0;
    float distance = 0, along = 0, outside = 0;
  };
  Place place_of(double x) const;
  float value(const std::array<Place, 3>& p, float u, float v, float w) const;
  const std::array<float, 6>& halves(std::size_t i, std::size_t j, std::size_t k) const {
    return halves_[(i * n_ + j) * n_ + k];
  }

  std::size_t n_;
  int degree_;
  std::vector<std::array<float, 6>> halves_;
};

}  // namespace veritope::bench
