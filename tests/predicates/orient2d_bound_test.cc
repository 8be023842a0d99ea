// SPDX-License-Identifier: LGPL-3.0-or-later
// The constants of predicates/orient2d.h against docs/bounds/orient2d.md: derivation rerun in exact
// rationals.
#include "predicates/orient2d.h"
#include "tests/predicates/bound_derivation.h"

namespace veritope {
namespace {

using bounds::Polynomial;
using bounds::RoundingCount;
using bounds::UnderflowCount;

TEST(Orient2dBound, RelativeConstantFollowsFromTheRoundings) {
  const RoundingCount x;
  const formulas::Orient2d<RoundingCount> f(x, x, x, x, x, x);
  EXPECT_EQ(f.det().roundings - 1, 3);
  bounds::expect_tight(internal::kOrient2dRel, f.det().roundings - 1,
                       f.magnitude(bounds::kSame).roundings);
  EXPECT_EQ(f.cancelling_magnitude(bounds::kSame).roundings, f.magnitude(bounds::kSame).roundings);
}

TEST(Orient2dBound, AbsoluteConstantPaysForUnderflowAndForFlushing) {
  for (const Rational& unit : {bounds::underflow_unit(), bounds::flush_unit()}) {
    // The two products are the only operations that can underflow; every factor may be as large as
    // it likes.
    formulas::Orient2d<UnderflowCount> f({}, {}, {}, {}, {}, {});
    const UnderflowCount d = UnderflowCount::bounded_by(0, unit);
    f.left = d * d, f.right = d * d;
    const Polynomial error = f.det().error, missing = f.cancelling_magnitude(bounds::kSame).error;
    EXPECT_EQ(error.coefficient.size(), 1u);
    const Rational rel = Rational::from_double(internal::kOrient2dRel);
    // 4 more units: kRel * S itself may underflow. The factor is for the addition of kAbs.
    EXPECT_LE(error.at(0) + rel * missing.at(0) + Rational(4) * unit,
              Rational::from_double(kFilterFloor) * (Rational(1) - Rational::power_of_two(-50)));
  }
}

}  // namespace
}  // namespace veritope
