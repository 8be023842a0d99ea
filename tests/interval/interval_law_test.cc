// SPDX-License-Identifier: LGPL-3.0-or-later
// The four operations, squares and roots on every combination of kinds of bounds: 0, subnormal,
// ordinary, largest, infinite, of both signs; and empty. The oracle decides in extended rationals.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "interval/interval.h"
#include "robust/binary64.h"

namespace veritope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();

// A number of the extended line: infinite, or exact.
struct Extended {
  int infinite = 0;
  Rational value;
};
Extended extended(double v) {
  if (is_finite(v)) return {0, Rational::from_double(v)};
  return {v > 0 ? 1 : -1, Rational()};
}
int sign(const Extended& a) { return a.infinite != 0 ? a.infinite : to_int(a.value.sign()); }
bool less(const Extended& a, const Extended& b) {
  return a.infinite != b.infinite ? a.infinite < b.infinite : a.infinite == 0 && a.value < b.value;
}
// The bound's product as a limit: 0 * infinity is 0, which the products near it tend to or are.
Extended times(const Extended& a, const Extended& b) {
  if (a.infinite == 0 && b.infinite == 0) return {0, a.value * b.value};
  return {sign(a) * sign(b), Rational()};
}
Extended plus(const Extended& a, const Extended& b) {
  if (a.infinite != 0 || b.infinite != 0)
    return {a.infinite != 0 ? a.infinite : b.infinite, Rational()};
  return {0, a.value + b.value};
}
// The inverse of a bound of an interval of positive numbers.
Extended inverse(const Extended& a) {
  if (a.infinite != 0) return {0, Rational()};
  return a.value.sign() == Sign::kZero ? Extended{1, Rational()}
                                       : Extended{0, Rational(1) / a.value};
}
Extended negative(const Extended& a) { return {-a.infinite, -a.value}; }

struct Set {
  Extended lo, hi;
};
std::optional<Set> set_of(const Interval& a) {
  if (a.is_empty()) return std::nullopt;
  return Set{extended(a.lo()), extended(a.hi())};
}
Interval rounded(const std::optional<Set>& s) {
  if (!s) return Interval::empty();
  const double lo = s->lo.infinite != 0 ? s->lo.infinite * kInfinity : round_down(s->lo.value);
  const double hi = s->hi.infinite != 0 ? s->hi.infinite * kInfinity : round_up(s->hi.value);
  return Interval::from_bounds(lo, hi);
}
using MaybeSet = std::optional<Set>;
MaybeSet sum(const MaybeSet& a, const MaybeSet& b) {
  if (!a || !b) return std::nullopt;
  return Set{plus(a->lo, b->lo), plus(a->hi, b->hi)};
}
MaybeSet opposite(const MaybeSet& a) {
  if (!a) return std::nullopt;
  return Set{negative(a->hi), negative(a->lo)};
}
MaybeSet product(const MaybeSet& a, const MaybeSet& b) {
  if (!a || !b) return std::nullopt;
  Set out{times(a->lo, b->lo), times(a->lo, b->lo)};
  for (const Extended& v : {times(a->lo, b->hi), times(a->hi, b->lo), times(a->hi, b->hi)}) {
    if (less(v, out.lo)) out.lo = v;
    if (less(out.hi, v)) out.hi = v;
  }
  return out;
}
MaybeSet inverse(const MaybeSet& b) {
  if (!b || (sign(b->lo) == 0 && sign(b->hi) == 0)) return std::nullopt;
  if (sign(b->hi) <= 0) return opposite(inverse(opposite(b)));
  if (sign(b->lo) < 0) return Set{{-1, Rational()}, {1, Rational()}};
  return Set{inverse(b->hi), inverse(b->lo)};
}
MaybeSet square(const MaybeSet& a) {
  if (!a) return std::nullopt;
  MaybeSet out = product(a, a);
  const Extended first = times(a->lo, a->lo), second = times(a->hi, a->hi);
  out->lo = less(first, second) ? first : second;
  if (sign(a->lo) * sign(a->hi) <= 0) out->lo = Extended{};
  return out;
}

