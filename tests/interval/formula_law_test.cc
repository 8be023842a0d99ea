// SPDX-License-Identifier: LGPL-3.0-or-later
// Random formulas against two evaluators that share no code with the subject: exact fractions by recursion, and MPFR
// with 400 bits to nearest.
#include <gtest/gtest.h>
#include <mpfr.h>

#include <memory>
#include <optional>

#include "interval/formula/formula_evaluator.h"
#include "robust/base/random.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

// A formula as a tree. `op` is the character of an operator, 'm' for unary minus, or the first of a function's name.
struct Tree {
  char op = '#';
  std::string word;  // of a leaf: its text; of a function: its name
  Rational number;   // of a leaf
  std::vector<Tree> parts;
};

struct Drawn {
  Random random;
  std::vector<std::string> names = {"x", "y", "z"};
  std::vector<Rational> values;

  explicit Drawn(std::uint64_t seed) : random(seed) {
    for (int i = 0; i < 3; ++i)
      values.push_back(Rational(Integer(random.between(-40, 40)), Integer(random.between(1, 12))));
  }
  Tree leaf() {
    Tree out;
    switch (random.below(5)) {
      case 0:
      case 1: {
        const std::size_t i = random.below(3);
        out.word = names[i], out.number = values[i];
        break;
      }
      case 2: {
        const std::int64_t n = random.between(0, 9);
        out.word = std::to_string(n), out.number = Rational(n);
        break;
      }
      case 3: {
        const std::int64_t n = random.between(0, 999);
        out.word = std::to_string(n) + "e-2";
        out.number = Rational(Integer(n), Integer(100));
        break;
      }
      default: {
        const std::int64_t n = random.between(1, 9);  // halves of multiples of 2^-20
        Tree top, bottom, two, exponent;
        top.word = std::to_string(n), top.number = Rational(n);
        two.word = "2", two.number = Rational(2);
        exponent.word = "21", exponent.number = Rational(21);
        bottom.op = '^', bottom.parts = {two, exponent};
        out.op = '/', out.parts = {top, bottom};
      }
    }
    return out;
  }
  Tree draw(int depth, bool exact_only) {
    if (depth == 0 || random.below(8) == 0) return leaf();
    Tree out;
    const auto part = [&] { return draw(depth - 1, exact_only); };
    switch (random.below(exact_only ? 9 : 13)) {
      case 0: out.op = '+', out.parts = {part(), part()}; break;
      case 1: out.op = '-', out.parts = {part(), part()}; break;
      case 2: out.op = '*', out.parts = {part(), part()}; break;
      case 3: out.op = '/', out.parts = {part(), part()}; break;
      case 4: {
        Tree exponent;
        const std::int64_t n = random.between(0, 5);
        exponent.word = std::to_string(n), exponent.number = Rational(n);
        out.op = '^', out.parts = {part(), exponent};
        break;
      }
      case 5: out.op = 'm', out.parts = {part()}; break;
      case 6: out.op = 'f', out.word = "abs", out.parts = {part()}; break;
      case 7:
      case 8: {
        out.op = 'f', out.word = random.below(2) != 0 ? "min" : "max";
        const std::uint64_t count = 2 + random.below(2);
        for (std::uint64_t i = 0; i < count; ++i) out.parts.push_back(part());
        break;
      }
      case 9: out.op = 'f', out.word = "sqrt", out.parts = {part()}; break;
      case 10: out.op = 'f', out.word = "sin", out.parts = {part()}; break;
      case 11: out.op = 'f', out.word = "cos", out.parts = {part()}; break;
      default: out.op = 'f', out.word = "exp", out.parts = {part()};
    }
    return out;
  }
  std::string blank() { return random.below(6) == 0 ? " " : ""; }
  // The weakest part may be: 0 a sum, 1 a product, 2 a sign, 3 a power, 4 an atom.
  std::string text(const Tree& tree, int strength) {
    const auto part = [&](std::size_t i, int least) {
      return blank() + text(tree.parts[i], least) + blank();
    };
    std::string out;
    int own = 4;
    switch (tree.op) {
      case '#': out = tree.word; break;
      case '+':
      case '-': own = 0, out = part(0, 0) + tree.op + part(1, 1); break;
      case '*':
      case '/': own = 1, out = part(0, 1) + tree.op + part(1, 2); break;
      case 'm': own = 2, out = "-" + part(0, 2); break;
      case '^': own = 3, out = part(0, 4) + "^" + part(1, 2); break;
      default:
        out = tree.word + "(";
        for (std::size_t i = 0; i < tree.parts.size(); ++i) out += (i > 0 ? "," : "") + part(i, 0);
        out += ")";
    }
    return own < strength || random.below(10) == 0 ? "(" + blank() + out + blank() + ")" : out;
  }
};

