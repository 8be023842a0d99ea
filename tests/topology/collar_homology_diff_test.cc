// SPDX-License-Identifier: LGPL-3.0-or-later
// Betti numbers of |K| by GUDHI's cubical complexes over the voxels of the finest level: a collar of genus g has 1, 2g, 1. They
// must agree with what K1 to K3 found; they could never stand in for K3 (the knotted collar).
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "tests/support/betti_numbers.h"
#include "tests/support/collar_examples.h"
#include "topology/collar.h"

namespace veritope {
namespace {

#ifdef VT_HAVE_GUDHI

using octree_shapes::Cells;

TEST(CollarHomology, IsThatOfTheProductOnEveryExample) {
  for (const octree_shapes::CollarExample& example : octree_shapes::collar_examples()) {
    SCOPED_TRACE(example.name);
    const Betti got = betti_numbers(example.cells);
    const Collar collar =
        find_collar(CommonSubdivision::build(
                        OctreeKeySet::make(std::span<const OctreeCell>(example.cells)).value())
                        .value())
            .value();
    if (collar.outcome == CollarOutcome::kCollar) {
      Betti want{};
      for (const CollarBody& body : collar.bodies) {
        const auto genus = static_cast<int>(collar.boundary.components[body.d_plus].genus());
        want = {want[0] + 1, want[1] + 2 * genus, want[2] + 1};
      }
      EXPECT_EQ(got, want);
    }
    if (!collar.boundary.is_manifold()) continue;
    // Any compact 3-manifold in space: one b0 a body, one b2 a boundary component but one a body, b1 = sum of genus.
    std::int64_t genus = 0;
    for (const BoundaryComponent& c : collar.boundary.components) genus += c.genus();
    const auto bodies = static_cast<int>(collar.boundary.bodies.size()),
               sides = static_cast<int>(collar.boundary.components.size());
    EXPECT_EQ(got, (Betti{bodies, static_cast<int>(genus), sides - bodies}));
  }
}

// PROVES COLLAR-1.K3
TEST(CollarHomology, OfAKnottedCollarIsThatOfAProduct) {
  EXPECT_EQ(betti_numbers(octree_shapes::tube_in_torus(true)), (Betti{1, 2, 1}));
  EXPECT_EQ(betti_numbers(octree_shapes::tube_in_torus(false)), (Betti{1, 2, 1}));
}

TEST(CollarHomology, IsThatOfTheSetAfterRandomSubdivision) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    Cells wall = octree_shapes::block(4, {2, 2, 2}, {12, 12, 12});
    for (int n = 0; n < 12; ++n) {  // voids, pits and tunnels, as they fall
      std::array<int, 3> low, high;
      for (unsigned a = 0; a < 3; ++a) {
        low[a] = static_cast<int>(random.below(12));
        high[a] = low[a] + 1 + static_cast<int>(random.below(random.below(3) == 0 ? 12 : 3));
      }
      wall = octree_shapes::without(wall, octree_shapes::block(4, low, high));
    }
    const Cells cells =
        octree_shapes::refine(wall, [&](const OctreeCell&) { return random.below(20) == 0; });
    const auto complex =
        CommonSubdivision::build(OctreeKeySet::make(std::span<const OctreeCell>(cells)).value())
            .value();
    const Betti got = betti_numbers(cells);
    // chi of |K| is a topological invariant, manifold or not.
    const std::int64_t chi = std::int64_t{complex.num_vertices()} - complex.num_edges() +
                             complex.num_faces() - complex.num_cells();
    EXPECT_EQ(got[0] - got[1] + got[2], chi) << "seed " << seed;
  }
}

#else

TEST(CollarHomology, IsThatOfTheProductOnEveryExample) {
  GTEST_SKIP() << "libgudhi-dev is not installed";
}

#endif

}  // namespace
}  // namespace veritope
