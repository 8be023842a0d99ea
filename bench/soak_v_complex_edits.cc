// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_v_complex_edits.cc: --sequences N --steps K --seed S : random sequences of edits of V-complexes; after
// each step the invariants, dd = 0, links, genera and the Euler characteristic, and in every tenth sequence the Betti
// numbers. A sequence that breaks a law is shrunk and printed; one JSON line a figure.
#include <cstdint>
#include <cstdio>
#include <string>

#include "bench/arguments.h"
#include "bench/stopwatch.h"
#include "tests/support/v_complex_edits.h"

int main(int argc, char** argv) {
  using namespace veritope;
  std::uint64_t sequences = 1000, steps = 50, seed = 1;
  bench::read_arguments(argc, argv,
                        {{"--sequences", &sequences}, {"--steps", &steps}, {"--seed", &seed}});
  const bench::Stopwatch watch;
  v_edits::Tally tally;
  std::uint64_t broken = 0;
  for (std::uint64_t i = 0; i < sequences; ++i) {
    const v_edits::Sequence sequence = v_edits::random_sequence(seed * 10000000 + i, steps);
    const std::string fault = v_edits::run_and_shrink(sequence, i % 10 == 0, &tally);
    if (fault.empty()) continue;
    ++broken;
    std::fprintf(stderr, "sequence %llu: %s\n", static_cast<unsigned long long>(i), fault.c_str());
  }
  const auto number = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
  std::printf(
      "{\"name\":\"v_complex_edits_broken\",\"value\":%llu,\"goal\":\"0\",\"sequences\":%llu,"
      "\"steps\":%llu,"
      "\"edits_done\":%llu,\"edits_refused\":%llu}\n",
      number(broken), number(sequences), number(steps), number(tally.done), number(tally.refused));
  std::printf("{\"name\":\"v_complex_edits_seconds\",\"value\":%.0f}\n", watch.ns() * 1e-9);
  return broken == 0 ? 0 : 1;
}
