// SPDX-License-Identifier: LGPL-3.0-or-later
// io/chains/expression_text.h: expressions as text: A | (B - !C) & "part.stl". Grammar: docs/cli/boolean.md.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "robust/base/result.h"
#include "solids/expression/expression_tree.h"

namespace veritope {

/// What an operand of an expression is called.
struct OperandName {
  std::string text;        ///< a name, or the name of a file
  bool is_file = false;    ///< it stood in double quotes
  std::size_t column = 0;  ///< where it first occurs, from 1
  friend bool operator==(const OperandName& a, const OperandName& b) {
    return a.text == b.text && a.is_file == b.is_file;
  }
};

struct ExpressionText {
  ExpressionTree tree;
  std::vector<OperandName> operands;  ///< each once, in the order of their first occurrence
};

/// [A-Za-z_][A-Za-z0-9_]*
bool is_operand_name(std::string_view text);

/// @error  kSyntax with the column, counted in bytes from 1, in the message; kOverLimit for more than kMostLeaves
///         occurrences of operands
/// @cost   near-linear; no recursion, however deep the text is nested
Result<ExpressionText> read_expression(std::string_view text);

/// Writes the expression with other names, and with parentheses where they are needed. It reads back as the same tree,
/// but runs of one operator become one node. REQUIRES a name for each operand, and an allowed depth.
std::string write_expression(const ExpressionTree& tree, const std::vector<std::string>& names);

}  // namespace veritope
