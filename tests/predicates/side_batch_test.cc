// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/side_batch.h"

#include <gtest/gtest.h>
#include <immintrin.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <vector>

#include "robust/base/random.h"
#include "robust/binary64.h"

namespace veritope {
namespace {

struct Cloud {
  Vec3d a, b, c;
  std::vector<double> x, y, z;
  PointArrays points(std::size_t from, std::size_t n) const {
    return {x.data() + from, y.data() + from, z.data() + from, n};
  }
};

// kind 0: uniform; 1: integers, a third of them on the plane; 2: any finite bits; 3: near 2^-300.
Cloud cloud(Random& random, int kind, std::size_t n) {
  const auto number = [&] {
    if (kind == 0) return random.unit();
    if (kind == 1) return static_cast<double>(random.between(-9, 9));
    if (kind == 3) return std::ldexp(random.unit(), static_cast<int>(random.between(-320, -280)));
    for (;;) {
      const double v = std::bit_cast<double>(random.next());
      if (is_finite(v)) return v;
    }
  };
  const auto point = [&] { return Vec3d{number(), number(), number()}; };
  Cloud r{point(), point(), point(), {}, {}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    Vec3d p = point();
    if (kind == 1 && i % 3 == 0) {  // a + s (b - a) + t (c - a)
      const double s = static_cast<double>(random.between(-5, 5)), t = s + 1;
      p = {r.a.x + s * (r.b.x - r.a.x) + t * (r.c.x - r.a.x),
           r.a.y + s * (r.b.y - r.a.y) + t * (r.c.y - r.a.y),
           r.a.z + s * (r.b.z - r.a.z) + t * (r.c.z - r.a.z)};
    }
    r.x.push_back(p.x), r.y.push_back(p.y), r.z.push_back(p.z);
  }
  return r;
}

TEST(SideBatch, GivesTheAnswersOfThePlaneFilterOnEveryBackEndForAnyLengthAndStart) {
  Random random(31);
  std::printf("%zu back ends\n", internal::num_side_back_ends());
  for (int kind = 0; kind < 4; ++kind) {
    const Cloud k = cloud(random, kind, 64);
    const Orient3dPlaneFilter filter(k.a, k.b, k.c);
    for (std::size_t back_end = 0; back_end < internal::num_side_back_ends(); ++back_end) {
      for (std::size_t from = 0; from < 9; ++from) {
        for (std::size_t n = 0; n <= 40; ++n) {
          std::vector<Sign3> out(n + 1, Sign3::kZero);
          internal::orient3d_filter_on(back_end, k.a, k.b, k.c, k.points(from, n), out.data());
          for (std::size_t i = 0; i < n; ++i) {
            ASSERT_EQ(out[i], filter(k.points(from, n).at(i)))
                << "kind " << kind << " back end " << back_end << " [" << from << ", +" << n << ')';
          }
          ASSERT_EQ(out[n], Sign3::kZero) << "written beyond the end";
        }
      }
    }
  }
}

TEST(SideBatch, IsExactInAnyModeOfTheCaller) {
  Random random(32);
  for (int round = 0; round < 200; ++round) {
    const Cloud k = cloud(random, round % 4, 700);
    std::vector<Sign> want, got(k.x.size());
    for (std::size_t i = 0; i < k.x.size(); ++i)
      want.push_back(orient3d(k.a, k.b, k.c, k.points(0, k.x.size()).at(i)));
    TierCounts tally;
    orient3d(k.a, k.b, k.c, k.points(0, k.x.size()), got.data(), &tally);
    EXPECT_EQ(got, want) << round;
    EXPECT_EQ(
        tally[Tier::kFilter] + tally[Tier::kLattice] + tally[Tier::kInterval] + tally[Tier::kExact],
        k.x.size());
    if (round % 4 == 0) {
      EXPECT_GT(tally[Tier::kFilter], 650u);
    }
    if (round % 4 == 1) {
      EXPECT_GT(tally[Tier::kLattice], 0u);
    }
    std::vector<Sign> flushed(k.x.size());
    const unsigned saved = _mm_getcsr();
    _mm_setcsr(saved | 0xe040u);  // toward zero, FTZ, DAZ
    orient3d(k.a, k.b, k.c, k.points(0, k.x.size()), flushed.data());
    _mm_setcsr(saved);
    EXPECT_EQ(flushed, want) << round;
  }
}

}  // namespace
}  // namespace veritope
