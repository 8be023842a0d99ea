// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/edge_gap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/predicates/test_scale.h"
#include "tests/solids/edge_gap_oracle.h"

namespace veritope {
namespace {

using internal::ScaledEdge;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

EdgeEnds reversed(const EdgeEnds& e) { return {e.b, e.a}; }

// Calls body(e, f, where) for pairs of all kinds.
template <typename Body>
void for_random_pairs(std::uint64_t seed, long loops, Body body) {
  for (int kind = 0; kind < oracle::kNumEdgeKinds; ++kind) {
    Random random(seed + static_cast<std::uint64_t>(kind));
    for (long i = 0; i < scaled(loops); ++i) {
      const EdgeEnds e = oracle::random_edge(random, kind), f = oracle::random_edge(random, kind);
      SCOPED_TRACE("seed " + std::to_string(seed) + " kind " + std::to_string(kind) + ": " +
                   oracle::text(e) + ", " + oracle::text(f));
      body(e, f);
      if (::testing::Test::HasFailure()) return;
    }
  }
}

TEST(EdgeGap, IsThatOfItsDefinitionForEdgesOfAllSizes) {
  int zeros = 0;
  for_random_pairs(1, 300, [&](const EdgeEnds& e, const EdgeEnds& f) {
    const Rational want = oracle::squared_gap(oracle::rational(e), oracle::rational(f));
    EXPECT_EQ(squared_gap(e, f), want);
    EXPECT_EQ(squared_gap(reversed(f), e), want);
    EXPECT_EQ(has_no_gap(e, f), want == Rational(0));
    EXPECT_EQ(has_no_gap(f, reversed(e)), want == Rational(0));
    zeros += want == Rational(0);
  });
  EXPECT_GT(zeros, 0);
}

TEST(EdgeGap, IsTheLesserOneOfTheTwoDistances) {
  const EdgeEnds longer{{0, 0, 0}, {8, 0, 0}}, shorter{{1, 3, 0}, {2, 4, 0}};
  EXPECT_EQ(squared_gap(longer, shorter), Rational(16));
  EXPECT_EQ(squared_gap(shorter, longer), Rational(16));
  const EdgeEnds inside{{2, 0, 0}, {5, 0, 0}}, overlapping{{6, 0, 0}, {11, 0, 0}};
  EXPECT_TRUE(has_no_gap(longer, inside));
  EXPECT_EQ(squared_gap(longer, overlapping), Rational(9));
  EXPECT_EQ(squared_gap(longer, {{3, 2, 0}, {3, 2, 0}}), Rational(4)) << "a point";
}

TEST(EdgeGap, IsZeroForPartsOfAnEdgeOnly) {
  Random random(8);
  for (long i = 0; i < scaled(1000); ++i) {
    const auto c = [&] { return std::ldexp(static_cast<double>(random.between(-1000, 1000)), 20); };
    const Vec3d a{c(), c(), c()}, d{c(), c(), c()};
    const auto at = [&](double t) { return Vec3d{a.x + t * d.x, a.y + t * d.y, a.z + t * d.z}; };
    const auto part = [&] { return static_cast<double>(random.below(1024)) / 1024; };
    const EdgeEnds e{at(0), at(1)};
    EdgeEnds f{at(part()), at(part())};
    SCOPED_TRACE(oracle::text(e) + ", " + oracle::text(f));
    EXPECT_TRUE(has_no_gap(e, f) && has_no_gap(f, e));
    EXPECT_EQ(squared_gap(e, f), Rational(0));
    f.a.x += 0x1p-20;
    if (d.y == 0 && d.z == 0) continue;
    EXPECT_FALSE(has_no_gap(e, f) || has_no_gap(f, e));
    EXPECT_GT(squared_gap(e, f), Rational(0));
  }
}

TEST(RunAlong, IsThatOfItsDefinitionForEdgesOfAllSizes) {
  int yes = 0, no = 0;
  for_random_pairs(2, 300, [&](const EdgeEnds& e, const EdgeEnds& f) {
    const bool want = oracle::run_along(oracle::rational(e), oracle::rational(f));
    EXPECT_EQ(run_along(e, f), want);
    EXPECT_EQ(run_along(reversed(f), e), want);
    ++(want ? yes : no);
  });
  EXPECT_GT(yes, 100);
  EXPECT_GT(no, 100);
}

TEST(RunAlong, LeavesOutContinuationsCornersAndPoints) {
  const EdgeEnds e{{0, 0, 0}, {4, 0, 0}};
  EXPECT_FALSE(run_along(e, {{4, 0, 0}, {8, 0, 0}})) << "continues";
  EXPECT_FALSE(run_along(e, {{4, 0, 0}, {5, 0.25, 0}})) << "continues in a curve";
  EXPECT_FALSE(run_along(e, {{5, 0, 0}, {6, 0, 0}})) << "continues after another edge";
  EXPECT_FALSE(run_along(e, {{4, 0, 0}, {3, 1, 0}})) << "corner of 45 degrees";
  EXPECT_TRUE(run_along(e, {{4, 0, 0}, {2, 1, 0}})) << "wedge of 27 degrees";
  EXPECT_FALSE(run_along(e, {{2, 0, 0}, {2, 0, 0}})) << "a point";
  EXPECT_FALSE(run_along({{2, 0, 0}, {2, 0, 0}}, {{2, 0, 0}, {2, 0, 0}}));
  EXPECT_TRUE(run_along(e, {{4, 0, 0}, {0, 0, 0}})) << "the other side of a seam";
  EXPECT_TRUE(run_along(e, {{2, 1, 0}, {6, 1, 0}})) << "a middle is projected to an end";
  EXPECT_FALSE(run_along(e, {{2.25, 1, 0}, {6.25, 1, 0}}));
}

TEST(NearestRoot, IsTheNearestNumber) {
  const auto next = [](double v) { return std::nextafter(v, kInfinity); };
  const auto half = [](double v, double w) {
    return (Rational::from_double(v) + Rational::from_double(w)) / Rational(2);
  };
  Random random(3);
  for (long i = 0; i < scaled(3000); ++i) {
    const auto part = [&] {
      return Rational(Integer(static_cast<std::int64_t>(random.next() >> (1 + random.below(62)))) +
                      1);
    };
    const Rational a = part() / part() * Rational::power_of_two(random.between(-2200, 1950));
    const double root = nearest_root(a);
    ASSERT_GE(root, 0) << a.to_string();
    ASSERT_TRUE(std::isfinite(root)) << a.to_string();
    const Rational above = half(root, next(root));
    ASSERT_LE(a, above * above) << a.to_string();
    if (root == 0) continue;
    const Rational below = half(root, std::nextafter(root, 0.0));
    ASSERT_GE(a, below * below) << a.to_string();
  }
}

TEST(NearestRoot, IsExactForSquaresAndRoundsTiesToEven) {
  EXPECT_EQ(nearest_root(Rational(0)), 0);
  Random random(4);
  for (long i = 0; i < scaled(1000); ++i) {
    const double v = std::ldexp(1 + random.unit(), static_cast<int>(random.between(-1070, 1022)));
    const Rational r = Rational::from_double(v);
    ASSERT_EQ(nearest_root(r * r), v) << v;
  }
  const Rational tie = Rational(1) + Rational::power_of_two(-53);
  EXPECT_EQ(nearest_root(tie * tie), 1);
  EXPECT_EQ(nearest_root(tie * tie + Rational::power_of_two(-2000)), 1 + 0x1p-52);
  const Rational least = Rational::power_of_two(-1074);
  EXPECT_EQ(nearest_root(least * least), 0x1p-1074);
  EXPECT_EQ(nearest_root(Rational::power_of_two(2100)), kInfinity);
}

// A pair below 2^501, as the first tier needs it, and the same as edges.
struct ScaledPair {
  ScaledEdge e, f;
  EdgeEnds exact_e, exact_f;
};

ScaledPair scaled_pair(EdgeEnds e, EdgeEnds f, int kind) {
  const int exponent = kind == 3 || kind == 5 ? -523 : (kind == 4 ? 500 : 0);
  for (Vec3d* p : {&e.a, &e.b, &f.a, &f.b})
    *p = {std::ldexp(p->x, exponent), std::ldexp(p->y, exponent), std::ldexp(p->z, exponent)};
  return {internal::scaled_edge(to_point(e.a), to_point(e.b)),
          internal::scaled_edge(to_point(f.a), to_point(f.b)), e, f};
}

template <typename Body>
void for_random_scaled_pairs(std::uint64_t seed, long loops, Body body) {
  for (int kind = 0; kind < oracle::kNumEdgeKinds; ++kind) {
    Random random(seed + static_cast<std::uint64_t>(kind));
    for (long i = 0; i < scaled(loops); ++i) {
      const ScaledPair pair =
          scaled_pair(oracle::random_edge(random, kind), oracle::random_edge(random, kind), kind);
      SCOPED_TRACE("seed " + std::to_string(seed) + " kind " + std::to_string(kind) + ": " +
                   oracle::text(pair.exact_e) + ", " + oracle::text(pair.exact_f));
      body(pair);
      if (::testing::Test::HasFailure()) return;
    }
  }
}

TEST(EdgeGapBounds, ContainTheGap) {
  for_random_scaled_pairs(5, 2000, [](const ScaledPair& p) {
    const auto bounds = internal::gap_bounds(p.e, p.f);
    const Rational gap = squared_gap(p.exact_e, p.exact_f);
    const Rational lo = Rational::from_double(bounds.lo), hi = Rational::from_double(bounds.hi);
    EXPECT_LE(lo * lo, gap);
    EXPECT_GE(hi * hi, gap);
  });
}

// The first tier without its slack would be wrong: the constants are needed, and they are not wasteful.
TEST(EdgeGapBounds, AreTightWhereAnEndIsNearAnEnd) {
  const ScaledPair p =
      scaled_pair({{1, 1, 1}, {2, 3, 5}}, {{1, 1 + 0x1p-52, 1}, {2, 3, 5 + 0x1p-50}}, 1);
  const auto bounds = internal::gap_bounds(p.e, p.f);
  EXPECT_GT(bounds.lo, 0);
  EXPECT_LE(bounds.hi - bounds.lo, 0x1p-45 * bounds.hi);
}

TEST(ApproxSquaredGap, DiffersByLessThanItSays) {
  for_random_scaled_pairs(6, 2000, [](const ScaledPair& p) {
    const double gap = nearest_root(squared_gap(p.exact_e, p.exact_f));
    const double error = 2 * (internal::kEdgeGapRel * (gap + std::max(p.e.length, p.f.length)) +
                              internal::kEdgeGapFloor);
    EXPECT_NEAR(std::sqrt(internal::approx_squared_gap(p.e, p.f, 0x1p510)), gap, error);
    if (gap > error) {
      EXPECT_EQ(internal::approx_squared_gap(p.e, p.f, gap - error), kInfinity);
    }
    EXPECT_LT(internal::approx_squared_gap(p.e, p.f, gap + error), kInfinity);
  });
}

TEST(RunAlongFilter, NeverContradictsTheExactAnswer) {
  long certain = 0;
  for_random_scaled_pairs(7, 2000, [&](const ScaledPair& p) {
    const Sign3 sign = internal::run_along_filter(p.e, p.f);
    if (!is_certain(sign)) return;
    ++certain;
    EXPECT_EQ(sign == Sign3::kPositive, run_along(p.exact_e, p.exact_f));
  });
  EXPECT_GT(certain, scaled(4000));
}

TEST(RunAlongFilter, NeverContradictsTheExactAnswerNear30DegreesAndNearTheEnds) {
  Random random(9);
  const auto noise = [&] { return 0x1p-52 * static_cast<double>(random.between(-3, 3)); };
  long certain = 0;
  for (long i = 0; i < scaled(3000); ++i) {
    const double size = 1 + random.unit();
    const EdgeEnds e{{0, 0, 0}, {4, noise(), 0}};
    const EdgeEnds wedge{{1, 1, 0}, {1 + std::sqrt(3.0) * size + noise(), 1 + size, 0}};
    const EdgeEnds at_end{{4 - 6 * size, 1, 0}, {4 + 6 * size + noise(), 1 + noise(), noise()}};
    const ScaledPair p = scaled_pair(e, i % 2 == 0 ? wedge : at_end, 1);
    const Sign3 sign = internal::run_along_filter(p.e, p.f);
    if (!is_certain(sign)) continue;
    ++certain;
    ASSERT_EQ(sign == Sign3::kPositive, run_along(p.exact_e, p.exact_f))
        << oracle::text(p.exact_e) << oracle::text(p.exact_f);
  }
  EXPECT_LT(certain, scaled(3000)) << "none is near the cases where the answer changes";
}

// What the derivation in edge_gap.cc adds up, in units of u |w|.
TEST(EdgeGapBounds, HaveTheConstantOfTheirDerivation) {
  const double product = 2 + 3, squared_length = 2 + 3, quotient = 1;
  const double foot = product + squared_length + quotient;
  const double difference = 1 + 2 + 1, length = 2.5;
  EXPECT_LE(foot + difference + length + 1, internal::kEdgeGapRel / 0x1p-53);
}

}  // namespace
}  // namespace veritope
