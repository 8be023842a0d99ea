// SPDX-License-Identifier: LGPL-3.0-or-later
// The constants of predicates/orient3d.h against docs/bounds/orient3d.md: derivation rerun in exact
// rationals.
#include "predicates/orient3d.h"
#include "tests/predicates/bound_derivation.h"

namespace veritope {
namespace {

using bounds::Polynomial;
using bounds::RoundingCount;
using bounds::UnderflowCount;

// PROVES MESH-11 for the predicates; the other bounds have tests of their own.
TEST(Orient3dBound, RelativeConstantFollowsFromTheRoundings) {
  const RoundingCount x;
  const formulas::Plane3<RoundingCount> f(x, x, x, x, x, x, x, x, x);
  const RoundingCount w = x - x;
  EXPECT_EQ(f.det(w, w, w).roundings - 1, 7);
  bounds::expect_tight(internal::kOrient3dRel, f.det(w, w, w).roundings - 1,
                       f.magnitude(w, w, w, bounds::kSame).roundings);
}

TEST(Orient3dBound, AbsoluteConstantsPayForUnderflowAndForFlushing) {
  for (const Rational& unit : {bounds::underflow_unit(), bounds::flush_unit()}) {
    // Symbol 0 bounds the differences w of the fourth point, symbol 1 those of the plane.
    const UnderflowCount w = UnderflowCount::bounded_by(0, unit),
                         v = UnderflowCount::bounded_by(1, unit);
    formulas::Plane3<UnderflowCount> f({}, {}, {}, {}, {}, {}, {}, {}, {});
    f.yz = f.zy = f.zx = f.xz = f.xy = f.yx = v * v;
    const Polynomial error = f.det(w, w, w).error,
                     missing = f.magnitude(w, w, w, bounds::kSame).error;
    // What underflow does is at most c1 |w| + c0, whatever the size of the plane's differences:
    // kEta * size() pays for the first, because size() >= |w| (1 - u)^2, kAbs for the second.
    for (const auto& [exponent, c] : error.coefficient) {
      EXPECT_TRUE(exponent[1] == 0 && exponent[0] <= 1) << exponent[0] << ' ' << exponent[1];
    }
    const Rational rel = Rational::from_double(internal::kOrient3dRel);
    const Rational less = Rational(1) - Rational::power_of_two(-48);
    EXPECT_LE(error.at(1) + rel * missing.at(1),
              Rational::from_double(internal::kOrient3dEta) * less);
    // 4 more units: kRel * S and kEta * size() themselves may underflow.
    EXPECT_LE(error.at(0) + rel * missing.at(0) + Rational(4) * unit,
              Rational::from_double(kFilterFloor) * less);
  }
}

TEST(Orient3dBound, SizeCountsEachFactorOfAMinor) {
  const formulas::Plane3<UnderflowCount> f({}, {}, {}, {}, {}, {}, {}, {}, {});
  const auto symbol = [](int i) { return UnderflowCount::bounded_by(i, bounds::underflow_unit()); };
  const Polynomial size = f.size(symbol(0), symbol(1), symbol(2), bounds::kSame).size;
  EXPECT_GE(size.at(1, 0, 0), Rational(1));
  EXPECT_GE(size.at(0, 1, 0), Rational(1));
  EXPECT_GE(size.at(0, 0, 1), Rational(1));
}

}  // namespace
}  // namespace veritope
