// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_formula.cc: ns a rounded value of a formula at rational points, one thread, least of the repetitions.
// Rows formula_<name>: beside plain binary64 with the functions of the C library, compiled, without bounds;
// formula_waves_fractions: fractions and 128 bits, the tiers that decide what binary64 intervals leave open.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/stopwatch.h"
#include "interval/formula/formula_evaluator.h"

namespace veritope::bench {
namespace {

using Tier = FormulaEvaluator::Tier;
constexpr std::int64_t kSide = 300;  // points of a grid in the plane, by side
constexpr int kRepetitions = 5;

template <typename Run>
double ns_a_point(int repetitions, std::int64_t side, Run run) {
  double least = 1e300;
  for (int i = 0; i < repetitions; ++i) {
    const Stopwatch watch;
    run();
    least = std::min(least, watch.ns() / static_cast<double>(side * side));
  }
  return least;
}

using Plain = double (*)(double, double);

void row(const std::string& name, const std::string& text, Tier first, std::int64_t side,
         Plain plain) {
  const RealFormula formula = parse_formula(text, std::vector<std::string>{"x", "y"}).value();
  FormulaEvaluator evaluator(formula, first);
  std::vector<std::vector<Rational>> points;
  for (std::int64_t i = 0; i < side * side; ++i)
    points.push_back(
        {Rational(Integer(i % side), Integer(side)), Rational(Integer(i / side), Integer(side))});
  std::int64_t sum = 0;
  const double ours = ns_a_point(kRepetitions, side, [&] {
    for (const std::vector<Rational>& p : points) sum += evaluator.round_to_multiple(p)->multiple;
  });
  double total = 0;
  const double peer = ns_a_point(kRepetitions, side, [&] {
    for (std::int64_t i = 0; i < side * side; ++i)
      total += plain(static_cast<double>(i % side) / static_cast<double>(side),
                     static_cast<double>(i / side) / static_cast<double>(side));
  });
  const FormulaEvaluator::Counts& counts = evaluator.counts();
  std::printf(
      "{\"row\":\"formula_%s\",\"ours\":%.4g,\"peer\":%.4g,\"unit\":\"ns\",\"binary64\":%llu,"
      "\"exact\":%llu,"
      "\"wide\":%llu,\"mean\":%.9g,\"plain_mean\":%.9g}\n",
      name.c_str(), ours, peer, static_cast<unsigned long long>(counts.binary64),
      static_cast<unsigned long long>(counts.exact), static_cast<unsigned long long>(counts.wide),
      static_cast<double>(sum) * 0x1p-20 / kRepetitions / static_cast<double>(side * side),
      total / kRepetitions / static_cast<double>(side * side));
  std::fflush(stdout);
}

double waves(double x, double y) { return 0.15 + 0.1 * std::sin(6 * x) * std::cos(6 * y); }
double bump(double x, double y) { return std::exp(-(x * x + y * y) / 0.02); }
double distance(double x, double y) { return std::sqrt(x * x + y * y) / 3; }

}  // namespace
}  // namespace veritope::bench

int main() {
  using namespace veritope::bench;
  const std::string text = "0.15 + 0.1*sin(6*x)*cos(6*y)";
  row("waves", text, Tier::kBinary64, kSide, waves);
  row("bump", "exp(-(x^2 + y^2)/0.02)", Tier::kBinary64, kSide, bump);
  row("distance", "sqrt(x^2 + y^2)/3", Tier::kBinary64, kSide, distance);
  row("waves_fractions", text, Tier::kExact, 50, waves);
  return 0;
}