std::vector<Interval> all_kinds() {
  const double bounds[] = {-kInfinity, -kLargest, -3.1, -0x1p-1022, -0x1p-1074, -0.0,     0.0,
                           0x1p-1074,  0x1p-1022, 0.7,  3.1,        kLargest,   kInfinity};
  std::vector<Interval> out{Interval::empty()};
  for (double lo : bounds)
    for (double hi : bounds)
      if (lo <= hi && lo < kInfinity && hi > -kInfinity)
        out.push_back(Interval::from_bounds(lo, hi));
  return out;
}

TEST(IntervalLaw, EveryCombinationOfKindsOfBoundsGivesTheTightestResult) {
  const std::vector<Interval> kinds = all_kinds();
  ASSERT_GT(kinds.size(), 80u);
  for (const Interval& a : kinds) {
    for (const Interval& b : kinds) {
      const MaybeSet p = set_of(a), q = set_of(b);
      Interval got[4];
      {
        const ScopedUpward upward;
        got[0] = a + b, got[1] = a - b, got[2] = a * b, got[3] = a / b;
      }
      const MaybeSet want[4] = {sum(p, q), sum(p, opposite(q)), product(p, q),
                                product(p, inverse(q))};
      for (int i = 0; i < 4; ++i)
        ASSERT_EQ(got[i], rounded(want[i]))
            << to_string(a) << " +-*/"[i + 1] << ' ' << to_string(b) << " gave "
            << to_string(got[i]) << " not " << to_string(rounded(want[i]));
    }
  }
}

TEST(IntervalLaw, SquaresAndInversesAndRootsOfEveryKindAreTightest) {
  for (const Interval& a : all_kinds()) {
    Interval squared, inverted, root;
    {
      const ScopedUpward upward;
      squared = sqr(a), inverted = recip(a), root = sqrt(a);
    }
    EXPECT_EQ(squared, rounded(square(set_of(a)))) << to_string(a) << to_string(squared);
    EXPECT_EQ(inverted, rounded(inverse(set_of(a)))) << to_string(a) << to_string(inverted);
    if (a.is_empty() || a.hi() < 0) {
      EXPECT_TRUE(root.is_empty()) << to_string(a);
      continue;
    }
    // lo is the largest number whose square is not above the given bound; hi the least one not below.
    const double least = a.lo() > 0 ? a.lo() : 0;
    const auto square_of = [](double v) {
      return Rational::from_double(v) * Rational::from_double(v);
    };
    EXPECT_LE(square_of(root.lo()), Rational::from_double(least));
    EXPECT_GT(square_of(std::nextafter(root.lo(), kInfinity)), Rational::from_double(least));
    if (!is_finite(a.hi())) {
      EXPECT_EQ(root.hi(), kInfinity);
      continue;
    }
    EXPECT_GE(square_of(root.hi()), Rational::from_double(a.hi()));
    if (root.hi() > 0) {
      EXPECT_LT(square_of(std::nextafter(root.hi(), 0)), Rational::from_double(a.hi()));
    }
  }
}

TEST(IntervalLaw, EmptyStaysEmptyAndHasNoSign) {
  const ScopedUpward upward;
  Interval chain = Interval::empty();
  for (int i = 0; i < 4; ++i) chain = (chain * Interval(2.0) - Interval::entire()) * chain + chain;
  EXPECT_TRUE(chain.is_empty());
  EXPECT_TRUE((-chain).is_empty());
  EXPECT_EQ(chain.sign(), Sign3::kUncertain);
  EXPECT_EQ(to_string(chain), "[empty]");
  EXPECT_FALSE(contains(chain, Rational(0)));
  EXPECT_TRUE(Interval::entire().is_entire());
  EXPECT_FALSE(chain.is_entire());
}

}  // namespace
}  // namespace veritope
