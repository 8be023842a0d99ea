// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/thicken.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>

#include "tests/support/collar_examples.h"
#include "topology/collar.h"

namespace veritope {
namespace {

using octree_shapes::Cells;

OctreeKeySet keys(const Cells& cells) {
  return OctreeKeySet::make(std::span<const OctreeCell>(cells)).value();
}
CommonSubdivision build(const Cells& cells) {
  return CommonSubdivision::build(keys(cells)).value();
}

// Every cell of `cells` is one of the complex.
void expect_contains(const CommonSubdivision& complex, const Cells& cells) {
  for (const OctreeCell& cell : cells)
    EXPECT_TRUE(std::ranges::binary_search(complex.cells().keys(), OctreeKey::make(cell).value()))
        << to_string(cell);
}

TEST(Thicken, LeavesManifoldsAsTheyAre) {
  const CommonSubdivision wall = build(octree_shapes::thick_wall());
  EXPECT_TRUE(cells_at_defects(wall, analyse_boundary(wall)).empty());
  EXPECT_EQ(thicken_to_manifold(keys(octree_shapes::thick_wall())).value().num_cells(),
            wall.num_cells());
}

TEST(Thicken, FillsOneQuadrantBesideABadEdgeAndAllOctantsAtABadVertex) {
  const CommonSubdivision at_edge = build(octree_shapes::edge_contact_of_different_length());
  const std::vector<OctreeKey> one = cells_at_defects(at_edge, analyse_boundary(at_edge));
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].cell(), (OctreeCell{4, 7, 8, 14})) << "beside the smaller of the two cells";
  const CommonSubdivision pits = build(octree_shapes::pits_with_common_edge());
  EXPECT_EQ(cells_at_defects(pits, analyse_boundary(pits)).size(), 1u);
  const CommonSubdivision at_vertex = build(octree_shapes::pits_with_common_vertex());
  const std::vector<OctreeKey> octants = cells_at_defects(at_vertex, analyse_boundary(at_vertex));
  EXPECT_EQ(octants.size(), 2u) << "one of each pit";
  // At the root's corner, and where the octants around are of several sizes.
  const CommonSubdivision corner = build({{1, 0, 0, 0}, {3, 4, 4, 4}});
  EXPECT_EQ(cells_at_defects(corner, analyse_boundary(corner)).size(), 6u);
}

TEST(Thicken, TurnsTheContactsIntoCollars) {
  for (const Cells& cells :
       {octree_shapes::edge_contact_of_different_length(), octree_shapes::pits_with_common_edge(),
        octree_shapes::pits_with_common_vertex()}) {
    const CommonSubdivision complex = thicken_to_manifold(keys(cells)).value();
    expect_contains(complex, cells);
    const Collar collar = find_collar(complex).value();
    EXPECT_EQ(collar.outcome, CollarOutcome::kCollar) << collar.message;
  }
}

TEST(Thicken, EndsInAManifoldAroundAnyCells) {
  std::size_t grown = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    Random random(seed);
    const Cells cells = octree_shapes::random_cells(random, 3, 1 + static_cast<unsigned>(seed % 4),
                                                    4 + static_cast<unsigned>(seed % 7));
    if (cells.empty()) continue;
    SCOPED_TRACE("seed " + std::to_string(seed) + " cells " + octree_shapes::text(cells));
    const CommonSubdivision complex = thicken_to_manifold(keys(cells)).value();
    EXPECT_TRUE(analyse_boundary(complex).is_manifold());
    EXPECT_EQ(complex.cells().finest_level(), keys(cells).finest_level());
    expect_contains(complex, cells);
    grown += complex.num_cells() > cells.size();
  }
  EXPECT_GT(grown, 300u);
}

// One level finer within some distance of a random point.
std::function<unsigned(const OctreeCell&)> finer_near_a_point(unsigned fine, std::uint64_t seed) {
  Random random(seed);
  std::array<std::int64_t, 3> centre;  // on a grid of half the finest cells
  for (std::int64_t& x : centre) x = static_cast<std::int64_t>(random.below(2u << fine));
  const std::int64_t near =
      (1 << (fine - 2)) + static_cast<std::int64_t>(random.below(3u << (fine - 2)));
  return [=](const OctreeCell& c) {
    const std::array<std::uint32_t, 3> index{c.i, c.j, c.k};
    std::int64_t square = 0;
    for (unsigned a = 0; a < 3; ++a) {
      const std::int64_t d = ((2 * std::int64_t{index[a]} + 1) << (fine - c.level)) - centre[a];
      square += d * d;
    }
    return square < near * near ? fine : fine - 1;
  };
}

// Most such covers are not manifolds, because of places where levels change.
TEST(Thicken, MakesCollarsOfCoversOfMixedLevels) {
  int with_defects = 0;
  for (std::uint64_t seed = 1; seed <= 36; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto genus = static_cast<int>(seed % 3);
    const unsigned fine = genus == 2 ? 7 : 6;  // the double torus has thin bars
    const octree_shapes::VoxelSolid solid = genus == 0   ? octree_shapes::ball(fine)
                                            : genus == 1 ? octree_shapes::solid_torus(fine)
                                                         : octree_shapes::double_torus(fine);
    const Cells cells = octree_shapes::cover(solid, finer_near_a_point(fine, seed));
    with_defects += !analyse_boundary(build(cells)).is_manifold();
    const CommonSubdivision complex = thicken_to_manifold(keys(cells)).value();
    expect_contains(complex, cells);
    const Collar collar = find_collar(complex).value();
    ASSERT_EQ(collar.outcome, CollarOutcome::kCollar) << collar.message;
    EXPECT_EQ(collar.boundary.components[0].genus(), genus);
    EXPECT_EQ(replay_collapse(complex, collar.d_plus_faces(), collar.collapses).fault,
              CollapseFault::kNone);
  }
  EXPECT_GT(with_defects, 12);
}

TEST(Thicken, OverTheLimitOfFacesIsRefused) {
  EXPECT_EQ(thicken_to_manifold(keys(octree_shapes::thick_wall()), 100).error().code,
            Code::kOverLimit);
  // The cells themselves fit, what is to be added does not: 12 faces, then 5 more.
  const Cells cells{{1, 0, 0, 0}, {1, 1, 1, 0}};
  EXPECT_EQ(thicken_to_manifold(keys(cells), 12).error().code, Code::kOverLimit);
  EXPECT_EQ(thicken_to_manifold(keys(cells), 16).value().num_faces(), 16u);
}

}  // namespace
}  // namespace veritope