// The exact value; none where a part has none, or is beyond 2^40.
std::optional<Rational> exact_value(const Tree& tree) {
  if (tree.op == '#') return tree.number;
  std::vector<Rational> v;
  for (const Tree& part : tree.parts) {
    const std::optional<Rational> value = exact_value(part);
    if (!value) return std::nullopt;
    v.push_back(*value);
  }
  Rational out = v[0];
  switch (tree.op) {
    case '+': out += v[1]; break;
    case '-': out -= v[1]; break;
    case '*': out *= v[1]; break;
    case '/':
      if (v[1] == Rational(0)) return std::nullopt;
      out /= v[1];
      break;
    case 'm': out = Rational(0) - out; break;
    case '^': {
      Rational power(1);
      for (Rational i; i < v[1]; i += Rational(1)) power *= v[0];
      out = power;
      break;
    }
    default:
      if (tree.word == "abs" && out < Rational(0)) out = Rational(0) - out;
      for (const Rational& x : v)
        if ((tree.word == "min" && x < out) || (tree.word == "max" && out < x)) out = x;
  }
  const Rational most(std::int64_t{1} << 40);
  if (most < out || out < Rational(0) - most) return std::nullopt;
  return out;
}

// A number with 400 bits.
class Real400 {
 public:
  Real400() { mpfr_init2(v_, 400); }
  explicit Real400(const Rational& x) : Real400() {
    mpfr_set_str(v_, x.numerator().to_string().c_str(), 10, MPFR_RNDN);
    Real400 d;
    mpfr_set_str(d.v_, x.denominator().to_string().c_str(), 10, MPFR_RNDN);
    mpfr_div(v_, v_, d.v_, MPFR_RNDN);
  }
  Real400(const Real400& other) : Real400() { mpfr_set(v_, other.v_, MPFR_RNDN); }
  Real400& operator=(const Real400& other) { return mpfr_set(v_, other.v_, MPFR_RNDN), *this; }
  ~Real400() { mpfr_clear(v_); }
  mpfr_ptr get() { return v_; }

 private:
  mpfr_t v_;
};

// No value where a part has no value, is close to having none, or is close to 2^40 or beyond.
std::optional<Real400> value_with_400_bits(const Tree& tree) {
  if (tree.op == '#') return Real400(tree.number);
  std::vector<Real400> v;
  for (const Tree& part : tree.parts) {
    std::optional<Real400> value = value_with_400_bits(part);
    if (!value) return std::nullopt;
    v.push_back(*value);
  }
  Real400 out = v[0];
  const auto is_near_zero = [](Real400& x) {
    return mpfr_cmp_d(x.get(), 0x1p-50) < 0 && mpfr_cmp_d(x.get(), -0x1p-50) > 0;
  };
  switch (tree.op) {
    case '+': mpfr_add(out.get(), v[0].get(), v[1].get(), MPFR_RNDN); break;
    case '-': mpfr_sub(out.get(), v[0].get(), v[1].get(), MPFR_RNDN); break;
    case '*': mpfr_mul(out.get(), v[0].get(), v[1].get(), MPFR_RNDN); break;
    case '/':
      if (is_near_zero(v[1])) return std::nullopt;
      mpfr_div(out.get(), v[0].get(), v[1].get(), MPFR_RNDN);
      break;
    case 'm': mpfr_neg(out.get(), v[0].get(), MPFR_RNDN); break;
    case '^':
      mpfr_pow_ui(out.get(), v[0].get(), mpfr_get_ui(v[1].get(), MPFR_RNDN), MPFR_RNDN);
      break;
    default:
      if (tree.word == "abs") mpfr_abs(out.get(), v[0].get(), MPFR_RNDN);
      if (tree.word == "sin") mpfr_sin(out.get(), v[0].get(), MPFR_RNDN);
      if (tree.word == "cos") mpfr_cos(out.get(), v[0].get(), MPFR_RNDN);
      if (tree.word == "exp") mpfr_exp(out.get(), v[0].get(), MPFR_RNDN);
      if (tree.word == "sqrt") {
        if (is_near_zero(v[0]) || mpfr_sgn(v[0].get()) < 0) return std::nullopt;
        mpfr_sqrt(out.get(), v[0].get(), MPFR_RNDN);
      }
      for (Real400& x : v) {
        if (tree.word == "min") mpfr_min(out.get(), out.get(), x.get(), MPFR_RNDN);
        if (tree.word == "max") mpfr_max(out.get(), out.get(), x.get(), MPFR_RNDN);
      }
  }
  if (mpfr_cmp_d(out.get(), 0x1.fffp39) > 0 || mpfr_cmp_d(out.get(), -0x1.fffp39) < 0)
    return std::nullopt;
  return out;
}

std::string described(std::uint64_t seed, const std::string& text, const Drawn& drawn) {
  return std::to_string(seed) + ": " + text + " at " + drawn.values[0].to_string() + ", " +
         drawn.values[1].to_string() + ", " + drawn.values[2].to_string();
}

