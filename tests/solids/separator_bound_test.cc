// SPDX-License-Identifier: LGPL-3.0-or-later
// The constants of solids/polyhedron/separator.h against docs/bounds/separator.md: derivation rerun in exact rationals.
#include "solids/polyhedron/separator.h"
#include "tests/predicates/bound_derivation.h"

namespace veritope {
namespace {

using bounds::RoundingCount;
using bounds::UnderflowCount;

// Two dot products of k roundings each, their difference without its own, against kRel * size of one rounding.
Rational derived(int k, int size_roundings) {
  const Rational u = bounds::unit_roundoff(), up = Rational(1) + u, down = Rational(1) - u;
  return Rational(2) * (bounds::power(up, k) - Rational(1)) * up / bounds::power(down, size_roundings + 2);
}

// PROVES MESH-11 for separators.
TEST(SeparatorBound, RelativeConstantFollowsFromTheRoundings) {
  const RoundingCount d, p;
  const int k = formulas::dot3(d, d, d, p, p, p).roundings;
  EXPECT_EQ(k, 3);
  const double constant = internal::kSeparatorRel;
  const Rational c = Rational::from_double(constant), slack = Rational(1) + Rational::power_of_two(-20);
  EXPECT_EQ(constant, round_up(derived(k, 1)));
  EXPECT_LE(c, derived(k, 1) * slack);
  EXPECT_GT(derived(k + 1, 1), c);
  EXPECT_GT(derived(k, 2), c);
  EXPECT_GT(c, derived(k - 1, 1) * slack);
}

TEST(SeparatorBound, RelativeConstantOfRaysFollowsFromTheRoundings) {
  const RoundingCount d, p;
  const RoundingCount r = p - p;
  const int roundings = formulas::dot3(d, d, d, r, r, r).roundings;
  bounds::expect_tight(internal::kSeparatorRayRel, roundings - 1, roundings);
}

TEST(SeparatorBound, AbsoluteConstantPaysForUnderflowAndForFlushing) {
  for (const Rational& unit : {bounds::underflow_unit(), bounds::flush_unit()}) {
    const UnderflowCount d = UnderflowCount::bounded_by(0, unit), p = UnderflowCount::bounded_by(1, unit);
    const UnderflowCount dot = formulas::dot3(d, d, d, p, p, p);
    EXPECT_EQ(dot.error.coefficient.size(), 1u);
    const Rational rel = Rational::from_double(internal::kSeparatorRel);
    // Two dot products; size and kRel * size may underflow, too.
    EXPECT_LE(Rational(2) * dot.error.at(0) + rel * unit + Rational(4) * unit,
              Rational::from_double(internal::kSeparatorAbs) * (Rational(1) - Rational::power_of_two(-50)));
  }
}

TEST(SeparatorBound, BelowTheLargestSizeNothingOverflows) {
  const Rational up = Rational(1) + bounds::unit_roundoff(), down = Rational(1) - bounds::unit_roundoff();
  const Rational exact_size = Rational::from_double(internal::kSeparatorMaxSize) / down;
  // The difference of two sums of three roundings each.
  EXPECT_LT(Rational(2) * exact_size * bounds::power(up, 4), Rational::from_double(0x1.fffffffffffffp1023));
}

}  // namespace
}  // namespace veritope
