// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_dms_insertions.cc: --rounds N --seed S [--points P] [--degree D]. N vertices in random simplex-spline
// solids of degrees up to D, 4 unless given: values and derivatives at P points, 100 unless given, that change
// (tests/support/dms_insertions.h). One JSON line.
#include <cstdio>
#include <string>

#include "bench/arguments.h"
#include "tests/support/dms_insertions.h"

int main(int argc, char** argv) {
  using namespace veritope;
  std::uint64_t rounds = 100, seed = 1;
  int degree = 4, points = 100;
  bench::read_arguments(
      argc, argv,
      {{"--rounds", &rounds}, {"--seed", &seed}, {"--degree", &degree}, {"--points", &points}});
  DmsInsertionCounts counts;
  long broken = 0;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    const std::string law = check_dms_insertion(seed * 10'000'000 + round, degree, points, counts);
    if (law.empty()) continue;
    ++broken;
    std::fprintf(stderr, "%s\n", law.c_str());
  }
  std::printf(
      "{\"name\":\"dms_insertions\",\"value\":%ld,\"goal\":\"0 broken laws\",\"insertions\":%llu,"
      "\"points\":%llu,\"collapsed\":%llu,\"in_the_tetrahedron\":%llu,\"on_the_boundary\":%llu}\n",
      broken, static_cast<unsigned long long>(counts.insertions),
      static_cast<unsigned long long>(counts.points),
      static_cast<unsigned long long>(counts.collapsed),
      static_cast<unsigned long long>(counts.inside),
      static_cast<unsigned long long>(counts.creases));
  return broken == 0 ? 0 : 1;
}
