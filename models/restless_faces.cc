// SPDX-License-Identifier: LGPL-3.0-or-later
#include "models/restless_faces.h"

#include <algorithm>
#include <utility>

#include "robust/base/check.h"
#include "robust/base/random.h"

namespace veritope::patch_shapes {
namespace {

constexpr std::int64_t kStepsOfMove = 1000;

Patch restless_face(int n, const Rational& z, Random& random) {
  const auto moved = [&](int i, bool is_inner) {
    Rational x = Rational(i) / Rational(n);
    if (is_inner)
      x += Rational(static_cast<std::int64_t>(random.below(2 * kStepsOfMove + 1)) - kStepsOfMove) /
           Rational(5 * kStepsOfMove * n);
    return x;
  };
  const bool is_top = z.sign() > 0;  // the bottom's normal points down
  Patch::Tensor map({n, n}, 3, false);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const auto at = static_cast<std::size_t>(is_top ? i * (n + 1) + j : j * (n + 1) + i);
      const bool is_inner = 0 < std::min(i, j) && std::max(i, j) < n;
      map.component(0)[at] = moved(i, is_inner);
      map.component(1)[at] = moved(j, is_inner);
      map.component(2)[at] = z;
    }
  return make_patch(std::move(map)).value();
}

}  // namespace

Patches restless_cube(int n, std::uint64_t seed) {
  VT_CHECK(2 <= n && n <= kMaxPatchDegree,
           "a face of no inner control points, or of a high degree");
  Random random(seed);
  Patches out = box({0, 0, 0}, {1, 1, 1});
  for (Patch& face : out)
    for (const int z : {0, 1}) {
      const auto heights = face.component(2);
      if (std::all_of(heights.begin(), heights.end(),
                      [&](const Rational& h) { return h == Rational(z); }))
        face = restless_face(n, Rational(z), random);
    }
  return out;
}

}  // namespace veritope::patch_shapes
