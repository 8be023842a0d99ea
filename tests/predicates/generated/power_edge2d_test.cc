// SPDX-License-Identifier: LGPL-3.0-or-later
// Made by tools/generate_predicates.py from predicates/generated/power_edge2d.formula: do not edit.
// clang-format off
#include "predicates/generated/power_edge2d.h"
#include "tests/predicates/generated/subject.h"

namespace veritope {
namespace {

using generated::Operands;

Sign by_formula(const Operands& v) {
  std::array<Rational, 9> w;
  for (std::size_t i = 0; i < 9; ++i) w[i] = Rational::from_double(v[i]);
  return formulas::power_edge2d_of<Rational>(w).sign();
}

const bool kRegistered = generated::add({
    .name = "power_edge2d",
    .axes = {0, 1, -1, 0, 1, -1, 0, 1, -1},
    .powers = {1, 1, 2, 1, 1, 2, 1, 1, 2},
    .has_lattice = true,
    .decide = [](const Operands& v, TierCounts* tally) { return power_edge2d({v[0], v[1]}, v[2], {v[3], v[4]}, v[5], {v[6], v[7]}, v[8], tally); },
    .filter = [](const Operands& v) { return power_edge2d_filter({v[0], v[1]}, v[2], {v[3], v[4]}, v[5], {v[6], v[7]}, v[8]); },
    .lattice = [](const Operands& v) { return internal::power_edge2d_lattice({v[0], v[1]}, v[2], {v[3], v[4]}, v[5], {v[6], v[7]}, v[8]); },
    .interval = [](const Operands& v) { return internal::power_edge2d_interval({v[0], v[1]}, v[2], {v[3], v[4]}, v[5], {v[6], v[7]}, v[8]); },
    .exact = [](const Operands& v) { return internal::power_edge2d_exact({v[0], v[1]}, v[2], {v[3], v[4]}, v[5], {v[6], v[7]}, v[8]); },
    .by_formula = by_formula,
    .laws = {{1, {3, 4, 5, 0, 1, 2, 6, 7, 8}, {}}, {1, {}, {0, 1, -1, 0, 1, -1, 0, 1, -1}}},
    .examples = {{{-1, 0, 0, 1, 0, 0, 0, 0, 0}, Sign::kPositive}, 
                 {{-1, 0, 0, 1, 0, 0, 0, 1, 0}, Sign::kZero}, 
                 {{-1, 0, 0, 1, 0, 0, 0, 2, 0}, Sign::kNegative}, 
                 {{-1, 0, 0, 1, 0, 0, 0, 2, 3}, Sign::kZero}, 
                 {{-1, 0, 1, 1, 0, 1, 0, 0, 0}, Sign::kZero}, 
                 {{-1, 0, 4, 1, 0, 0, 0.5, 0, 0}, Sign::kNegative}, 
                 {{3, 4, 7, 3, 4, 7, 1, 1, 5}, Sign::kZero}, 
                 {{-0x1p600, 0, 0, 0x1p600, 0, 0, 0, 0x1p600, 0x1p-1074}, Sign::kPositive}},
});

TEST(PowerEdge2dBound, ConstantsFollowFromTheFormula) {
  [[maybe_unused]] const bounds::RoundingCount x, d = x - x;
  const auto det = formulas::power_edge2d_det(d, d, d, d, d, d, d, d);
  const auto magnitude = formulas::power_edge2d_magnitude(bounds::kSame, d, d, d, d, d, d, d, d);
  EXPECT_EQ(det.roundings - 1, 9);
  bounds::expect_tight(internal::kPowerEdge2dRel, det.roundings - 1, magnitude.roundings);
  for (const Rational& unit : {bounds::underflow_unit(), bounds::flush_unit()}) {
    const auto m = bounds::UnderflowCount::bounded_by(0, unit);
    const auto value = formulas::power_edge2d_det(m, m, m, m, m, m, m, m);
    const auto sum = formulas::power_edge2d_magnitude(bounds::kSame, m, m, m, m, m, m, m, m);
    generated::expect_underflow_paid<2>(value, sum, m, internal::kPowerEdge2dRel, internal::kPowerEdge2dEta);
  }
}

TEST(PowerEdge2dBound, TheErrorCountsEveryDifference) {
  generated::expect_size_counts_every<2, 8>(internal::kPowerEdge2dEta, [](const auto& v) {
    return internal::power_edge2d_error(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], kFilterFloor);
  });
}

}  // namespace
}  // namespace veritope
