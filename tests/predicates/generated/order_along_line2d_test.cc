// SPDX-License-Identifier: LGPL-3.0-or-later
// Made by tools/generate_predicates.py from predicates/generated/order_along_line2d.formula: do not edit.
// clang-format off
#include "predicates/generated/order_along_line2d.h"
#include "tests/predicates/generated/subject.h"

namespace veritope {
namespace {

using generated::Operands;

Sign by_formula(const Operands& v) {
  std::array<Rational, 8> w;
  for (std::size_t i = 0; i < 8; ++i) w[i] = Rational::from_double(v[i]);
  return formulas::order_along_line2d_of<Rational>(w).sign();
}

const bool kRegistered = generated::add({
    .name = "order_along_line2d",
    .axes = {0, 1, 0, 1, 0, 1, 0, 1},
    .powers = {1, 1, 1, 1, 1, 1, 1, 1},
    .has_lattice = true,
    .decide = [](const Operands& v, TierCounts* tally) { return order_along_line2d({v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}, {v[6], v[7]}, tally); },
    .filter = [](const Operands& v) { return order_along_line2d_filter({v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}, {v[6], v[7]}); },
    .lattice = [](const Operands& v) { return internal::order_along_line2d_lattice({v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}, {v[6], v[7]}); },
    .interval = [](const Operands& v) { return internal::order_along_line2d_interval({v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}, {v[6], v[7]}); },
    .exact = [](const Operands& v) { return internal::order_along_line2d_exact({v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}, {v[6], v[7]}); },
    .by_formula = by_formula,
    .laws = {{-1, {0, 1, 2, 3, 6, 7, 4, 5}, {}}, {-1, {2, 3, 0, 1, 4, 5, 6, 7}, {}}, {1, {}, {0, 1, 0, 1, -1, -1, -1, -1}}, {1, {}, {-1, -1, -1, -1, 0, 1, 0, 1}}},
    .examples = {{{0, 0, 2, 0, 5, 1, 4, 9}, Sign::kPositive}, 
                 {{0, 0, 2, 0, 4, 1, 5, 9}, Sign::kNegative}, 
                 {{0, 0, 2, 0, 4, 1, 4, 9}, Sign::kZero}, 
                 {{1, 2, 1, 2, 4, 1, 5, 9}, Sign::kZero}, 
                 {{0, 0, 0x1p-1074, 0, 0x1p-1074, 0, 0, 0}, Sign::kPositive}},
});

TEST(OrderAlongLine2dBound, ConstantsFollowFromTheFormula) {
  [[maybe_unused]] const bounds::RoundingCount x, d = x - x;
  const auto det = formulas::order_along_line2d_det(d, d, d, d);
  const auto magnitude = formulas::order_along_line2d_magnitude(bounds::kSame, d, d, d, d);
  EXPECT_EQ(det.roundings - 1, 3);
  bounds::expect_tight(internal::kOrderAlongLine2dRel, det.roundings - 1, magnitude.roundings);
  for (const Rational& unit : {bounds::underflow_unit(), bounds::flush_unit()}) {
    const auto m = bounds::UnderflowCount::bounded_by(0, unit);
    const auto value = formulas::order_along_line2d_det(m, m, m, m);
    const auto sum = formulas::order_along_line2d_magnitude(bounds::kSame, m, m, m, m);
    generated::expect_underflow_paid<0>(value, sum, m, internal::kOrderAlongLine2dRel, 0);
  }
}

}  // namespace
}  // namespace veritope
