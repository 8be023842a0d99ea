// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_micro_fit.cc: --fields N --vectors N --seed S [--first I]. Fields of directions sampled from random cages
// (bent, twisted, tapered, shaken; tests/support/random_fields.h), each without noise and with 1 % of it, and the cages
// that are fitted to them: certified, and measured with the evaluation of splines/. One JSON line a noise and figure.
#include <algorithm>
#include <cstdio>
#include <string>

#include "bench/arguments.h"
#include "bench/stopwatch.h"
#include "tests/solids/cage_support.h"
#include "tests/support/random_fields.h"

namespace {

using namespace veritope;
using namespace veritope::random_fields;

struct Totals {
  double median = 0, worst = 0, true_median = 0, true_worst = 0, seconds = 0, slowest = 0;
  int fields = 0, wrong = 0, uncertified = 0, stopped = 0;
};

// A 20th of the diagonal, as the command has it.
Rational margin_of(const DirectionField& field) {
  const auto exact = [](const Point3d& p) {
    return CellPoint{Rational::from_double(p[0]), Rational::from_double(p[1]),
                     Rational::from_double(p[2])};
  };
  std::vector<CellPoint> points;
  for (const Point3d& p : field.points) points.push_back(exact(p));
  return margin_length(box_of(cage_test::hull_of(std::move(points))), Rational(1) / Rational(20));
}

double worst(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

void judge(std::uint64_t seed, int number, int vectors, double noise, double goal, Totals& t) {
  Random random(seed * 1000003 + static_cast<std::uint64_t>(number));
  const CellVolume cage = random_cage(random);
  const Sample given = sample(random, cage, static_cast<std::size_t>(vectors), noise);
  FitCageOptions options;
  options.margin = margin_of(given.field);
  const bench::Stopwatch watch;
  const Result<FitCage> fit = fit_cage(given.field, {}, options);
  const double seconds = 1e-9 * watch.ns();
  ++t.fields;
  if (!fit) {
    ++t.wrong;
    std::fprintf(stderr, "field %d: %s\n", number, to_string(fit.error()).c_str());
    return;
  }
  const Certified answer = cage_test::certified({fit->cell});
  const bool is_certified = answer.verdict == Verdict::kValid;
  for (const auto& finding : answer.findings)
    std::fprintf(stderr, "field %d: %s\n", number, text_of(finding).c_str());
  const auto to_given = angles(fit->cell, given.field.points, given.field.axes);
  const auto to_truth = angles(fit->cell, given.field.points, given.truth);
  const double middle = median(to_given), most = worst(to_given);
  std::fprintf(
      stderr,
      "field %d noise %g: median %.4f worst %.3f, to the truth %.4f %.3f, %llu steps, %llu "
      "shortened, smooth %g, %.1f s%s%s\n",
      number, noise, middle, most, median(to_truth), worst(to_truth),
      static_cast<unsigned long long>(fit->steps), static_cast<unsigned long long>(fit->shortened),
      fit->smoothness, seconds, fit->stop ? ", stopped" : "",
      is_certified ? "" : ", NOT CERTIFIED");
  t.median = std::max(t.median, middle);
  t.worst = std::max(t.worst, most);
  t.true_median = std::max(t.true_median, median(to_truth));
  t.true_worst = std::max(t.true_worst, worst(to_truth));
  t.seconds += seconds;
  t.slowest = std::max(t.slowest, seconds);
  if (!is_certified) ++t.uncertified;
  if (fit->stop) ++t.stopped;
  if (!is_certified || !(middle <= goal) || !(most <= 5)) ++t.wrong;
}

int print(const char* name, double goal, const Totals& t) {
  std::printf(
      "{\"name\":\"micro_fit_%s\",\"value\":%d,\"goal\":\"0 fields over a median of %g or a worst "
      "angle of 5 degrees, or not certified\",\"fields\":%d,\"greatest_median\":%.4f,"
      "\"worst\":%.4f,\"greatest_median_to_truth\":%.4f,\"worst_to_truth\":%.4f,"
      "\"uncertified\":%d,\"stopped\":%d,\"seconds_a_field\":%.2f,\"slowest\":%.2f}\n",
      name, t.wrong, goal, t.fields, t.median, t.worst, t.true_median, t.true_worst, t.uncertified,
      t.stopped, t.seconds / t.fields, t.slowest);
  std::fflush(stdout);
  return t.wrong;
}

}  // namespace

int main(int argc, char** argv) {
  int fields = 50, vectors = 2000, first = 0;
  std::uint64_t seed = 1;
  bench::read_arguments(
      argc, argv,
      {{"--fields", &fields}, {"--vectors", &vectors}, {"--first", &first}, {"--seed", &seed}});
  Totals exact, noisy;
  for (int n = first; n < first + fields; ++n) {
    judge(seed, n, vectors, 0, 0.5, exact);
    judge(seed, n, vectors, 0.01, 1.5, noisy);
  }
  const int wrong = print("exact", 0.5, exact) + print("noisy", 1.5, noisy);
  return wrong == 0 ? 0 : 1;
}
