// SPDX-License-Identifier: LGPL-3.0-or-later
// Solids of revolution: cylinder, cone, teapot.
#include "models/patch_shapes.h"
#include "models/patch_shapes_internal.h"
#include "robust/base/check.h"

namespace veritope::patch_shapes {

using internal::PlaneCurve;
using internal::Scalar;

void internal::add_end(Patches& to, const EndDisk& disk) {
  const auto add_facing = [&](Patch::Tensor map, bool faces_up) {
    add(to, faces_up == disk.faces_up ? std::move(map) : swapped(map, 0, 1));
  };
  const Rational b = disk.radius / 2;
  std::array<Point, 4> square;
  for (int q = 0; q < 4; ++q) {
    const auto [x, y] = turned_xy(b, Rational(0), q);
    square[static_cast<std::size_t>(q)] = {disk.centre[0] + x, disk.centre[1] + y, disk.centre[2]};
  }
  add_facing(bilinear(square), true);
  const Scalar v = Scalar::linear(1, 0, 1), back = Scalar::linear(1, 1, 0);
  for (int q = 0; q < 4; ++q) {
    const PlaneCurve circle = quarter_circle(q);
    const Point &p = square[static_cast<std::size_t>(q)],
                &n = square[static_cast<std::size_t>(q + 1) % 4];
    const auto ruled = [&](std::size_t c, const std::vector<Rational>& outer,
                           const Rational& factor) {
      return back * Scalar::linear(0, p[c], n[c]) + v * Scalar(factor) * Scalar::along(0, outer);
    };
    add_facing(tensor_of(ruled(0, circle.x, disk.radius), ruled(1, circle.y, disk.radius),
                         ruled(2, circle.w, disk.height), back + v * Scalar::along(0, circle.w)),
               false);
  }
}

Patches frustum(const Rational& bottom, const Rational& top, const Rational& height) {
  VT_CHECK(bottom.sign() == Sign::kPositive && top.sign() != Sign::kNegative &&
               height.sign() == Sign::kPositive,
           "a frustum's measures are positive");
  Patches out;
  internal::add_revolved(out, {{{bottom, top}, {0, height}, {1, 1}}});
  internal::add_end(out, {bottom, 0, {0, 0, 0}, false});
  if (top.sign() != Sign::kZero) internal::add_end(out, {top, height, {0, 0, height}, true});
  return out;
}

namespace internal {

std::vector<PlaneCurve> teapot_profile() {
  const auto q = [](int p, int by) { return Rational(p) / Rational(by); };
  const std::vector<Rational> w{1, 1, 1, 1};
  return {{{0, 1, 2, 2}, {0, 0, 0, 1}, w},
          {{2, 2, 1, 1}, {1, 2, 2, q(5, 2)}, w},
          {{1, 1, q(1, 4), q(1, 4)}, {q(5, 2), 3, q(23, 8), q(25, 8)}, w},
          {{q(1, 4), q(1, 4), q(5, 8), q(5, 8)}, {q(25, 8), q(13, 4), q(13, 4), q(29, 8)}, w},
          {{q(5, 8), q(5, 8), q(1, 4), 0}, {q(29, 8), 4, 4, 4}, w}};
}

}  // namespace internal

Patches teapot() {
  Patches out;
  internal::add_revolved(out, internal::teapot_profile());
  return out;
}

}  // namespace veritope::patch_shapes
