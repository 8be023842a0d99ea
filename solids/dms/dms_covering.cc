// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_covering.h"

#include <algorithm>
#include <cstddef>

namespace veritope {
namespace {

using Corners = std::array<DmsPoint, 4>;

Rational with_corner(Corners corners, std::size_t m, const DmsPoint& p) {
  corners[m] = p;
  return six_volumes(corners);
}

}  // namespace

Rational six_volumes(const std::array<DmsPoint, 4>& corners) {
  return dot_product(
      difference(corners[1], corners[0]),
      cross_product(difference(corners[2], corners[0]), difference(corners[3], corners[0])));
}
bool contains(const std::array<DmsPoint, 4>& corners, const DmsPoint& p) {
  for (std::size_t m = 0; m < 4; ++m)
    if (with_corner(corners, m, p).sign() == Sign::kNegative) return false;
  return true;
}

bool DmsCovering::is_cut(std::uint32_t tetrahedron, const Corners& corners) const {
  std::vector<DmsPlane> planes = face_planes(corners);
  const std::vector<DmsPlane> of_root = face_planes(knots_.corners(tetrahedron));
  planes.insert(planes.end(), of_root.begin(), of_root.end());
  DmsRegion region(knots_, {corners.begin(), corners.end()}, planes);
  return region.find_cut(region.supports()).has_value();
}

bool DmsCovering::covers(std::uint32_t tetrahedron, const Corners& corners, const DmsPoint& x) {
  const Corners root = knots_.corners(tetrahedron);
  if (!std::all_of(corners.begin(), corners.end(),
                   [&](const DmsPoint& p) { return contains(root, p); }) ||
      is_cut(tetrahedron, corners))
    return false;
  const auto coefficients = pieces_.coefficients(corners);
  if (!coefficients) return false;
  Corners image;
  for (std::size_t m = 0; m < 4; ++m) {
    TetrahedralIndex at{};
    at[m] = degree_;
    image[m] = (*coefficients)[tetrahedral_index(at)];
  }
  const Sign sign = six_volumes(image).sign();
  if (sign == Sign::kZero) return false;
  for (std::size_t m = 0; m < 4; ++m) {
    const Rational of_x = with_corner(image, m, x);
    bool is_parted = true;
    for_each_tetrahedral_index(degree_, [&](const TetrahedralIndex& beta) {
      if (beta[m] != 0 || !is_parted) return;
      const DmsPoint& b = (*coefficients)[tetrahedral_index(beta)];
      is_parted = (of_x - with_corner(image, m, b)).sign() == sign;
    });
    if (!is_parted) return false;
  }
  return true;
}

}  // namespace veritope
