// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/chains/expression_text.h"

#include <gtest/gtest.h>

#include "robust/base/random.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

// The normal form of the text, with one variable for each operand and "box" for complements.
std::string normal_form(const std::string& text) {
  const Result<ExpressionText> read = read_expression(text);
  if (!read) return read.error().message;
  std::vector<Formula> operands;
  for (std::uint32_t i = 0; i < read->operands.size(); ++i)
    operands.push_back(Formula::variable(i));
  return read->tree.formula(operands, Formula::variable(99)).to_string();
}

std::string rewritten(const std::string& text) {
  const ExpressionText read = read_expression(text).value();
  std::vector<std::string> names;
  for (const OperandName& o : read.operands) names.push_back(o.text);
  return write_expression(read.tree, names);
}

TEST(ExpressionText, KnowsTheStrengthOfOperators) {
  EXPECT_EQ(normal_form("a"), "x0");
  EXPECT_EQ(normal_form("a|b&c"), "x0 | (x1 & x2)");
  EXPECT_EQ(normal_form(" ( a + b ) & c "), "(x0 | x1) & x2");
  EXPECT_EQ(normal_form("a - b - c"), "x0 & !x1 & !x2");
  EXPECT_EQ(normal_form("a - (b - c)"), "x0 & (!x1 | x2)");
  EXPECT_EQ(normal_form("a | b - c | d"), "((x0 | x1) & !x2) | x3");
  EXPECT_EQ(normal_form("!a & b"), "x99 & !x0 & x1");
  EXPECT_EQ(normal_form("!(a & b) + !!c"), "(x99 & (!x0 | !x1)) | (x99 & (!x99 | x2))");
  EXPECT_EQ(normal_form("\"a b.off\" - a - \"a b.off\""), "x0 & !x1 & !x0");
}

TEST(ExpressionText, NamesTheColumnOfAnError) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "column 1: an operand expected, but there is the end"},
      {"a |", "column 4: an operand expected, but there is the end"},
      {"a b", "column 3: an operator expected, but there is 'b'"},
      {"a | | b", "column 5: a name, a file in double quotes, ! or ( expected, but there is '|'"},
      {"(a | b", "column 1: this parenthesis is not closed"},
      {"a | b)", "column 6: this parenthesis was not opened"},
      {"a & \"b.off", "column 5: this quotation mark is not closed"},
      {"\"\"", "column 1: the name of a file must not be empty"},
      {"1a", "column 1: a name, a file in double quotes, ! or ( expected, but there is '1'"},
      {"a ^ b", "column 3: an operator expected, but there is '^'"},
      {"()", "column 2: a name, a file in double quotes, ! or ( expected, but there is ')'"},
      {"a!", "column 2: an operator expected, but there is '!'"},
  };
  for (const auto& [text, message] : cases) EXPECT_EQ(normal_form(text), message) << text;
}

TEST(ExpressionText, ListsOperandsOnceWithTheirFirstColumn) {
  const ExpressionText read = read_expression("b | (a - b) & \"a\"").value();
  ASSERT_EQ(read.operands.size(), 3u);
  EXPECT_EQ(read.operands[0], (OperandName{"b", false, 1}));
  EXPECT_EQ(read.operands[1], (OperandName{"a", false, 6}));
  EXPECT_EQ(read.operands[2], (OperandName{"a", true, 15}));
  EXPECT_EQ(read.operands[1].column, 6u);
  EXPECT_TRUE(is_operand_name("_a9"));
  EXPECT_FALSE(is_operand_name("9a") || is_operand_name("") || is_operand_name("a-b"));
}

TEST(ExpressionText, IsWrittenWithAsManyParenthesesAsItNeeds) {
  for (const char* text : {"a", "a | b | c", "(a - b) & c", "a - (b | c)", "!a & !(b | c)", "!!a",
                           "a | b - c", "a - (b - c)", "a | (b | c)"})
    EXPECT_EQ(rewritten(text), text);
  EXPECT_EQ(rewritten("((a)+((b)))"), "a | b");
}

TEST(ExpressionText, ReadsBackAsTheSameTree) {
  constexpr std::uint64_t kSeedOfTexts = 5;
  Random random(kSeedOfTexts);
  for (int i = 0; i < scaled(3000); ++i) {
    std::string text;
    int open = 0;
    for (int k = 0; k < 8; ++k) {
      if (k > 0) text += " |&+-"[1 + random.below(4)];
      while (random.below(3) == 0) text += random.below(2) != 0 ? "!" : (++open, "(");
      text += static_cast<char>('a' + random.below(4));
      while (open > 0 && random.below(3) == 0) text += ')', --open;
    }
    text += std::string(static_cast<std::size_t>(open), ')');
    ASSERT_EQ(normal_form(rewritten(text)), normal_form(text))
        << "seed " << kSeedOfTexts << " text " << text;
  }
}

TEST(ExpressionText, HasLimitsAndNoRecursion) {
  std::string wide = "a";
  for (std::uint64_t i = 1; i < kMostLeaves; ++i) wide += "|a";
  const ExpressionText read = read_expression(wide).value();
  const ExpressionSize size = read.tree.size({{1, 0}});
  EXPECT_EQ(size.leaves, kMostLeaves);
  EXPECT_EQ(size.depth, 1u);
  const Result<ExpressionText> wider = read_expression(wide + "|a");
  ASSERT_FALSE(wider);
  EXPECT_EQ(wider.error().code, Code::kOverLimit);
  const std::string deep(1000000, '(');
  EXPECT_FALSE(read_expression(deep));
  EXPECT_TRUE(read_expression(deep + "a" + std::string(1000000, ')')));
  const ExpressionText nots = read_expression(std::string(100000, '!') + "a").value();
  EXPECT_EQ(nots.tree.size({{1, 0}}).depth, 100000u);
}

}  // namespace
}  // namespace veritope