TEST(FormulaLaw, RationalFormulasAreRoundedAsExactFractionsAre) {
  long ties = 0, refused = 0;
  for (long i = 0; i < scaled(6000); ++i) {
    const auto seed = static_cast<std::uint64_t>(7210000 + i);
    Drawn drawn(seed);
    const Tree tree = drawn.draw(4, true);
    const std::string text = drawn.text(tree, 0);
    const Result<RealFormula> formula = parse_formula(text, drawn.names);
    ASSERT_TRUE(formula.has_value()) << described(seed, text, drawn) << formula.error().message;
    const std::optional<Rational> exact = exact_value(tree);
    for (const auto first : {FormulaEvaluator::Tier::kBinary64, FormulaEvaluator::Tier::kExact}) {
      const Result<RoundedValue> value =
          FormulaEvaluator(*formula, first).round_to_multiple(drawn.values);
      ASSERT_EQ(value.has_value(), exact.has_value()) << described(seed, text, drawn);
      if (!exact) continue;
      ASSERT_FALSE(value->open.has_value()) << described(seed, text, drawn) << value->open->message;
      // |2 (v 2^20 - multiple)| <= 1, and where it is 1, the multiple is even.
      Rational twice =
          *exact * Rational(1 << 21) - Rational(value->multiple) - Rational(value->multiple);
      if (twice < Rational(0)) twice = Rational(0) - twice;
      ASSERT_LE(twice, Rational(1)) << described(seed, text, drawn);
      if (twice == Rational(1)) {
        ASSERT_EQ(value->multiple % 2, 0) << described(seed, text, drawn);
      }
      ties += twice == Rational(1) ? 1 : 0;
    }
    refused += exact ? 0 : 1;
  }
  EXPECT_GT(ties, scaled(100));
  EXPECT_GT(refused, scaled(100));
}

TEST(FormulaLaw, AllFormulasAreRoundedAndEnclosedAs400BitsSay) {
  long compared = 0;
  for (long i = 0; i < scaled(4000); ++i) {
    const auto seed = static_cast<std::uint64_t>(7220000 + i);
    Drawn drawn(seed);
    const Tree tree = drawn.draw(4, false);
    const std::string text = drawn.text(tree, 0);
    const Result<RealFormula> formula = parse_formula(text, drawn.names);
    ASSERT_TRUE(formula.has_value()) << described(seed, text, drawn) << formula.error().message;
    std::optional<Real400> nearly = value_with_400_bits(tree);
    for (const auto first : {FormulaEvaluator::Tier::kBinary64, FormulaEvaluator::Tier::kWide}) {
      FormulaEvaluator evaluator(*formula, first);
      const Result<RoundedValue> value = evaluator.round_to_multiple(drawn.values);
      if (!nearly) continue;  // whatever it says, it does not fail
      ASSERT_TRUE(value.has_value()) << described(seed, text, drawn) << value.error().message;
      if (value->open) continue;
      ++compared;
      // 2^-150 is far more than the errors of 400 bits, which matter where the value is a tie.
      Real400 off = *nearly, exact(Rational(value->multiple) * Rational::power_of_two(-20));
      mpfr_sub(off.get(), off.get(), exact.get(), MPFR_RNDN);
      mpfr_abs(off.get(), off.get(), MPFR_RNDN);
      mpfr_sub_d(off.get(), off.get(), 0x1p-150, MPFR_RNDN);
      ASSERT_LE(mpfr_cmp_d(off.get(), 0x1p-21), 0) << described(seed, text, drawn);
      const FormulaBounds bounds = evaluator.enclose(drawn.values, 0, 120)->bounds;
      Real400 lo(bounds.lo - Rational::power_of_two(-150)),
          hi(bounds.hi + Rational::power_of_two(-150));
      ASSERT_TRUE(mpfr_lessequal_p(lo.get(), nearly->get()) &&
                  mpfr_lessequal_p(nearly->get(), hi.get()))
          << described(seed, text, drawn);
    }
  }
  EXPECT_GT(compared, scaled(3000));
}

TEST(FormulaLaw, AllTiersAgreeOnFormulasWithTiesAndIrrationalNumbers) {
  for (long i = 0; i < scaled(3000); ++i) {
    const auto seed = static_cast<std::uint64_t>(7230000 + i);
    Drawn drawn(seed);
    const std::string text = drawn.text(drawn.draw(3, false), 0);
    const RealFormula formula = parse_formula(text, drawn.names).value();
    const auto said = [&](FormulaEvaluator::Tier first) {
      const auto value = FormulaEvaluator(formula, first).round_to_multiple(drawn.values);
      if (!value) return value.error().message;
      return value->open ? value->open->message : std::to_string(value->multiple);
    };
    const std::string first = said(FormulaEvaluator::Tier::kBinary64);
    ASSERT_EQ(first, said(FormulaEvaluator::Tier::kExact)) << described(seed, text, drawn);
    // Intervals alone cannot decide a tie of a fraction that has no finite binary form.
    const std::string last = said(FormulaEvaluator::Tier::kWide);
    if (!last.starts_with("it is undecided")) {
      ASSERT_EQ(first, last) << described(seed, text, drawn);
    }
  }
}

}  // namespace
}  // namespace veritope
