// SPDX-License-Identifier: LGPL-3.0-or-later
// No predicate allocates on ordinary coordinates: counted, of operator new and of GMP.
#include <gmp.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "predicates/implicit_cache.h"
#include "predicates/implicit_predicates.h"
#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/perturbed.h"
#include "robust/base/random.h"

namespace {
thread_local std::size_t allocations = 0;
}
// Replaces new in the whole test binary. The other forms of new call this one.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size == 0 ? 1 : size)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace veritope {
namespace {

void* (*gmp_allocate)(std::size_t) = nullptr;
void* counted_allocate(std::size_t size) {
  ++allocations;
  return gmp_allocate(size);
}

class Allocations : public testing::Test {
 protected:
  void SetUp() override {
    mp_get_memory_functions(&gmp_allocate, &reallocate_, &free_);
    mp_set_memory_functions(counted_allocate, reallocate_, free_);
  }
  void TearDown() override { mp_set_memory_functions(gmp_allocate, reallocate_, free_); }

  Vec3d draw() { return {random_.unit() - 0.5, random_.unit() * 100, random_.unit()}; }

  Random random_{11};
  void* (*reallocate_)(void*, std::size_t, std::size_t) = nullptr;
  void (*free_)(void*, std::size_t) = nullptr;
};

template <typename Ask>
void expect_none(const char* what, Ask ask) {
  const std::size_t before = allocations;
  ask();
  EXPECT_EQ(allocations - before, 0u) << what;
}

TEST_F(Allocations, TheCounterCounts) {
  const std::size_t before = allocations;
  void* const volatile kept = ::operator new(8);  // a pair of new and delete may be left out
  ::operator delete(kept);
  EXPECT_EQ(allocations - before, 1u);
  const Integer a = power_of_two(64);  // outside int64_t
  EXPECT_GT(allocations - before, 1u);
}

TEST_F(Allocations, ExplicitPointsOfOrdinaryExponentsNeedNone) {
  for (int i = 0; i < 20; ++i) {
    const Vec3d a = draw(), b = draw(), c = draw(), d = draw(), e = draw();
    const Vec2d p{a.x, a.y}, q{b.x, b.y}, r{c.x, c.y}, s{d.x, d.y};
    const double tiny = 0x1p-30;
    expect_none("filtered", [&] {
      orient2d(p, q, r), orient3d(a, b, c, d), in_circle(p, q, r, s), in_sphere(a, b, c, d, e);
    });
    expect_none("exact zeros", [&] {
      orient2d(p, q, p), orient3d(a, b, c, a), in_circle(p, q, r, r), in_sphere(a, b, c, d, a);
      orient3d(a, b, {2 * a.x - b.x, 2 * a.y - b.y, 2 * a.z - b.z}, c);
    });
    expect_none("exact, of two limbs", [&] {
      internal::orient2d_exact(p, q, {r.x * tiny, r.y}),
          internal::orient3d_exact(a, b, c, {d.x * tiny, d.y, d.z});
      internal::in_circle_exact(p, q, r, {s.x * tiny, s.y}),
          internal::in_sphere_exact(a, b, c, d, {e.x * tiny, e.y, e.z});
    });
    expect_none("perturbed", [&] {
      orient2d_perturbed({p, q, p}, {1, 2, 3}), orient3d_perturbed({a, b, c, a}, {1, 2, 3, 4});
      in_circle_perturbed({p, p, p, p}, {4, 3, 2, 1}),
          in_sphere_perturbed({a, a, a, b, b}, {5, 4, 3, 2, 1});
    });
  }
}

TEST_F(Allocations, ImplicitPointsOfOrdinaryExponentsNeedNone) {
  for (int i = 0; i < 20; ++i) {
    std::array<Vec3d, 12> p;
    for (Vec3d& v : p) v = draw();
    expect_none("implicit", [&] {
      const LinePlanePoint l(p[0], p[1], p[2], p[3], p[4]), k(p[5], p[6], p[2], p[3], p[4]);
      const ThreePlanePoint t({p[2], p[3], p[4], p[5], p[6], p[7], p[8], p[9], p[10]});
      const CachedPoint cached_l(l), cached_k(k);
      const CachedPoint cached_t(t);
      const SegmentPoint s(p[2], p[3], 1, 3);
      const TrianglePoint w(p[2], p[3], p[4], 0.1, 0.2, 0.7);
      // All on the plane of p[2], p[3], p[4].
      orient3d(p[2], p[3], p[4], l), orient3d(p[2], p[3], p[4], t),
          orient3d(p[2], p[3], p[4], cached_t);
      orient3d(l, k, t, w), orient3d(cached_l, cached_k, cached_t, s), orient3d(p[11], l, t, s);
      orient2d_projected(l, t, l, 0), compare_lexicographic(l, cached_l),
          compare_along(p[9], t, cached_t);
      side_of_plane({p[8], 0.5}, t);
      in_sphere(l, k, t, w, s), in_sphere(l, k, t, w, cached_l),
          in_sphere(t, cached_t, p[0], p[1], p[2]);
    });
    expect_none("of three planes each", [&] {
      const ThreePlanePoint t({p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8]}),
          u({p[3], p[4], p[5], p[0], p[1], p[2], p[9], p[10], p[11]}),
          v({p[0], p[2], p[1], p[9], p[4], p[5], p[6], p[7], p[11]}),
          x({p[0], p[2], p[1], p[9], p[4], p[8], p[3], p[7], p[11]});
      EXPECT_EQ(orient3d(t, u, v, x), Sign::kZero);
      in_sphere(t, u, v, x, t);
    });
    expect_none("in the plane", [&] {
      const Vec2d a{p[0].x, p[0].y}, b{p[1].x, p[1].y}, c{p[2].x, p[2].y}, d{p[3].x, p[3].y};
      const SegmentSegmentPoint2d x(a, b, c, d), y(b, a, d, c);
      const SegmentPoint2d z(a, b, 0.3, 0.7);
      orient2d(x, y, z), orient2d(a, x, z), in_circle(x, y, z, a), in_circle(x, z, c, d),
          compare_lexicographic(x, y);
    });
  }
}

}  // namespace
}  // namespace veritope
