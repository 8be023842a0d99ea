// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/nearest_of_hull.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace veritope::internal {
namespace {

constexpr int kMostSteps = 64;
constexpr double kNear = 1e-3;  // of the distance: how near to the nearest point is near enough

PlainVector minus(const PlainVector& a, const PlainVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
PlainVector cross(const PlainVector& a, const PlainVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The point of the line, plane or space through one to four points that is nearest to the origin, as a mean of them;
// nothing if they depend on each other or a weight is not positive.
std::optional<PlainVector> inner_nearest(const std::vector<PlainVector>& points) {
  if (points.size() == 4) {
    const PlainVector a = minus(points[1], points[0]), b = minus(points[2], points[0]),
                      c = minus(points[3], points[0]), normal = cross(b, c);
    const double volume = dot_product(a, normal);
    if (volume == 0) return std::nullopt;
    const double x = -dot_product(points[0], normal) / volume,
                 y = -dot_product(points[0], cross(c, a)) / volume,
                 z = -dot_product(points[0], cross(a, b)) / volume;
    if (!(x > 0 && y > 0 && z > 0 && x + y + z < 1)) return std::nullopt;
    return PlainVector{};
  }
  if (points.size() == 1) return points[0];
  const PlainVector a = minus(points[1], points[0]);
  double x = 0, y = 0;
  PlainVector b{};
  const double aa = dot_product(a, a), pa = -dot_product(points[0], a);
  if (points.size() == 2) {
    x = pa / aa;
  } else {
    b = minus(points[2], points[0]);
    const PlainVector normal = cross(a, b), p = {-points[0][0], -points[0][1], -points[0][2]};
    const double area = dot_product(normal, normal);
    x = dot_product(cross(p, b), normal) / area;
    y = dot_product(cross(a, p), normal) / area;
    if (!(y > 0)) return std::nullopt;
  }
  if (!(x > 0 && x + y < 1)) return std::nullopt;
  PlainVector out = points[0];
  for (std::size_t c = 0; c < 3; ++c) out[c] += x * a[c] + y * b[c];
  return out;
}

// Keeps those of one to four points that are needed for the nearest point of their hull.
PlainVector reduce(std::vector<PlainVector>* simplex) {
  std::vector<PlainVector> best;
  PlainVector nearest{};
  for (unsigned subset = 1; subset < 1u << simplex->size(); ++subset) {
    std::vector<PlainVector> some;
    for (std::size_t i = 0; i < simplex->size(); ++i)
      if ((subset >> i & 1u) != 0) some.push_back((*simplex)[i]);
    const auto found = inner_nearest(some);
    if (!found) continue;
    if (!best.empty() && dot_product(*found, *found) >= dot_product(nearest, nearest)) continue;
    nearest = *found;
    best = std::move(some);
  }
  *simplex = std::move(best);
  return nearest;
}

}  // namespace

double dot_product(const PlainVector& a, const PlainVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::optional<PlainVector> nearest_of_hull(
    const std::function<PlainVector(const PlainVector& w)>& least) {
  std::vector<PlainVector> simplex;
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
    if (std::find(simplex.begin(), simplex.end(), next) != simplex.end()) return best;
    if (simplex.empty()) simplex.push_back(nearest);
    simplex.push_back(next);
    nearest = reduce(&simplex);
    if (simplex.size() == 4) return best;  // the origin is inside
  }
  return best;
}

}  // namespace veritope::internal
