// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_similarity.h: coordinates of approximately 1, exactly, for searches in binary64.
#pragma once
#include <cstdint>
#include <span>

#include "solids/dms/dms_model.h"
#include "solids/dms/dms_region.h"

namespace veritope {

/// x = centre + 2^exponent u.
struct DmsSimilarity {
  DmsPoint centre;
  std::int64_t exponent = 0;

  bool is_identity() const { return exponent == 0 && centre == DmsPoint{}; }
  DmsPoint to_unit(DmsPoint x) const;
  DmsPoint from_unit(DmsPoint u) const;
  /// The plane of the images of a plane's points.
  DmsPlane to_unit(const DmsPlane& plane) const;
  /// Knots, and the coordinates of values, mapped. REQUIRES a model without an attribute domain.
  DmsModel to_unit(DmsModel model) const;
  DmsModel from_unit(DmsModel model) const;
};

/// One that brings the points into [-4, 4]^3, the longest side of their box to a length from 1 to 4. Points near the
/// origin whose box is neither huge nor tiny keep their coordinates: the identity. So do points that are all equal.
/// REQUIRES points.
DmsSimilarity similarity_of(std::span<const DmsPoint> points);

/// x 2^exponent, rounded up. REQUIRES x >= 0.
double scaled_up(double x, std::int64_t exponent);
/// An exponent e with 2^e < |x| < 2^(e+2). REQUIRES x != 0.
std::int64_t exponent_of(const Rational& x);

}  // namespace veritope
