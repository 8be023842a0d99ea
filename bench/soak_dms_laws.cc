// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_dms_laws.cc: --rounds N --seed S [--degree D]. The laws of simplex-spline solids
// (tests/support/dms_laws.h) at twelve points of each of N random models of degrees up to D, 6 unless given: broken
// ones. One JSON line a figure.
#include <cstdio>
#include <string>

#include "bench/arguments.h"
#include "tests/support/dms_laws.h"

int main(int argc, char** argv) {
  using namespace veritope;
  constexpr int kPoints = 12;
  std::uint64_t rounds = 100, seed = 1;
  int degree = 6;
  bench::read_arguments(argc, argv,
                        {{"--rounds", &rounds}, {"--seed", &seed}, {"--degree", &degree}});
  DmsLawCounts counts;
  long broken = 0;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    const std::string law = check_dms_laws(seed * 10'000'000 + round, degree, kPoints, counts);
    if (law.empty()) continue;
    ++broken;
    std::fprintf(stderr, "%s\n", law.c_str());
  }
  std::printf(
      "{\"name\":\"dms_laws\",\"value\":%ld,\"goal\":\"0 broken "
      "laws\",\"models\":%llu,\"pairs\":%llu,"
      "\"on_faces\":%llu,\"on_planes_of_knots\":%llu,\"basis_values\":%llu}\n",
      broken, static_cast<unsigned long long>(counts.models),
      static_cast<unsigned long long>(counts.pairs),
      static_cast<unsigned long long>(counts.special),
      static_cast<unsigned long long>(counts.on_knots),
      static_cast<unsigned long long>(counts.basis));
  return broken == 0 ? 0 : 1;
}
