// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/formula/formula_evaluator.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "interval/formula/formula_tiers_internal.h"
#include "robust/base/check.h"

namespace veritope {
namespace {

using internal::FormulaFault;
using internal::FormulaPoint;
using internal::WideOutcome;

constexpr int kFirstPrecision = 128;

// The bounds as numbers that fit memory: MPFR's exponents go to 2^62. Tiny bounds are those of binary64 outside.
FormulaBounds bounds_of(const MpInterval& x) {
  constexpr double kTiny = 0x1p-1000;
  const Interval rough = x.to_interval();
  const auto bound = [&](double b, auto exact) {
    return b > -kTiny && b < kTiny ? Rational::from_double(b) : exact();
  };
  return {bound(rough.lo(), [&] { return x.lo(); }), bound(rough.hi(), [&] { return x.hi(); })};
}

std::string short_text(const Rational& x) {
  constexpr std::size_t kMostShown = 40;
  std::string text = x.to_string();
  if (text.size() <= kMostShown) return text;
  return "approximately " + internal::number_text("%.17g", nearest_double(x));
}

// The variables on which the node depends, with their values: " at x = 1/3, y = 0".
std::string place_text(const RealFormula& formula, std::uint32_t node, const FormulaPoint& at) {
  const auto nodes = formula.nodes();
  std::vector<bool> occurs(formula.variables().size());
  bool is_random = false;
  std::vector<std::uint32_t> todo = {node};
  while (!todo.empty()) {
    const FormulaNode& n = nodes[todo.back()];
    todo.pop_back();
    if (n.op == FormulaOp::kVariable) occurs[n.a] = true;
    is_random = is_random || n.op == FormulaOp::kRandom;
    if (n.op >= FormulaOp::kNegate) todo.push_back(n.a);
    if (n.op >= FormulaOp::kAdd) todo.push_back(n.b);
  }
  std::string out;
  const auto add = [&](const std::string& name, const std::string& value) {
    out += (out.empty() ? " at " : ", ") + name + " = " + value;
  };
  for (std::size_t i = 0; i < occurs.size(); ++i)
    if (occurs[i]) add(formula.variables()[i], short_text(at.values[i]));
  if (is_random) add("index", std::to_string(at.index));
  return out;
}

// What a fault says of a part of a formula.
std::string fault_text(FormulaFault fault, const std::string& part) {
  switch (fault) {
    case FormulaFault::kDivisionByZero: return "the divisor of " + part + " is 0";
    case FormulaFault::kRootOfNegative: return "the argument of " + part + " is negative";
    case FormulaFault::kZeroToNegative: return "0 is raised to a negative power in " + part;
    case FormulaFault::kNegativeToFraction:
      return "a negative number is raised to a power that is not an integer in " + part;
    case FormulaFault::kTooLarge:
      return "the value of " + part + " exceeds 2^" + std::to_string(RealFormula::kMostExponent) +
             " in absolute value";
    default: return "the value of " + part + " lies in the middle between two multiples of 2^-20";
  }
}

class Reporter {
 public:
  Reporter(const RealFormula& formula, const FormulaPoint& at) : formula_(formula), at_(at) {}

  Error error(const WideOutcome& outcome) const {
    return bad_argument(fault_text(outcome.fault, part(outcome)) +
                        place_text(formula_, outcome.node, at_));
  }
  OpenFormula open(const WideOutcome& outcome, int precision) const {
    OpenFormula out;
    out.bounds = bounds_of(outcome.value);
    out.column = formula_.nodes()[outcome.node].begin + 1;
    out.precision = precision;
    out.message = "it is undecided, with " + std::to_string(precision) + " bits, whether " +
                  fault_text(outcome.fault, part(outcome)) +
                  place_text(formula_, outcome.node, at_) + "; the number in question lies in " +
                  to_string(outcome.value.to_interval());
    return out;
  }

 private:
  std::string part(const WideOutcome& outcome) const {
    const FormulaNode& node = formula_.nodes()[outcome.node];
    const std::string_view text = formula_.text();
    return quoted_formula(text.substr(node.begin, node.end - node.begin)) + " (column " +
           std::to_string(node.begin + 1) + ")";
  }

