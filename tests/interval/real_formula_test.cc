// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/formula/real_formula.h"

#include <gtest/gtest.h>

#include "robust/base/check.h"

namespace veritope {
namespace {

const std::vector<std::string> kVariables = {"x", "y", "n_1"};

// The parse tree with a parenthesis around each operation.
std::string tree(const RealFormula& formula, std::size_t node) {
  const FormulaNode& n = formula.nodes()[node];
  const auto a = [&] { return tree(formula, n.a); };
  const auto b = [&] { return tree(formula, n.b); };
  switch (n.op) {
    case FormulaOp::kNumber: return n.number.to_string();
    case FormulaOp::kVariable: return formula.variables()[n.a];
    case FormulaOp::kPi: return "pi";
    case FormulaOp::kRandom: return "rand " + std::to_string(n.seed);
    case FormulaOp::kNegate: return "(-" + a() + ")";
    case FormulaOp::kSqrt: return "(sqrt " + a() + ")";
    case FormulaOp::kSin: return "(sin " + a() + ")";
    case FormulaOp::kCos: return "(cos " + a() + ")";
    case FormulaOp::kExp: return "(exp " + a() + ")";
    case FormulaOp::kAbs: return "(abs " + a() + ")";
    case FormulaOp::kAdd: return "(" + a() + " + " + b() + ")";
    case FormulaOp::kSubtract: return "(" + a() + " - " + b() + ")";
    case FormulaOp::kMultiply: return "(" + a() + " * " + b() + ")";
    case FormulaOp::kDivide: return "(" + a() + " / " + b() + ")";
    case FormulaOp::kPower: return "(" + a() + " ^ " + b() + ")";
    case FormulaOp::kMin: return "(min " + a() + " " + b() + ")";
    case FormulaOp::kMax: return "(max " + a() + " " + b() + ")";
  }
  return "?";
}
std::string tree_of(std::string_view text) {
  const Result<RealFormula> formula = parse_formula(text, kVariables);
  return formula ? tree(*formula, formula->nodes().size() - 1) : formula.error().message;
}

TEST(RealFormula, PowersBindTighterThanSignsAndFromTheRight) {
  EXPECT_EQ(tree_of("-x^2"), "(-(x ^ 2))");
  EXPECT_EQ(tree_of("2^3^x"), "(2 ^ (3 ^ x))");
  EXPECT_EQ(tree_of("2^-x^y"), "(2 ^ (-(x ^ y)))");
  EXPECT_EQ(tree_of("(-x)^2"), "((-x) ^ 2)");
  EXPECT_EQ(tree_of("2*x^2/3"), "((2 * (x ^ 2)) / 3)");
}

TEST(RealFormula, ProductsBindTighterThanSumsAndBothFromTheLeft) {
  EXPECT_EQ(tree_of("1 - 2 - 3 + 4"), "(((1 - 2) - 3) + 4)");
  EXPECT_EQ(tree_of("1/2/3*4"), "(((1 / 2) / 3) * 4)");
  EXPECT_EQ(tree_of("1 + 2*x - y/3"), "((1 + (2 * x)) - (y / 3))");
  EXPECT_EQ(tree_of("-x*-y - -1"), "(((-x) * (-y)) - (-1))");
  EXPECT_EQ(tree_of("(1 + 2)*(x - y)"), "((1 + 2) * (x - y))");
}

TEST(RealFormula, NumbersAreExactAndNamesMayHaveDigits) {
  EXPECT_EQ(tree_of("0.15"), "3/20");
  EXPECT_EQ(tree_of(".5e1 + 5."), "(5 + 5)");
  EXPECT_EQ(tree_of("125E-3"), "1/8");
  EXPECT_EQ(tree_of("1e+3"), "1000");
  EXPECT_EQ(tree_of("007"), "7");
  EXPECT_EQ(tree_of("n_1"), "n_1");
  EXPECT_EQ(tree_of("1099511627776"), "1099511627776");
}

TEST(RealFormula, FunctionsTakeTheirArgumentsAndBlanksAreIgnored) {
  EXPECT_EQ(tree_of("sqrt(x) + sin(x) + cos(x) + exp(x) + abs(x)"),
            "(((((sqrt x) + (sin x)) + (cos x)) + (exp x)) + (abs x))");
  EXPECT_EQ(tree_of(" min ( x , y ,\t1 )\n"), "(min (min x y) 1)");
  EXPECT_EQ(tree_of("max(x, y)"), "(max x y)");
  EXPECT_EQ(tree_of("rand( 18446744073709551615 ) * pi"), "(rand 18446744073709551615 * pi)");
}

TEST(RealFormula, ErrorsNameTheColumnAndTheTextThere) {
  const struct {
    std::string_view text, message;
  } cases[] = {
      {"", "column 1: a number, a name, - or ( expected, but there is the end"},
      {"1 +", "column 4: a number, a name, - or ( expected, but there is the end"},
      {"x*)", "column 3: a number, a name, - or ( expected, but there is \")\""},
      {"+1", "column 1: a number, a name, - or ( expected, but there is \"+\""},
      {"x y", "column 3: an operator expected, but there is \"y\""},
      {"2x", "column 2: an operator expected, but there is \"x\""},
      {"1.2.3", "column 4: an operator expected, but there is \".\""},
      {"x\xff", "column 2: an operator expected, but there is \"\\xff\""},
      {"x)", "column 2: this parenthesis was not opened"},
      {"2*(x + 1", "column 3: the parenthesis of \"(x + 1\" is not closed"},
      {"2*(x ; 1)", "column 6: an operator or ) expected, but there is \";\""},
      {"1 + .", "column 5: a digit beside the point expected, but there is \".\""},
      {"1 + 1e", "column 5: the exponent of the number \"1e\" has no digits"},
      {"1e-x", "column 1: the exponent of the number \"1e-\" has no digits"},
      {"1 + t",
       "column 5: \"t\" is not a variable here; the variables are x, y, n_1, and pi is a constant"},
      {"tan(x)",
       "column 1: \"tan\" is not a function; the functions are abs, cos, exp, max, min, rand, sin "
       "and sqrt"},
      {"sin x", "column 5: ( expected, but there is \"x\" after the function sin"},
      {"sin(x, y)", "column 6: ) expected, but there is \",\": sin has one argument"},
      {"min(x)", "column 6: a comma expected, but there is \")\": min has two arguments or more"},
      {"max(x, y", "column 4: the parenthesis of \"(x, y\" is not closed"},
      {"rand(x)",
       "column 6: a seed expected, but there is \"x\": seeds of rand are integers from 0 to "
       "18446744073709551615"},
      {"rand(-1)",
       "column 6: a seed expected, but there is \"-\": seeds of rand are integers from 0 to "
       "18446744073709551615"},
      {"rand(18446744073709551616)",
       "column 6: a seed expected, but there is \"18446744073709551616\": seeds of rand are "
       "integers from 0 to 18446744073709551615"},
      {"rand(1 + 1)", "column 8: ) expected, but there is \"+\" after the seed of rand"},
      {"rand(1", "column 5: the parenthesis of \"(1\" is not closed"},
  };
  for (const auto& c : cases) {
    const Result<RealFormula> formula = parse_formula(c.text, kVariables);
    ASSERT_FALSE(formula.has_value()) << c.text;
    EXPECT_EQ(formula.error().code, Code::kSyntax) << c.text;
    EXPECT_EQ(formula.error().message, c.message) << c.text;
  }
}

TEST(RealFormula, LimitsAreErrorsOfTheirOwn) {
  const auto error_of = [](const std::string& text) {
    const Result<RealFormula> formula = parse_formula(text, kVariables);
    EXPECT_TRUE(!formula && formula.error().code == Code::kOverLimit) << text;
    return formula ? "" : formula.error().message;
  };
  EXPECT_EQ(error_of("1 + 1e13"), "column 5: the number \"1e13\" exceeds 2^40");
  EXPECT_EQ(error_of("1e-1001"), "column 1: the exponent of the number \"1e-1001\" is beyond 1000");
  EXPECT_EQ(error_of("1e99999999999999999999"),
            "column 1: the exponent of the number \"1e99999999999999999999\" is beyond 1000");
  std::string longest = "x";
  while (longest.size() + 2 <= RealFormula::kMostCharacters) longest += "+x";
  EXPECT_TRUE(parse_formula(longest + " ", kVariables).has_value());  // 4,096 characters
  EXPECT_EQ(error_of(longest + "  "), "the formula has 4097 characters; at most 4096 are allowed");
}

TEST(RealFormula, DepthCountsParenthesesFunctionsSignsAndExponents) {
  const auto repeated = [](const std::string& part, int times) {
    std::string out;
    for (int i = 0; i < times; ++i) out += part;
    return out;
  };
  const int most = RealFormula::kMostDepth;
  const struct {
    std::string open, close;
  } kinds[] = {{"(", ")"}, {"sin(", ")"}, {"min(1,", ")"}, {"-", ""}, {"2^", ""}};
  for (const auto& kind : kinds) {
    const auto nested = [&](int times) {
      return parse_formula(repeated(kind.open, times) + "x" + repeated(kind.close, times),
                           kVariables);
    };
    EXPECT_TRUE(nested(most).has_value()) << kind.open;
    const Result<RealFormula> deeper = nested(most + 1);
    ASSERT_FALSE(deeper.has_value()) << kind.open;
    EXPECT_EQ(deeper.error().code, Code::kOverLimit);
    EXPECT_NE(deeper.error().message.find("nested more than 64 deep"), std::string::npos);
  }
  EXPECT_EQ(parse_formula(repeated("(", most) + "(x", kVariables).error().message,
            "column 65: parentheses, functions, signs and exponents are nested more than 64 deep "
            "at \"(x\"");
}

TEST(RealFormula, KnowsOnWhatItDepends) {
  const RealFormula formula = parse_formula("2*x + rand(1)", kVariables).value();
  EXPECT_TRUE(formula.depends_on(0) && formula.is_random());
  EXPECT_FALSE(formula.depends_on(1) || formula.depends_on(2));
  EXPECT_FALSE(parse_formula("y", kVariables)->is_random());
  EXPECT_EQ(formula.text(), "2*x + rand(1)");
}

TEST(RealFormula, NodesKnowTheirTextWithItsParentheses) {
  const RealFormula formula = parse_formula(" 1/( x - 1 ) + min(x, 2 , 3) ", kVariables).value();
  std::vector<std::string> texts;
  for (const FormulaNode& node : formula.nodes())
    texts.push_back(formula.text().substr(node.begin, node.end - node.begin));
  EXPECT_EQ(texts,
            (std::vector<std::string>{"1", "x", "1", "x - 1", "1/( x - 1 )", "x", "2", "min(x, 2",
                                      "3", "min(x, 2 , 3)", "1/( x - 1 ) + min(x, 2 , 3)"}));
}

TEST(RealFormula, NamesOfTheGrammarAreNoVariables) {
  for (const char* name : {"pi", "rand", "sin", "", "1x", "a b"}) {
    const std::vector<std::string> names = {name};
    EXPECT_THROW(parse_formula("1", names).has_value(), InternalError) << name;
  }
  const std::vector<std::string> twice = {"x", "x"};
  EXPECT_THROW(parse_formula("1", twice).has_value(), InternalError);
}

// From the formula of the header, computed by integers of Python.
TEST(RealFormula, RandomNumbersAreThoseOfTheContract) {
  EXPECT_EQ(formula_random(0, 0), 684141u);
  EXPECT_EQ(formula_random(0, 1), 35663u);
  EXPECT_EQ(formula_random(1, 0), 386074u);
  EXPECT_EQ(formula_random(~std::uint64_t{0}, ~std::uint64_t{0}), 405649u);
  EXPECT_EQ(formula_random(5, 3), 425479u);
}

TEST(RealFormula, RandomNumbersAreSpreadEvenlyOverSeedsAndOverIndices) {
  for (const bool by_seed : {false, true}) {
    std::vector<int> counts(16);
    for (std::uint64_t i = 0; i < 16000; ++i) {
      const std::uint32_t k = by_seed ? formula_random(i, 7) : formula_random(7, i);
      ASSERT_LT(k, 1u << 20);
      ++counts[k >> 16];
    }
    for (const int count : counts) EXPECT_NEAR(count, 1000, 150);
  }
}

}  // namespace
}  // namespace veritope
