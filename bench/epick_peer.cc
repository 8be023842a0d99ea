// SPDX-License-Identifier: LGPL-3.0-or-later
#include "bench/epick_peer.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace veritope::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
Kernel::Point_2 at(const Vec2d& p) { return {p.x, p.y}; }
Kernel::Point_3 at(const Vec3d& p) { return {p.x, p.y, p.z}; }

}  // namespace

long epick_orient2d(const Vec2d* p, std::size_t n) {
  long sum = 0;
  for (std::size_t i = 0; i < n; ++i, p += 3)
    sum += CGAL::orientation(at(p[0]), at(p[1]), at(p[2]));
  return sum;
}
long epick_orient3d(const Vec3d* p, std::size_t n) {
  long sum = 0;
  for (std::size_t i = 0; i < n; ++i, p += 4)
    sum += CGAL::orientation(at(p[0]), at(p[1]), at(p[2]), at(p[3]));
  return sum;
}
long epick_in_circle(const Vec2d* p, std::size_t n) {
  long sum = 0;
  for (std::size_t i = 0; i < n; ++i, p += 4)
    sum += CGAL::side_of_oriented_circle(at(p[0]), at(p[1]), at(p[2]), at(p[3]));
  return sum;
}
long epick_in_sphere(const Vec3d* p, std::size_t n) {
  long sum = 0;
  for (std::size_t i = 0; i < n; ++i, p += 5) {
    sum += CGAL::side_of_oriented_sphere(at(p[0]), at(p[1]), at(p[2]), at(p[3]), at(p[4]));
  }
  return sum;
}

}  // namespace veritope::bench
