// SPDX-License-Identifier: LGPL-3.0-or-later
// Built by tests/hostile_flags_test.py under flags that break ordinary floating point, together with the
// files of cli/ that call every predicate. Signs must be those of rational numbers, which the library
// computes as it was built, in each rounding mode. Prints the number of checks and of violations, and
// the first of these.
#include <cfenv>
#include <cstdint>
#include <cstdio>

#include "named_predicates/hard_cases.h"
#include "robust/base/fp_guard.h"

using namespace veritope;
using namespace veritope;

namespace {

// This file's own flags may have made infinities of a case: no case for the predicates.
bool is_finite_case(const HardCase& c) {
  for (std::size_t i = 0; i < c.predicate->num_operands; ++i) {
    std::uint64_t bits;
    __builtin_memcpy(&bits, &c.operands[i], sizeof bits);
    if ((bits >> 52 & 2047) == 2047) return false;
  }
  return true;
}

void set_rounding(int mode) {
  std::fesetround(mode);
  refresh_fp();
}

}  // namespace

int main() {
  constexpr int kModes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
  HardCases cases(11);
  long checks = 0, violations = 0;
  for (int i = 0; i < 16000; ++i) {
    const HardCase c = cases.next();
    if (!is_finite_case(c)) continue;
    const Sign sign = c.predicate->decide_by_formula(c.operands);
    for (const int mode : kModes) {
      if (i % 4 != 0 && mode != kModes[0]) continue;
      set_rounding(mode);
      const Sign found = c.predicate->decide(c.operands, nullptr);
      set_rounding(kModes[0]);
      ++checks;
      if (found == sign || violations++ >= 3) continue;
      std::fprintf(stderr, "mode %d: expected %d, found %d: %s%s\n", mode, to_int(sign),
                   to_int(found), std::string(c.predicate->name).c_str(), operands_text(c).c_str());
    }
  }
  std::printf("%ld %ld\n", checks, violations);
  return violations == 0 ? 0 : 1;
}
