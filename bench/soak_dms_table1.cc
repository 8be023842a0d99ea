// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_dms_table1.cc: [--set 1|2|3]: table 1 of [HHQ04] on data of our own (bench/table1_data.h): errors of
// fits within the paper's numbers of tetrahedra, control points and knots, and of free knots beside fixed ones. One
// JSON line a figure; --set 0, all, is the default. --tetrahedra, --degree and --free 0|1 fit one model instead.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

#include "bench/arguments.h"
#include "bench/stopwatch.h"
#include "bench/table1_data.h"
#include "solids/dms/fit/dms_fit.h"

namespace veritope::bench {
namespace {

struct Row {
  const char* name;
  std::size_t tetrahedra, control_points, knots;  // the paper's, as its error
  double error;
  std::size_t budget;  // of tetrahedra, so that control points are not more than the paper's
};
constexpr Row kRows[] = {{"layer", 1914, 3335, 992, 7.78170e-4, 1914},
                         {"cross", 2245, 3294, 858, 1.97281e-4, 1950},
                         {"ring", 2812, 4239, 1236, 1.52832e-4, 2650}};
constexpr std::size_t kFreeBudget = 600;  // for the comparison of free knots with fixed ones
constexpr double kUniformShare = 0.2, kFeatureError = 1e-6, kFeatureShare = 0.01, kGeometry = 1e-20;

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
  return {cross_plane()};
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

std::size_t num_knots(const DmsModel& model) {
  std::size_t knots = 0;
  for (const DmsCloud& cloud : model.clouds) knots += cloud.size();
  return knots;
}

void print(const std::string& name, const Fitted& fitted, double goal) {
  const DmsFit& f = fitted.fit;
  std::printf(
      "{\"name\":\"dms_table1_%s\",\"value\":%.4g,\"goal\":\"<= %.4g\",\"geometry_mse\":%.2g,"
      "\"max_error\":%.2g,\"tetrahedra\":%zu,\"control_points\":%zu,\"knots\":%zu,"
      "\"undetermined\":%zu,\"points\":%zu,\"outside\":%zu,\"degree\":%d,\"seconds\":%.1f}\n",
      name.c_str(), f.errors.attribute_mse[0], goal, f.errors.geometry_mse, f.errors.max_error[0],
      f.model.tetrahedra.size(), f.model.num_control(), num_knots(f.model), f.undetermined.size(),
      f.num_points, f.outside.size(), f.model.degree, fitted.seconds);
  std::fflush(stdout);
}

double error_of(const Fitted& fitted) { return fitted.fit.errors.attribute_mse[0]; }

// Whether the fit keeps to the row's numbers and to the goal.
bool keeps(const Fitted& fitted, const Row& row, double goal) {
  const DmsModel& model = fitted.fit.model;
  return error_of(fitted) <= goal && fitted.fit.errors.geometry_mse <= kGeometry &&
         model.tetrahedra.size() <= row.tetrahedra && model.num_control() <= row.control_points &&
         num_knots(model) <= row.knots && fitted.fit.outside.empty();
}

bool run_set(int set) {
  const Row& row = kRows[set - 1];
  const DmsData data = data_of(set);
  const DmsModel domain = domain_of(set);
  double goal = row.error;
  if (set == 1) {
    const Fitted uniform = fit(cube_domain(7), data, {2, {}, {}, false, {}});
    print("layer_uniform", uniform, row.error);
    goal = std::min(goal, kUniformShare * error_of(uniform));
  }
  if (set == 2) {
    const Fitted without = fit(cross_domain(false), data, {2, {}, row.budget, false, {}});
    print("cross_without_feature", without, row.error);
    goal = std::min(kFeatureError, kFeatureShare * error_of(without));
  }
  const Fitted best = fit(domain, data, {2, {}, row.budget, false, {}});
  print(row.name, best, goal);
  const Fitted fixed = fit(domain, data, {2, {}, kFreeBudget, false, {}}),
               free = fit(domain, data, {2, {}, kFreeBudget, true, features_of(set)});
  print(std::string(row.name) + "_fixed_knots", fixed, row.error);
  print(std::string(row.name) + "_free_knots", free, error_of(fixed) / 2);
  return keeps(best, row, goal);
}

}  // namespace
}  // namespace veritope::bench

int main(int argc, char** argv) {
  using namespace veritope;
  using namespace veritope::bench;
  int set = 0, degree = 2, is_free = 0;
  std::uint64_t tetrahedra = 0;
  read_arguments(argc, argv,
                 {{"--set", &set},
                  {"--degree", &degree},
                  {"--tetrahedra", &tetrahedra},
                  {"--free", &is_free}});
  if (set < 0 || set > 3) return 2;
  if (tetrahedra > 0 && set > 0) {
    const Fitted one =
        fit(domain_of(set), data_of(set), {degree, {}, tetrahedra, is_free != 0, features_of(set)});
    print(kRows[set - 1].name, one, kRows[set - 1].error);
    return 0;
  }
  bool is_good = true;
  for (int s = 1; s <= 3; ++s)
    if (set == 0 || set == s) is_good = run_set(s) && is_good;
  return is_good ? 0 : 1;
}
