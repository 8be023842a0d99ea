// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/certify/crossing_planes.h: two flat patches that cross in a line, and what a test asks of a witness.
#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "solids/patches/patch_complex.h"
#include "verify/certify/crossing_witness.h"

namespace veritope::planted {

inline PatchComplex complex_of(std::vector<Patch> patches) {
  PatchInput input;
  input.patches = std::move(patches);
  return make_patch_complex(std::move(input)).value();
}

inline std::optional<CrossingCondition> broken(const PatchComplex& complex,
                                               const CrossingWitness& w) {
  return broken_condition(complex.patch(w.sheets[0].patch), complex.patch(w.sheets[1].patch), w);
}

// Bilinear: corner + u U + v V for u, v in [0, 1].
inline Patch flat(const PatchPoint& corner, const PatchPoint& u, const PatchPoint& v) {
  std::vector<Rational> c;
  for (std::size_t k = 0; k < 3; ++k)
    for (const int a : {0, 1})
      for (const int b : {0, 1})
        c.push_back(corner[k] + (a == 1 ? u[k] : Rational(0)) + (b == 1 ? v[k] : Rational(0)));
  return make_patch(BezierSurface<Rational>({1, 1}, 3, false, c)).value();
}

// z = 0 on [-1, 1]^2.
inline Patch floor_patch() { return flat({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}); }
// x = 0, y in [-1, 1], z in [bottom, bottom + 2].
inline Patch wall_patch(const Rational& bottom = Rational(-1)) {
  return flat({0, -1, bottom}, {0, 2, 0}, {0, 0, 2});
}

}  // namespace veritope::planted
