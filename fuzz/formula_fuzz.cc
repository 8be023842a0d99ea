// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/formula_fuzz.cc: any bytes as a formula. Errors name a column of the text; values are the same in each tier that
// answers, and lie where enclosures say.
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "interval/formula/formula_evaluator.h"
#include "interval/formula/formula_tiers_internal.h"
#include "robust/base/check.h"

namespace {

using namespace veritope;
using Tier = FormulaEvaluator::Tier;

constexpr std::size_t kMostEvaluated = 100;  // nodes; more make an input slow, and show nothing new
const std::vector<std::string> kNames = {"x", "y", "z", "u", "v", "w", "n"};

Rational fraction(std::int64_t n, std::int64_t d) { return Rational(Integer(n), Integer(d)); }
const std::array<std::vector<Rational>, 3> kPoints = {{
    {fraction(1, 3), fraction(-2, 7), fraction(5, 4), fraction(1, 2), Rational(0), Rational(1),
     Rational(3)},
    {Rational(0), Rational(0), Rational(0), Rational(0), Rational(0), Rational(0), Rational(0)},
    {fraction(1, 1 << 21), fraction(-355, 113), Rational(1000000), fraction(7, 9),
     fraction(1, 1 << 30), fraction(-1, 1 << 30), Rational(64)},
}};

void check_error_of_text(const Error& error, std::size_t size) {
  constexpr std::string_view kColumn = "column ";
  for (const char c : error.message) VT_CHECK(c >= ' ' && c <= '~', "a message with raw bytes");
  VT_CHECK(error.code == Code::kSyntax || error.code == Code::kOverLimit, "an error of a text");
  if (size > RealFormula::kMostCharacters) return;
  VT_CHECK(error.message.starts_with(kColumn), "no column");
  const unsigned long column = std::stoul(error.message.substr(kColumn.size()));
  VT_CHECK(column >= 1 && column <= size + 1, "a column off the text");
}

void check_nodes(const RealFormula& formula) {
  std::uint32_t number = 0;
  for (const FormulaNode& node : formula.nodes()) {
    VT_CHECK(node.begin < node.end && node.end <= formula.text().size(), "a node off the text");
    if (node.op >= FormulaOp::kNegate) VT_CHECK(node.a < number, "an operand after its node");
    if (node.op >= FormulaOp::kAdd) VT_CHECK(node.b < number, "an operand after its node");
    ++number;
  }
}

std::string said(const Result<RoundedValue>& value) {
  if (!value) return value.error().message;
  return value->open ? value->open->message : std::to_string(value->multiple);
}
bool is_decided(const Result<RoundedValue>& value) { return !value || !value->open; }

void check_bounds(FormulaEvaluator& evaluator, const std::vector<Rational>& values, int precision,
                  const Result<RoundedValue>& rounded) {
  const Result<EnclosedValue> enclosed = evaluator.enclose(values, 5, precision);
  if (is_decided(rounded))
    VT_CHECK(enclosed.has_value() == rounded.has_value(), "an enclosure of no value");
  if (!enclosed) return VT_CHECK(enclosed.error().message == said(rounded), "another error");
  if (enclosed->open) return VT_CHECK(!is_decided(rounded), "a value without an enclosure");
  const FormulaBounds& bounds = enclosed->bounds;
  VT_CHECK(bounds.lo <= bounds.hi, "bounds in the wrong order");
  if (!is_decided(rounded)) return;
  const Rational most = Rational::power_of_two(RealFormula::kMostExponent);
  if (bounds.lo < -most || most < bounds.hi) return;  // few bits
  VT_CHECK(internal::nearest_multiple(bounds.lo) <= rounded->multiple &&
               rounded->multiple <= internal::nearest_multiple(bounds.hi),
           "the rounded value and the enclosure contradict each other");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Result<RealFormula> formula = parse_formula(text, kNames);
  if (!formula) return check_error_of_text(formula.error(), size), 0;
  check_nodes(*formula);
  if (formula->nodes().size() > kMostEvaluated) return 0;
  FormulaEvaluator quick(*formula), exact(*formula, Tier::kExact), wide(*formula, Tier::kWide);
  for (const std::vector<Rational>& values : kPoints) {
    const Result<RoundedValue> value = quick.round_to_multiple(values, 5);
    VT_CHECK(said(value) == said(exact.round_to_multiple(values, 5)), "two tiers disagree");
    const Result<RoundedValue> slow = wide.round_to_multiple(values, 5);
    VT_CHECK(!is_decided(slow) || said(value) == said(slow), "two tiers disagree");
    check_bounds(quick, values, 40, value);
    check_bounds(quick, values, 200, value);
  }
  return 0;
}
