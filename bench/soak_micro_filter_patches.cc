// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_micro_filter_patches.cc: --cases N --curved N --points N --seed S. Random tiles (jacks and boxes) in
// random cells near the surface of solids of rational patches whose equations are known: balls with and without poles,
// shells, cylinders, a ball with a neck, tori. In affine cells most truths are known in fractions, witnesses included;
// in curved cells, which are one to one by construction, exact points of the tile must not contradict the status. One
// JSON line a kind: wrong results; undecided ones are counted; a wrong case goes to standard error.
#include <array>
#include <cstdio>
#include <string>

#include "bench/arguments.h"
#include "solids/patches/patch_complex.h"
#include "tests/support/round_truth.h"

namespace {

using namespace veritope;
using namespace veritope::round_truth;

struct Totals {
  std::uint64_t cases = 0, wrong = 0, known = 0, undecided_known = 0;
  std::array<std::uint64_t, 5> statuses{};
};

void judge(std::uint64_t seed, int number, bool is_affine, int points, Totals* totals) {
  Random random(seed * 1000003 + static_cast<std::uint64_t>(number));
  const auto kind = static_cast<Solid::Kind>(number % Solid::kNumKinds);
  const Case c = random_case(random, kind, is_affine);
  const PatchComplex complex = make_patch_complex(c.patches).value();
  const TileFilter filter = TileFilter::make(complex);
  const TileShape shape = micro_tiles::shape_of(c.tile);
  const CellFinding finding = filter.find({&c.map}, shape);
  std::optional<CellStatus> truth;
  if (is_affine) truth = status_of(c.solid, c.parts());
  const std::string fault = fault_of(c, shape, finding, truth, points, random);
  ++totals->cases;
  ++totals->statuses[static_cast<std::size_t>(finding.status)];
  if (truth && *truth != CellStatus::kTouching) {
    ++totals->known;
    if (finding.status == CellStatus::kUndecided) {
      ++totals->undecided_known;
      std::fprintf(stderr, "undecided, but %s: seed %llu, case %d\n", cell_status_name(*truth),
                   static_cast<unsigned long long>(seed), number);
    }
  }
  if (fault.empty()) return;
  ++totals->wrong;
  std::fprintf(stderr, "wrong: %s, seed %llu, case %d\n%s", fault.c_str(),
               static_cast<unsigned long long>(seed), number, c.text().c_str());
}

std::uint64_t print(const char* name, const Totals& t) {
  std::printf("{\"name\":\"micro_filter_patches_%s\",\"value\":%llu,\"goal\":\"0\",\"cases\":%llu",
              name, static_cast<unsigned long long>(t.wrong),
              static_cast<unsigned long long>(t.cases));
  for (std::size_t s = 0; s < t.statuses.size(); ++s)
    std::printf(",\"%s\":%llu", cell_status_name(static_cast<CellStatus>(s)),
                static_cast<unsigned long long>(t.statuses[s]));
  std::printf(",\"known\":%llu,\"undecided_known\":%llu}\n",
              static_cast<unsigned long long>(t.known),
              static_cast<unsigned long long>(t.undecided_known));
  std::fflush(stdout);
  return t.wrong;
}

}  // namespace

int main(int argc, char** argv) {
  int cases = 1200, curved = 300, points = 500;
  std::uint64_t seed = 1;
  bench::read_arguments(
      argc, argv,
      {{"--cases", &cases}, {"--curved", &curved}, {"--points", &points}, {"--seed", &seed}});
  std::array<Totals, 2> totals;
  for (int n = 0; n < cases; ++n) judge(seed, n, true, points, &totals[0]);
  for (int n = 0; n < curved; ++n) judge(seed + 1, n, false, points, &totals[1]);
  const std::uint64_t wrong = print("affine", totals[0]) + print("curved", totals[1]);
  return wrong == 0 ? 0 : 1;
}
