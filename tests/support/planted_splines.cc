// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/patch_model.h"
#include "models/patch_shapes.h"
#include "tests/support/planted_defects.h"

namespace veritope::planted {

using enum MeshRule;

std::vector<SplineExample> splines() {
  using namespace patch_shapes;
  const Patches ball = sphere(), cube = patch_shapes::box({0, 0, 0}, {1, 1, 1});
  const auto without = [](Patches patches, std::size_t i) {
    patches.erase(patches.begin() + static_cast<std::ptrdiff_t>(i));
    return patches;
  };
  return {
      {"an open side of a sphere", model_of(without(ball, 1)), kM3},
      {"spheres that cross",
       model_of(patch_shapes::joined({ball, placed(ball, 1, {1, Rational(1) / Rational(3), 0})})),
       kM7},
      {"a tiny sphere through a sphere",
       model_of(
           patch_shapes::joined({ball, placed(ball, Rational(1) / Rational(1000), {-1, 0, 0})})),
       kM7},
      {"a sphere inside out", model_of(patch_shapes::reversed(ball)), kM9},
      {"a patch twice",
       model_of(patch_shapes::joined(
           {cube, without(without(without(without(without(cube, 5), 4), 3), 2), 1)})),
       kM4},
  };
}

}  // namespace veritope::planted
