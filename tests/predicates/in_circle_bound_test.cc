// SPDX-License-Identifier: LGPL-3.0-or-later
// The constants of predicates/in_circle.h against docs/bounds/in_circle.md: derivation rerun in
// exact rationals.
#include "predicates/in_circle.h"
#include "tests/predicates/bound_derivation.h"

namespace veritope {
namespace {

using bounds::Polynomial;
using bounds::RoundingCount;
using bounds::UnderflowCount;

TEST(InCircleBound, RelativeConstantFollowsFromTheRoundings) {
  const RoundingCount x;
  const formulas::InCircle<RoundingCount> f(x, x, x, x, x, x, x, x);
  EXPECT_EQ(f.det().roundings - 1, 10);
  bounds::expect_tight(internal::kInCircleRel, f.det().roundings - 1,
                       f.magnitude(bounds::kSame).roundings);
}

TEST(InCircleBound, AbsoluteConstantsPayForUnderflowAndForFlushing) {
  for (const Rational& unit : {bounds::underflow_unit(), bounds::flush_unit()}) {
    // m bounds every difference: set the last point to zero, so that the constructor's differences
    // add no bound of their own.
    const UnderflowCount m = UnderflowCount::bounded_by(0, unit);
    UnderflowCount zero;
    zero.unit = unit;
    const formulas::InCircle<UnderflowCount> f(m, m, m, m, m, m, zero, zero);
    const Polynomial error = f.det().error, missing = f.magnitude(bounds::kSame).error,
                     lost = f.size().error;
    // size() >= m^2 (1 - u)^5 - lost, and m^j <= 1 + m^2 for j <= 2.
    Rational sum;
    const Rational rel = Rational::from_double(internal::kInCircleRel),
                   eta = Rational::from_double(internal::kInCircleEta);
    for (int j = 0; j <= 2; ++j) sum += error.at(j) + rel * missing.at(j) + eta * lost.at(j);
    for (const auto& [exponent, c] : error.coefficient) EXPECT_LE(exponent[0], 2);
    const Rational less = Rational(1) - Rational::power_of_two(-48);
    EXPECT_LE(sum, eta * less);
    EXPECT_LE(sum + Rational(4) * unit, Rational::from_double(kFilterFloor) * less);
  }
}

TEST(InCircleBound, SizeCountsEveryDifference) {
  const auto symbol = [](int i) { return UnderflowCount::bounded_by(i, bounds::underflow_unit()); };
  const UnderflowCount a = symbol(0), b = symbol(1), c = symbol(2), zero;
  for (const bool in_x : {true, false}) {
    const formulas::InCircle<UnderflowCount> f(in_x ? a : zero, in_x ? zero : a, in_x ? b : zero,
                                               in_x ? zero : b, in_x ? c : zero, in_x ? zero : c,
                                               zero, zero);
    EXPECT_GE(f.size().size.at(2, 0, 0), Rational(1));
    EXPECT_GE(f.size().size.at(0, 2, 0), Rational(1));
    EXPECT_GE(f.size().size.at(0, 0, 2), Rational(1));
  }
}

}  // namespace
}  // namespace veritope
