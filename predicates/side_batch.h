// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/side_batch.h: on which side of the plane through a, b, c does each of many points lie?
// The filter of orient3d.h over arrays of coordinates, several points per instruction; the instruction set is chosen at
// run time.  Bound: docs/bounds/orient3d.md.
#pragma once
#include <cstddef>

#include "predicates/orient3d.h"

namespace veritope {

/// n points, axis by axis. No alignment is required.
struct PointArrays {
  const double* x = nullptr;
  const double* y = nullptr;
  const double* z = nullptr;
  std::size_t n = 0;
  Vec3d at(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

/// out[i] = Orient3dPlaneFilter(a, b, c)(points.at(i)), the same answer on every back end: never zero, a
/// sign or uncertain. Computes to nearest with gradual underflow whatever the caller's control word is.
void orient3d_filter(const Vec3d& a, const Vec3d& b, const Vec3d& c, const PointArrays& points,
                     Sign3* out) noexcept;

/// out[i] = orient3d(a, b, c, points.at(i)), exact: the filter, then its uncertain points one by one.
/// REQUIRES finite coordinates.
void orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const PointArrays& points, Sign* out,
              TierCounts* tally = nullptr) noexcept;

namespace internal {
// The filter on one back end of those that this processor has, the widest last.
std::size_t num_side_back_ends() noexcept;
void orient3d_filter_on(std::size_t back_end, const Vec3d& a, const Vec3d& b, const Vec3d& c,
                        const PointArrays& points, Sign3* out) noexcept;
}  // namespace internal
}  // namespace veritope
