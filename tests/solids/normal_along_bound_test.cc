// SPDX-License-Identifier: LGPL-3.0-or-later
// The constants of solids/polyhedron/normal_along.h against docs/bounds/normal_along.md: derivation rerun in exact rationals.
#include "solids/polyhedron/normal_along.h"
#include "tests/predicates/bound_derivation.h"

namespace veritope {
namespace {

using bounds::Polynomial;
using bounds::RoundingCount;
using bounds::UnderflowCount;

// PROVES MESH-11 for the normal along a direction.
TEST(NormalAlongBound, RelativeConstantFollowsFromTheRoundings) {
  const RoundingCount x, d;  // the direction's integers are exact
  const formulas::NormalAlong<RoundingCount> f(x, x, x, x, x, x, x, x, x, bounds::kSame);
  EXPECT_EQ(f.det(d, d, d).roundings - 1, 6);
  bounds::expect_tight(internal::kNormalAlongRel, f.det(d, d, d).roundings - 1,
                       f.magnitude(d, d, d, bounds::kSame).roundings);
}

TEST(NormalAlongBound, AbsoluteConstantPaysForUnderflowAndForFlushing) {
  const Rational longest = Rational::power_of_two(31);
  for (const Rational& unit : {bounds::underflow_unit(), bounds::flush_unit()}) {
    // Symbol 0 bounds the components of d, symbol 1 those of the facet's edges, which may be as large as they like.
    const UnderflowCount d = UnderflowCount::bounded_by(0, unit), edge = UnderflowCount::bounded_by(1, unit);
    const formulas::NormalAlong<UnderflowCount> f(edge, edge, edge, edge, edge, edge, bounds::kSame);
    const Polynomial error = f.det(d, d, d).error, missing = f.magnitude(d, d, d, bounds::kSame).error;
    for (const auto& [exponent, c] : error.coefficient)
      EXPECT_TRUE(exponent[1] == 0 && exponent[0] <= 1) << exponent[0] << ' ' << exponent[1];
    const Rational rel = Rational::from_double(internal::kNormalAlongRel);
    // 4 more units: kRel * S itself may underflow. The factor is for the addition of kAbs.
    EXPECT_LE((error.at(1) + rel * missing.at(1)) * longest + error.at(0) + rel * missing.at(0) + Rational(4) * unit,
              Rational::from_double(kFilterFloor) * (Rational(1) - Rational::power_of_two(-50)));
  }
}

}  // namespace
}  // namespace veritope
