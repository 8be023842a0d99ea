// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/exact_in_sphere.h: on which side of the sphere through four rational points does a fifth lie?
#pragma once
#include "predicates/exact_point.h"
#include "robust/base/sign.h"
#include "robust/cascade.h"

namespace veritope {

/// Like in_sphere of explicit points: if orient3d(a, b, c, d) > 0, positive iff e lies inside the sphere through a, b,
/// c, d. The filter and the lattice are asked only where all five points are binary64 ones.
Sign in_sphere(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
               const ExactPoint3& d, const ExactPoint3& e, TierCounts* tally = nullptr);

namespace internal {
Sign3 in_sphere_interval(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                         const ExactPoint3& d, const ExactPoint3& e);
Sign in_sphere_exact(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                     const ExactPoint3& d, const ExactPoint3& e);
}  // namespace internal

}  // namespace veritope
