// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_solvers.cc: compares the solver with polynomial systems whose roots are all known. One JSON line a figure.
//   soak_solvers [--systems N] [--seed S]     N systems of each kind and dimension (default 60, 1)
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "bench/arguments.h"
#include "tests/interval/known_systems.h"

namespace {

using namespace veritope;
using known::Recipe;
using known::Tally;

struct Total {
  Tally tally;
  int systems = 0, incomplete = 0;
  double seconds = 0, worst = 0;

  void add(const Tally& t) {
    tally.missed += t.missed, tally.false_uniqueness += t.false_uniqueness;
    tally.simple += t.simple, tally.simple_isolated += t.simple_isolated;
    tally.multiple += t.multiple, tally.multiple_in_clusters += t.multiple_in_clusters;
  }
  void add(const Total& t) {
    add(t.tally);
    systems += t.systems, incomplete += t.incomplete, seconds += t.seconds;
    worst = t.worst > worst ? t.worst : worst;
  }
  bool is_good() const {
    return tally.missed == 0 && tally.false_uniqueness == 0 &&
           tally.simple_isolated * 100 >= tally.simple * 95;
  }
  void print(const char* name) const {
    std::printf(
        "{\"name\":\"solvers_%s\",\"value\":%d,\"goal\":\"0 missed, 0 false uniqueness claims, >= "
        "95 %% of the simple "
        "isolated\",\"systems\":%d,\"missed\":%d,\"false_uniqueness\":%d,\"simple\":%d,\"simple_"
        "isolated\":%d,\"multiple\":%d,"
        "\"multiple_in_clusters\":%d,\"incomplete\":%d,\"seconds\":%.2f,\"slowest\":%.3f}\n",
        name, tally.missed + tally.false_uniqueness, systems, tally.missed, tally.false_uniqueness,
        tally.simple, tally.simple_isolated, tally.multiple, tally.multiple_in_clusters, incomplete,
        seconds, worst);
    std::fflush(stdout);
  }
};

template <std::size_t N>
Total run(const Recipe& recipe, int count, std::uint64_t seed) {
  Random random(seed);
  Total out;
  for (int i = 0; i < count; ++i) {
    const auto system = known::draw<N>(random, recipe);
    const auto start = std::chrono::steady_clock::now();
    const auto report =
        polynomial_roots<N>(std::span<const Bezier<Rational, N>>(system.equations)).value();
    const double s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    Total one;
    one.add(judge(system, report));
    one.systems = 1, one.seconds = one.worst = s;
    one.incomplete = one.tally.multiple == 0 && !report.is_complete();
    if (!one.is_good())
      std::fprintf(stderr, "N %zu, seed %llu, case %d\n", N, static_cast<unsigned long long>(seed),
                   i);
    out.add(one);
  }
  return out;
}

Rational tenth_to(int n) {
  Rational out(1);
  for (int i = 0; i < n; ++i) out /= Rational(10);
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  int systems = 60;
  std::uint64_t seed = 1;
  bench::read_arguments(argc, argv, {{"--systems", &systems}, {"--seed", &seed}});
  const struct {
    const char* name;
    Recipe recipe;
  } kinds[] = {
      {"simple", {2, {}, false, false}},
      {"curved", {2, {}, false, true}},
      {"boundary", {2, {}, true, false}},
      {"close_1e-12", {1, tenth_to(12), false, false}},
      {"close_1e-20", {1, tenth_to(20), false, false}},
      {"close_1e-12_curved", {1, tenth_to(12), false, true}},
      {"double", {1, Rational(0), false, false}},
      {"double_boundary", {1, Rational(0), true, true}},
  };
  Total all;
  for (const auto& kind : kinds) {
    Total total = run<1>(kind.recipe, systems, seed);
    total.add(run<2>(kind.recipe, systems, seed));
    total.add(run<3>(kind.recipe, systems / 2, seed));
    total.add(run<4>(kind.recipe, systems / 4, seed));
    total.print(kind.name);
    all.add(total);
  }
  all.print("all");
  return all.is_good() ? 0 : 1;
}
