// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_dms_xray.cc: --models N --seed S [--degree D]. Sums along eight rays of a grid through each of N random
// models of degrees up to D, 3 unless given, beside exact integrals (tests/support/dms_rays.h): those whose bounds do
// not contain them. One JSON line a figure.
#include <cstdio>
#include <string>

#include "bench/arguments.h"
#include "tests/support/dms_laws.h"
#include "tests/support/dms_rays.h"

int main(int argc, char** argv) {
  using namespace veritope;
  constexpr int kRays = 8;
  std::uint64_t models = 100, seed = 1;
  int degree = 3;
  bench::read_arguments(argc, argv,
                        {{"--models", &models}, {"--seed", &seed}, {"--degree", &degree}});
  DmsRayCounts counts;
  long misses = 0;
  for (std::uint64_t k = 0; k < models; ++k) {
    const std::string miss = check_dms_rays(seed * 10'000'000 + k, degree, kRays, counts);
    if (miss.empty()) continue;
    ++misses;
    std::fprintf(stderr, "%s\n", miss.c_str());
  }
  std::printf(
      "{\"name\":\"dms_xray\",\"value\":%ld,\"goal\":\"0 misses\",\"models\":%llu,\"rays\":%llu,"
      "\"share_decided_exactly\":%.4f,\"greatest_bound\":%.3g}\n",
      misses, static_cast<unsigned long long>(counts.models),
      static_cast<unsigned long long>(counts.rays),
      static_cast<double>(counts.exact) /
          static_cast<double>(std::max<std::uint64_t>(1, counts.computed)),
      counts.worst);
  return misses == 0 ? 0 : 1;
}
