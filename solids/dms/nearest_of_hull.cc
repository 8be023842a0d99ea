// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/nearest_of_hull.h"

#include <cmath>

#include "solids/polyhedron/nearest_simplex.h"

namespace veritope::internal {
namespace {

constexpr int kMostSteps = 64;
constexpr double kNear = 1e-3;  // of the distance: how near to the nearest point is near enough

}  // namespace

double dot_product(const PlainVector& a, const PlainVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::optional<PlainVector> nearest_of_hull(
    const std::function<PlainVector(const PlainVector& w)>& least) {
  NearestSimplex simplex;
  PlainVector nearest = least({1, 0, 0});
  std::optional<PlainVector> best;  // with the greatest least product for its length
  double most = 0;
  for (int step = 0; step < kMostSteps; ++step) {
    const double length = std::sqrt(dot_product(nearest, nearest));
    if (!(length > 0) || !std::isfinite(length)) return best;
    const PlainVector next = least(nearest);
    const double product = dot_product(nearest, next) / length;
    if (product > most) best = nearest, most = product;
    if (product >= (1 - kNear) * length) return best;
    simplex.add({next[0], next[1], next[2]});
    Vec3d found;
    if (!simplex.nearest(found)) return best;  // the origin is inside
    nearest = {found.x, found.y, found.z};
  }
  return best;
}

}  // namespace veritope::internal
