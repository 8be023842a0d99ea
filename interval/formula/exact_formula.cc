// SPDX-License-Identifier: LGPL-3.0-or-later
// The second tier: rational numbers.
#include <algorithm>
#include <utility>

#include "interval/formula/formula_tiers_internal.h"

namespace veritope::internal {
namespace {

std::uint64_t bits_in(const Rational& x) {
  return std::max(x.numerator().bit_length(), x.denominator().bit_length());
}
bool is_integer(const Rational& x) { return x.denominator() == Integer(1); }

// The square root of a / b in lowest terms is rational iff a and b are squares.
std::optional<Integer> exact_square_root(const Integer& a) {
  Integer root = floor_sqrt(a);
  if (root * root != a) return std::nullopt;
  return root;
}
std::optional<Rational> exact_square_root(const Rational& x) {
  const auto n = exact_square_root(x.numerator());
  const auto d = n ? exact_square_root(x.denominator()) : std::nullopt;
  if (!d) return std::nullopt;
  return Rational(*n, *d);
}

// The n-th root, if it is an integer. REQUIRES a > 0, n > 0. Only one integer is near the root; its power is compared.
std::optional<Integer> exact_root(const Integer& a, std::uint64_t n) {
  if (a == Integer(1)) return a;
  if (n >= a.bit_length()) return std::nullopt;  // 1 < root < 2
  const int precision = static_cast<int>(a.bit_length() / n) + 64;
  const MpInterval root = pow(MpInterval(Rational(a), precision),
                              MpInterval(Rational(Integer(1), Integer(n)), precision));
  const Rational above = root.hi();
  const Integer candidate = floor_divide(above.numerator(), above.denominator());
  if (power(candidate, n) != a) return std::nullopt;
  return candidate;
}

// x^n for an integer n.
std::optional<Rational> integer_power(const Rational& x, const Integer& n) {
  if (x.sign() == 0) {
    if (n.sign() < 0) return std::nullopt;
    return Rational(n.is_zero() ? 1 : 0);
  }
  const std::uint64_t times = abs(n).low_bits();
  if (bits_in(x) > 1 && (!n.fits_int64() || times > kMostExactBits / bits_in(x)))
    return std::nullopt;
  Rational out(power(x.numerator(), times), power(x.denominator(), times));
  return n.sign() < 0 ? Rational(1) / out : out;
}

std::optional<Rational> exact_power(const Rational& x, const Rational& y) {
  if (is_integer(y)) return integer_power(x, y.numerator());
  if (x.sign() < 0 || (x.sign() == 0 && y.sign() < 0)) return std::nullopt;
  if (x.sign() == 0 || x == Rational(1)) return x;
  if (y.denominator().bit_length() > 32 || bits_in(x) > kMostExactBits) return std::nullopt;
  const auto n = exact_root(x.numerator(), y.denominator().low_bits());
  const auto d = n ? exact_root(x.denominator(), y.denominator().low_bits()) : std::nullopt;
  return d ? integer_power(Rational(*n, *d), y.numerator()) : std::nullopt;
}

std::optional<Rational> exact_of_one(FormulaOp op, const Rational& a) {
  switch (op) {
    case FormulaOp::kNegate: return -a;
    case FormulaOp::kAbs: return abs(a);
    case FormulaOp::kSqrt: return a.sign() < 0 ? std::nullopt : exact_square_root(a);
    // The values at all other rational numbers are irrational (Lindemann).
    case FormulaOp::kSin: return a.sign() == 0 ? std::optional(Rational(0)) : std::nullopt;
    case FormulaOp::kCos:
    case FormulaOp::kExp: return a.sign() == 0 ? std::optional(Rational(1)) : std::nullopt;
    default: return std::nullopt;
  }
}

std::optional<Rational> exact_of_two(FormulaOp op, const Rational& a, const Rational& b) {
  switch (op) {
    case FormulaOp::kAdd: return a + b;
    case FormulaOp::kSubtract: return a - b;
    case FormulaOp::kMultiply: return a * b;
    case FormulaOp::kDivide: return b.sign() == 0 ? std::nullopt : std::optional(a / b);
    case FormulaOp::kPower: return exact_power(a, b);
    case FormulaOp::kMin: return std::min(a, b);
    case FormulaOp::kMax: return std::max(a, b);
    default: return std::nullopt;
  }
}

std::optional<Rational> exact_value(const FormulaNode& node, const std::vector<ExactNode>& before,
                                    const FormulaPoint& at) {
  switch (node.op) {
    case FormulaOp::kNumber: return node.number;
    case FormulaOp::kVariable: return at.values[node.a];
    case FormulaOp::kRandom:
      return Rational(formula_random(node.seed, at.index)) * Rational::power_of_two(-20);
    case FormulaOp::kPi: return std::nullopt;
    default: break;
  }
  const std::optional<Rational>& a = before[node.a].value;
  if (!a) return std::nullopt;
  std::optional<Rational> out;
  if (node.op < FormulaOp::kAdd) {
    out = exact_of_one(node.op, *a);
  } else if (const std::optional<Rational>& b = before[node.b].value) {
    out = exact_of_two(node.op, *a, *b);
  }
  if (out && bits_in(*out) > kMostExactBits) return std::nullopt;
  return out;
}

}  // namespace

std::vector<ExactNode> exact_nodes(const RealFormula& formula, const FormulaPoint& at) {
  const Rational most = Rational::power_of_two(RealFormula::kMostExponent);
  std::vector<ExactNode> out;
  out.reserve(formula.nodes().size());
  for (const FormulaNode& node : formula.nodes()) {
    ExactNode exact{exact_value(node, out, at)};
    if (exact.value && most < abs(*exact.value)) exact = {std::nullopt, true};
    out.push_back(std::move(exact));
  }
  return out;
}

std::int64_t nearest_multiple(const Rational& x) {
  const Integer numerator = x.numerator() << 20;
  const Integer& denominator = x.denominator();
  Integer nearest = floor_divide(numerator, denominator);
  const Integer twice_rest = (numerator - nearest * denominator) << 1;
  if (denominator < twice_rest || (denominator == twice_rest && nearest.test_bit(0)))
    nearest += Integer(1);
  return nearest.to_int64();
}

}  // namespace veritope::internal
