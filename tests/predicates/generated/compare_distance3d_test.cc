// SPDX-License-Identifier: LGPL-3.0-or-later
// Made by tools/generate_predicates.py from predicates/generated/compare_distance3d.formula: do not edit.
// clang-format off
#include "predicates/generated/compare_distance3d.h"
#include "tests/predicates/generated/subject.h"

namespace veritope {
namespace {

using generated::Operands;

Sign by_formula(const Operands& v) {
  std::array<Rational, 9> w;
  for (std::size_t i = 0; i < 9; ++i) w[i] = Rational::from_double(v[i]);
  return formulas::compare_distance3d_of<Rational>(w).sign();
}

const bool kRegistered = generated::add({
    .name = "compare_distance3d",
    .axes = {0, 1, 2, 0, 1, 2, 0, 1, 2},
    .powers = {1, 1, 1, 1, 1, 1, 1, 1, 1},
    .has_lattice = true,
    .decide = [](const Operands& v, TierCounts* tally) { return compare_distance3d({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}, tally); },
    .filter = [](const Operands& v) { return compare_distance3d_filter({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}); },
    .lattice = [](const Operands& v) { return internal::compare_distance3d_lattice({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}); },
    .interval = [](const Operands& v) { return internal::compare_distance3d_interval({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}); },
    .exact = [](const Operands& v) { return internal::compare_distance3d_exact({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}); },
    .by_formula = by_formula,
    .laws = {{-1, {0, 1, 2, 6, 7, 8, 3, 4, 5}, {}}, {1, {}, {0, 1, 2, 0, 1, 2, 0, 1, 2}}},
    .examples = {{{0, 0, 0, 2, 0, 0, 0, 1, 0}, Sign::kPositive}, 
                 {{0, 0, 0, 0, 1, 0, 2, 0, 0}, Sign::kNegative}, 
                 {{0, 0, 0, 3, 4, 0, -5, 0, 0}, Sign::kZero}, 
                 {{7, 8, 0, 1, 2, 0, 1, 2, 0}, Sign::kZero}, 
                 {{0, 0, 0, 0x1p-1074, 0, 0, 0, 0, 0}, Sign::kPositive}, 
                 {{0, 0, 0, 0x1.fffffffffffffp1023, 0, 0, -0x1.fffffffffffffp1023, 0x1p-1074, 0}, Sign::kNegative}},
});

TEST(CompareDistance3dBound, ConstantsFollowFromTheFormula) {
  [[maybe_unused]] const bounds::RoundingCount x, d = x - x;
  const auto det = formulas::compare_distance3d_det(d, d, d, d, d, d, d, d, d);
  const auto magnitude = formulas::compare_distance3d_magnitude(
      bounds::kSame, d, d, d, d, d, d, d, d, d);
  EXPECT_EQ(det.roundings - 1, 5);
  bounds::expect_tight(internal::kCompareDistance3dRel, det.roundings - 1, magnitude.roundings);
  for (const Rational& unit : {bounds::underflow_unit(), bounds::flush_unit()}) {
    const auto m = bounds::UnderflowCount::bounded_by(0, unit);
    const auto value = formulas::compare_distance3d_det(m, m, m, m, m, m, m, m, m);
    const auto sum = formulas::compare_distance3d_magnitude(
        bounds::kSame, m, m, m, m, m, m, m, m, m);
    generated::expect_underflow_paid<0>(value, sum, m, internal::kCompareDistance3dRel, 0);
  }
}

}  // namespace
}  // namespace veritope
