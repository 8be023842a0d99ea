// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/epick_peer.h: loops over CGAL's EPICK predicates [CGAL55], compiled in a file of their own
// with the flags that CGAL needs.
#pragma once
#include <cstddef>

#include "predicates/vec.h"

namespace veritope::bench {

/// Sums of the signs over n tuples of 3, 4, 4 and 5 points in a row: a check value, and a reason
/// for the compiler to compute them all.
long epick_orient2d(const Vec2d* p, std::size_t n);
long epick_orient3d(const Vec3d* p, std::size_t n);
long epick_in_circle(const Vec2d* p, std::size_t n);
long epick_in_sphere(const Vec3d* p, std::size_t n);

}  // namespace veritope::bench
