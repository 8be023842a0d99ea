// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_dms_iso.cc: --rounds N --seed S [--cells N] [--kind K] [--clouds 1]. Isosurfaces of polynomial attributes
// (tests/support/dms_level_sets.h), N of each kind, half of them after affine maps: those certified with a topology
// that is not theirs, or at a singular level. One JSON line a figure.
#include <cstdio>
#include <string>

#include "bench/arguments.h"
#include "solids/dms/dms_iso.h"
#include "tests/support/dms_level_sets.h"

int main(int argc, char** argv) {
  using namespace veritope;
  std::uint64_t rounds = 30, seed = 1, cells = 40'000, only = kLevelSetKinds, clouds = 0;
  bench::read_arguments(argc, argv,
                        {{"--rounds", &rounds},
                         {"--seed", &seed},
                         {"--cells", &cells},
                         {"--kind", &only},
                         {"--clouds", &clouds}});
  std::uint64_t certified = 0, undecided = 0, broken = 0, singular = 0;
  for (int kind = 0; kind < kLevelSetKinds; ++kind) {
    if (only < kLevelSetKinds && static_cast<int>(only) != kind) continue;
    for (std::uint64_t round = 0; round < rounds; ++round) {
      const std::uint64_t number = seed * 1'000'000 + static_cast<std::uint64_t>(kind) * 10'000;
      const LevelSet set = draw_level_set(number + round, static_cast<LevelSetKind>(kind),
                                          clouds != 0, round % 2 != 0);
      DmsIsoOptions options;
      options.level = set.level;
      options.within = Rational(8);
      options.max_cells = cells;
      const auto iso = find_dms_iso(set.model, options);
      if (!iso) return 1;
      singular += set.is_singular ? 1 : 0;
      const bool is_right =
          !set.is_singular && iso->components == set.components && iso->euler == set.euler;
      (iso->certified ? is_right ? certified : broken : undecided) += 1;
      if ((iso->certified && is_right) || (set.is_singular && !iso->certified)) {
        if (only == kLevelSetKinds) continue;
      }
      std::fprintf(stderr,
                   "%s: certified %d, %llu components, euler %lld, %llu cells, %llu undecided\n",
                   set.text.c_str(), iso->certified ? 1 : 0,
                   static_cast<unsigned long long>(iso->components),
                   static_cast<long long>(iso->euler), static_cast<unsigned long long>(iso->cells),
                   static_cast<unsigned long long>(iso->num_undecided));
    }
  }
  std::printf(
      "{\"name\":\"dms_iso\",\"value\":%llu,\"goal\":\"0 wrong certified topologies\","
      "\"certified\":%llu,\"undecided\":%llu,\"singular\":%llu}\n",
      static_cast<unsigned long long>(broken), static_cast<unsigned long long>(certified),
      static_cast<unsigned long long>(undecided), static_cast<unsigned long long>(singular));
  return broken == 0 ? 0 : 1;
}
