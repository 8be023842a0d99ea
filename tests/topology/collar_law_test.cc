// SPDX-License-Identifier: LGPL-3.0-or-later
// Laws of K1 and of collars: symmetries, subdivision, and the links of all grid points.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <set>

#include "tests/support/collar_examples.h"
#include "tests/support/complex_oracle.h"
#include "topology/collar.h"

namespace veritope {
namespace {

using octree_shapes::build;
using octree_shapes::Cells;
using octree_shapes::grid;

// Bad edges as unit edges of the finest grid, bad vertices off them: what the oracle lists.
oracle::VoxelLinks links(const CommonSubdivision& c, const ComplexBoundary& boundary) {
  oracle::VoxelLinks out;
  std::set<oracle::GridPoint> ends;
  for (const BadEdge& bad : boundary.bad_edges) {
    EXPECT_EQ(bad.num_faces, 4u);
    const unsigned axis = c.edge_axis(bad.edge);
    oracle::GridPoint p = grid(c, c.edges()[bad.edge].lower);
    const oracle::GridPoint end = grid(c, c.edges()[bad.edge].upper);
    ends.insert(p);
    for (; p != end; ++p[axis]) out.bad_edges.insert({p, axis});
    ends.insert(end);
  }
  for (const BadVertex& bad : boundary.bad_vertices)
    if (!ends.contains(grid(c, bad.vertex))) out.bad_points.insert(grid(c, bad.vertex));
  return out;
}

// PROVES COLLAR-1.K1
TEST(CollarLaw, K1IsWhatTheLinksOfAllGridPointsSay) {
  int with_edges = 0, with_vertices_only = 0, manifolds = 0;
  for (std::uint64_t seed = 1; seed <= 2500; ++seed) {
    Random random(seed);
    const unsigned cells_in_16 = 1 + static_cast<unsigned>(seed % 6),
                   empty_in_16 = 3 + static_cast<unsigned>(seed / 6 % 10);
    const Cells cells = octree_shapes::random_cells(
        random, 2 + static_cast<unsigned>(seed % 4 == 0), cells_in_16, empty_in_16);
    if (cells.empty()) continue;
    const CommonSubdivision complex = build(cells);
    const ComplexBoundary boundary = analyse_boundary(complex);
    const oracle::VoxelLinks got = links(complex, boundary), want = oracle::voxel_links(cells);
    EXPECT_EQ(got.bad_edges, want.bad_edges)
        << "seed " << seed << " cells " << octree_shapes::text(cells);
    EXPECT_EQ(got.bad_points, want.bad_points)
        << "seed " << seed << " cells " << octree_shapes::text(cells);
    EXPECT_EQ(boundary.is_manifold(), want.bad_edges.empty() && want.bad_points.empty());
    with_edges += !want.bad_edges.empty();
    with_vertices_only += want.bad_edges.empty() && !want.bad_points.empty();
    manifolds += boundary.is_manifold();
  }
  EXPECT_GT(with_edges, 500);
  EXPECT_GT(with_vertices_only, 20);
  EXPECT_GT(manifolds, 300);
}

// All that does not depend on numbering.
struct Answer {
  CollarOutcome outcome;
  std::size_t bad_edges, bad_vertices, bodies;
  std::vector<std::array<std::int64_t, 4>> components;
  bool operator==(const Answer&) const = default;
  friend void PrintTo(const Answer& a, std::ostream* out) {
    *out << "outcome " << static_cast<int>(a.outcome) << ", bad edges " << a.bad_edges
         << ", vertices " << a.bad_vertices << ", bodies " << a.bodies << ", components";
    for (const auto& c : a.components)
      *out << " (V " << c[0] << " E " << c[1] << " F " << c[2] << " body " << c[3] << ")";
  }
};

Answer answer(const Cells& cells) {
  const CommonSubdivision complex = build(cells);
  const Collar collar = find_collar(complex).value();
  Answer out{collar.outcome,
             collar.boundary.bad_edges.size(),
             collar.boundary.bad_vertices.size(),
             collar.boundary.bodies.size(),
             {}};
  for (const BoundaryComponent& c : collar.boundary.components)
    out.components.push_back({static_cast<std::int64_t>(c.vertices),
                              static_cast<std::int64_t>(c.edges),
                              static_cast<std::int64_t>(c.faces),
                              collar.boundary.is_manifold()
                                  ? static_cast<std::int64_t>(collar.boundary.bodies[c.body].cells)
                                  : 0});
  std::sort(out.components.begin(), out.components.end());
  return out;
}

Cells shifted_by_half_a_root(const Cells& cells, unsigned mask) {
  Cells out = octree_shapes::into_octant(cells, 0, 0, 0);
  for (OctreeCell& c : out) {
    const std::uint32_t half = 1u << (c.level - 2);  // REQUIRES original levels of at least 1
    c.i += mask & 1 ? half : 0;
    c.j += mask & 2 ? half : 0;
    c.k += mask & 4 ? half : 0;
  }
  return out;
}

void expect_invariant(const Cells& cells, std::uint64_t seed) {
  const Answer want = answer(cells);
  Random random(seed);
  std::array<unsigned, 3> axes{0, 1, 2};
  std::shuffle(axes.begin(), axes.end(), random);
  const auto mirror = static_cast<unsigned>(random.below(8)),
             octant = static_cast<unsigned>(random.below(8));
  SCOPED_TRACE("seed " + std::to_string(seed) + " axes " + std::to_string(axes[0]) +
               std::to_string(axes[1]) + " mirror " + std::to_string(mirror) + " octant " +
               std::to_string(octant));
  EXPECT_EQ(answer(octree_shapes::transformed(cells, axes, mirror)), want);
  EXPECT_EQ(answer(octree_shapes::into_octant(cells, octant & 1, octant >> 1 & 1, octant >> 2)),
            want);
  EXPECT_EQ(answer(shifted_by_half_a_root(cells, octant)), want);
}

TEST(CollarLaw, TurnedMirroredMovedAndHalvedCellsGiveTheSameAnswer) {
  std::uint64_t seed = 1;
  for (const octree_shapes::CollarExample& example : octree_shapes::collar_examples()) {
    if (example.name == "one cell" || example.cells.size() > 20000) continue;
    SCOPED_TRACE(example.name);
    expect_invariant(example.cells, seed++);
  }
  for (; seed <= 300; ++seed) {
    Random random(seed);
    const Cells cells = octree_shapes::random_cells(random, 3, 3, 7);
    if (cells.empty()) continue;
    SCOPED_TRACE("cells " + octree_shapes::text(cells));
    expect_invariant(cells, seed);
  }
}

// |K| stays the same set: so must K1, the surfaces, and (not by proof, by experience) the greedy collapse.
TEST(CollarLaw, CellsInEightKeepTheAnswer) {
  const auto examples = octree_shapes::collar_examples();
  int trials = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const octree_shapes::CollarExample& example = examples[seed % examples.size()];
    if (example.cells.size() > 16000 || example.outcome == CollarOutcome::kUndecided) continue;
    SCOPED_TRACE(example.name + ", seed " + std::to_string(seed));
    Random random(seed);
    const std::uint64_t every = 2 + random.below(40);
    const Cells finer = octree_shapes::refine(
        example.cells, [&](const OctreeCell&) { return random.below(every) == 0; });
    const CommonSubdivision before = build(example.cells), after = build(finer);
    const Collar a = find_collar(before).value(), b = find_collar(after).value();
    EXPECT_EQ(b.outcome, example.outcome) << b.message;
    ASSERT_EQ(a.boundary.components.size(), b.boundary.components.size());
    EXPECT_EQ(a.boundary.bad_vertices.size(), b.boundary.bad_vertices.size());
    EXPECT_EQ(a.boundary.bad_edges.empty(), b.boundary.bad_edges.empty());
    std::vector<std::int64_t> chi_a, chi_b;
    for (const BoundaryComponent& c : a.boundary.components) chi_a.push_back(c.euler());
    for (const BoundaryComponent& c : b.boundary.components) chi_b.push_back(c.euler());
    std::sort(chi_a.begin(), chi_a.end());
    std::sort(chi_b.begin(), chi_b.end());
    EXPECT_EQ(chi_a, chi_b);
    if (b.outcome == CollarOutcome::kCollar) {
      EXPECT_EQ(replay_collapse(after, b.d_plus_faces(), b.collapses).fault, CollapseFault::kNone);
    }
    ++trials;
  }
  EXPECT_GT(trials, 30);
}

// The oracle collapses by rounds over all cells, another order: on random manifolds with two sides both must agree that it is a
// collar, or one of them be stuck; a collar that both refuse would have to be stuck twice.
TEST(CollarLaw, AgreesWithTheOracleOnRandomSmallBodies) {
  int collars = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Random random(seed);
    Cells wall = octree_shapes::without(octree_shapes::block(3, {1, 1, 1}, {7, 7, 7}),
                                        octree_shapes::block(3, {3, 3, 3}, {5, 5, 5}));
    for (std::uint64_t n = random.below(6); n > 0; --n)
      wall.erase(wall.begin() + static_cast<std::ptrdiff_t>(random.below(wall.size())));
    const Cells cells = octree_shapes::refine(
        octree_shapes::coarsen(wall), [&](const OctreeCell&) { return random.below(30) == 0; });
    SCOPED_TRACE("seed " + std::to_string(seed) + " cells " + octree_shapes::text(cells));
    const Collar collar = find_collar(build(cells)).value();
    const oracle::BruteComplex brute = oracle::brute_complex(cells, oracle::EdgeRule::kEveryVertex);
    EXPECT_EQ(collar.boundary.bad_edges.size(), brute.bad_edges().size());
    EXPECT_EQ(collar.boundary.bad_vertices.size(), brute.bad_vertices().size());
    const auto sides = brute.boundary_components();
    ASSERT_EQ(collar.boundary.components.size(), sides.size());
    std::vector<std::int64_t> got, want;
    for (const BoundaryComponent& c : collar.boundary.components) got.push_back(c.euler());
    for (const auto& side : sides) want.push_back(brute.euler(side));
    std::sort(got.begin(), got.end());
    std::sort(want.begin(), want.end());
    EXPECT_EQ(got, want);
    if (!collar.boundary.is_manifold()) continue;
    const bool collapses =
        sides.size() == 2 && brute.collapse(sides[0]) == std::array<std::size_t, 4>{};
    EXPECT_EQ(collar.outcome == CollarOutcome::kCollar, collapses) << collar.message;
    collars += collapses;
  }
  EXPECT_GT(collars, 100);
}

}  // namespace
}  // namespace veritope
