// SPDX-License-Identifier: LGPL-3.0-or-later
// The first tier: binary64 intervals.
#include <cmath>
#include <utility>

#include "interval/formula/formula_tiers_internal.h"
#include "interval/formula/quick_functions_internal.h"
#include "interval/functions.h"
#include "interval/numeric.h"
#include "interval/relations.h"
#include "interval/upward.h"

namespace veritope::internal {
namespace {

constexpr double kMostValue = 0x1p40;
static_assert(RealFormula::kMostExponent == 40);

bool is_small_enough(const Interval& x) {
  return is_subset(x, Interval::from_bounds(-kMostValue, kMostValue));
}

// The narrowest interval, at low cost for a quotient of binary64 integers. REQUIRES a live ScopedUpward.
Interval quick_enclosure(const Rational& x) {
  constexpr std::int64_t kExactIntegers = std::int64_t{1} << 53;
  const Integer &n = x.numerator(), &d = x.denominator();
  if (!n.fits_int64() || !d.fits_int64()) return enclose(x);
  const std::int64_t numerator = n.to_int64(), denominator = d.to_int64();
  if (numerator > kExactIntegers || numerator < -kExactIntegers || denominator > kExactIntegers)
    return enclose(x);
  const Interval over(static_cast<double>(numerator));
  return denominator == 1 ? over : over / Interval(static_cast<double>(denominator));
}

// n, if x is the set of one integer n that binary64 intervals can show.
std::optional<std::int64_t> integer_of(const Interval& x) {
  const double v = x.lo();
  if (!is_singleton(x) || !(std::abs(v) <= kMostValue)) return std::nullopt;
  const auto n = static_cast<std::int64_t>(v);
  if (static_cast<double>(n) != v) return std::nullopt;
  return n;
}

// The integer nearest to v 2^20; products with powers of two and the difference below are exact, so that the rounding
// mode does not matter.
std::int64_t nearest_integer(double v) {
  const double scaled = std::abs(v) * 0x1p20;
  const auto below = static_cast<std::int64_t>(scaled);
  const double rest = scaled - static_cast<double>(below);
  const std::int64_t nearest = below + (rest > 0.5 || (rest == 0.5 && below % 2 != 0) ? 1 : 0);
  return v < 0 ? -nearest : nearest;
}

bool has_operands(FormulaOp op) { return op >= FormulaOp::kNegate; }
bool has_two_operands(FormulaOp op) { return op >= FormulaOp::kAdd; }

}  // namespace

std::optional<std::int64_t> nearest_multiple(const Interval& x) {
  const std::int64_t n = nearest_integer(x.lo());
  if (n != nearest_integer(x.hi())) return std::nullopt;
  return n;
}

QuickFormula::QuickFormula(const RealFormula& formula) : values_(formula.nodes().size()) {
  const auto nodes = formula.nodes();
  std::vector<bool> is_constant(nodes.size());
  const ScopedUpward upward;
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    const FormulaNode& node = nodes[i];
    if (node.op == FormulaOp::kNumber || node.op == FormulaOp::kPi) {
      constexpr double kPiLow = 0x1.921fb54442d18p+1, kPiHigh = 0x1.921fb54442d19p+1;
      values_[i] =
          node.op == FormulaOp::kPi ? Interval::from_bounds(kPiLow, kPiHigh) : enclose(node.number);
      is_constant[i] = true;
      continue;
    }
    Step step{node.op, false, i, node.a, node.b, 0, node.seed};
    if (node.op == FormulaOp::kVariable) step.leaf = std::exchange(step.a, 0);
    const bool has_constant_power = node.op == FormulaOp::kPower && is_constant[node.b];
    if (const auto n = has_constant_power ? integer_of(values_[node.b]) : std::nullopt)
      step.is_integer_power = true, step.exponent = *n;
    is_constant[i] = has_operands(node.op) && is_constant[node.a] &&
                     (!has_two_operands(node.op) || is_constant[node.b]);
    if (!is_constant[i]) {
      steps_.push_back(step);
    } else if (!run(step, {})) {
      has_constants_ = false;
      return;
    }
  }
}

bool QuickFormula::run(const Step& step, const FormulaPoint& at) {
  Interval& out = values_[step.out];
  const Interval& a = values_[step.a];
  const Interval& b = values_[step.b];
  switch (step.op) {
    case FormulaOp::kNumber:
    case FormulaOp::kPi: return false;  // no steps
    case FormulaOp::kVariable:
      out = at.bounds.empty() ? quick_enclosure(at.values[step.leaf]) : at.bounds[step.leaf];
      break;
    case FormulaOp::kRandom: out = Interval(formula_random(step.leaf, at.index) * 0x1p-20); break;
    case FormulaOp::kNegate: out = -a; break;
    case FormulaOp::kAbs: out = abs(a); break;
    case FormulaOp::kSin: out = quick_sin(a); break;
    case FormulaOp::kCos: out = quick_cos(a); break;
    case FormulaOp::kExp: out = quick_exp(a); break;
    case FormulaOp::kSqrt:
      if (a.lo() < 0) return false;
      out = sqrt(a);
      break;
    case FormulaOp::kAdd: out = a + b; break;
    case FormulaOp::kSubtract: out = a - b; break;
    case FormulaOp::kMultiply: out = a * b; break;
    case FormulaOp::kDivide:
      if (is_member(0, b)) return false;
      out = a / b;
      break;
    case FormulaOp::kMin: out = min(a, b); break;
    case FormulaOp::kMax: out = max(a, b); break;
    case FormulaOp::kPower: {
      const auto n = step.is_integer_power ? step.exponent : integer_of(b);
      if (n) {
        if (*n < 0 && is_member(0, a)) return false;
        out = quick_power(a, *n);
        break;
      }
      if (a.lo() <= 0) return false;
      out = b == Interval(0.5) ? sqrt(a) : pow(a, b);
      break;
    }
  }
  return is_small_enough(out);
}

std::optional<Interval> QuickFormula::enclose_value(const FormulaPoint& at) {
  if (!has_constants_) return std::nullopt;
  for (const Step& step : steps_)
    if (!run(step, at)) return std::nullopt;
  return values_.back();
}

std::optional<std::int64_t> QuickFormula::round_value(const FormulaPoint& at) {
  const ScopedUpward upward;
  const std::optional<Interval> value = enclose_value(at);
  return value ? nearest_multiple(*value) : std::nullopt;
}

}  // namespace veritope::internal