  const RealFormula& formula_;
  const FormulaPoint& at_;
};

}  // namespace

class FormulaEvaluator::Body {
 public:
  Body(const RealFormula& formula, Tier first)
      : formula_(&formula), first_(first), quick_(formula) {}

  Result<RoundedValue> round(const FormulaPoint& at) {
    require_values(at);
    if (first_ == Tier::kBinary64) {
      if (const auto multiple = quick_.round_value(at)) {
        ++counts_.binary64;
        return RoundedValue{*multiple, std::nullopt};
      }
    }
    return round_slowly(at);
  }

  std::optional<std::int64_t> round_within(const FormulaPoint& at) {
    VT_CHECK(at.bounds.size() == formula_->variables().size(), "bounds of each variable");
    return first_ == Tier::kBinary64 ? quick_.round_value(at) : std::nullopt;
  }

  Result<EnclosedValue> enclose(const FormulaPoint& at, int precision) {
    require_values(at);
    VT_CHECK(precision >= MpInterval::kMinPrecision && precision <= kMostPrecision,
             "the precision of an enclosure");
    const auto exact = internal::exact_nodes(*formula_, at);
    if (const auto& value = exact.back().value)
      return EnclosedValue{{*value, *value}, std::nullopt};
    for (;; precision = std::min(2 * precision, kMostPrecision)) {
      const WideOutcome outcome = internal::wide_value(*formula_, exact, precision);
      if (outcome.fault == FormulaFault::kNone)
        return EnclosedValue{bounds_of(outcome.value), std::nullopt};
      if (outcome.is_certain) return Reporter(*formula_, at).error(outcome);
      if (precision == kMostPrecision)
        return EnclosedValue{{}, Reporter(*formula_, at).open(outcome, precision)};
    }
  }

  const Counts& counts() const { return counts_; }

 private:
  void require_values(const FormulaPoint& at) const {
    VT_CHECK(at.values.size() == formula_->variables().size(), "a value for each variable");
  }

  Result<RoundedValue> round_slowly(const FormulaPoint& at) {
    const auto exact = internal::exact_nodes(*formula_, at);
    if (const auto& value = exact.back().value; value && first_ != Tier::kWide) {
      ++counts_.exact;
      return RoundedValue{internal::nearest_multiple(*value), std::nullopt};
    }
    for (int precision = kFirstPrecision;; precision *= 2) {
      WideOutcome outcome = internal::wide_value(*formula_, exact, precision);
      if (outcome.fault == FormulaFault::kNone) {
        if (const auto multiple = nearest_multiple(outcome.value, kRoundingExponent)) {
          ++counts_.wide;
          return RoundedValue{*multiple, std::nullopt};
        }
        outcome.fault = FormulaFault::kRounding, outcome.is_certain = false;
      }
      if (outcome.is_certain) return Reporter(*formula_, at).error(outcome);
      if (precision >= kMostPrecision) {
        ++counts_.open;
        return RoundedValue{0, Reporter(*formula_, at).open(outcome, precision)};
      }
    }
  }

  const RealFormula* formula_;
  Tier first_;
  internal::QuickFormula quick_;
  Counts counts_;
};

FormulaEvaluator::FormulaEvaluator(const RealFormula& formula, Tier first)
    : body_(std::make_unique<Body>(formula, first)) {}
FormulaEvaluator::FormulaEvaluator(FormulaEvaluator&&) noexcept = default;
FormulaEvaluator& FormulaEvaluator::operator=(FormulaEvaluator&&) noexcept = default;
FormulaEvaluator::~FormulaEvaluator() = default;

Result<RoundedValue> FormulaEvaluator::round_to_multiple(std::span<const Rational> values,
                                                         std::uint64_t index) {
  return body_->round({values, index});
}
std::optional<std::int64_t> FormulaEvaluator::round_within(std::span<const Interval> bounds,
                                                           std::uint64_t index) {
  return body_->round_within({{}, index, bounds});
}
Result<EnclosedValue> FormulaEvaluator::enclose(std::span<const Rational> values,
                                                std::uint64_t index, int precision) {
  return body_->enclose({values, index}, precision);
}
const FormulaEvaluator::Counts& FormulaEvaluator::counts() const { return body_->counts(); }

}  // namespace veritope
