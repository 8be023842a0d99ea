// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/filter/tile_shape.h: the surface of a tile in the unit cube, prepared for many cells.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "interval/box.h"
#include "interval/ring_numbers.h"
#include "robust/base/result.h"
#include "solids/patches/patch.h"

namespace veritope {

/// Polynomial tensor patches whose union is a closed surface in [0,1]^3, or curves and sheets, and what is needed of
/// them in every cell: their corners, each once, and bounds of their derivatives. Immutable: threads may share it.
class TileShape {
 public:
  using Surface = BezierSurface<Rational>;

  struct Side {
    Surface exact;
    BezierSurface<Interval> enclosed;
    /// Numbers of corners: of the parameters (0,0), (1,0), (0,1), (1,1).
    std::array<std::uint32_t, 4> corners{};
    /// For each axis and coordinate, bounds of the absolute value of the first and second derivative.
    std::array<Point3d, 2> first{}, second{};

    /// Whether the second degree is 0: the image is a curve.
    bool is_curve() const { return exact.degree(1) == 0; }
  };

  /// REQUIRES that the patches are the boundary of a body: embedded, closed, oriented (a certified tile). That is not
  /// examined.
  /// @error kBadArgument without patches, for a rational patch, one without three coordinates, of a degree that is not
  ///        in 1..kMaxPatchDegree, or with a control point out of the unit cube: the number of the patch is named
  static Result<TileShape> make(std::vector<Surface> patches);
  /// Any curves and sheets, which may cross each other, and bound nothing. A curve is a patch of the degrees (p, 0).
  /// @error as make, but that the second degree may be 0
  static Result<TileShape> make_open(std::vector<Surface> patches);

  bool is_open() const { return is_open_; }
  const std::vector<Side>& patches() const { return patches_; }
  const std::vector<Box3>& corners() const { return corners_; }
  const std::vector<PatchPoint>& exact_corners() const { return exact_corners_; }

 private:
  TileShape() = default;
  static Result<TileShape> make(std::vector<Surface> patches, bool is_open);

  bool is_open_ = false;
  std::vector<Side> patches_;
  std::vector<Box3> corners_;
  std::vector<PatchPoint> exact_corners_;
};

}  // namespace veritope
