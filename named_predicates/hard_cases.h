// SPDX-License-Identifier: LGPL-3.0-or-later
// named_predicates/hard_cases.h: the cases of `veritope selftest` and `veritope corpus`: hard to decide, the same on
// every machine.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "named_predicates/named_predicate.h"
#include "robust/base/random.h"

namespace veritope {

struct HardCase {
  const NamedPredicate* predicate;
  Operands operands;
};

/// The predicates that have hard cases, on explicit points and on implicit ones.
std::vector<const NamedPredicate*> hard_case_predicates();

/// The predicates on points, in turn. At least a third of the cases are exactly zero, others differ from zero by some
/// units in the last place; exponents reach both ends of binary64. All points exist.
class HardCases {
 public:
  explicit HardCases(std::uint64_t seed) : HardCases(seed, hard_case_predicates()) {}
  /// These predicates only, in turn. REQUIRES some of hard_case_predicates().
  HardCases(std::uint64_t seed, std::vector<const NamedPredicate*> predicates);
  HardCase next();
  const std::vector<const NamedPredicate*>& predicates() const { return predicates_; }

 private:
  Random random_;
  std::vector<const NamedPredicate*> predicates_;
  std::size_t next_ = 0;
};

/// " 0x1p+0 0x1.8p+1": the operands as `veritope predicate` reads them.
std::string operands_text(const HardCase& hard_case);

}  // namespace veritope
