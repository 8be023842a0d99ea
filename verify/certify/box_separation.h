// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/box_separation.h: the axis on which two boxes are farthest apart. Rounded: for searches only.
#pragma once
#include <algorithm>
#include <cstddef>

#include "robust/base/box3d.h"

namespace veritope {

struct Separation {
  std::size_t axis = 0;
  double distance = 0;    ///< 0: they touch
  bool is_above = false;  ///< b is
};
inline Separation separation(const Box3d& a, const Box3d& b) {
  Separation out;
  for (std::size_t k = 0; k < 3; ++k) {
    const double above = b.lo[k] - a.hi[k], below = a.lo[k] - b.hi[k];
    if (std::max(above, below) > out.distance) out = {k, std::max(above, below), above > below};
  }
  return out;
}

}  // namespace veritope
