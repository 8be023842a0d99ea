// SPDX-License-Identifier: LGPL-3.0-or-later
#include "models/patch_shapes.h"

#include "models/patch_shapes_internal.h"
#include "robust/base/check.h"
#include "solids/patches/patch_transform.h"

namespace veritope::patch_shapes {
namespace internal {

Patch::Tensor bilinear(const std::array<Point, 4>& corners) {
  Patch::Tensor out({1, 1}, 3, false);
  for (std::size_t c = 0; c < 3; ++c) {
    const auto to = out.component(static_cast<int>(c));
    to[0] = corners[0][c], to[2] = corners[1][c], to[3] = corners[2][c], to[1] = corners[3][c];
  }
  return out;
}

}  // namespace internal

namespace {

Patches renumbered(const Patches& patches) {
  Patches out;
  for (const Patch& p : patches) {
    if (p.is_triangle()) {
      internal::add(out, p.triangle());
    } else {
      internal::add(out, p.tensor());
    }
  }
  return out;
}

}  // namespace

Patches box(const Point& low, const Point& high) {
  // For each axis, the face at `high` runs along the next axis, then the one after it.
  Patches out;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool at_high : {false, true}) {
      const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
      std::array<Point, 4> corners;
      corners.fill(low);
      for (Point& p : corners) p[axis] = at_high ? high[axis] : low[axis];
      corners[1][i] = corners[2][i] = high[i];
      corners[2][j] = corners[3][j] = high[j];
      if (!at_high) std::swap(corners[1], corners[3]);
      internal::add(out, internal::bilinear(corners));
    }
  return out;
}

Patches placed(const Patches& patches, const Rational& factor, const Point& shift) {
  AffineMap map{3, 3, std::vector<Rational>(9), {shift[0], shift[1], shift[2]}};
  map.linear[0] = map.linear[4] = map.linear[8] = factor;
  const auto moved = affine_image(patches, map);
  VT_CHECK(moved.has_value(), "a model placed with the factor 0");
  return moved.value();
}

Patches joined(std::initializer_list<Patches> parts) {
  Patches all;
  for (const Patches& part : parts) all.insert(all.end(), part.begin(), part.end());
  return renumbered(all);
}

Patches reversed(const Patches& patches) {
  Patches out;
  for (const Patch& p : patches) out.push_back(reversed(p));
  return out;
}

}  // namespace veritope::patch_shapes
