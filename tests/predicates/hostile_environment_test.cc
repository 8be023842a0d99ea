// SPDX-License-Identifier: LGPL-3.0-or-later
// The tiers after the filter do not rely on the floating-point environment: they answer the same under every rounding mode and with
// FTZ and DAZ on. The filters do rely on it: a thread that begins in another environment, or says that its environment has changed,
// decides without them, so that the predicates answer the same, too.
#include <gtest/gtest.h>

#include <cfenv>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "interval/upward.h"
#include "predicates/compare_along.h"
#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/order_on_circle.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/segment_segment2d.h"
#include "predicates/session.h"
#include "predicates/side_of_plane.h"
#include "robust/base/fp_guard.h"
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
  return {sign3(in::orient2d_zero_line(a, b, c)),
          sign3(in::orient2d_zero_line(a, {a.x, b.y}, {a.x, c.y})),
          sign3(in::orient2d_lattice(a, b, c)),
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

// What the callers see; a session of the points' own box among it.
std::vector<int> signs(const Points& p, TierCounts* tally) {
  const Vec2d flat[] = {xy(p[0]), xy(p[1]), xy(p[2]), xy(p[3])};
  const PlaneCoefficients f{p[0], p[2].x};
  const Session2d plane = Session2d::around(flat, 4);
  const Session3d space = Session3d::around(p.data(), p.size());
  return {to_int(orient2d(flat[0], flat[1], flat[2], tally)),
          to_int(orient3d(p[0], p[1], p[2], p[3], tally)),
          to_int(in_circle(flat[0], flat[1], flat[2], flat[3], tally)),
          to_int(in_sphere(p[0], p[1], p[2], p[3], p[4], tally)),
          to_int(side_of_plane(f, p[1], tally)),
          to_int(compare_along(p[0], p[1], p[2], tally)),
          to_int(plane.orient2d(flat[0], flat[1], flat[2], tally)),
          to_int(plane.in_circle(flat[0], flat[1], flat[2], flat[3], tally)),
          to_int(space.orient3d(p[0], p[1], p[2], p[3], tally)),
          to_int(space.in_sphere(p[0], p[1], p[2], p[3], p[4], tally))};
}

constexpr unsigned kHostileWords[] = {0x2000u, 0x4000u, 0x6000u, 0x8000u,
                                      0x0040u, 0x8040u, 0xe040u};

void on_all_kinds(std::uint64_t seed,
                  const std::function<void(const Points&, const std::string&)>& check) {
  for (int kind = 0; kind < generate::kNumKinds; ++kind) {
    Random random(seed + static_cast<unsigned>(kind));
    for (int i = 0; i < 300; ++i) {
      const Points p = generate::points(static_cast<generate::Kind>(kind), random);
      check(p, std::string(generate::kKindNames[kind]) + ": " + generate::text(p));
    }
  }
}

// `enter` is called once in each thread that has another control word: one thread for thirty cases, since a busy
// machine takes its time to start one.
void expect_the_same_signs(const std::function<void()>& enter) {
  struct Case {
    Points points;
    std::string text;
    std::vector<int> usual, hostile;
    TierCounts tally;
  };
  for (const unsigned extra : kHostileWords) {
    std::vector<Case> cases;
    const auto decide = [&] {
      std::thread([&] {
        _mm_setcsr(0x1f80u | extra);
        enter();
        for (Case& c : cases) c.hostile = signs(c.points, &c.tally);
      }).join();
      for (const Case& c : cases) {
        ASSERT_EQ(c.usual, c.hostile) << "word " << extra << ", " << c.text;
        ASSERT_EQ(c.tally[Tier::kFilter], 0u) << "word " << extra << ", " << c.text;
      }
      cases.clear();
    };
    on_all_kinds(71, [&](const Points& p, const std::string& text) {
      cases.push_back({p, text, signs(p, nullptr), {}, {}});
      if (cases.size() == 30) decide();
    });
    if (!cases.empty()) decide();
  }
}

TEST(HostileEnvironment, AThreadThatBeginsInOneDecidesWithoutFilters) {
  expect_the_same_signs([] {});
}

TEST(HostileEnvironment, AThreadThatSaysThatItsWordHasChangedDoesSo) {
  expect_the_same_signs([] {
    const unsigned word = _mm_getcsr();
    _mm_setcsr(0x1f80u);
    EXPECT_TRUE(filters_are_sound());
    _mm_setcsr(word);
    refresh_fp();
    EXPECT_FALSE(filters_are_sound());
  });
}

TEST(HostileEnvironment, ASessionNoticesAChangeAndServesOtherThreads) {
  const Vec3d p[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::thread([&] {
    EXPECT_TRUE(filters_are_sound());
    _mm_setcsr(0x1f80u | 0x4000u);
    const Session3d session = Session3d::around(p, 4);
    EXPECT_FALSE(filters_are_sound());
    TierCounts here, there;
    EXPECT_EQ(session.orient3d(p[0], p[1], p[2], p[3], &here), Sign::kPositive);
    EXPECT_EQ(here[Tier::kFilter], 0u);
    std::thread([&] {
      _mm_setcsr(0x1f80u);
      EXPECT_EQ(session.orient3d(p[0], p[1], p[2], p[3], &there), Sign::kPositive);
    }).join();
    EXPECT_EQ(there[Tier::kFilter], 1u);
    _mm_setcsr(0x1f80u);
    refresh_fp();
    EXPECT_TRUE(filters_are_sound());
  }).join();
}

TEST(HostileEnvironment, PredicatesInsideAScopeThatRoundsUpwardDecideWithoutFilters) {
  on_all_kinds(72, [](const Points& p, const std::string& text) {
    const std::vector<int> usual = signs(p, nullptr);
    std::vector<int> inside;
    TierCounts tally, after;
    {
      const ScopedUpward upward;
      inside = {to_int(orient2d(xy(p[0]), xy(p[1]), xy(p[2]), &tally)),
                to_int(orient3d(p[0], p[1], p[2], p[3], &tally)),
                to_int(in_circle(xy(p[0]), xy(p[1]), xy(p[2]), xy(p[3]), &tally)),
                to_int(in_sphere(p[0], p[1], p[2], p[3], p[4], &tally))};
    }
    ASSERT_TRUE(std::equal(inside.begin(), inside.end(), usual.begin())) << text;
    ASSERT_EQ(tally[Tier::kFilter], 0u);
    orient2d({0, 0}, {1, 0}, {0, 1}, &after);
    ASSERT_EQ(after[Tier::kFilter], 1u);
  });
}

TEST(HostileEnvironment, SubnormalPointsAreNotTakenForEqualOnes) {
  const unsigned usual_word = _mm_getcsr();
  const double least = 0x1p-1074;
  _mm_setcsr(usual_word | 0x8040u);
  refresh_fp();
  const Sign order = order_on_circle({0, 0}, {least, 0}, {0, 1}, {-1, 0});
  const SegmentContact contact = segment_segment2d(
      {-2 * least, -2 * least}, {2 * least, -2 * least}, {least, -2 * least}, {0, -2 * least});
  _mm_setcsr(usual_word);
  refresh_fp();
  EXPECT_EQ(order, Sign::kPositive);
  EXPECT_EQ(contact, SegmentContact::kOverlap);
}

#if defined(__GLIBC__)
// A filter that overflows still traps: it computes before it is asked whether it counts.
TEST(HostileEnvironment, TheProbeDoesNotTrap) {
  Sign small = Sign::kZero;
  bool are_sound = true;
  std::thread([&] {
    feenableexcept(FE_OVERFLOW | FE_INVALID | FE_DIVBYZERO);
    small = orient2d({0, 0}, {1, 0}, {0, 1});
    are_sound = filters_are_sound();
  }).join();
  EXPECT_EQ(small, Sign::kPositive);
  EXPECT_FALSE(are_sound);
}
#endif

TEST(HostileEnvironment, TheFirstDecisionOfAThreadIsTheFiltersToo) {
  TierCounts tally;
  std::thread([&] { orient2d({0, 0}, {1, 0}, {0, 1}, &tally); }).join();
  EXPECT_EQ(tally[Tier::kFilter], 1u);
}

#endif

}  // namespace
}  // namespace veritope
