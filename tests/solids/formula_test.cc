// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/formula.h"

#include <gtest/gtest.h>

#include "robust/base/random.h"
#include "solids/expression/decision_diagram.h"
#include "solids/expression/expression_tree.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

constexpr std::uint64_t kFormulaSeed = 20261127;
constexpr std::uint32_t kNumVariables = 5;

Formula x(std::uint32_t i) { return Formula::variable(i); }

// Builds a random formula, and beside it the set of assignments at which it is 1.
struct Tabled {
  Formula formula;
  std::uint32_t table;
};
Tabled random_formula(Random& random, int depth) {
  if (depth == 0 || random.below(5) == 0) {
    if (random.below(12) == 0) {
      const bool value = random.below(2) != 0;
      return {Formula::constant(value), value ? ~0u : 0u};
    }
    const auto i = static_cast<std::uint32_t>(random.below(kNumVariables));
    std::uint32_t table = 0;
    for (std::uint32_t a = 0; a < 32; ++a) table |= (a >> i & 1u) << a;
    return {x(i), table};
  }
  std::vector<Formula> parts;
  std::uint32_t any = 0, all = ~0u;
  for (std::uint64_t n = 1 + random.below(3); n > 0; --n) {
    Tabled part = random_formula(random, depth - 1);
    if (random.below(3) == 0) part = {part.formula.negated(), ~part.table};
    any |= part.table;
    all &= part.table;
    parts.push_back(std::move(part.formula));
  }
  if (random.below(2) != 0) return {Formula::any_of(parts), any};
  return {Formula::all_of(parts), all};
}

std::uint32_t table_of(const Formula& f) {
  std::uint32_t out = 0;
  for (std::uint32_t a = 0; a < 32; ++a)
    if (f.value([a](std::uint32_t v) { return to_value((a >> v & 1u) != 0); }) == Value3::kOne)
      out |= 1u << a;
  return out;
}

// No union is a part of a union, no intersection of an intersection, no constant of anything; two parts or more.
void expect_normal_form(const Formula& f) {
  const auto nodes = f.nodes();
  ASSERT_EQ(nodes[0].end, nodes.size());
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].kind <= Formula::Kind::kLiteral) {
      EXPECT_EQ(nodes[i].end, i + 1);
      EXPECT_TRUE(nodes.size() == 1 || nodes[i].kind == Formula::Kind::kLiteral);
      continue;
    }
    int num_parts = 0;
    std::uint32_t part = i + 1;
    for (; part < nodes[i].end; part = nodes[part].end, ++num_parts)
      EXPECT_NE(nodes[part].kind, nodes[i].kind);
    EXPECT_EQ(part, nodes[i].end);
    EXPECT_GE(num_parts, 2) << f.to_string();
  }
}

