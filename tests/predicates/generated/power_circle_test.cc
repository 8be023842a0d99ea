// SPDX-License-Identifier: LGPL-3.0-or-later
// Made by tools/generate_predicates.py from predicates/generated/power_circle.formula: do not edit.
// clang-format off
#include "predicates/generated/power_circle.h"
#include "tests/predicates/generated/subject.h"

namespace veritope {
namespace {

using generated::Operands;

Sign by_formula(const Operands& v) {
  std::array<Rational, 12> w;
  for (std::size_t i = 0; i < 12; ++i) w[i] = Rational::from_double(v[i]);
  return formulas::power_circle_of<Rational>(w).sign();
}

const bool kRegistered = generated::add({
    .name = "power_circle",
    .axes = {0, 1, -1, 0, 1, -1, 0, 1, -1, 0, 1, -1},
    .powers = {1, 1, 2, 1, 1, 2, 1, 1, 2, 1, 1, 2},
    .has_lattice = true,
    .decide = [](const Operands& v, TierCounts* tally) { return power_circle({v[0], v[1]}, v[2], {v[3], v[4]}, v[5], {v[6], v[7]}, v[8], {v[9], v[10]}, v[11], tally); },
    .filter = [](const Operands& v) { return power_circle_filter({v[0], v[1]}, v[2], {v[3], v[4]}, v[5], {v[6], v[7]}, v[8], {v[9], v[10]}, v[11]); },
    .lattice = [](const Operands& v) { return internal::power_circle_lattice({v[0], v[1]}, v[2], {v[3], v[4]}, v[5], {v[6], v[7]}, v[8], {v[9], v[10]}, v[11]); },
    .interval = [](const Operands& v) { return internal::power_circle_interval({v[0], v[1]}, v[2], {v[3], v[4]}, v[5], {v[6], v[7]}, v[8], {v[9], v[10]}, v[11]); },
    .exact = [](const Operands& v) { return internal::power_circle_exact({v[0], v[1]}, v[2], {v[3], v[4]}, v[5], {v[6], v[7]}, v[8], {v[9], v[10]}, v[11]); },
    .by_formula = by_formula,
    .laws = {{-1, {3, 4, 5, 0, 1, 2, 6, 7, 8, 9, 10, 11}, {}}, {-1, {0, 1, 2, 6, 7, 8, 3, 4, 5, 9, 10, 11}, {}}, {-1, {0, 1, 2, 3, 4, 5, 9, 10, 11, 6, 7, 8}, {}}, {1, {}, {0, 1, -1, 0, 1, -1, 0, 1, -1, 0, 1, -1}}},
    .examples = {{{1, 0, 0, 0, 1, 0, -1, 0, 0, 0, 0, 0}, Sign::kPositive}, 
                 {{1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0}, Sign::kZero}, 
                 {{1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0.5}, Sign::kPositive}, 
                 {{1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, -0.5}, Sign::kNegative}, 
                 {{-1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0}, Sign::kNegative}, 
                 {{1, 0, -1, 0, 1, -1, -1, 0, -1, 0, 0, -2}, Sign::kZero}, 
                 {{0x1p1000, 0, 0, 0, 0x1p1000, 0, -0x1p1000, 0, 0, 0, -0x1p1000, 0x1p-1074}, Sign::kPositive}},
});

TEST(PowerCircleBound, ConstantsFollowFromTheFormula) {
  [[maybe_unused]] const bounds::RoundingCount x, d = x - x;
  const auto det = formulas::power_circle_det(d, d, d, d, d, d, d, d, d);
  const auto magnitude = formulas::power_circle_magnitude(bounds::kSame, d, d, d, d, d, d, d, d, d);
  EXPECT_EQ(det.roundings - 1, 11);
  bounds::expect_tight(internal::kPowerCircleRel, det.roundings - 1, magnitude.roundings);
  for (const Rational& unit : {bounds::underflow_unit(), bounds::flush_unit()}) {
    const auto m = bounds::UnderflowCount::bounded_by(0, unit);
    const auto value = formulas::power_circle_det(m, m, m, m, m, m, m, m, m);
    const auto sum = formulas::power_circle_magnitude(bounds::kSame, m, m, m, m, m, m, m, m, m);
    generated::expect_underflow_paid<2>(value, sum, m, internal::kPowerCircleRel, internal::kPowerCircleEta);
  }
}

TEST(PowerCircleBound, TheErrorCountsEveryDifference) {
  generated::expect_size_counts_every<2, 9>(internal::kPowerCircleEta, [](const auto& v) {
    return internal::power_circle_error(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], kFilterFloor);
  });
}

}  // namespace
}  // namespace veritope
