// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_dms_fast.cc: --rounds N --seed S [--degree D]. FastDms beside exact values at 32 points of each of N
// random models of degrees up to D, 6 unless given, by the kernels' bounds, by pairs, and with the tolerance that is
// usual, in turn: numbers outside of their bounds or wrong tetrahedra. One JSON line a figure.
#include <cstdio>
#include <string>

#include "bench/arguments.h"
#include "tests/support/fast_dms_check.h"

int main(int argc, char** argv) {
  using namespace veritope;
  std::uint64_t rounds = 100, seed = 1;
  int degree = 6;
  bench::read_arguments(argc, argv,
                        {{"--rounds", &rounds}, {"--seed", &seed}, {"--degree", &degree}});
  long broken = 0;
  double greatest = 0;
  FastDmsCounts sum;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    const std::uint64_t number = seed * 10'000'000 + round;
    const RandomDms drawn = draw_fast_dms(number, degree);
    Random random(number);
    const FastDmsPoints points = draw_fast_dms_points(random, drawn.model, 32);
    FastDmsOptions options;
    options.with_gradient = true;
    options.exact_first = 0;
    if (round % 3 != 2) options.tolerance = round % 3 == 0 ? 1e300 : 1e-20;
    FastDms fast(drawn.model, options);
    const FastDmsResults results(fast, points);
    const std::string wrong = check_fast_dms(drawn.model, points, results, greatest);
    const FastDmsCounts& c = fast.counts();
    sum.fast += c.fast, sum.pairs += c.pairs, sum.near_faces += c.near_faces;
    sum.open_sign += c.open_sign, sum.wide += c.wide, sum.unprepared += c.unprepared;
    if (wrong.empty()) continue;
    ++broken;
    std::fprintf(stderr, "%s: %s\n", drawn.text.c_str(), wrong.c_str());
  }
  const auto count = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
  std::printf(
      "{\"name\":\"dms_fast\",\"value\":%ld,\"goal\":\"0 broken bounds\",\"models\":%llu,"
      "\"points_fast\":%llu,\"points_by_pairs\":%llu,\"near_faces\":%llu,\"open_signs\":%llu,"
      "\"wide\":%llu,\"out_of_range\":%llu,\"greatest_share_of_a_bound\":%.3g}\n",
      broken, count(rounds), count(sum.fast), count(sum.pairs), count(sum.near_faces),
      count(sum.open_sign), count(sum.wide), count(sum.unprepared), greatest);
  return broken == 0 ? 0 : 1;
}
