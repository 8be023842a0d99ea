// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/volume_fold.h: two points of a volume at which the Jacobian determinant of its map has opposite signs.
// The theorem: docs/THEORY.md, INVALID-4. Design: docs/design/0054-folded-volumes-are-refuted.md.
#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "io/splines/spline_model.h"
#include "robust/base/sign.h"
#include "robust/rational.h"

namespace veritope {

/// A point of the closed domain of a volume, and a polynomial piece that holds it, in which derivatives are taken.
struct FoldPlace {
  std::array<std::uint64_t, 3>
      piece{};  ///< numbers on the axes: the pieces lie between different knots of the domain
  std::array<Rational, 3> at;  ///< from 0 to 1 along the piece's axes
};

struct VolumeFold {
  std::uint64_t entity = 0;
  std::array<FoldPlace, 2> places;  ///< where the determinant is positive, and where it is negative
};

/// The first volume of the model with such points among those that are examined: its corners, the middle of each
/// piece, and the points of each piece whose parameters are 0, 1/2 or 1 in it. Corners are decided exactly, and so are
/// the middles of pieces with numbers as short as in certificates; otherwise a sign that rounded intervals leave open
/// counts as none. Nothing found proves nothing. Volumes
/// that are not in space, or that may be torn at an inner knot (multiplicity over the degree), are not examined, nor
/// are those of a degree over 15, which certificates are not about.
/// @cost linear in the control points of the pieces, times their degrees
std::optional<VolumeFold> find_fold(const SplineModel& model);

/// The exact sign of the Jacobian determinant. REQUIRES a volume in space and a place on it.
Sign jacobian_sign(const ExactVolume& volume, const FoldPlace& place);

/// The parameters of the file. REQUIRES a place on the volume.
std::array<Rational, 3> parameters_at(const ExactVolume& volume, const FoldPlace& place);
/// The point in space. REQUIRES a volume in space and a place on it.
std::array<Rational, 3> point_at(const ExactVolume& volume, const FoldPlace& place);

/// Whether knots and control points of the place's piece are short enough for a certificate: B2 of its page.
/// REQUIRES clamped axes.
bool fits_certificate(const ExactVolume& volume, const FoldPlace& place);

}  // namespace veritope
