// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_micro_filter.cc: --cases N --curved N --points N --seed S. Random tiles (jacks and boxes) in random cells
// near the surface of random solids. In affine cells, against convex solids, convex bubbles, and blocks with notches,
// tunnels and bubbles, the truth is known in fractions, witnesses included. In curved cells, which are one to one by
// construction, exact points of the tile must not contradict the status. One JSON line a kind: wrong results, and those
// that are undecided although nothing touches; the solid, cell and tile of a wrong one go to standard error.
#include <array>
#include <cstdio>
#include <string>

#include "bench/arguments.h"
#include "tests/support/micro_truth.h"

namespace {

using namespace veritope;
using namespace veritope::micro_truth;

struct Totals {
  std::uint64_t cases = 0, wrong = 0, undecided = 0, undecided_contacts = 0;
  std::array<std::uint64_t, 5> statuses{};
};

void judge(const char* name, std::uint64_t seed, int number, bool is_curved, int points,
           Totals* totals) {
  Random random(seed * 1000003 + static_cast<std::uint64_t>(number));
  const bool has_blocks = number % 2 != 0;
  const Case c =
      is_curved ? random_curved_case(random, has_blocks) : random_case(random, has_blocks);
  const TileFilter filter = std::move(TileFilter::make(c.solid.mesh).value());
  const TileShape shape = micro_tiles::shape_of(c.tile);
  const CellMap cell{&c.map};
  const CellFinding finding = filter.find(cell, shape);
  std::optional<Facts> facts;
  if (!is_curved) facts = c.solid.facts(c.parts());
  std::string fault = fault_of(c, cell, shape, finding, facts);
  if (fault.empty() && is_curved) fault = contradiction_of(c, cell, finding.status, points, random);
  ++totals->cases;
  ++totals->statuses[static_cast<std::size_t>(finding.status)];
  if (finding.status == CellStatus::kUndecided) {
    const bool is_contact = facts && facts->status() == CellStatus::kTouching;
    ++(is_contact ? totals->undecided_contacts : totals->undecided);
    if (!is_contact)
      std::fprintf(stderr, "undecided: %s, seed %llu, case %d\n", name,
                   static_cast<unsigned long long>(seed), number);
  }
  if (fault.empty()) return;
  ++totals->wrong;
  std::fprintf(stderr, "wrong: %s: %s, seed %llu, case %d\n%s", name, fault.c_str(),
               static_cast<unsigned long long>(seed), number, c.text().c_str());
}

std::uint64_t print(const char* name, const Totals& t) {
  std::printf("{\"name\":\"micro_filter_%s\",\"value\":%llu,\"goal\":\"0\",\"cases\":%llu", name,
              static_cast<unsigned long long>(t.wrong + t.undecided),
              static_cast<unsigned long long>(t.cases));
  for (std::size_t s = 0; s < t.statuses.size(); ++s)
    std::printf(",\"%s\":%llu", cell_status_name(static_cast<CellStatus>(s)),
                static_cast<unsigned long long>(t.statuses[s]));
  std::printf(",\"wrong\":%llu,\"undecided_contacts\":%llu}\n",
              static_cast<unsigned long long>(t.wrong),
              static_cast<unsigned long long>(t.undecided_contacts));
  std::fflush(stdout);
  return t.wrong + t.undecided;
}

}  // namespace

int main(int argc, char** argv) {
  int cases = 2000, curved = 200, points = 10000;
  std::uint64_t seed = 1;
  bench::read_arguments(
      argc, argv,
      {{"--cases", &cases}, {"--curved", &curved}, {"--points", &points}, {"--seed", &seed}});
  std::array<Totals, 3> totals;
  for (int n = 0; n < cases; ++n) {
    const bool has_blocks = n % 2 != 0;
    judge(has_blocks ? "blocks" : "convex", seed, n, false, 0, &totals[has_blocks ? 1 : 0]);
  }
  for (int n = 0; n < curved; ++n) judge("curved", seed + 1, n, true, points, &totals[2]);
  const std::uint64_t wrong =
      print("convex", totals[0]) + print("blocks", totals[1]) + print("curved", totals[2]);
  return wrong == 0 ? 0 : 1;
}
