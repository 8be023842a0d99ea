// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/volumes/axis_turn.h: rotations about any rational axis, by quaternions that need not have length 1.
#pragma once
#include <vector>

#include "solids/volumes/cell_maps.h"
#include "solids/volumes/placed.h"

namespace veritope {

/// The line of the points point + t direction.
struct TurnAxis {
  CellPoint point{}, direction{};
};

/// The quaternion a + b d, d the direction of the axis: it turns by the angle 2 atan2(b |d|, a), and
///   x -> (a^2 - b^2 |d|^2) x + 2 b^2 (d·x) d + 2 a b d x x
/// is this rotation times a^2 + b^2 |d|^2. No square root is needed, whatever the length of d.
struct HalfTurn {
  Rational a, b;
  friend bool operator==(const HalfTurn&, const HalfTurn&) = default;
};

/// A turn from 0 to an angle: q_0 = 1, ..., q_n, each less than 180 degrees beyond the one before (<q_i, q_i+1> > 0),
/// so that the quaternions (1 - t) q_i + t q_i+1 turn from one to the next.
struct Turn {
  std::vector<HalfTurn> stops;
  Rational degrees;  ///< as asked for
  Rational
      error;  ///< the angle of q_n is at most so many degrees from it; 0: it is exactly this angle
};

/// The largest error of the tangent of half the angle, or of its cotangent if that is less than 1: 2^-50.
Rational max_half_angle_error();

/// The turn by `degrees` about a direction. Multiples of 180 degrees are exact, and of 90 if the length of the
/// direction is rational; other angles end at the simplest rational that is at most max_half_angle_error() from the
/// tangent of half the angle (from the cotangent, where it is less than 1), relatively so for small tangents.
/// @error kBadArgument unless 0 < degrees <= 360, and for the direction 0
Result<Turn> make_turn(const CellPoint& direction, const Rational& degrees);

/// The rotation by any number of degrees, exactly a rotation; `error` as in Turn.
struct Rotation {
  Placement placement;
  Rational error;
};
/// @error kBadArgument for the direction 0
Result<Rotation> make_rotation(const TurnAxis& axis, const Rational& degrees);

/// The control points of the surface under the bilinear form of two quaternions, whose quadratic form is the rotation:
/// those of a row of a volume of revolution. REQUIRES a rational surface in space.
CellSurface turned_row(const CellSurface& surface, const TurnAxis& axis, const HalfTurn& p,
                       const HalfTurn& q);

/// (u, v, w) -> the surface turned about the axis: each step is a rational arc of degree 2 over an interval
/// of length 1; at 0 and at a full turn the volume has the same homogeneous control points. Coordinates beyond the
/// third do not turn.
/// @error kBadArgument for a surface that is not in space, that lies on the axis, or that is in a plane with the axis
///        and has points on both of its sides (with their parameters); kOverLimit
Result<CellVolume> revolved(const CellSurface& surface, const TurnAxis& axis, const Turn& turn);

}  // namespace veritope
