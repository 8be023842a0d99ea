// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/jack_volumes.h"

#include <array>
#include <cstddef>

#include "solids/micro/jack_maker_internal.h"

namespace veritope {
namespace {

const Rational kCubeMiddle = Rational(1) / Rational(2);

// A square across the axis of an arm.
struct ArmSquare {
  Rational at, half_width;
};

// The volume between the first and the last of the squares, whose places rise along the axis.
BezierVolume<Rational> volume_through(std::size_t axis, const std::vector<ArmSquare>& squares) {
  std::array<int, 3> degrees = {1, 1, 1};
  degrees[axis] = static_cast<int>(squares.size()) - 1;
  BezierVolume<Rational> out(degrees, 3, false);
  const Grid<3> grid = out.grid();
  for (std::size_t n = 0; n < grid.count(); ++n) {
    const std::array<std::size_t, 3> index = grid.index_of(n);
    const ArmSquare& square = squares[index[axis]];
    for (std::size_t a = 0; a < 3; ++a) {
      Rational& x = out.component(static_cast<int>(a))[n];
      if (a == axis)
        x = square.at;
      else
        x = index[a] == 0 ? kCubeMiddle - square.half_width : kCubeMiddle + square.half_width;
    }
  }
  return out;
}

}  // namespace

std::vector<BezierVolume<Rational>> jack_volumes(const JackShape& shape,
                                                 const WallNumbers& numbers) {
  const internal::JackMaker maker(shape);
  std::vector<BezierVolume<Rational>> out;
  out.push_back(volume_through(
      0, {{kCubeMiddle - shape.node, shape.node}, {kCubeMiddle + shape.node, shape.node}}));
  for (std::size_t wall = 0; wall < 6; ++wall) {
    if ((shape.arms >> wall & 1) == 0) continue;
    const Rational t = Rational(numbers[wall]) / Rational(kMaxWallNumber);
    std::vector<ArmSquare> squares;
    for (const internal::JackCrossSection& c : maker.profile()) {
      const Rational width = c.width.fixed + c.width.slope * t;
      if (wall % 2 == 1)
        squares.push_back({kCubeMiddle + c.distance, width});
      else
        squares.insert(squares.begin(), {kCubeMiddle - c.distance, width});
    }
    out.push_back(volume_through(wall / 2, squares));
  }
  return out;
}

}  // namespace veritope
