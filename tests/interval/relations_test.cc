// SPDX-License-Identifier: LGPL-3.0-or-later
// relations.h and numeric.h, beyond the cases of ITF1788: against their definitions on a small grid.
#include "interval/relations.h"

#include <gtest/gtest.h>
#include <immintrin.h>

#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "interval/numeric.h"
#include "interval/reduction.h"
#include "robust/base/check.h"
#include "tests/interval/draw.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Intervals with ends in {0, 2, 4, 6}; the points 0, 1, ..., 6 tell their relations.
std::vector<Interval> grid() {
  std::vector<Interval> out{Interval::empty()};
  for (int lo = 0; lo <= 6; lo += 2)
    for (int hi = lo; hi <= 6; hi += 2) out.push_back(Interval::from_bounds(lo, hi));
  return out;
}
std::vector<int> points(const Interval& a) {
  std::vector<int> out;
  for (int p = 0; p <= 6; ++p)
    if (contains(a, Rational(p))) out.push_back(p);
  return out;
}
template <typename F>
bool all_pairs(const Interval& a, const Interval& b, F f) {
  for (int x : points(a))
    for (int y : points(b))
      if (!f(x, y)) return false;
  return true;
}
template <typename F>
bool each_has(const Interval& a, const Interval& b, F f) {
  for (int x : points(a)) {
    bool some = false;
    for (int y : points(b)) some = some || f(x, y);
    if (!some) return false;
  }
  return true;
}

TEST(Relations, AreWhatTheirQuantifiersSay) {
  for (const Interval& a : grid()) {
    for (const Interval& b : grid()) {
      const auto x = points(a), y = points(b);
      const std::string pair = to_string(a) + " " + to_string(b);
      const bool empty = x.empty() || y.empty();
      EXPECT_EQ(is_subset(a, b), each_has(a, b, [](int p, int q) { return p == q; })) << pair;
      EXPECT_EQ(is_disjoint(a, b), all_pairs(a, b, [](int p, int q) { return p != q; })) << pair;
      EXPECT_EQ(precedes(a, b), all_pairs(a, b, [](int p, int q) { return p <= q; })) << pair;
      EXPECT_EQ(strictly_precedes(a, b), all_pairs(a, b, [](int p, int q) { return p < q; }))
          << pair;
      EXPECT_EQ(is_less(a, b), each_has(a, b, [](int p, int q) { return p <= q; }) &&
                                   each_has(b, a, [](int q, int p) { return p <= q; }))
          << pair;
      EXPECT_EQ(a == b, x == y) << pair;
      EXPECT_EQ(points(intersection(a, b)).empty(), is_disjoint(a, b)) << pair;
      for (int p = 0; p <= 6; ++p)
        EXPECT_EQ(is_member(p, intersection(a, b)), is_member(p, a) && is_member(p, b)) << pair;
      EXPECT_TRUE(is_subset(a, hull(a, b)) && is_subset(b, hull(a, b))) << pair;
      const Sign3 order = compare(a, b);
      EXPECT_EQ(order == Sign3::kNegative, !empty && strictly_precedes(a, b)) << pair;
      EXPECT_EQ(order == Sign3::kPositive, !empty && strictly_precedes(b, a)) << pair;
      EXPECT_EQ(order == Sign3::kZero, x.size() == 1 && x == y) << pair;
      if (empty) continue;
      EXPECT_EQ(min(a, b), Interval::from_bounds(std::min(x.front(), y.front()),
                                                 std::min(x.back(), y.back())));
      EXPECT_EQ(max(a, b), Interval::from_bounds(std::max(x.front(), y.front()),
                                                 std::max(x.back(), y.back())));
    }
  }
}

