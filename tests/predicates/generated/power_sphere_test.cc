// SPDX-License-Identifier: LGPL-3.0-or-later
// Made by tools/generate_predicates.py from predicates/generated/power_sphere.formula: do not edit.
// clang-format off
#include "predicates/generated/power_sphere.h"
#include "tests/predicates/generated/subject.h"

namespace veritope {
namespace {

using generated::Operands;

Sign by_formula(const Operands& v) {
  std::array<Rational, 20> w;
  for (std::size_t i = 0; i < 20; ++i) w[i] = Rational::from_double(v[i]);
  return formulas::power_sphere_of<Rational>(w).sign();
}

const bool kRegistered = generated::add({
    .name = "power_sphere",
    .axes = {0, 1, 2, -1, 0, 1, 2, -1, 0, 1, 2, -1, 0, 1, 2, -1, 0, 1, 2, -1},
    .powers = {1, 1, 1, 2, 1, 1, 1, 2, 1, 1, 1, 2, 1, 1, 1, 2, 1, 1, 1, 2},
    .has_lattice = true,
    .decide = [](const Operands& v, TierCounts* tally) { return power_sphere({v[0], v[1], v[2]}, v[3], {v[4], v[5], v[6]}, v[7], {v[8], v[9], v[10]}, v[11], {v[12], v[13], v[14]}, v[15], {v[16], v[17], v[18]}, v[19], tally); },
    .filter = [](const Operands& v) { return power_sphere_filter({v[0], v[1], v[2]}, v[3], {v[4], v[5], v[6]}, v[7], {v[8], v[9], v[10]}, v[11], {v[12], v[13], v[14]}, v[15], {v[16], v[17], v[18]}, v[19]); },
    .lattice = [](const Operands& v) { return internal::power_sphere_lattice({v[0], v[1], v[2]}, v[3], {v[4], v[5], v[6]}, v[7], {v[8], v[9], v[10]}, v[11], {v[12], v[13], v[14]}, v[15], {v[16], v[17], v[18]}, v[19]); },
    .interval = [](const Operands& v) { return internal::power_sphere_interval({v[0], v[1], v[2]}, v[3], {v[4], v[5], v[6]}, v[7], {v[8], v[9], v[10]}, v[11], {v[12], v[13], v[14]}, v[15], {v[16], v[17], v[18]}, v[19]); },
    .exact = [](const Operands& v) { return internal::power_sphere_exact({v[0], v[1], v[2]}, v[3], {v[4], v[5], v[6]}, v[7], {v[8], v[9], v[10]}, v[11], {v[12], v[13], v[14]}, v[15], {v[16], v[17], v[18]}, v[19]); },
    .by_formula = by_formula,
    .laws = {{-1, {4, 5, 6, 7, 0, 1, 2, 3, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19}, {}}, {-1, {0, 1, 2, 3, 8, 9, 10, 11, 4, 5, 6, 7, 12, 13, 14, 15, 16, 17, 18, 19}, {}}, {-1, {0, 1, 2, 3, 4, 5, 6, 7, 12, 13, 14, 15, 8, 9, 10, 11, 16, 17, 18, 19}, {}}, {-1, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14, 15}, {}}, {1, {}, {0, 1, 2, -1, 0, 1, 2, -1, 0, 1, 2, -1, 0, 1, 2, -1, 0, 1, 2, -1}}},
    .examples = {{{0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, -1, 0, 0, 0, 0, 0, 0, 0}, Sign::kPositive}, 
                 {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 0, 0, 0, 0, 0}, Sign::kNegative}, 
                 {{0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, -1, 0, 0, 0, 0, -1, 0, 0}, Sign::kZero}, 
                 {{0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, -1, 0, 0, 0, 0, -1, 0, 0x1p-1074}, Sign::kPositive}, 
                 {{0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, -1, 0, 0, 0, 0, -1, 0, -0x1p-1074}, Sign::kNegative}, 
                 {{0, 1, 0, 3, 1, 0, 0, 3, 0, 0, 1, 3, -1, 0, 0, 3, 0, 0, 0, 2}, Sign::kZero}},
});

TEST(PowerSphereBound, ConstantsFollowFromTheFormula) {
  [[maybe_unused]] const bounds::RoundingCount x, d = x - x;
  const auto det = formulas::power_sphere_det(d, d, d, d, d, d, d, d, d, d, d, d, d, d, d, d);
  const auto magnitude = formulas::power_sphere_magnitude(
      bounds::kSame, d, d, d, d, d, d, d, d, d, d, d, d, d, d, d, d);
  EXPECT_EQ(det.roundings - 1, 16);
  bounds::expect_tight(internal::kPowerSphereRel, det.roundings - 1, magnitude.roundings);
  for (const Rational& unit : {bounds::underflow_unit(), bounds::flush_unit()}) {
    const auto m = bounds::UnderflowCount::bounded_by(0, unit);
    const auto value = formulas::power_sphere_det(m, m, m, m, m, m, m, m, m, m, m, m, m, m, m, m);
    const auto sum = formulas::power_sphere_magnitude(
        bounds::kSame, m, m, m, m, m, m, m, m, m, m, m, m, m, m, m, m);
    generated::expect_underflow_paid<3>(value, sum, m, internal::kPowerSphereRel, internal::kPowerSphereEta);
  }
}

TEST(PowerSphereBound, TheErrorCountsEveryDifference) {
  generated::expect_size_counts_every<3, 16>(internal::kPowerSphereEta, [](const auto& v) {
    return internal::power_sphere_error(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], v[9], v[10], v[11], v[12], v[13], v[14], v[15], kFilterFloor);
  });
}

}  // namespace
}  // namespace veritope
