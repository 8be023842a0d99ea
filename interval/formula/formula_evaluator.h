// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/formula/formula_evaluator.h: values of formulas, rounded to the same multiples of 2^-20 on every machine, or
// enclosed. Design: docs/design/0072-formulas.md.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "interval/formula/real_formula.h"
#include "interval/interval.h"
#include "robust/base/result.h"
#include "robust/rational.h"

namespace veritope {

/// lo <= x <= hi.
struct FormulaBounds {
  Rational lo, hi;
};

/// What is not known of a formula's value.
struct OpenFormula {
  /// A sentence with the part of the formula, its column, and the values of the variables.
  std::string message;
  /// Those of the number that was to be decided about: a divisor, a root's argument, the base of a power, the value.
  FormulaBounds bounds;
  std::uint32_t column = 1;  ///< where the part begins, counted from 1
  int precision = 0;         ///< the bits with which it was last computed
};

struct RoundedValue {
  std::int64_t multiple = 0;        ///< the rounded value is multiple 2^-20
  std::optional<OpenFormula> open;  ///< present: the answer is undecided
};
struct EnclosedValue {
  FormulaBounds bounds;             ///< of the value
  std::optional<OpenFormula> open;  ///< present: whether there is a value is undecided
};

/// Evaluates one formula at many points. Each answer is right or undecided, on every machine the same: first
/// binary64 intervals are asked, then exact rational numbers, then intervals of 128, 256, ..., kMostPrecision bits.
/// A formula has a value where all its parts have one, and none of them exceeds 2^RealFormula::kMostExponent. x^y is
/// defined for integers y (0^0 is 1, and 0^y is not defined for y < 0) and for x >= 0. The work space is kept
/// between calls: one evaluator serves one thread.
class FormulaEvaluator {
 public:
  static constexpr int kRoundingExponent = -20, kMostPrecision = 4096;
  /// The tier that is asked first, for tests.
  enum class Tier : std::uint8_t { kBinary64, kExact, kWide };

  /// REQUIRES that the formula outlives it, and of the thread what MpInterval requires.
  explicit FormulaEvaluator(const RealFormula& formula, Tier first = Tier::kBinary64);
  FormulaEvaluator(FormulaEvaluator&&) noexcept;
  FormulaEvaluator& operator=(FormulaEvaluator&&) noexcept;
  ~FormulaEvaluator();

  /// The value rounded to the nearest multiple of 2^-20; a value in the middle between two goes to the even multiple.
  /// Undecided where an irrational expression is such a middle, a divisor that is zero or the like, because then no
  /// number of bits decides.
  /// @param values  of formula.variables(), in their order. REQUIRES as many
  /// @param index   what rand depends on besides its seed
  /// @error  kBadArgument where there is no value: division by 0, a square root of a negative number, a negative power
  ///         of 0, a fractional power of a negative number, a part beyond 2^40. The message names the part of the
  ///         formula, its column and the values of the variables
  /// @cost   in binary64: 5 ns an operation, 50 ns for sin, cos and exp, 10 us for a fractional power; otherwise up to
  ///         milliseconds
  Result<RoundedValue> round_to_multiple(std::span<const Rational> values, std::uint64_t index = 0);

  /// What round_to_multiple says for all values within these bounds, if binary64 shows that it is the same.
  /// @param bounds  of formula.variables(), in their order. REQUIRES as many, finite
  std::optional<std::int64_t> round_within(std::span<const Interval> bounds,
                                           std::uint64_t index = 0);

  /// Bounds of the value, computed with `precision` bits, or with more where fewer do not show that there is a
  /// value. They are not the narrowest. REQUIRES 2 <= precision <= kMostPrecision.
  /// @error  as above
  Result<EnclosedValue> enclose(std::span<const Rational> values, std::uint64_t index,
                                int precision);

  /// How many answers each tier gave.
  struct Counts {
    std::uint64_t binary64 = 0, exact = 0, wide = 0, open = 0;
  };
  const Counts& counts() const;

 private:
  class Body;
  std::unique_ptr<Body> body_;
};

}  // namespace veritope
