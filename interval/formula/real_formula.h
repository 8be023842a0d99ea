// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/formula/real_formula.h: formulas of named variables as text, such as 0.15 + 0.1*sin(6*x)*cos(6*y), and their
// parse trees. formula_evaluator.h computes their values. Design: docs/design/0072-formulas.md.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robust/base/result.h"
#include "robust/rational.h"

namespace veritope {

enum class FormulaOp : std::uint8_t {
  kNumber,
  kVariable,
  kPi,
  kRandom,  ///< rand(seed): see formula_random
  // with one operand
  kNegate,
  kSqrt,
  kSin,
  kCos,
  kExp,
  kAbs,
  // with two operands
  kAdd,
  kSubtract,
  kMultiply,
  kDivide,
  kPower,
  kMin,
  kMax,
};

struct FormulaNode {
  FormulaOp op = FormulaOp::kNumber;
  std::uint32_t a =
      0;  ///< the first operand, a node before this one; of kVariable: the number of the variable
  std::uint32_t b = 0;      ///< the second operand
  std::uint32_t begin = 0;  ///< the node's text is the part [begin, end) of the formula's
  std::uint32_t end = 0;
  std::uint64_t seed = 0;  ///< of kRandom
  Rational number;         ///< of kNumber
};

/// A formula. Its value is a real number, or it has none: formula_evaluator.h says where.
class RealFormula {
 public:
  static constexpr std::size_t kMostCharacters = 4096;
  /// The number of parentheses, functions, signs and exponents around the innermost number or variable.
  static constexpr int kMostDepth = 64;
  /// Numbers in the text, and values of all parts of the formula, are at most 2^kMostExponent in absolute value.
  static constexpr int kMostExponent = 40;
  /// The decimal exponent of a number in the text, in absolute value.
  static constexpr int kMostDecimalExponent = 1000;

  const std::string& text() const { return text_; }
  const std::vector<std::string>& variables() const { return variables_; }
  /// Operands come before the nodes that use them; the last node is the formula.
  std::span<const FormulaNode> nodes() const { return nodes_; }
  bool depends_on(std::size_t variable) const;
  /// Whether rand occurs.
  bool is_random() const;

 private:
  friend class FormulaParser;

  std::string text_;
  std::vector<std::string> variables_;
  std::vector<FormulaNode> nodes_;
};

/// Reads a formula. Grammar, with spaces, tabs and ends of lines wherever two symbols meet:
///   sum      = product { ("+" | "-") product }
///   product  = factor { ("*" | "/") factor }
///   factor   = "-" factor | power
///   power    = atom [ "^" factor ]
///   atom     = number | variable | "pi" | "(" sum ")" | "rand" "(" seed ")" | function "(" sum { "," sum } ")"
///   function = "sqrt" | "sin" | "cos" | "exp" | "abs", with one argument | "min" | "max", with two or more
///   number   = digits with at most one point, then perhaps an exponent: 12, .5, 1.5e-3
///   seed     = an integer from 0 to 2^64 - 1
/// So -x^2 is -(x^2), 2^3^2 is 2^(3^2), and 2^-1 is 1/2. Numbers are exact: 0.1 is one tenth, and p/q is a quotient of
/// exact numbers.
/// @param variables  their names, [A-Za-z_][A-Za-z0-9_]*. REQUIRES that no two are equal, and that none is a name of
///                   the grammar
/// @error  kSyntax, or kOverLimit for the limits of RealFormula; the message has the column, counted in bytes from 1,
///         and the text there
/// @cost   near-linear; recursion to kMostDepth
Result<RealFormula> parse_formula(std::string_view text, std::span<const std::string> variables);

/// The value of rand(seed) where the caller's index (of a cell, of a wall) is `index`: k 2^-20 with
///   k = mix(mix(seed) xor index) / 2^44, rounded down, and for z of 64 bits, modulo 2^64,
///   mix(z): z += 0x9e3779b97f4a7c15, z = (z xor z / 2^30) 0xbf58476d1ce4e5b9, z = (z xor z / 2^27) 0x94d049bb133111eb,
///   and the result is z xor z / 2^31, quotients rounded down.
/// @return  k, in [0, 2^20)
/// @source  splitmix64, as in [BV21]
constexpr std::uint32_t formula_random(std::uint64_t seed, std::uint64_t index) {
  const auto mix = [](std::uint64_t z) {
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  };
  return static_cast<std::uint32_t>(mix(mix(seed) ^ index) >> 44);
}

/// The text between double quotes, with bytes other than printable ASCII as \xNN, cut to 60 characters and "..." if
/// it is longer.
std::string quoted_formula(std::string_view text);

}  // namespace veritope
