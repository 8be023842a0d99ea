// SPDX-License-Identifier: LGPL-3.0-or-later
// Completeness of the axis codes: every ordered pair of triangles on a grid that triangle_triangle calls proper gets codes, and they hold by
// an independent reading of the page. If a pair ever got none, the certificate's design would be incomplete.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/certify/pair_code_check.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

void tell(const char* grid, const PairCodeTally& t) {
  std::printf("%s: %ld ordered pairs, %ld proper, longest code %ld\n", grid, t.pairs, t.proper, t.longest);
}

TEST(PairCodesDiff, EveryPairOfThe3x3x3Grid) {
  const PairCodeTally t = expect_codes_on_grid(3, 3, 3, 1);
  tell("3x3x3, all", t);
  EXPECT_EQ(t.pairs, 2876 * 2875);
  EXPECT_EQ(t.proper, 5336804);
}

TEST(PairCodesDiff, EveryPairOfTheFlat5x5Grid) {
  const PairCodeTally t = expect_codes_on_grid(5, 5, 1, 1);
  tell("5x5, all", t);
  EXPECT_EQ(t.proper, 1441876);
}

TEST(PairCodesDiff, SamplesOfThe4x4x4AndFlat7x7Grids) {
  tell("4x4x4, a part", expect_codes_on_grid(4, 4, 4, 0.001 * static_cast<double>(scaled(1))));
  tell("7x7, a part", expect_codes_on_grid(7, 7, 1, 0.003 * static_cast<double>(scaled(1))));
}

// Facets at a common vertex, where contacts are richest: all corners but one from a grid around it.
TEST(PairCodesDiff, PairsAtOneVertexOfThe5x5x5Grid) {
  GridTriangles grid(5, 5, 5);
  const std::uint32_t centre = 62;
  std::vector<std::size_t> at;
  for (std::size_t f = 0; f < grid.mesh.faces.size(); ++f)
    for (std::uint32_t v : grid.mesh.faces[f])
      if (v == centre) at.push_back(f);
  Random random(3);
  PairCodeTally tally;
  for (std::size_t f : at)
    for (std::size_t g : at)
      if (f != g && random.below(40) == 0 && !expect_codes(grid, f, g, tally)) return;
  tell("at one vertex of 5x5x5, a part", tally);
  EXPECT_GT(tally.proper, 100000);
}

}  // namespace
}  // namespace veritope
