// SPDX-License-Identifier: LGPL-3.0-or-later
// The third tier: intervals of any precision.
#include <limits>
#include <utility>

#include "interval/formula/formula_tiers_internal.h"
#include "robust/base/check.h"

namespace veritope::internal {
namespace {

bool is_nonnegative(const MpInterval& x) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return is_subset(x, MpInterval(Interval::from_bounds(0, kInfinity), MpInterval::kMinPrecision));
}
// How the members compare with the integer nearest to them; uncertain also where that is not known.
Sign3 compare_with_integer(const MpInterval& x) {
  const std::optional<std::int64_t> n = nearest_multiple(x, 0);
  return n ? compare(x, MpInterval(Rational(*n), 64)) : Sign3::kUncertain;
}

// An operand: its enclosure, and its value if that is known exactly.
struct WideOperand {
  const MpInterval& enclosure;
  const std::optional<Rational>& exact;
  Sign3 sign() const { return exact ? to_sign3(exact->sign()) : enclosure.sign(); }
};

struct WideResult {
  MpInterval value;
  FormulaFault fault = FormulaFault::kNone;
  bool is_certain = true;
};
WideResult fault_at(const MpInterval& operand, FormulaFault fault, bool is_certain) {
  return {operand, fault, is_certain};
}

WideResult wide_quotient(const WideOperand& a, const WideOperand& b) {
  const Sign3 sign = b.sign();
  if (sign == Sign3::kZero || sign == Sign3::kUncertain)
    return fault_at(b.enclosure, FormulaFault::kDivisionByZero, is_certain(sign));
  return {a.enclosure / b.enclosure};
}

WideResult wide_root(const WideOperand& a) {
  const Sign3 sign = a.sign();
  if (sign == Sign3::kNegative || (sign == Sign3::kUncertain && !is_nonnegative(a.enclosure)))
    return fault_at(a.enclosure, FormulaFault::kRootOfNegative, is_certain(sign));
  return {sqrt(a.enclosure)};
}

WideResult wide_integer_power(const WideOperand& a, std::int64_t n) {
  const Sign3 sign = a.sign();
  if (n < 0 && (sign == Sign3::kZero || sign == Sign3::kUncertain))
    return fault_at(a.enclosure, FormulaFault::kZeroToNegative, is_certain(sign));
  return {pown(a.enclosure, n)};
}

WideResult wide_power(const WideOperand& a, const WideOperand& b) {
  if (b.exact && b.exact->denominator() == Integer(1))
    return wide_integer_power(a, b.exact->numerator().to_int64());
  const Sign3 beside_integer = compare_with_integer(b.enclosure);
  if (beside_integer == Sign3::kZero)
    return wide_integer_power(a, *nearest_multiple(b.enclosure, 0));
  const Sign3 base = a.sign(), exponent = b.sign();
  if (base == Sign3::kPositive) return {pow(a.enclosure, b.enclosure)};
  if (base == Sign3::kNegative || (base == Sign3::kUncertain && !is_nonnegative(a.enclosure))) {
    const bool is_fraction = b.exact || is_certain(beside_integer);
    return fault_at(a.enclosure, FormulaFault::kNegativeToFraction,
                    base == Sign3::kNegative && is_fraction);
  }
  if (exponent == Sign3::kPositive) return {pow(a.enclosure, b.enclosure)};
  const bool is_pole = base == Sign3::kZero && exponent == Sign3::kNegative;
  return fault_at(a.enclosure, FormulaFault::kZeroToNegative, is_pole);
}

WideResult wide_step(FormulaOp op, const WideOperand& a, const WideOperand& b) {
  switch (op) {
    case FormulaOp::kNegate: return {-a.enclosure};
    case FormulaOp::kAbs: return {abs(a.enclosure)};
    case FormulaOp::kSqrt: return wide_root(a);
    case FormulaOp::kSin: return {sin(a.enclosure)};
    case FormulaOp::kCos: return {cos(a.enclosure)};
    case FormulaOp::kExp: return {exp(a.enclosure)};
    case FormulaOp::kAdd: return {a.enclosure + b.enclosure};
    case FormulaOp::kSubtract: return {a.enclosure - b.enclosure};
    case FormulaOp::kMultiply: return {a.enclosure * b.enclosure};
    case FormulaOp::kDivide: return wide_quotient(a, b);
    case FormulaOp::kPower: return wide_power(a, b);
    case FormulaOp::kMin: return {min(a.enclosure, b.enclosure)};
    case FormulaOp::kMax: return {max(a.enclosure, b.enclosure)};
    default: break;
  }
  VT_CHECK(false, "a leaf of a formula is a number, or pi");
  return {a.enclosure};
}

// A value that is not too large, or the fault.
WideResult limited(MpInterval value) {
  static_assert(RealFormula::kMostExponent == 40);
  const MpInterval limit(Interval::from_bounds(-0x1p40, 0x1p40), value.precision());
  if (is_subset(value, limit)) return {std::move(value)};
  const bool is_outside = intersection(value, limit).is_empty();
  return {std::move(value), FormulaFault::kTooLarge, is_outside};
}

}  // namespace

WideOutcome wide_value(const RealFormula& formula, std::span<const ExactNode> exact,
                       int precision) {
  const auto nodes = formula.nodes();
  std::vector<MpInterval> values;
  values.reserve(nodes.size());
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    const FormulaNode& node = nodes[i];
    if (exact[i].value) {
      values.emplace_back(*exact[i].value, precision);
      continue;
    }
    if (node.op == FormulaOp::kPi) {
      values.push_back(MpInterval::pi(precision));
      continue;
    }
    if (exact[i].is_too_large) return {FormulaFault::kTooLarge, true, i, MpInterval(precision)};
    const WideOperand a{values[node.a], exact[node.a].value},
        b{values[node.b], exact[node.b].value};
    WideResult step = wide_step(node.op, a, b);
    if (step.fault == FormulaFault::kNone) step = limited(std::move(step.value));
    if (step.fault != FormulaFault::kNone)
      return {step.fault, step.is_certain, i, std::move(step.value)};
    values.push_back(std::move(step.value));
  }
  return {FormulaFault::kNone, true, static_cast<std::uint32_t>(nodes.size() - 1),
          std::move(values.back())};
}

}  // namespace veritope::internal
