// SPDX-License-Identifier: LGPL-3.0-or-later
// The constants of solids/classify/ray_bounds.h against docs/bounds/ray_net.md, on the lines that the code executes.
#include <gtest/gtest.h>

#include "solids/classify/ray_bounds.h"
#include "tests/support/directed_bounds.h"

namespace veritope {
namespace {

using bounds::power;
using bounds::RoundingCount;
using bounds::UnderflowCount;

// The constant times the slack is the derived one.
void expect_tight(double constant, int k, int bound_roundings) {
  bounds::expect_tight_directed(
      Rational::from_double(constant) * Rational::from_double(internal::kNetSlack), k,
      bound_roundings);
}

constexpr RoundingCount kExact;
constexpr RoundingCount kRounded{1};

TEST(RayNetBound, CoordinatesRelativeToAPointCarryFourRoundings) {
  const RoundingCount p = internal::relative_to_centre(kRounded, kRounded, kRounded);
  EXPECT_EQ(p.roundings, 4);
  // The size |m| + |w c| (2), rel *, * kNetSlack, + kNetTiny.
  expect_tight(internal::kRelativeRel, p.roundings, 2 + 3);
}

TEST(RayNetBound, PlanesCarryThreeRoundings) {
  const RoundingCount v = internal::plane_value({kExact, kExact, kExact}, kExact, kExact, kExact);
  EXPECT_EQ(v.roundings, 3);
  // The sums of the errors and of the sizes are plane_value's own (3); + error, rel *, * kNetSlack, + kNetTiny.
  expect_tight(internal::kPlaneRel, v.roundings, 3 + 4);
}

TEST(RayNetBound, TurnsCarryTwoRoundings) {
  const RoundingCount x = internal::turned(kExact, kExact, kExact, kExact)[0];
  EXPECT_EQ(x.roundings, 2);
  // |t0| + |t1| (1), rel *, + error, the product, * kNetSlack, + kNetTiny.
  expect_tight(internal::kTurnRel, x.roundings, 1 + 5);
}

TEST(RayNetBound, BoundsPayForTheErrorsOfTheirTerms) {
  // All three coordinates err by 1 in the worst direction.
  EXPECT_GE(internal::plane_bound(1.0 + 2.0 + 4.0, 0), 7.0);
  EXPECT_LE(internal::plane_bound(7.0, 0), 7.0 * (1 + 0x1p-30));
  for (const auto& turn : {std::array<double, 2>{1, 0}, std::array<double, 2>{0.8125, 0.59375}}) {
    const double worst = std::abs(turn[0]) + std::abs(turn[1]);
    EXPECT_GE(internal::turn_bound(1, 0, turn), worst);
    EXPECT_LE(internal::turn_bound(1, 0, turn), worst * (1 + 0x1p-30));
  }
}

TEST(RayNetBound, UnderflowIsPaidFor) {
  for (const Rational& lost : {bounds::underflow_unit(), bounds::flush_unit()}) {
    const auto m = UnderflowCount::bounded_by(0, lost), n = UnderflowCount::bounded_by(1, lost);
    const Rational tiny = Rational::from_double(internal::kNetTiny);
    for (const auto& value :
         {internal::relative_to_centre(m, m, n), internal::plane_value({n, n, n}, m, m, m),
          internal::turned(n, n, m, m)[0]})
      for (const auto& [exponent, loss] : value.error.coefficient) {
        EXPECT_EQ(exponent, (std::array<int, 4>{}));
        EXPECT_LE(Rational(4) * loss, tiny);
      }
  }
}

}  // namespace
}  // namespace veritope
