// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/distance.h: comparisons of distances and of angles between rational points.
#pragma once
#include <array>

#include "predicates/exact_point.h"
#include "robust/base/sign.h"
#include "robust/cascade.h"
#include "robust/rational.h"

namespace veritope {

/// The sign of |p - q| - |p - r|.
Sign compare_distances(const ExactPoint3& p, const ExactPoint3& q, const ExactPoint3& r,
                       TierCounts* tally = nullptr);

/// The sign of the distance from the middle of a and b to `centre`, minus |centre - surface|: negative or zero iff the
/// closed ball around `centre` that has `surface` on its sphere contains the middle.
Sign compare_middle_to_ball(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& centre,
                            const ExactPoint3& surface, TierCounts* tally = nullptr);

/// The sign of the radius of the sphere through the four corners, minus factor |p - q|.
/// REQUIRES a tetrahedron that is not flat, factor >= 0.
Sign compare_circumradius(const std::array<const ExactPoint3*, 4>& tetrahedron,
                          const ExactPoint3& p, const ExactPoint3& q, const Rational& factor,
                          TierCounts* tally = nullptr);

/// The sign of the volume of the tetrahedron minus `volume`. REQUIRES orient3d of the corners >= 0.
Sign compare_volume(const std::array<const ExactPoint3*, 4>& tetrahedron, const Rational& volume,
                    TierCounts* tally = nullptr);

/// Whether the angle at b between a and c is less than the one, from 0 to a right one, whose squared cosine is given.
/// REQUIRES a != b, b != c.
bool is_angle_less(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                   const Rational& squared_cosine, TierCounts* tally = nullptr);

/// Whether the half-planes from the line a b through c and d enclose less than the angle whose squared cosine is given,
/// as above. REQUIRES triangles a b c and a b d that are not degenerate.
bool is_dihedral_less(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                      const ExactPoint3& d, const Rational& squared_cosine,
                      TierCounts* tally = nullptr);

/// Whether the path a, b, c turns at b by more than the angle, from 0 to a right one, whose squared cosine is given.
/// REQUIRES a != b, b != c.
bool turns_more(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                const Rational& squared_cosine, TierCounts* tally = nullptr);

/// Whether the triangles (a, b, c) and (b, a, d), which are two facets of one oriented surface, meet in the edge a b
/// with normals that enclose more than the angle whose squared cosine is given, as above.
/// REQUIRES triangles that are not degenerate.
bool folds_more(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                const ExactPoint3& d, const Rational& squared_cosine, TierCounts* tally = nullptr);

}  // namespace veritope
