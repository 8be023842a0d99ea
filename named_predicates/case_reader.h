// SPDX-License-Identifier: LGPL-3.0-or-later
// named_predicates/case_reader.h: a line of `veritope predicate`. The format: docs/cli/predicate.md.
#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

#include "named_predicates/named_predicate.h"
#include "named_predicates/number_reader.h"
#include "robust/base/result.h"

namespace veritope {

struct PredicateCase {
  const NamedPredicate* predicate = nullptr;
  Operands operands{};
  Sign expected = Sign::kZero;  ///< if the lines have that column
};

class CaseReader {
 public:
  /// `predicate`: the predicate of all lines; null: its name is the first column of each line. `has_expected`: the
  /// expected sign follows the operands.
  CaseReader(const NamedPredicate* predicate, bool has_expected)
      : predicate_(predicate), has_expected_(has_expected) {}

  /// Nothing for an empty line or a comment. REQUIRES that 8 bytes after the line may be read.
  /// @error of NumberReader with the column, counted from 1; kSyntax for another number of columns, for an
  /// unknown name and for points that do not exist.
  Result<std::optional<PredicateCase>> read(std::string_view line) const;

 private:
  Error wrong_number_of_columns(const NamedPredicate& predicate, std::size_t count) const;

  NumberReader numbers_;
  const NamedPredicate* predicate_;
  bool has_expected_;
};

}  // namespace veritope
