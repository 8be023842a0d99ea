// SPDX-License-Identifier: LGPL-3.0-or-later
// Implicit points under every rounding mode and with FTZ and DAZ on, in a thread that did not notice.
#include <gtest/gtest.h>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include <vector>

#include "predicates/implicit_cache.h"
#include "predicates/implicit_predicates.h"
#include "tests/predicates/point_generators.h"

namespace veritope {
namespace {

#if defined(__SSE2__)

using generate::Points;
using generate::xy;

// Implicit points are made and asked in the hostile environment; their filters allow for it.
std::vector<int> implicit_answers(const Points& p, const Points& q) {
  const LinePlanePoint line(p[0], p[1], p[2], p[3], p[4]);
  const ThreePlanePoint planes({p[0], p[1], p[2], p[3], p[4], q[0], q[1], q[2], q[3]});
  const SegmentPoint segment(q[0], q[1], q[4].x, 3);
  const TrianglePoint triangle(p[2], p[3], p[4], 1, q[4].y, -7);
  const SegmentSegmentPoint2d crossing(xy(p[0]), xy(p[1]), xy(q[0]), xy(q[1])), same(xy(q[1]), xy(q[0]), xy(p[1]), xy(p[0]));
  std::vector<int> out{line.is_defined(), planes.is_defined(), crossing.is_defined()};
  const auto put = [&](Sign s) { out.push_back(to_int(s)); };
  put(orient3d(segment, triangle, p[2], p[3]));
  put(in_sphere(segment, triangle, p[2], p[3], q[4]));
  if (line.is_defined()) {
    put(orient3d(q[0], q[1], q[2], line)), put(orient3d(p[2], p[3], q[0], line));
    put(orient3d(line, segment, triangle, p[0])), put(compare_lexicographic(line, p[0]));
  }
  if (planes.is_defined()) {
    const CachedPoint cached(planes);
    put(orient3d(q[1], q[2], q[4], planes)), put(orient3d(p[3], p[4], q[0], cached)), put(compare_x(cached, q[0]));
    put(orient2d_projected(planes, segment, triangle, 1)), put(side_of_plane({q[0], 1}, planes));
  }
  if (crossing.is_defined()) {
    put(orient2d(crossing, xy(p[0]), xy(p[1]))), put(orient2d(crossing, same, xy(p[2])));
    put(in_circle(crossing, xy(p[2]), xy(p[3]), same)), put(compare_lexicographic(crossing, same));
  }
  return out;
}

TEST(HostileEnvironment, ImplicitPointsAnswerTheSameUnderEveryControlWord) {
  const unsigned usual_word = _mm_getcsr();
  for (int kind = 0; kind < generate::kNumKinds; ++kind) {
    Random random(57u + static_cast<unsigned>(kind));
    for (int i = 0; i < 100; ++i) {
      const Points p = generate::points(static_cast<generate::Kind>(kind), random),
                   q = generate::points(static_cast<generate::Kind>(kind), random);
      const std::vector<int> usual = implicit_answers(p, q);
      for (const unsigned extra : {0x2000u, 0x4000u, 0x6000u, 0x8000u, 0x0040u, 0x8040u, 0xe040u}) {
        _mm_setcsr(usual_word | extra);
        const std::vector<int> hostile = implicit_answers(p, q);
        const unsigned word_after = _mm_getcsr();
        _mm_setcsr(usual_word);
        ASSERT_EQ(usual, hostile) << generate::kKindNames[kind] << ", word " << extra << ": "
                                  << generate::text(p) << generate::text(q);
        ASSERT_EQ(word_after & 0xe040u, extra);
      }
    }
  }
}

#endif

}  // namespace
}  // namespace veritope
