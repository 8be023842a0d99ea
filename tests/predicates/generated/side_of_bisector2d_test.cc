// SPDX-License-Identifier: LGPL-3.0-or-later
// Made by tools/generate_predicates.py from predicates/generated/side_of_bisector2d.formula: do not edit.
// clang-format off
#include "predicates/generated/side_of_bisector2d.h"
#include "tests/predicates/generated/subject.h"

namespace veritope {
namespace {

using generated::Operands;

Sign by_formula(const Operands& v) {
  std::array<Rational, 6> w;
  for (std::size_t i = 0; i < 6; ++i) w[i] = Rational::from_double(v[i]);
  return formulas::side_of_bisector2d_of<Rational>(w).sign();
}

const bool kRegistered = generated::add({
    .name = "side_of_bisector2d",
    .axes = {0, 1, 0, 1, 0, 1},
    .powers = {1, 1, 1, 1, 1, 1},
    .has_lattice = true,
    .decide = [](const Operands& v, TierCounts* tally) { return side_of_bisector2d({v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}, tally); },
    .filter = [](const Operands& v) { return side_of_bisector2d_filter({v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}); },
    .lattice = [](const Operands& v) { return internal::side_of_bisector2d_lattice({v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}); },
    .interval = [](const Operands& v) { return internal::side_of_bisector2d_interval({v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}); },
    .exact = [](const Operands& v) { return internal::side_of_bisector2d_exact({v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}); },
    .by_formula = by_formula,
    .laws = {{-1, {2, 3, 0, 1, 4, 5}, {}}, {1, {}, {0, 1, 0, 1, 0, 1}}},
    .examples = {{{0, 0, 2, 0, 0.5, 9}, Sign::kPositive}, 
                 {{0, 0, 2, 0, 1, 9}, Sign::kZero}, 
                 {{0, 0, 2, 0, 1.0000000000000002, 9}, Sign::kNegative}, 
                 {{5, 5, 5, 5, 1, 2}, Sign::kZero}, 
                 {{0, 0, 0x1p-1074, 0, 0, 0}, Sign::kPositive}},
});

TEST(SideOfBisector2dBound, ConstantsFollowFromTheFormula) {
  [[maybe_unused]] const bounds::RoundingCount x, d = x - x;
  const auto det = formulas::side_of_bisector2d_det(d, d, d, d, d, d);
  const auto magnitude = formulas::side_of_bisector2d_magnitude(bounds::kSame, d, d, d, d, d, d);
  EXPECT_EQ(det.roundings - 1, 4);
  bounds::expect_tight(internal::kSideOfBisector2dRel, det.roundings - 1, magnitude.roundings);
  for (const Rational& unit : {bounds::underflow_unit(), bounds::flush_unit()}) {
    const auto m = bounds::UnderflowCount::bounded_by(0, unit);
    const auto value = formulas::side_of_bisector2d_det(m, m, m, m, m, m);
    const auto sum = formulas::side_of_bisector2d_magnitude(bounds::kSame, m, m, m, m, m, m);
    generated::expect_underflow_paid<0>(value, sum, m, internal::kSideOfBisector2dRel, 0);
  }
}

}  // namespace
}  // namespace veritope