TEST(Formula, IsWrittenWithSignsAtItsVariables) {
  const Formula f = Formula::any_of({x(0), Formula::all_of({x(1), x(2).negated()})});
  EXPECT_EQ(f.to_string(), "x0 | (x1 & !x2)");
  EXPECT_EQ(f.negated().to_string(), "!x0 & (!x1 | x2)");
  EXPECT_EQ(Formula::any_of({f, f}).to_string(), "x0 | (x1 & !x2) | x0 | (x1 & !x2)");
  EXPECT_EQ(Formula::all_of({f, x(3)}).to_string(), "(x0 | (x1 & !x2)) & x3");
  EXPECT_EQ(Formula::all_of({Formula::constant(true), x(4)}), x(4));
  EXPECT_EQ(Formula::all_of({Formula::constant(false), x(4)}).to_string(), "0");
  EXPECT_EQ(f.variables(), (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_TRUE(f.is_read_once());
  EXPECT_EQ(f.depth(), 2u);
  EXPECT_EQ(x(0).depth(), 0u);
  EXPECT_EQ(Formula::all_of({f, x(3)}).depth(), 3u);
}

TEST(Formula, AsksForNoMoreVariablesThanItNeeds) {
  const Formula f = Formula::any_of({x(0), Formula::all_of({x(1), x(2)}), x(3)});
  std::vector<std::uint32_t> asked;
  const auto value = f.value([&](std::uint32_t v) {
    asked.push_back(v);
    return v == 3 ? Value3::kOne : v == 0 ? Value3::kMixed : Value3::kZero;
  });
  EXPECT_EQ(value, Value3::kOne);
  EXPECT_EQ(asked, (std::vector<std::uint32_t>{0, 1, 3}));
}

TEST(Formula, KeepsItsTruthTableAndItsNormalForm) {
  Random random(kFormulaSeed);
  for (int i = 0; i < scaled(2000); ++i) {
    const Tabled f = random_formula(random, 4);
    SCOPED_TRACE(testing::Message()
                 << "seed " << kFormulaSeed << " formula " << i << ": " << f.formula.to_string());
    ASSERT_EQ(table_of(f.formula), f.table);
    ASSERT_EQ(table_of(f.formula.negated()), ~f.table);
    expect_normal_form(f.formula);
    expect_normal_form(f.formula.negated());
    // Fold some variables: what remains has the table of the restriction, on the assignments that agree with them.
    const std::uint32_t fixed = static_cast<std::uint32_t>(random.below(32)),
                        bits = static_cast<std::uint32_t>(random.below(32));
    const auto value_of = [&](std::uint32_t v) {
      return (fixed >> v & 1u) != 0 ? to_value((bits >> v & 1u) != 0) : Value3::kMixed;
    };
    const Formula folded = f.formula.folded(value_of);
    expect_normal_form(folded);
    for (const std::uint32_t v : folded.variables()) EXPECT_EQ(fixed >> v & 1u, 0u);
    const std::uint32_t table = table_of(folded);
    for (std::uint32_t a = 0; a < 32; ++a) {
      if ((a & fixed) != (bits & fixed)) continue;
      ASSERT_EQ(table >> a & 1u, f.table >> a & 1u);
    }
    const Value3 value = f.formula.value(value_of);
    EXPECT_EQ(is_constant(value), folded.is_constant());
    EXPECT_TRUE(!folded.is_constant() || (value == Value3::kOne) == folded.nodes()[0].is_positive);
  }
}

TEST(DecisionDiagram, DependsOnExactlyTheVariablesInItsSupport) {
  Random random(kFormulaSeed);
  for (int i = 0; i < scaled(2000); ++i) {
    const Tabled f = random_formula(random, 4);
    SCOPED_TRACE(testing::Message()
                 << "seed " << kFormulaSeed << " formula " << i << ": " << f.formula.to_string());
    const auto diagram = DecisionDiagram::make(f.formula, 1000);
    ASSERT_TRUE(diagram);
    std::vector<std::uint32_t> support;
    for (std::uint32_t v = 0; v < kNumVariables; ++v) {
      bool depends = false;
      for (std::uint32_t a = 0; a < 32; ++a)
        depends |= (f.table >> a & 1u) != (f.table >> (a ^ 1u << v) & 1u);
      if (depends) support.push_back(v);
    }
    ASSERT_EQ(diagram->support(), support);
    ASSERT_EQ(table_of(diagram->formula()), f.table);
    expect_normal_form(diagram->formula());
    for (std::uint32_t a = 0; a < 32; ++a)
      ASSERT_EQ(diagram->value([a](std::uint32_t v) { return (a >> v & 1u) != 0; }),
                (f.table >> a & 1u) != 0);
  }
}

TEST(DecisionDiagram, EndsAtItsBudget) {
  // x0 x1 | x2 x3 | ... in an order that makes it exponential: x0 xn | x1 xn+1 | ...
  std::vector<Formula> parts;
  for (std::uint32_t i = 0; i < 40; ++i) parts.push_back(Formula::all_of({x(i), x(i + 40)}));
  EXPECT_FALSE(DecisionDiagram::make(Formula::any_of(parts), 10000));
  parts.resize(10);
  EXPECT_TRUE(DecisionDiagram::make(Formula::any_of(parts), 10000));
}

TEST(ExpressionTree, CountsAndHasItsNormalForm) {
  ExpressionTree tree;  // (a - b - c) | !a
  using enum ExpressionOperator;
  for (std::uint32_t i = 0; i < 3; ++i) tree.add({kOperand, i, {}});
  tree.add({kDifference, 0, {0, 1, 2}});
  tree.add({kOperand, 0, {}});
  tree.add({kComplement, 0, {4}});
  tree.add({kUnion, 0, {3, 5}});
  EXPECT_TRUE(tree.has_complement());
  const ExpressionSize size = tree.size({{1, 0}, {1, 0}, {5, 7}});
  EXPECT_EQ(size.leaves, 8u);
  EXPECT_EQ(size.depth, 9u);
  EXPECT_EQ(tree.formula({x(0), x(1), Formula::any_of({x(2), x(3)})}, x(9)).to_string(),
            "(x0 & !x1 & !x2 & !x3) | (x9 & !x0)");
  EXPECT_FALSE((ExpressionSize{kMostLeaves + 1, 1}.is_allowed()));
  EXPECT_FALSE((ExpressionSize{2, kMostDepth + 1}.is_allowed()));
  EXPECT_TRUE((ExpressionSize{kMostLeaves, kMostDepth}.is_allowed()));
}

}  // namespace
}  // namespace veritope