TEST(Relations, EveryStateOfOverlapOccursAndMirrors) {
  std::set<Overlap> seen;
  const auto mirrored = [](Overlap o) {
    if (o == Overlap::kBothEmpty) return o;
    if (o == Overlap::kFirstEmpty) return Overlap::kSecondEmpty;
    if (o == Overlap::kSecondEmpty) return Overlap::kFirstEmpty;
    const int first = static_cast<int>(Overlap::kBefore), last = static_cast<int>(Overlap::kAfter);
    return static_cast<Overlap>(first + last - static_cast<int>(o));
  };
  for (const Interval& a : grid())
    for (const Interval& b : grid()) {
      const Overlap o = overlap(a, b);
      seen.insert(o);
      EXPECT_EQ(overlap(b, a), mirrored(o)) << to_string(a) << to_string(b);
    }
  EXPECT_EQ(seen.size(), 16u);
}

TEST(Relations, HoldForSubnormalsUnderFlushingAndFromAnyMode) {
  const Interval least(0x1p-1074), zero;
  const unsigned saved = _mm_getcsr();
  _mm_setcsr(saved | 0xe040u);  // toward zero, FTZ, DAZ
  const bool same = least == zero, inside = is_subset(least, zero),
             before = strictly_precedes(zero, least);
  const Sign3 sign = least.sign();
  const Interval joined = hull(least, zero);
  const double width = wid(joined), middle = mid(Interval::from_bounds(0x1p-1074, 0x1.8p-1073));
  _mm_setcsr(saved);
  EXPECT_FALSE(same || inside);
  EXPECT_TRUE(before);
  EXPECT_EQ(sign, Sign3::kPositive);
  EXPECT_EQ(joined.hi(), 0x1p-1074);
  EXPECT_EQ(width, 0x1p-1074);
  EXPECT_EQ(middle, 0x1p-1073);
}

TEST(Numeric, MiddleAndRadiusCoverTheInterval) {
  Random random(71);
  for (long i = 0; i < scaled(20000); ++i) {
    const Interval a = draw_interval(random);
    const MidRad m = mid_rad(a);
    ASSERT_TRUE(is_member(m.mid, a)) << to_string(a);
    ASSERT_EQ(m.rad, rad(a));
    ASSERT_LE(mig(a), mag(a));
    if (!is_common(a)) {
      ASSERT_EQ(m.rad, kInfinity);
      continue;
    }
    const Rational lo = Rational::from_double(a.lo()), hi = Rational::from_double(a.hi()),
                   middle = Rational::from_double(m.mid), sum = lo + hi;
    ASSERT_EQ(m.mid, nearest_double(sum / Rational(2))) << to_string(a);
    const Rational left = middle - lo, right = hi - middle;
    ASSERT_EQ(m.rad, round_up(left < right ? right : left)) << to_string(a);
    ASSERT_EQ(wid(a), round_up(hi - lo)) << to_string(a);
  }
}

TEST(Numeric, CancellationUndoesAnAddition) {
  Random random(72);
  int undone = 0;
  for (long i = 0; i < scaled(20000); ++i) {
    const Interval b = draw_interval(random), z = draw_interval(random);
    Interval a;
    {
      const ScopedUpward upward;
      a = b + z;
    }
    const Interval back = cancel_minus(a, b);
    ASSERT_TRUE(is_subset(z, back)) << to_string(b) << to_string(z) << to_string(back);
    ASSERT_EQ(cancel_plus(a, -b), back);
    undone += back.is_entire() ? 0 : 1;
  }
  EXPECT_GT(undone, 10000);
  EXPECT_TRUE(cancel_minus(Interval(1.0), Interval::from_bounds(0, 0x1p-60)).is_entire());
}

TEST(Numeric, SumsRoundOnce) {
  const double x[] = {1, 0x1p100, -0x1p100, 0x1p-60}, y[] = {0x1p-1074, 1, 1, -1};
  EXPECT_EQ(sum_nearest(x), 1);
  EXPECT_EQ(dot_nearest(x, y), -0x1p-60);
  EXPECT_EQ(sum_abs_nearest(std::span(x).first(2)), 0x1p100);
  EXPECT_THROW(dot_nearest(x, std::span(y).first(3)), InternalError);
}

}  // namespace
}  // namespace veritope
