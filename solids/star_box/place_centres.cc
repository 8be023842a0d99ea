// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/star_box/place_centres.h"

#include <algorithm>
#include <cmath>

namespace veritope {

Point3d mean_normal(PieceForest& forest, const std::vector<PieceForest::Id>& pieces,
                    NormalWeight weight) {
  Point3d sum{};
  for (const PieceForest::Id id : pieces) {
    const Point3d one = forest.approx_normal(id);
    const double unit = weight == NormalWeight::kSize ? 1 : std::hypot(one[0], one[1], one[2]);
    for (std::size_t k = 0; k < 3 && unit > 0; ++k) sum[k] += one[k] / unit;
  }
  return sum;
}

bool place_centres(const Point3d& direction, double part, StarBox* star) {
  double largest = 0;
  for (const double v : direction) largest = std::max(largest, std::abs(v));
  if (!(largest > 0) || !std::isfinite(largest)) return false;
  const Box3d& box = star->box;
  const Point3d middle = approx_centre(box);
  for (std::size_t k = 0; k < 3; ++k) {
    const double step = part * 0.5 * (box.hi[k] - box.lo[k]) * (direction[k] / largest);
    star->inside[k] = middle[k] - step;
    star->outside[k] = middle[k] + step;
  }
  return true;
}

bool are_centres(PieceForest& forest, const std::vector<PieceForest::Id>& pieces,
                 const StarBox& star) {
  for (const Point3d* const c : {&star.inside, &star.outside})
    for (std::size_t k = 0; k < 3; ++k)
      if (!(star.box.lo[k] < (*c)[k] && (*c)[k] < star.box.hi[k])) return false;
  return has_star_signs(forest, pieces, star);
}

}  // namespace veritope
