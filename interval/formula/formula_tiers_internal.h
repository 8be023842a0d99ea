// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/formula/formula_tiers_internal.h: the three ways to evaluate a formula. formula_evaluator.cc asks them in
// turn; each of them answers only what it has proved.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "interval/formula/real_formula.h"
#include "interval/interval.h"
#include "interval/mp_interval.h"

namespace veritope::internal {

/// Why a formula has no value, or what is asked about its value.
enum class FormulaFault : std::uint8_t {
  kNone,
  kDivisionByZero,
  kRootOfNegative,
  kZeroToNegative,      ///< 0 raised to a negative power
  kNegativeToFraction,  ///< a negative number raised to a power that is not an integer
  kTooLarge,            ///< beyond 2^RealFormula::kMostExponent
  kRounding,            ///< two multiples are nearest to an enclosure of the value
};

/// The values of the variables, in the order of RealFormula::variables(), and the index for rand.
struct FormulaPoint {
  std::span<const Rational> values;
  std::uint64_t index = 0;
  std::span<const Interval> bounds = {};  ///< of the values; the first tier needs no values then
};

/// First tier: the formula as a list of steps on binary64 intervals. Constant parts are computed once.
class QuickFormula {
 public:
  explicit QuickFormula(const RealFormula& formula);
  /// An enclosure, if it is proved that all parts of the formula have values and are not too large.
  /// REQUIRES a live ScopedUpward.
  std::optional<Interval> enclose_value(const FormulaPoint& at);
  std::optional<std::int64_t> round_value(const FormulaPoint& at);

 private:
  struct Step {
    FormulaOp op;
    bool is_integer_power;
    std::uint32_t out, a, b;
    std::int64_t exponent;  // of an integer power
    std::uint64_t leaf;     // the number of a variable, or the seed of rand
  };
  bool run(const Step& step, const FormulaPoint& at);

  bool has_constants_ = true;  // false: a part without variables has no value, or a doubtful one
  std::vector<Step> steps_;
  std::vector<Interval> values_;  // of the nodes
};

/// The integer nearest to x 2^20, ties to even, if all members x have the same one. REQUIRES |x| <= 2^40.
std::optional<std::int64_t> nearest_multiple(const Interval& x);

/// Second tier: nodes whose values are rational numbers, as exact numbers of not more than kMostExactBits bits above
/// and below the fraction bar. The third tier asks for their signs, and so finds where there is no value.
struct ExactNode {
  std::optional<Rational> value;  ///< absent: irrational, too long or too large, or does not exist
  bool is_too_large = false;
};
inline constexpr std::uint64_t kMostExactBits = 16384;
std::vector<ExactNode> exact_nodes(const RealFormula& formula, const FormulaPoint& at);
/// The integer nearest to x 2^20, ties to even. REQUIRES |x| <= 2^40.
std::int64_t nearest_multiple(const Rational& x);

/// Third tier: intervals with as many bits as asked for, around exact nodes where there are any. Stops at the first
/// node that has no value, or of which the intervals do not say whether it has one.
struct WideOutcome {
  FormulaFault fault = FormulaFault::kNone;
  bool is_certain = true;  ///< false: there may be this fault
  std::uint32_t node = 0;  ///< where it is; without a fault the last node
  MpInterval value{2};     ///< of this node; where there may be a fault, of the operand in question
};
WideOutcome wide_value(const RealFormula& formula, std::span<const ExactNode> exact, int precision);

}  // namespace veritope::internal
