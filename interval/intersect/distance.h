// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/intersect/distance.h: enclosures of the least and the greatest distance between points, curves and surfaces
// in up to three dimensions, and of the least distance between parts of one map that are not neighbours. Design:
// docs/design/0012-certified-solvers.md.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "interval/ring_numbers.h"
#include "robust/base/result.h"
#include "splines/bezier.h"
#include "splines/bspline.h"

namespace veritope {

/// A point, or the Bezier pieces of a curve or surface, in doubles with bounds: distances are measured between shapes.
class Shape {
 public:
  struct Piece {
    Bezier<Interval, 2> map;            // a curve has degree 0 along axis 1, a point along both
    std::array<std::size_t, 2> cell{};  // its place among the pieces
  };

  /// @error kBadArgument: dimension not 1 to 3, or a weight that is not positive
  static Result<Shape> point(std::span<const Rational> coordinates);
  static Result<Shape> of(const BSpline<Rational, 1>& curve);
  static Result<Shape> of(const BSpline<Rational, 2>& surface);

  int dimension() const { return dimension_; }
  const std::vector<Piece>& pieces() const { return pieces_; }
  /// True for two pieces that share a point of the domain, or a point of a glued border: the two borders of an axis
  /// along which the map closes exactly, or a border that is one point. A piece is its own neighbour.
  bool are_neighbours(const Piece& a, const Piece& b) const;

 private:
  template <std::size_t N>
  static Result<Shape> of_pieces(const BSpline<Rational, N>& map);

  int dimension_ = 0;
  std::vector<Piece> pieces_;
  std::array<std::size_t, 2> cells_{1, 1};
  std::array<bool, 2> is_closed_{};                    // along an axis
  std::array<std::array<bool, 2>, 2> is_collapsed_{};  // [axis][end]: that border is a point
};

struct DistanceOptions {
  double relative_width = 0x1p-20;  ///< wanted: hi - lo <= relative_width * hi
  double absolute_width = 0x1p-40;  ///< or hi - lo <= this
  std::uint64_t max_pairs = 200000;
};

struct DistanceEnclosure {
  Interval distance;         ///< encloses the distance; empty without two parts to compare
  bool is_as_asked = false;  ///< as narrow as the options require; false if max_pairs were spent
  std::uint64_t pairs = 0;   ///< pairs of parts that were examined
};

/// min |x - y| and max |x - y| over x in a, y in b. @cost branch and bound; the bounds of a pair of parts are off by
/// the square of their size.
/// @error kBadArgument: different dimensions, or options that are not positive
Result<DistanceEnclosure> least_distance(const Shape& a, const Shape& b,
                                         const DistanceOptions& options = {});
Result<DistanceEnclosure> greatest_distance(const Shape& a, const Shape& b,
                                            const DistanceOptions& options = {});

/// min |x - y| over x and y in pieces that are not neighbours: the seed's least distance of parts of a boundary that do
/// not meet [SSP01] 3, for the parts into which the knots cut the map; more knots make finer parts. 0 iff the map meets
/// itself outside of neighbours.
Result<DistanceEnclosure> least_self_distance(const Shape& shape,
                                              const DistanceOptions& options = {});

}  // namespace veritope
