// SPDX-License-Identifier: LGPL-3.0-or-later
// The constants of predicates/in_sphere.h against docs/bounds/in_sphere.md: derivation rerun in
// exact rationals.
#include "predicates/in_sphere.h"
#include "tests/predicates/bound_derivation.h"

namespace veritope {
namespace {

using bounds::Polynomial;
using bounds::RoundingCount;
using bounds::UnderflowCount;

TEST(InSphereBound, RelativeConstantFollowsFromTheRoundings) {
  const RoundingCount x;
  const formulas::InSphere<RoundingCount> f(x, x, x, x, x, x, x, x, x, x, x, x, x, x, x);
  EXPECT_EQ(f.det().roundings - 1, 15);
  bounds::expect_tight(internal::kInSphereRel, f.det().roundings - 1,
                       f.magnitude(bounds::kSame).roundings);
}

TEST(InSphereBound, AbsoluteConstantsPayForUnderflowAndForFlushing) {
  for (const Rational& unit : {bounds::underflow_unit(), bounds::flush_unit()}) {
    // m bounds every difference: set the last point to zero, so that the constructor's differences
    // add no bound of their own.
    const UnderflowCount m = UnderflowCount::bounded_by(0, unit);
    UnderflowCount zero;
    zero.unit = unit;
    const formulas::InSphere<UnderflowCount> f(m, m, m, m, m, m, m, m, m, m, m, m, zero, zero,
                                               zero);
    const Polynomial error = f.det().error, missing = f.magnitude(bounds::kSame).error,
                     lost = f.size().error;
    // size() >= m^4 (1 - u)^12 - lost, and m^j <= 1 + m^4 for j <= 3.
    Rational sum;
    const Rational rel = Rational::from_double(internal::kInSphereRel),
                   eta = Rational::from_double(internal::kInSphereEta);
    for (int j = 0; j <= 4; ++j) sum += error.at(j) + rel * missing.at(j) + eta * lost.at(j);
    for (const auto& [exponent, c] : error.coefficient) EXPECT_LE(exponent[0], 3);
    const Rational less = Rational(1) - Rational::power_of_two(-48);
    EXPECT_LE(sum, eta * less);
    EXPECT_LE(sum + Rational(4) * unit, Rational::from_double(internal::kInSphereAbs) * less);
  }
}

TEST(InSphereBound, SizeCountsEveryDifference) {
  const auto symbol = [](int i) { return UnderflowCount::bounded_by(i, bounds::underflow_unit()); };
  const UnderflowCount zero;
  for (int axis = 0; axis < 3; ++axis) {
    std::array<UnderflowCount, 12> p;
    for (int i = 0; i < 4; ++i) p[3 * i + axis] = symbol(i);
    const formulas::InSphere<UnderflowCount> f(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8],
                                               p[9], p[10], p[11], zero, zero, zero);
    EXPECT_GE(f.size().size.at(4, 0, 0, 0), Rational(1));
    EXPECT_GE(f.size().size.at(0, 4, 0, 0), Rational(1));
    EXPECT_GE(f.size().size.at(0, 0, 4, 0), Rational(1));
    EXPECT_GE(f.size().size.at(0, 0, 0, 4), Rational(1));
  }
}

}  // namespace
}  // namespace veritope
