// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/case_reader.h: a line of `veritope predicate`. The format: docs/cli.md.
#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

#include "cli/named_predicate.h"
#include "cli/number_reader.h"
#include "robust/base/result.h"

namespace veritope::cli {

struct PredicateCase {
  Operands operands{};
  Sign expected = Sign::kZero;  ///< if the lines have that column
};

class CaseReader {
 public:
  /// `has_expected`: behind the operands stands the expected sign.
  CaseReader(std::size_t num_operands, bool has_expected)
      : num_operands_(num_operands), has_expected_(has_expected) {}

  /// Nothing for an empty line and for a comment. REQUIRES that 8 bytes behind the line may be read.
  /// @error of NumberReader with the column, counted from 1; kSyntax for another number of columns.
  Result<std::optional<PredicateCase>> read(std::string_view line) const;

 private:
  std::size_t num_columns() const { return num_operands_ + (has_expected_ ? 1 : 0); }
  Error wrong_number_of_columns(std::size_t count) const;

  NumberReader numbers_;
  std::size_t num_operands_;
  bool has_expected_;
};

}  // namespace veritope::cli
