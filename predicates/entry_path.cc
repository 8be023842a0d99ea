// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/entry_path.h"

namespace veritope {

// The determinant is a polynomial in ε. Where the point is on the plane, the coefficients after that of ε^0 are n (g
// - u), if the path has a target, and the coordinates of n = (b - a) x (c - a); as the point is on the plane, n (g -
// u) is the determinant at g.
Sign orient3d_entered(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                      const EntryPath& path, TierCounts* tally) {
  if (const Sign s = orient3d(a, b, c, path.start(), tally); s != Sign::kZero) return s;
  if (path.target())
    if (const Sign s = orient3d(a, b, c, *path.target(), tally); s != Sign::kZero) return s;
  for (int axis = 0; axis < 3; ++axis)
    if (const Sign s = orient2d_projected(a, b, c, axis, tally); s != Sign::kZero) return s;
  return Sign::kZero;
}

// The four volumes add up to that of the tetrahedron, so equal signs exclude a degenerate one.
bool is_entered(const std::array<const ExactPoint3*, 4>& t, const EntryPath& path,
                TierCounts* tally) {
  const auto &a = *t[0], &b = *t[1], &c = *t[2], &e = *t[3];
  const Sign s = orient3d_entered(a, b, c, path, tally);
  return s != Sign::kZero && orient3d_entered(a, c, e, path, tally) == s &&
         orient3d_entered(a, e, b, path, tally) == s && orient3d_entered(b, e, c, path, tally) == s;
}

}  // namespace veritope
