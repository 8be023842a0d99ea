// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/hostile_cases.cc: --cases N --seed S. Writes N hard cases of the named predicates with their signs for
// hostile_signs.cc. The library's cascade in a clean build decides them; for one case in 64 so does the formula over
// rational numbers. A record: the predicate's number and the sign, 32 bits each, then the operands.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "named_predicates/hard_cases.h"
#include "robust/base/fp_guard.h"

namespace {

using namespace veritope;
using namespace veritope;

bool write_case(const HardCases& cases, const HardCase& hard_case, Sign sign) {
  const auto& all = cases.predicates();
  std::int32_t number = 0;
  while (all[static_cast<std::size_t>(number)] != hard_case.predicate) ++number;
  const std::int32_t head[] = {number, to_int(sign)};
  const std::size_t count = hard_case.predicate->num_operands;
  return std::fwrite(head, sizeof head, 1, stdout) == 1 &&
         std::fwrite(hard_case.operands.data(), sizeof(double), count, stdout) == count;
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t num_cases = 0, seed = 1;
  for (int i = 1; i + 1 < argc; i += 2) {
    if (std::strcmp(argv[i], "--cases") == 0) num_cases = std::strtoull(argv[i + 1], nullptr, 10);
    if (std::strcmp(argv[i], "--seed") == 0) seed = std::strtoull(argv[i + 1], nullptr, 10);
  }
  if (num_cases == 0 || !check_fp()) return 2;
  HardCases cases(seed);
  for (std::uint64_t i = 0; i < num_cases; ++i) {
    const HardCase hard_case = cases.next();
    const Sign sign = hard_case.predicate->decide(hard_case.operands, nullptr);
    if (i % 64 == 0 && hard_case.predicate->decide_by_formula(hard_case.operands) != sign) {
      std::fprintf(stderr, "hostile_cases: a wrong sign of %s in a clean build:%s\n",
                   std::string(hard_case.predicate->name).c_str(),
                   operands_text(hard_case).c_str());
      return 1;
    }
    if (!write_case(cases, hard_case, sign)) return 1;
  }
  return std::fflush(stdout) == 0 ? 0 : 1;
}
