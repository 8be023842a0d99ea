// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/formula/formula_evaluator.h"

#include <gtest/gtest.h>

#include "interval/formula/formula_tiers_internal.h"
#include "interval/upward.h"
#include "robust/base/check.h"

namespace veritope {
namespace {

using Tier = FormulaEvaluator::Tier;
constexpr Tier kTiers[] = {Tier::kBinary64, Tier::kExact, Tier::kWide};
constexpr std::uint64_t kIndex = 42;

Rational ratio(std::int64_t n, std::int64_t d) { return Rational(Integer(n), Integer(d)); }

const std::vector<std::string> kNames = {"x", "y", "z", "n"};
const std::vector<Rational> kValues = {ratio(1, 3), ratio(-2, 7), ratio(5, 4), Rational(3)};

// "143652", "error: ..." or "open: ...".
std::string answer(const std::string& text, Tier first,
                   const std::vector<Rational>& values = kValues) {
  const Result<RealFormula> formula = parse_formula(text, kNames);
  if (!formula) return "unread: " + formula.error().message;
  const Result<RoundedValue> value =
      FormulaEvaluator(*formula, first).round_to_multiple(values, kIndex);
  if (!value) {
    EXPECT_EQ(value.error().code, Code::kBadArgument);
    return "error: " + value.error().message;
  }
  return value->open ? "open: " + value->open->message : std::to_string(value->multiple);
}
void expect_answer(const std::string& text, const std::string& expected,
                   const std::vector<Rational>& values = kValues) {
  for (const Tier first : kTiers)
    EXPECT_EQ(answer(text, first, values), expected)
        << text << ", tier " << static_cast<int>(first);
}

// Computed with 300 bits by mpmath at x = 1/3, y = -2/7, z = 5/4 and the index 42.
TEST(FormulaEvaluator, ValuesAreTheGoldenOnesInEveryTier) {
  const std::pair<const char*, std::int64_t> golden[] = {
      {"0.15 + 0.1*sin(6*x)*cos(6*y)", 143652},
      {"sqrt(2)", 1482910},
      {"pi", 3294199},
      {"-pi", -3294199},
      {"exp(1)", 2850325},
      {"exp(-20)", 0},
      {"exp(27.7)", 1123458571322550365},
      {"sin(1000000)", -366995},
      {"cos(1e12)", 829892},
      {"sin(x)^2 + cos(y)^3", 1038407},
      {"x^0.5", 605396},
      {"z^-7", 219902},
      {"z^y", 983810},
      {"abs(y)*100", 29959314},
      {"min(x, y, z)", -299593},
      {"max(sin(x), cos(x), x)", 990859},
      {"rand(0)", 317875},
      {"rand(1)", 518971},
      {"rand(7) - rand(18446744073709551615)", 208660},
      {"sqrt(x*x + y*y + z*z) - 1", 340636},
      {"2^x^y", 2707891},
      {"-2^2 + 10 - 3 - 4/2/2", 2097152},
      {"exp(-(x^2 + y^2)/(2*0.1^2))", 68},
      {"sin(2*pi*x)", 908093},
      {"cos(pi*y)^2 - 1e-7", 407623},
      {"sqrt(exp(y))", 908987},
      {"(x + y)^9*1e6", 1},
      {"1e12/3", 349525333333333333},
      {"(3/7)^(1/5)", 885125},
      {"rand(3)*x", 92387},
      {"10^(1/3)", 2259089},
      // pi between two binary64 numbers
      {"(pi - 3.141592653589793115997963468544185161590576171875)*1e12", 128},
      {"(pi - 3.141592653589793560087173318606801331043243408203125)*1e12", -337},
      {"2^40", std::int64_t{1} << 60},
      {"-2^40", -(std::int64_t{1} << 60)},
      {"n", 3 << 20},
  };
  for (const auto& [text, multiple] : golden) expect_answer(text, std::to_string(multiple));
}

TEST(FormulaEvaluator, BoundsThatRoundAlikeHaveTheAnswerOfTheirValues) {
  const RealFormula formula =
      parse_formula("0.15 + 0.1*sin(6*x)*cos(6*y) + rand(3)", kNames).value();
  FormulaEvaluator evaluator(formula);
  const std::int64_t expected = evaluator.round_to_multiple(kValues, kIndex).value().multiple;
  for (const double width : {0.0, 0x1p-40, 0x1p-10}) {
    std::vector<Interval> bounds;
    for (const Rational& x : kValues)
      bounds.push_back(Interval::from_bounds(nearest_double(x) - width - 0x1p-50,
                                             nearest_double(x) + width + 0x1p-50));
    const auto found = evaluator.round_within(bounds, kIndex);
    ASSERT_EQ(found.has_value(), width < 0x1p-20) << width;
    if (found) {
      EXPECT_EQ(*found, expected);
    }
  }
  EXPECT_FALSE(FormulaEvaluator(formula, Tier::kExact)
                   .round_within(std::vector<Interval>(4, Interval(0.5)), kIndex)
                   .has_value());
}

TEST(FormulaEvaluator, TiesGoToTheEvenMultipleInEveryTier) {
  const std::pair<const char*, std::int64_t> ties[] = {
      {"1/2^21", 0},
      {"3/2^21", 2},
      {"5/2^21", 2},
      {"-1/2^21", 0},
      {"-3/2^21", -2},
      {"x*9/2^21", 2},           // thirds: no binary64 number
      {"(x + 4*x)*3/2^21", 2},   // 5 / 2^21
      {"1/(7*2^21)*7*3", 2},     //
      {"sqrt(9/49)*7/2^21", 2},  // roots of squares
      {"sqrt(2)*sqrt(2)*0 + 3/2^21", 2},
      {"(27/64)^(1/3)*4/2^21", 2},    // a cube root
      {"(16/81)^0.75*27*5/2^24", 2},  // 40 / 2^24
      {"abs(-5/2^21)", 2},
      {"max(-1, min(7/2^21, 1))", 4},
      {"exp(x - 1/3)*3/2^21", 2},  // exp(0)
      {"(sin(x*3 - 1) + cos(3*x - 1))/2^21*5", 2},
      {"max(3/2^21, sin(x) - 2)", 2},
      {"(sin(x*3 - 1) + x)*9/2^21", 2},
      {"cos(x*3 - 1)*x*9/2^21", 2},
      {"exp(x*3 - 1)*x*9/2^21", 2},
      {"((x*3 - 1)^0.5 + x)*9/2^21", 2},
      {"rand(0) + 1/2^21", 317876},  // 317875.5
      {"rand(2)*0 + 2^-21", 0},
  };
  for (const auto& [text, multiple] : ties) expect_answer(text, std::to_string(multiple));
}

TEST(FormulaEvaluator, NamesThePartTheColumnAndTheVariablesWhereThereIsNoValue) {
  expect_answer("1 + 1/(x - 1/3)",
                "error: the divisor of \"1/(x - 1/3)\" (column 5) is 0 at x = 1/3");
  expect_answer("x + sqrt(y)*y",
                "error: the argument of \"sqrt(y)\" (column 5) is negative at y = -2/7");
  expect_answer("sqrt(sin(y))",
                "error: the argument of \"sqrt(sin(y))\" (column 1) is negative at y = -2/7");
  expect_answer(
      "2*(n - 3)^(y)",
      "error: 0 is raised to a negative power in \"(n - 3)^(y)\" (column 3) at y = -2/7, n = 3");
  expect_answer("0^-2", "error: 0 is raised to a negative power in \"0^-2\" (column 1)");
  expect_answer("0^-sqrt(2)",
                "error: 0 is raised to a negative power in \"0^-sqrt(2)\" (column 1)");
  expect_answer("y^x",
                "error: a negative number is raised to a power that is not an integer in \"y^x\" "
                "(column 1) at x = 1/3, y = -2/7");
  expect_answer("(-2)^pi",
                "error: a negative number is raised to a power that is not an integer in "
                "\"(-2)^pi\" (column 1)");
  expect_answer("1 + exp(28)",
                "error: the value of \"exp(28)\" (column 5) exceeds 2^40 in absolute value");
  expect_answer(
      "-exp(28*z)/exp(27*z)",
      "error: the value of \"exp(28*z)\" (column 2) exceeds 2^40 in absolute value at z = 5/4");
  expect_answer("2^40 + 1e-1000",
                "error: the value of \"2^40 + 1e-1000\" (column 1) exceeds 2^40 in absolute value");
  expect_answer("-2^40 - 1",
                "error: the value of \"-2^40 - 1\" (column 1) exceeds 2^40 in absolute value");
  expect_answer("10^1e12",
                "error: the value of \"10^1e12\" (column 1) exceeds 2^40 in absolute value");
  expect_answer("1/(rand(1)*0)",
                "error: the divisor of \"1/(rand(1)*0)\" (column 1) is 0 at index = 42");
  expect_answer("1/max(0, sin(x) - 2)",
                "error: the divisor of \"1/max(0, sin(x) - 2)\" (column 1) is 0 at x = 1/3");
  const std::vector<Rational> large = {Rational::power_of_two(41), Rational(0), Rational(0),
                                       Rational(0)};
  expect_answer(
      "x/x",
      "error: the value of \"x\" (column 1) exceeds 2^40 in absolute value at x = 2199023255552",
      large);
  const std::vector<Rational> fine = {ratio(-1, 3) * Rational::power_of_two(-300), Rational(0),
                                      Rational(0), Rational(0)};
  expect_answer("sqrt(x)",
                "error: the argument of \"sqrt(x)\" (column 1) is negative at x = approximately "
                "-1.6363644884325754e-91",
                fine);
  // The part that comes first is named.
  expect_answer("1/0 + sqrt(-1)", "error: the divisor of \"1/0\" (column 1) is 0");
}

TEST(FormulaEvaluator, PowersHaveTheValuesOfTheContract) {
  const std::string one = "1048576";
  for (const char* text :
       {"0^0", "1^0.5", "(-1)^2", "(-1)^(2*n)", "1^(-pi)", "(-2)^max(0, sin(x) - 3)", "0^0.5 + 1",
        "0^pi + 1", "(sin(x) - sin(x))^2 + 1", "sqrt(abs(sin(x) - sin(x))) + 1", "4^-0.5*2"})
    expect_answer(text, one);
  expect_answer("(-2)^(-3)", "-131072");
  expect_answer("(-8)^n", std::to_string(-512 * (std::int64_t{1} << 20)));
}

TEST(FormulaEvaluator, SaysUndecidedWhereNoNumberOfBitsDecides) {
  const auto formula = parse_formula("sin(x)^2 + cos(x)^2 - 1/2^21", kNames).value();
  FormulaEvaluator evaluator(formula);
  const RoundedValue value = evaluator.round_to_multiple(kValues).value();
  ASSERT_TRUE(value.open.has_value());
  EXPECT_EQ(value.open->precision, FormulaEvaluator::kMostPrecision);
  EXPECT_EQ(value.open->column, 1u);
  const Rational tie = Rational(1) - Rational::power_of_two(-21);
  EXPECT_TRUE(value.open->bounds.lo <= tie && tie <= value.open->bounds.hi);
  EXPECT_LT(value.open->bounds.hi - value.open->bounds.lo, Rational::power_of_two(-4000));
  EXPECT_EQ(value.open->message,
            "it is undecided, with 4096 bits, whether the value of \"sin(x)^2 + cos(x)^2 - "
            "1/2^21\" (column 1) lies in the "
            "middle between two multiples of 2^-20 at x = 1/3; the number in question lies in "
            "[0.99999952316284169, "
            "0.99999952316284191]");
  EXPECT_EQ(evaluator.counts().open, 1u);
  // Its bounds are known all the same.
  const EnclosedValue enclosed = evaluator.enclose(kValues, 0, 100).value();
  EXPECT_FALSE(enclosed.open.has_value());
  EXPECT_TRUE(enclosed.bounds.lo <= tie && tie <= enclosed.bounds.hi);

  const std::pair<const char*, const char*> open[] = {
      {"2/(sin(x)^2 + cos(x)^2 - 1)",
       "the divisor of \"2/(sin(x)^2 + cos(x)^2 - 1)\" (column 1) is 0 at x = 1/3;"},
      {"1 + sqrt(sin(x) - sin(x))",
       "the argument of \"sqrt(sin(x) - sin(x))\" (column 5) is negative at x = 1/3;"},
      {"(-2)^(sin(x)^2 + cos(x)^2)",
       "a negative number is raised to a power that is not an integer in"},
      {"(sin(x) - sin(x))^-1", "0 is raised to a negative power in"},
      {"(sin(x) - sin(x))^0.5", "a negative number is raised to a power that is not an integer in"},
      {"0^(sin(x) - sin(x))", "0 is raised to a negative power in"},
      {"2^40*(sin(x)^2 + cos(x)^2)", "exceeds 2^40 in absolute value at x = 1/3;"},
  };
  for (const auto& [text, part] : open)
    for (const Tier first : kTiers) {
      const std::string said = answer(text, first);
      EXPECT_TRUE(said.starts_with("open: it is undecided, with 4096 bits, whether ")) << said;
      EXPECT_NE(said.find(part), std::string::npos) << said;
    }
  const auto divisor = parse_formula("2/(sin(x)^2 + cos(x)^2 - 1)", kNames).value();
  const EnclosedValue none = FormulaEvaluator(divisor).enclose(kValues, 0, 60).value();
  ASSERT_TRUE(none.open.has_value());
  EXPECT_TRUE(none.open->bounds.lo <= Rational(0) && Rational(0) <= none.open->bounds.hi);
}

TEST(FormulaEvaluator, EachTierAnswersWhatTheOneBeforeDoesNot) {
  const struct {
    const char* text;
    std::uint64_t binary64, exact, wide;
  } cases[] = {
      {"0.15 + 0.1*sin(6*x)*cos(6*y)", 1, 0, 0},
      {"3/2^21", 1, 0, 0},
      {"x*9/2^21", 0, 1, 0},
      {"sqrt(2)^2 - 1 - 2^-21 - 2^-80", 0, 0, 1},
      {"1 - 2^-21 - exp(-60)", 0, 0, 1},
      {"1 + (2^-21 - 2^-21*cos(1e-20))/(1 - cos(1e-20))*exp(-1e-30)", 0, 0, 1},
  };
  for (const auto& c : cases) {
    const auto formula = parse_formula(c.text, kNames).value();
    FormulaEvaluator evaluator(formula);
    EXPECT_FALSE(evaluator.round_to_multiple(kValues)->open.has_value()) << c.text;
    EXPECT_EQ(evaluator.counts().binary64, c.binary64) << c.text;
    EXPECT_EQ(evaluator.counts().exact, c.exact) << c.text;
    EXPECT_EQ(evaluator.counts().wide, c.wide) << c.text;
    EXPECT_EQ(answer(c.text, Tier::kBinary64), answer(c.text, Tier::kWide));
  }
}

TEST(FormulaEvaluator, EnclosesWithThePrecisionThatIsAskedFor) {
  const auto formula = parse_formula("exp(x)*pi + 1/n", kNames).value();
  FormulaEvaluator evaluator(formula);
  FormulaBounds before;
  for (const int precision : {2, 10, 53, 200, 1000, 4096}) {
    const FormulaBounds bounds = evaluator.enclose(kValues, 0, precision)->bounds;
    EXPECT_LT(bounds.lo, bounds.hi);
    EXPECT_LE(bounds.hi - bounds.lo, Rational::power_of_two(6 - precision));
    if (precision > 2) {
      EXPECT_TRUE(before.lo <= bounds.lo && bounds.hi <= before.hi);
    }
    before = bounds;
  }
  const auto exact = parse_formula("x + 1/n", kNames).value();
  const FormulaBounds point = FormulaEvaluator(exact).enclose(kValues, 0, 2)->bounds;
  EXPECT_TRUE(point.lo == ratio(2, 3) && point.hi == ratio(2, 3));
  // More bits than asked for, where fewer leave the sign of the divisor open.
  const auto near = parse_formula("1/(sqrt(2) - 1.4142135)", kNames).value();
  EXPECT_LT(Rational(0), FormulaEvaluator(near).enclose(kValues, 0, 20)->bounds.lo);
  // Tiny bounds are those of binary64.
  const auto tiny = parse_formula("exp(-1e8)", kNames).value();
  const FormulaBounds bounds = FormulaEvaluator(tiny).enclose(kValues, 0, 100)->bounds;
  EXPECT_TRUE(bounds.lo == Rational(0) && bounds.hi == Rational::power_of_two(-1074));
  const auto bad = parse_formula("1/(x - x)", kNames).value();
  EXPECT_EQ(FormulaEvaluator(bad).enclose(kValues, 0, 100).error().message,
            "the divisor of \"1/(x - x)\" (column 1) is 0 at x = 1/3");
}

TEST(FormulaEvaluator, LongFractionsAreLeftToIntervals) {
  // More than kMostExactBits bits, and 3 / 2^21 up to 2^-10000 or less.
  expect_answer("3/2^21 + 2^-1000*(1/3)^20000", "2");
  expect_answer(
      "3/2^21 - (1/3)^20000",
      "open: it is undecided, with 4096 bits, whether the value of \"3/2^21 - (1/3)^20000\" "
      "(column 1) lies in the middle between two multiples of 2^-20; the number in question lies "
      "in "
      "[1.4305114746093748e-06, 1.430511474609375e-06]");
  // Products of numbers of 12,680 bits.
  EXPECT_TRUE(answer("3/2^21 - (1/3)^8000*(1/3)^8000", Tier::kBinary64).starts_with("open: "));
  EXPECT_EQ(answer("3/2^21 - (1/3)^8000", Tier::kBinary64), "1");
  const std::vector<Rational> fine = {Rational(1) / Rational(power(Integer(3), 20000)), Rational(0),
                                      Rational(0), Rational(0)};
  expect_answer("x", "0", fine);
}

TEST(FormulaEvaluator, ChecksItsArguments) {
  const auto formula = parse_formula("x", kNames).value();
  FormulaEvaluator evaluator(formula);
  const std::vector<Rational> few(2);
  EXPECT_THROW(evaluator.round_to_multiple(few).has_value(), InternalError);
  EXPECT_THROW(evaluator.enclose(few, 0, 60).has_value(), InternalError);
  EXPECT_THROW(evaluator.enclose(kValues, 0, 1).has_value(), InternalError);
  EXPECT_THROW(evaluator.enclose(kValues, 0, 4097).has_value(), InternalError);
}

TEST(FormulaEvaluator, RoundsTheSameInEveryRoundingMode) {
  const auto formula = parse_formula("0.15 + 0.1*sin(6*x)*cos(6*y)", kNames).value();
  const ScopedUpward upward;
  FormulaEvaluator evaluator(formula);
  EXPECT_EQ(evaluator.round_to_multiple(kValues)->multiple, 143652);
}

// REQUIRES of nearest_multiple: |x| <= 2^40.
TEST(FormulaTiers, BothRoundingsAgreeOnTiesAndBesideThem) {
  for (int quarters = -40; quarters <= 40; ++quarters)
    for (const double offset : {-0x1p-60, 0.0, 0x1p-60}) {
      const double v = quarters * 0x1p-22 + offset;
      EXPECT_EQ(internal::nearest_multiple(Interval(v)),
                internal::nearest_multiple(Rational::from_double(v)))
          << v;
      EXPECT_EQ(internal::nearest_multiple(Interval(v)),
                nearest_multiple(MpInterval(Interval(v), 90), -20))
          << v;
    }
  EXPECT_EQ(internal::nearest_multiple(Interval(0x1p40)), std::int64_t{1} << 60);
  EXPECT_EQ(internal::nearest_multiple(Rational::power_of_two(40)), std::int64_t{1} << 60);
  EXPECT_EQ(internal::nearest_multiple(Interval::from_bounds(0, 0x1p-20)), std::nullopt);
}

}  // namespace
}  // namespace veritope
