// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/random_expressions.h: what the soaks of curved expressions have in common.
#pragma once
#include <cstdint>

#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "solids/classify/point_answer.h"
#include "solids/expression/formula.h"
#include "solids/patches/patch_transform.h"

namespace veritope::bench {

using patch_shapes::Patches;

inline Rational ratio(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

// Other patches of one solid.
inline Patches in_another_way(const Patches& patches, Random& random) {
  switch (random.below(6)) {
    case 0: return subdivided(patches);
    case 1: return elevated(patches, 1);
    case 2: return relabelled(patches, random);
    case 3: return relabelled(subdivided(patches), random);
    case 4: return cut_along_belts(patches, random);
    default: return patches;
  }
}

inline AffineMap random_map(Random& random) {
  const auto entry = [&] {
    return ratio(static_cast<std::int64_t>(random.below(9)) - 4,
                 1 + static_cast<std::int64_t>(random.below(5)));
  };
  for (;;) {
    AffineMap out{3, 3, {}, {}};
    for (int i = 0; i < 9; ++i) out.linear.push_back(entry());
    for (int i = 0; i < 3; ++i) out.translation.push_back(entry());
    const auto& m = out.linear;
    const Rational det = m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
                         m[2] * (m[3] * m[7] - m[4] * m[6]);
    if (det.sign() != 0) return out;
  }
}
inline ExactPoint image_of(const AffineMap& map, const ExactPoint& p) {
  ExactPoint out;
  for (std::size_t r = 0; r < 3; ++r) {
    out[r] = map.translation[r];
    for (std::size_t c = 0; c < 3; ++c) out[r] += map.linear[3 * r + c] * p[c];
  }
  return out;
}

inline Formula random_formula(Random& random, std::uint64_t num_solids, std::uint64_t leaves) {
  if (leaves == 1) return Formula::variable(static_cast<std::uint32_t>(random.below(num_solids)));
  const std::uint64_t left = 1 + random.below(leaves - 1);
  const Formula a = random_formula(random, num_solids, left),
                b = random_formula(random, num_solids, leaves - left);
  switch (random.below(4)) {
    case 0:
    case 1: return Formula::any_of({a, b});
    case 2: return Formula::all_of({a, b});
    default: return Formula::all_of({a, b.negated()});
  }
}

}  // namespace veritope::bench
