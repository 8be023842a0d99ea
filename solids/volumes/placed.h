// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/volumes/placed.h: cells moved by affine maps, and cells cut at a parameter.
#pragma once
#include <array>
#include <vector>

#include "solids/volumes/cell_maps.h"
#include "splines/affine_map.h"

namespace veritope {

/// x -> linear x + shift in space.
struct Placement {
  std::array<CellPoint, 3> linear{CellPoint{Rational(1), Rational(0), Rational(0)},
                                  CellPoint{Rational(0), Rational(1), Rational(0)},
                                  CellPoint{Rational(0), Rational(0), Rational(1)}};
  CellPoint shift{};
  friend bool operator==(const Placement&, const Placement&) = default;
};

Placement translation(const CellPoint& by);
/// x -> second(first(x)).
Placement after(const Placement& second, const Placement& first);
Rational determinant(const Placement& placement);
/// The largest entry of |M^T M - 1|, M the linear part: 0 iff M is a rotation or a rotation and a reflection. The
/// distance of M from the nearest such map, in the spectral norm, is at most three times this.
Rational distance_from_rotation(const Placement& placement);

/// The image of the map; coordinates beyond the third stay. REQUIRES a map in space.
template <std::size_t N>
BSpline<Rational, N> placed(const BSpline<Rational, N>& map, const Placement& placement) {
  const int n = map.dimension();
  const auto size = static_cast<std::size_t>(n);
  AffineMap affine{n, n, std::vector<Rational>(size * size), std::vector<Rational>(size)};
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < 3 && i < 3; ++j)
      affine.linear[i * size + j] = placement.linear[i][j];
    if (i < 3) affine.translation[i] = placement.shift[i];
    if (i >= 3) affine.linear[i * size + i] = Rational(1);
  }
  return transformed(map, affine);
}

/// The two parts of a cell, the one with the lower parameters first. @error kBadArgument unless the parameter lies
/// inside of the domain of the axis
Result<std::array<CellVolume, 2>> split(const CellVolume& cell, std::size_t axis,
                                        const Rational& at);

}  // namespace veritope
