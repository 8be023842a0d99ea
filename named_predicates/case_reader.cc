// SPDX-License-Identifier: LGPL-3.0-or-later
#include "named_predicates/case_reader.h"

#include <algorithm>
#include <string>

#include "io/base/source.h"

namespace veritope {
namespace {

constexpr std::string_view kBlanks = " \t";

using Columns = std::array<std::string_view, kMostOperands + 2>;  // a name and a sign

// The number of columns; `columns` gets those that fit.
std::size_t split(std::string_view line, Columns& columns) {
  std::size_t count = 0;
  for (;;) {
    line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
    if (line.empty()) return count;
    const std::size_t size = std::min(line.find_first_of(kBlanks), line.size());
    if (count < columns.size()) columns[count] = line.substr(0, size);
    line.remove_prefix(size);
    ++count;
  }
}

std::optional<Sign> sign_from_text(std::string_view text) {
  if (text == "-1") return Sign::kNegative;
  if (text == "0") return Sign::kZero;
  if (text == "1") return Sign::kPositive;
  return std::nullopt;
}

Error not_a_sign(std::string_view text) {
  return Error{Code::kSyntax, {}, "-1, 0 or 1 expected, but there is " + quoted(text)};
}

Error in_column(std::size_t index, Error error) {
  error.message = "column " + std::to_string(index + 1) + ": " + error.message;
  return error;
}

}  // namespace

Result<std::optional<PredicateCase>> CaseReader::read(std::string_view line) const {
  Columns columns;
  const std::size_t count = split(line, columns);
  if (count == 0 || columns[0].starts_with('#')) return std::optional<PredicateCase>();
  const std::size_t first = predicate_ == nullptr ? 1 : 0;
  const NamedPredicate* const predicate = first == 1 ? predicate_from_name(columns[0]) : predicate_;
  if (predicate == nullptr) {
    return in_column(0,
                     Error{Code::kSyntax,
                           {},
                           "the name of a predicate expected, but there is " + quoted(columns[0])});
  }
  const std::size_t num_operands = predicate->num_operands;
  if (count - first != num_operands + (has_expected_ ? 1 : 0)) {
    return wrong_number_of_columns(*predicate, count - first);
  }
  std::optional<PredicateCase> out(std::in_place);
  out->predicate = predicate;
  for (std::size_t i = 0; i < num_operands; ++i) {
    const Result<double> number = numbers_.read(columns[first + i]);
    if (!number) return in_column(first + i, number.error());
    out->operands[i] = *number;
  }
  if (predicate->is_defined != nullptr && !predicate->is_defined(out->operands)) {
    return Error{
        Code::kSyntax,
        {},
        "an implicit point does not exist: there is no such intersection, or a denominator is 0"};
  }
  if (!has_expected_) return out;
  const std::string_view sign = columns[first + num_operands];
  const std::optional<Sign> expected = sign_from_text(sign);
  if (!expected) return in_column(first + num_operands, not_a_sign(sign));
  out->expected = *expected;
  return out;
}

Error CaseReader::wrong_number_of_columns(const NamedPredicate& predicate,
                                          std::size_t count) const {
  return Error{Code::kSyntax,
               {},
               std::to_string(predicate.num_operands) +
                   (has_expected_ ? " numbers and a sign" : " numbers") + " expected, but there " +
                   (count == 1 ? "is 1 column" : "are " + std::to_string(count) + " columns")};
}

}  // namespace veritope
