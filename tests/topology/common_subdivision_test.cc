// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/common_subdivision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "tests/support/collar_examples.h"
#include "tests/support/complex_oracle.h"

namespace veritope {
namespace {

using octree_shapes::build;
using octree_shapes::Cells;
using octree_shapes::grid;

using Segment = std::pair<oracle::GridPoint, oracle::GridPoint>;
Segment segment(const CommonSubdivision& c, std::uint32_t e) {
  return {grid(c, c.edges()[e].lower), grid(c, c.edges()[e].upper)};
}

oracle::GridSquare square(const CommonSubdivision& c, std::uint32_t f) {
  const CommonSubdivision::Face& face = c.faces()[f];
  return {face.axis, grid(c, face.corner), 1 << (c.cells().finest_level() - face.level)};
}

// The oracle numbers cells by their place in the list: both are compared through keys.
void expect_as_defined(const Cells& cells) {
  SCOPED_TRACE("cells " + octree_shapes::text(cells));
  const CommonSubdivision got = build(cells);
  const oracle::BruteComplex want = oracle::brute_complex(cells, oracle::EdgeRule::kEveryVertex);

  std::set<oracle::GridPoint> points;
  for (std::uint32_t v = 0; v < got.num_vertices(); ++v) points.insert(grid(got, v));
  EXPECT_EQ(points, std::set<oracle::GridPoint>(want.vertices.begin(), want.vertices.end()));
  EXPECT_EQ(points.size(), got.num_vertices());

  std::set<Segment> segments;
  for (std::uint32_t e = 0; e < got.num_edges(); ++e) segments.insert(segment(got, e));
  EXPECT_EQ(segments, std::set<Segment>(want.edges.begin(), want.edges.end()));
  EXPECT_EQ(segments.size(), got.num_edges());

  std::set<oracle::GridSquare> squares;
  for (std::uint32_t f = 0; f < got.num_faces(); ++f) squares.insert(square(got, f));
  EXPECT_EQ(squares, std::set<oracle::GridSquare>(want.faces.begin(), want.faces.end()));
  ASSERT_EQ(squares.size(), got.num_faces());

  for (std::uint32_t f = 0; f < got.num_faces(); ++f) {
    const auto at = static_cast<std::size_t>(
        std::lower_bound(want.faces.begin(), want.faces.end(), square(got, f)) -
        want.faces.begin());
    std::set<Segment> edges, want_edges;
    for (const std::uint32_t e : got.edges_of_face(f)) edges.insert(segment(got, e));
    for (const std::size_t e : want.face_edges[at]) want_edges.insert(want.edges[e]);
    EXPECT_EQ(edges, want_edges);
    EXPECT_EQ(edges.size(), got.edges_of_face(f).size());
    std::set<OctreeKey> around, want_around;
    for (const std::uint32_t cell : {got.faces()[f].below, got.faces()[f].above})
      if (cell != CommonSubdivision::kNone) around.insert(got.cells()[cell]);
    for (const std::size_t cell : want.face_cells[at])
      want_around.insert(OctreeKey::make(cells[cell]).value());
    EXPECT_EQ(around, want_around);
  }
}

// What makes it a regular cell complex, and the names.
void expect_regular(const CommonSubdivision& c) {
  for (std::uint32_t f = 0; f < c.num_faces(); ++f) {
    const CommonSubdivision::Face& face = c.faces()[f];
    std::map<std::uint32_t, int> ends;
    for (const std::uint32_t e : c.edges_of_face(f)) {
      EXPECT_NE(c.edge_axis(e), face.axis);
      ++ends[c.edges()[e].lower];
      ++ends[c.edges()[e].upper];
    }
    EXPECT_EQ(ends.size(), c.edges_of_face(f).size()) << "face " << f;
    for (const auto& [v, n] : ends) EXPECT_EQ(n, 2) << "face " << f << " vertex " << v;
    if (f > 0) {
      EXPECT_LT(std::tuple(c.faces()[f - 1].corner, c.faces()[f - 1].axis),
                std::tuple(face.corner, face.axis));
    }
    for (const std::uint32_t cell : {face.below, face.above})
      if (cell != CommonSubdivision::kNone) {
        EXPECT_EQ(std::ranges::count(c.faces_of_cell(cell), f), 1);
      }
  }
  for (std::uint32_t e = 0; e < c.num_edges(); ++e) {
    const auto lower = c.point(c.edges()[e].lower), upper = c.point(c.edges()[e].upper);
    for (unsigned a = 0; a < 3; ++a) EXPECT_EQ(lower[a] < upper[a], a == c.edge_axis(e));
    if (e > 0) {
      EXPECT_LT(std::tuple(c.edges()[e - 1].lower, c.edge_axis(e - 1)),
                std::tuple(c.edges()[e].lower, c.edge_axis(e)));
    }
  }
  for (std::uint32_t v = 1; v < c.num_vertices(); ++v) {
    const auto p = c.point(v - 1), q = c.point(v);
    EXPECT_LT(std::tuple(p[2], p[1], p[0]), std::tuple(q[2], q[1], q[0]));
  }
  for (std::uint32_t cell = 0; cell < c.num_cells(); ++cell) {  // its boundary is a sphere
    std::set<std::uint32_t> edges, vertices;
    for (const std::uint32_t f : c.faces_of_cell(cell))
      edges.insert(c.edges_of_face(f).begin(), c.edges_of_face(f).end());
    for (const std::uint32_t e : edges) vertices.insert({c.edges()[e].lower, c.edges()[e].upper});
    EXPECT_EQ(vertices.size() + c.faces_of_cell(cell).size(), edges.size() + 2) << "cell " << cell;
  }
}

void expect_counts(const Cells& cells, std::uint32_t vertices, std::uint32_t edges,
                   std::uint32_t faces) {
  const CommonSubdivision c = build(cells);
  EXPECT_EQ(c.num_vertices(), vertices) << octree_shapes::text(cells);
  EXPECT_EQ(c.num_edges(), edges) << octree_shapes::text(cells);
  EXPECT_EQ(c.num_faces(), faces) << octree_shapes::text(cells);
  expect_regular(c);
}

// PROVES COLLAR-1.SUBDIVISION
TEST(CommonSubdivision, OfFewCellsHasTheCountsOfAHandDrawing) {
  expect_counts({{0, 0, 0, 0}}, 8, 12, 6);
  expect_counts({{20, 0xfffff, 0, 5}}, 8, 12, 6);
  expect_counts({{1, 0, 0, 0}, {1, 1, 0, 0}}, 12, 20, 11);
  // A cell of half the size on a face: four quadrants there, five more vertices on that face; four corners away from it.
  expect_counts({{1, 0, 0, 0}, {2, 2, 0, 0}}, 8 + 5 + 4, (12 + 4 + 4) + 4 + 4, 5 + 4 + 5);
  // They touch along half an edge: it is split, and shared.
  expect_counts({{1, 0, 0, 0}, {2, 2, 2, 0}}, 8 + 8 - 1, 12 + 1 + 11, 12);
  // Along 5/8 to 6/8 of the edge: three parts.
  expect_counts({{1, 0, 0, 0}, {4, 8, 8, 5}}, 8 + 8, 12 + 2 + 11, 12);
  // In a vertex only.
  expect_counts({{1, 0, 0, 0}, {2, 2, 2, 2}}, 15, 24, 12);
  // The smallest cell on the face of the largest: three quadrants a level and the last one.
  const CommonSubdivision deep = build({{1, 0, 0, 0}, {20, 1u << 19, 0, 0}});
  EXPECT_EQ(deep.num_faces(), 5u + 3 * 19 + 1 + 5);
  expect_regular(deep);
}

// PROVES COLLAR-1.SUBDIVISION
TEST(CommonSubdivision, IsTheOneOfTheDefinitionOnRandomCells) {
  std::size_t tested = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Cells cells = octree_shapes::random_cells(
        random, 2 + static_cast<unsigned>(seed % 3 == 0), 1 + static_cast<unsigned>(seed % 5), 5);
    if (cells.empty() || cells.size() > 150) continue;
    expect_as_defined(cells);
    expect_regular(build(cells));
    if (HasFailure()) return;
    ++tested;
  }
  EXPECT_GT(tested, 250u);
}

TEST(CommonSubdivision, IsTheOneOfTheDefinitionWhereOnlyEdgesTouch) {
  expect_as_defined(octree_shapes::edge_contact_of_different_length());
  expect_regular(build(octree_shapes::edge_contact_of_different_length()));
}

TEST(CommonSubdivision, IsRegularOnShellsOfMixedLevels) {
  for (const octree_shapes::CollarExample& example : octree_shapes::collar_examples()) {
    if (example.cells.size() > 12000) continue;
    SCOPED_TRACE(example.name);
    expect_regular(build(example.cells));
  }
}

TEST(CommonSubdivision, OverTheLimitOfFacesIsRefused) {
  const Cells cells{{1, 0, 0, 0}, {1, 1, 0, 0}};
  const auto with_limit = [&](std::uint32_t faces) {
    return CommonSubdivision::build(OctreeKeySet::make(std::span<const OctreeCell>(cells)).value(),
                                    faces);
  };
  EXPECT_TRUE(with_limit(11));
  ASSERT_FALSE(with_limit(10));
  EXPECT_EQ(with_limit(10).error().code, Code::kOverLimit);
  EXPECT_EQ(with_limit(10).error().message, "2 octree cells have more than 10 faces");
}

TEST(CommonSubdivision, DoesNotDependOnTheOrderOfTheCells) {
  Cells cells = octree_shapes::edge_contact_of_different_length();
  const CommonSubdivision a = build(cells);
  Random random(3);
  std::shuffle(cells.begin(), cells.end(), random);
  const CommonSubdivision b = build(cells);
  ASSERT_EQ(a.num_faces(), b.num_faces());
  for (std::uint32_t f = 0; f < a.num_faces(); ++f) {
    EXPECT_EQ(a.faces()[f].corner, b.faces()[f].corner);
    EXPECT_EQ(a.faces()[f].below, b.faces()[f].below);
    EXPECT_TRUE(std::ranges::equal(a.edges_of_face(f), b.edges_of_face(f)));
  }
}

}  // namespace
}  // namespace veritope
