// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_dms_table1.cc: [--set 1|2|3]: table 1 of [HHQ04] on data of our own (bench/table1_data.h): errors of fits
// within the paper's numbers of tetrahedra, control points and knots. One JSON line a figure; --set 0, all, is the
// default. --degree, --tetrahedra and --free 0|1 fit one model instead.
#include <cstdio>
#include <string>

#include "bench/arguments.h"
#include "bench/stopwatch.h"
#include "bench/table1_data.h"
#include "solids/dms/fit/dms_fit.h"

namespace veritope::bench {
namespace {

struct Row {
  const char* name;
  std::size_t tetrahedra, control_points, knots;  // of the paper, as its error
  double error;
};
constexpr Row kRows[] = {{"layer", 1914, 3335, 992, 7.78170e-4},
                         {"cross", 2245, 3294, 858, 1.97281e-4},
                         {"ring", 2812, 4239, 1236, 1.52832e-4}};

DmsData data_of(int set) {
  if (set == 1) return layer_data();
  return set == 2 ? cross_data() : ring_data();
}
DmsModel domain_of(int set) {
  if (set == 1) return cube_domain(2);
  return set == 2 ? cross_domain(true) : ring_domain(8, 2, 2);
}
std::vector<DmsPlane> features_of(int set) {
  if (set != 2) return {};
  return {DmsPlane{{Rational(1), Rational(-1), Rational(0)}, Rational(0)}};
}

struct Fitted {
  DmsFit fit;
  double seconds = 0;
};
Fitted fit(const DmsModel& domain, const DmsData& data, const DmsFitOptions& options) {
  const Stopwatch watch;
  Result<DmsFit> result = fit_dms(domain, data, options);
  if (!result) {
    std::fprintf(stderr, "%s\n", result.error().message.c_str());
    std::exit(1);
  }
  for (const DmsFitRound& r : result->rounds)
    std::fprintf(stderr, "  %zu tetrahedra, %zu control points, %zu knots: %.4g, at most %.3g\n",
                 r.tetrahedra, r.control_points, r.knots, r.attribute_mse[0], r.max_error[0]);
  return {std::move(*result), watch.ns() / 1e9};
}

void print(const std::string& name, const Fitted& fitted, const std::string& goal) {
  const DmsFit& f = fitted.fit;
  std::size_t knots = 0;
  for (const DmsCloud& cloud : f.model.clouds) knots += cloud.size();
  std::printf(
      "{\"name\":\"%s\",\"value\":%.6g,\"goal\":\"%s\",\"geometry\":%.3g,\"max\":%.3g,"
      "\"tetrahedra\":%zu,\"control_points\":%zu,\"knots\":%zu,\"undetermined\":%zu,"
      "\"outside\":%zu,\"degree\":%d,\"seconds\":%.1f}\n",
      name.c_str(), f.errors.attribute_mse[0], goal.c_str(), f.errors.geometry_mse,
      f.errors.max_error[0], f.model.tetrahedra.size(), f.model.num_control(), knots,
      f.undetermined.size(), f.outside.size(), f.model.degree, fitted.seconds);
  std::fflush(stdout);
}

}  // namespace
}  // namespace veritope::bench

int main(int argc, char** argv) {
  using namespace veritope;
  using namespace veritope::bench;
  int set = 0, degree = 2, is_free = 0, cells = 0;
  std::uint64_t tetrahedra = 0;
  read_arguments(argc, argv,
                 {{"--set", &set}, {"--degree", &degree}, {"--tetrahedra", &tetrahedra},
                  {"--free", &is_free}, {"--cells", &cells}});
  if (tetrahedra > 0 || cells > 0) {
    DmsFitOptions options{degree, {}, {}, is_free != 0, features_of(set)};
    if (tetrahedra > 0) options.max_tetrahedra = tetrahedra;
    const DmsModel domain = cells > 0 ? cube_domain(cells) : cells < 0 ? cross_domain(false) : domain_of(set);
    print(kRows[set - 1].name, fit(domain, data_of(set), options), "");
    return 0;
  }
  return 0;
}
