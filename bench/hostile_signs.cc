// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/hostile_signs.cc: decides the cases of FILE, which hostile_cases.cc wrote, under every control word. This file
// and the library in it are compiled with the flags under test. Prints a line for each mode: its name, cases, zeros,
// wrong signs; and the first wrong ones on standard error. Exit 1 if there are any.
#include <cfenv>
#include <cstdint>
#include <cstdio>
#include <vector>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "named_predicates/hard_cases.h"
#include "robust/base/fp_guard.h"

namespace {

using namespace veritope;
using namespace veritope;

struct Mode {
  const char* name;
  int rounding;
  unsigned flush;  // bits of the control word
};
constexpr Mode kModes[] = {
    {"nearest", FE_TONEAREST, 0},
    {"upward", FE_UPWARD, 0},
    {"downward", FE_DOWNWARD, 0},
    {"toward_zero", FE_TOWARDZERO, 0},
#if defined(__SSE2__)
    {"ftz", FE_TONEAREST, 0x8000},
    {"daz", FE_TONEAREST, 0x0040},
    {"ftz_daz", FE_TONEAREST, 0x8040},
    {"upward_ftz_daz", FE_UPWARD, 0x8040},
    {"downward_ftz_daz", FE_DOWNWARD, 0x8040},
#endif
};

void enter(const Mode& mode) {
  std::fesetround(mode.rounding);
#if defined(__SSE2__)
  _mm_setcsr((_mm_getcsr() & ~0x8040u) | mode.flush);
#endif
  refresh_fp();
}

struct Case {
  std::int32_t predicate, sign;
  Operands operands;
};

std::vector<Case> read_cases(const char* path, const HardCases& names) {
  std::vector<Case> cases;
  std::FILE* file = std::fopen(path, "rb");
  if (file == nullptr) return cases;
  Case c{};
  while (std::fread(&c.predicate, sizeof(std::int32_t), 2, file) == 2) {
    const std::size_t count =
        names.predicates()[static_cast<std::size_t>(c.predicate)]->num_operands;
    if (std::fread(c.operands.data(), sizeof(double), count, file) != count) break;
    cases.push_back(c);
  }
  std::fclose(file);
  return cases;
}

}  // namespace

int main(int argc, char** argv) {
  const HardCases names(1);
  const std::vector<Case> cases = argc == 2 ? read_cases(argv[1], names) : std::vector<Case>();
  if (cases.empty()) return 2;
  long num_wrong_in_all = 0;
  for (const Mode& mode : kModes) {
    long num_zeros = 0, num_wrong = 0;
    enter(mode);
    for (const Case& c : cases) {
      const NamedPredicate& predicate = *names.predicates()[static_cast<std::size_t>(c.predicate)];
      const int sign = to_int(predicate.decide(c.operands, nullptr));
      num_zeros += c.sign == 0;
      if (sign == c.sign) continue;
      if (num_wrong++ < 3) {
        enter(kModes[0]);
        std::fprintf(stderr, "%s: expected %d, found %d: %s%s\n", mode.name, c.sign, sign,
                     std::string(predicate.name).c_str(),
                     operands_text({&predicate, c.operands}).c_str());
        enter(mode);
      }
    }
    enter(kModes[0]);
    std::printf("%s %zu %ld %ld\n", mode.name, cases.size(), num_zeros, num_wrong);
    num_wrong_in_all += num_wrong;
  }
  return num_wrong_in_all == 0 ? 0 : 1;
}
