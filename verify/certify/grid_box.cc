// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/grid_box.h"

#include <cmath>

namespace veritope {

double on_grid(double v, double unit) { return std::nearbyint(v / unit) * unit; }

CoverBox on_grid(const Box3d& box, double unit) {
  CoverBox out;
  out.unit = unit;
  for (std::size_t k = 0; k < 3; ++k) {
    out.star.box.lo[k] = std::floor(box.lo[k] / unit) * unit;
    out.star.box.hi[k] = std::ceil(box.hi[k] / unit) * unit;
  }
  return out;
}

CoverBox cube_around(const Point3d& middle, double half) {
  Box3d cube;
  for (std::size_t k = 0; k < 3; ++k) cube.lo[k] = middle[k] - half, cube.hi[k] = middle[k] + half;
  return on_grid(cube, std::exp2(std::ceil(std::log2(2 * half / kUnitsInBox))));
}

}  // namespace veritope
