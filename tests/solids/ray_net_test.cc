// SPDX-License-Identifier: LGPL-3.0-or-later
// The nets of rays: doubles never contradict integers, and integers are right.
#include "solids/classify/ray_net_internal.h"

#include <gtest/gtest.h>

#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "solids/classify/patch_rays.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

using namespace internal;

constexpr std::uint64_t kSeed = 20261127;

bool is_certain(CommonSign s) { return s == CommonSign::kPositive || s == CommonSign::kNegative; }

std::vector<Patches> shapes() {
  return {patch_shapes::sphere(), patch_shapes::octant_sphere(),
          patch_shapes::one_patch_torus(3, 1), patch_shapes::pn_torus(12, 8)};
}

TEST(RayNet, RoundedSignsAreThoseOfIntegers) {
  Random random(kSeed);
  std::size_t certain = 0, only_exact = 0;
  for (const Patches& patches : shapes()) {
    const PatchComplex complex = complex_of(patches);
    const PatchRays rays(complex);
    NetPool pool;
    for (int i = 0; i < 200; ++i) {
      const auto patch = static_cast<std::uint32_t>(random.below(patches.size()));
      const TensorForm& form = rays.form(patch);
      // A point on the patch, or very near to it, so that signs are close.
      const RayPoint q(
          [&] {
            const TensorForm& f =
                rays.form(static_cast<std::uint32_t>(random.below(patches.size())));
            const std::size_t c = random.below(2) == 0 ? 0 : f.count() - 1;
            ExactPoint p;
            for (std::size_t k = 0; k < 3; ++k) {
              p[k] = Rational(f.exact[k][c], f.exact[3][c]);
              if (random.below(2) == 0)
                p[k] += Rational::power_of_two(-static_cast<std::int64_t>(random.below(120)));
            }
            return p;
          }(),
          rays.scale());
      RoundedNet rounded(form, q, pool);
      ExactNet exact(form, q);
      for (int depth = 0; depth < 24; ++depth) {
        const PlaneNormal n = rounded.normal();
        for (std::size_t k = 0; k < 4; ++k) {
          const CommonSign r = k < 3 ? rounded.sign(k) : rounded.side(n),
                           e = k < 3 ? exact.sign(k) : exact.side(n);
          if (is_certain(r)) {
            EXPECT_EQ(r, e) << "seed " << kSeed << " point " << i;
          }
          certain += is_certain(r) ? 1 : 0;
          only_exact += is_certain(e) && !is_certain(r) ? 1 : 0;
        }
        const std::size_t axis = random.below(2);
        RoundedNet rounded_half = rounded.halve(axis);
        ExactNet exact_half = exact.halve(axis);
        if (random.below(2) == 0) continue;
        for (std::size_t k = 0; k < 3; ++k) {
          const CommonSign r = rounded_half.sign(k);
          if (is_certain(r)) {
            EXPECT_EQ(r, exact_half.sign(k)) << "seed " << kSeed << " point " << i;
          }
        }
      }
    }
  }
  EXPECT_GT(certain, 10'000u);
  EXPECT_GT(only_exact, 10u);  // the comparison is close enough to tell something
}

// All six directions, in doubles and in integers, count the same.
TEST(PatchRays, AllDirectionsAgree) {
  Random random(kSeed);
  for (const Patches& patches : shapes()) {
    const PatchComplex complex = complex_of(patches);
    const PatchRays rays(complex);
    const Box3d& hull = rays.hull();
    for (int i = 0; i < 40; ++i) {
      double c[3];
      for (std::size_t k = 0; k < 3; ++k)
        c[k] = std::ldexp(hull.lo[k] + random.unit() * (hull.hi[k] - hull.lo[k]), rays.scale());
      const RayPoint q(Vec3d{c[0], c[1], c[2]}, rays.scale());
      std::optional<ShellWindings> first;
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (const bool is_upward : {false, true})
          for (const bool is_exact : {false, true}) {
            const RayCount count = is_exact ? rays.count_exactly(q, {axis, is_upward}, 64)
                                            : rays.count_rounded(q, {axis, is_upward});
            ASSERT_EQ(count.state, RayCount::State::kCounted) << "seed " << kSeed << " point " << i;
            if (!first) first = count.windings;
            EXPECT_EQ(*first, count.windings) << "seed " << kSeed << " point " << i;
          }
    }
  }
}

TEST(PatchRays, PiecesAtThePointStayOpen) {
  const PatchComplex complex = complex_of(patch_shapes::octant_sphere());
  const PatchRays rays(complex);
  const RayPoint q(Vec3d{0.6, 0.0, 0.8}, rays.scale()), pole(Vec3d{0, 0, 1}, rays.scale());
  for (const RayPoint* p : {&q, &pole}) {
    const RayCount rounded = rays.count_rounded(*p, {2, true});
    EXPECT_EQ(rounded.state, RayCount::State::kOpen);
    const RayCount exact = rays.count_exactly(*p, {2, true}, 8);
    EXPECT_EQ(exact.state, RayCount::State::kOpen);
    EXPECT_FALSE(exact.open.empty());
  }
}

}  // namespace
}  // namespace veritope
