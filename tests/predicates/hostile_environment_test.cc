// SPDX-License-Identifier: LGPL-3.0-or-later
// The tiers after the filter do not rely on the floating-point environment: they answer the same under every rounding mode and with
// FTZ and DAZ on. (The filters do rely on it; robust/base/fp_guard.h refuses such a thread.)
#include <gtest/gtest.h>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include <vector>

#include "predicates/compare_along.h"
#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/side_of_plane.h"
#include "tests/predicates/point_generators.h"

namespace veritope {
namespace {

#if defined(__SSE2__)

using generate::Points;
using generate::xy;

std::vector<int> answers(const Points& p) {
  namespace in = internal;
  const Vec2d a = xy(p[0]), b = xy(p[1]), c = xy(p[2]), d = xy(p[3]);
  const PlaneCoefficients f{p[0], p[2].x};
  const auto sign3 = [](Sign3 s) { return static_cast<int>(s); };
  return {sign3(in::orient2d_lattice(a, b, c)),
          sign3(in::orient2d_interval(a, b, c)),
          to_int(in::orient2d_exact(a, b, c)),
          sign3(in::orient3d_lattice(p[0], p[1], p[2], p[3])),
          sign3(in::orient3d_interval(p[0], p[1], p[2], p[3])),
          to_int(in::orient3d_exact(p[0], p[1], p[2], p[3])),
          sign3(in::in_circle_interval(a, b, c, d)),
          to_int(in::in_circle_exact(a, b, c, d)),
          sign3(in::in_sphere_interval(p[0], p[1], p[2], p[3], p[4])),
          to_int(in::in_sphere_exact(p[0], p[1], p[2], p[3], p[4])),
          sign3(in::side_of_plane_interval(f, p[1])),
          to_int(in::side_of_plane_exact(f, p[1])),
          sign3(in::compare_along_interval(p[0], p[1], p[2])),
          to_int(in::compare_along_exact(p[0], p[1], p[2]))};
}

// The short lattice may refuse a little earlier with DAZ, but never contradicts: 2 is uncertain.
bool consistent(const std::vector<int>& usual, const std::vector<int>& hostile) {
  for (std::size_t i = 0; i < usual.size(); ++i) {
    const bool lattice = i == 0 || i == 4;
    if (usual[i] != hostile[i] && !(lattice && (usual[i] == 2 || hostile[i] == 2))) return false;
  }
  return true;
}

TEST(HostileEnvironment, ExactTiersAnswerTheSameUnderEveryControlWord) {
  const unsigned usual_word = _mm_getcsr();
  for (int kind = 0; kind < generate::kNumKinds; ++kind) {
    Random random(31u + static_cast<unsigned>(kind));
    for (int i = 0; i < 400; ++i) {
      const Points p = generate::points(static_cast<generate::Kind>(kind), random);
      const std::vector<int> usual = answers(p);
      for (const unsigned extra : {0x2000u, 0x4000u, 0x6000u, 0x8000u, 0x0040u, 0x8040u, 0xe040u}) {
        _mm_setcsr(usual_word | extra);
        const std::vector<int> hostile = answers(p);
        const unsigned word_after = _mm_getcsr();
        _mm_setcsr(usual_word);
        ASSERT_TRUE(consistent(usual, hostile))
            << generate::kKindNames[kind] << ", word " << extra << ": " << generate::text(p);
        ASSERT_EQ(word_after & 0xe040u, extra);
      }
    }
  }
}

#endif

}  // namespace
}  // namespace veritope
