// SPDX-License-Identifier: LGPL-3.0-or-later
#include "named_predicates/hard_cases.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "named_predicates/hard_explicit_operands.h"
#include "named_predicates/hard_implicit_points.h"
#include "named_predicates/implicit_names.h"
#include "robust/base/check.h"

namespace veritope {
namespace {

Operands implicit_operands(const NamedPredicate& predicate, Random& random) {
  using generate::Wanted;
  const Wanted wanted = predicate.name.starts_with("orient")
                            ? Wanted::kFlat
                            : (predicate.name.starts_with("in_") ? Wanted::kRound : Wanted::kEqual);
  for (;;) {
    Operands operands{};
    double* next = operands.data();
    for (const auto& p : generate::disguised_points(predicate.kinds, wanted, random))
      next = std::copy(p.numbers.begin(), p.numbers.end(), next);
    if (predicate.is_defined(operands)) return operands;
  }
}

}  // namespace

std::vector<const NamedPredicate*> hard_case_predicates() {
  std::vector<const NamedPredicate*> all;
  for (const NamedPredicate& p : named_predicates()) all.push_back(&p);
  for (const NamedPredicate& p : implicit_predicates()) all.push_back(&p);
  return all;
}

HardCases::HardCases(std::uint64_t seed, std::vector<const NamedPredicate*> predicates)
    : random_(seed), predicates_(std::move(predicates)) {
  VT_CHECK(!predicates_.empty(), "hard cases of no predicate");
}

HardCase HardCases::next() {
  const NamedPredicate& predicate = *predicates_[next_++ % predicates_.size()];
  return {&predicate, predicate.kinds.empty() ? hard_operands(predicate, random_)
                                              : implicit_operands(predicate, random_)};
}

std::string operands_text(const HardCase& hard_case) {
  std::string text;
  for (std::size_t i = 0; i < hard_case.predicate->num_operands; ++i) {
    char number[32];
    std::snprintf(number, sizeof number, " %a", hard_case.operands[i]);
    text += number;
  }
  return text;
}

}  // namespace veritope
