// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/collar.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/collar_examples.h"
#include "tests/support/complex_oracle.h"

namespace veritope {
namespace {

using octree_shapes::build;
using octree_shapes::Cells;

void expect_replays(const CommonSubdivision& complex, const Collar& collar) {
  const CollapseCheck check = replay_collapse(complex, collar.d_plus_faces(), collar.collapses);
  EXPECT_EQ(check.fault, CollapseFault::kNone) << check.message;
}

std::vector<int> genus_of_bodies(const Collar& collar) {
  std::vector<int> out;
  for (const CollarBody& body : collar.bodies)
    out.push_back(static_cast<int>(collar.boundary.components[body.d_plus].genus()));
  std::sort(out.begin(), out.end());
  return out;
}

// PROVES COLLAR-1, COLLAR-1.K3
TEST(Collar, IsFoundWhereThereIsOneAndRefusedWhereThereIsNone) {
  for (const octree_shapes::CollarExample& example : octree_shapes::collar_examples()) {
    SCOPED_TRACE(example.name);
    const CommonSubdivision complex = build(example.cells);
    const Collar collar = find_collar(complex).value();
    EXPECT_EQ(collar.outcome, example.outcome) << collar.message;
    EXPECT_EQ(collar.message.empty(), example.outcome == CollarOutcome::kCollar);
    if (collar.outcome != CollarOutcome::kCollar) continue;
    EXPECT_EQ(genus_of_bodies(collar), example.genus);
    expect_replays(complex, collar);
    for (const CollarBody& body : collar.bodies) EXPECT_TRUE(body.is_product);
  }
}

// "Voxel shells of sphere, torus, double torus collapse at once, onto either side": one attempt, no retry.
TEST(Collar, OfVoxelShellsCollapsesAtOnceOntoEitherSide) {
  for (const octree_shapes::CollarExample& example : octree_shapes::collar_examples()) {
    if (example.outcome != CollarOutcome::kCollar || example.genus.size() != 1 ||
        example.name == "the same without the knot")
      continue;
    const CommonSubdivision complex = build(example.cells);
    const ComplexBoundary boundary = analyse_boundary(complex);
    ASSERT_EQ(boundary.components.size(), 2u) << example.name;
    for (std::uint32_t side = 0; side < 2; ++side) {
      SCOPED_TRACE(example.name + ", side " + std::to_string(side));
      const std::uint32_t d_plus[] = {boundary.components[side].first_face};
      const Collar collar = find_collar(complex, {.d_plus = d_plus, .max_attempts = 1}).value();
      EXPECT_EQ(collar.outcome, CollarOutcome::kCollar) << collar.message;
      EXPECT_EQ(collar.bodies[0].d_plus, side);
      EXPECT_EQ(collar.bodies[0].d_minus, 1 - side);
      EXPECT_EQ(collar.bodies[0].attempts, 1u);
      EXPECT_EQ(collar.d_plus_faces(), boundary.faces_of(side));
      expect_replays(complex, collar);
    }
  }
}

// PROVES COLLAR-1.SUBDIVISION, COLLAR-1.K1
TEST(Collar, SeesCellsThatTouchAlongEdgesOfDifferentLength) {
  const Cells cells = octree_shapes::edge_contact_of_different_length();
  const CommonSubdivision complex = build(cells);
  const Collar collar = find_collar(complex).value();
  EXPECT_EQ(collar.outcome, CollarOutcome::kNotManifold);
  ASSERT_EQ(collar.boundary.bad_edges.size(), 1u);
  EXPECT_EQ(collar.boundary.bad_edges[0].num_faces, 4u);
  EXPECT_EQ(name_of(complex, 1, collar.boundary.bad_edges[0].edge), "edge (8 8 14)-(8 8 15) / 16");
  EXPECT_EQ(collar.message, "edge (8 8 14)-(8 8 15) / 16 has 4 boundary faces");
  EXPECT_TRUE(collar.boundary.bad_vertices.empty());
  for (const BoundaryComponent& c : collar.boundary.components) EXPECT_EQ(c.euler(), 2);
  ASSERT_EQ(collar.boundary.components.size(), 2u);
}

// The trap: everything else holds, and without the one bad edge nothing would be seen.
TEST(Collar, WouldBeAcceptedThereIfEdgesWereSplitByFaceNeighboursOnly) {
  const Cells cells = octree_shapes::edge_contact_of_different_length();
  for (const auto rule : {oracle::EdgeRule::kFaceNeighbours, oracle::EdgeRule::kEveryVertex}) {
    const oracle::BruteComplex brute = oracle::brute_complex(cells, rule);
    EXPECT_EQ(brute.bad_edges().size(), rule == oracle::EdgeRule::kFaceNeighbours ? 0u : 1u);
    EXPECT_TRUE(brute.bad_vertices().empty());
    const auto components = brute.boundary_components();
    ASSERT_EQ(components.size(), 2u);
    for (const auto& faces : components) {
      EXPECT_EQ(brute.euler(faces), 2);
      EXPECT_EQ(brute.collapse(faces), (std::array<std::size_t, 4>{}));
    }
  }
}

// PROVES COLLAR-1.K1
TEST(Collar, NeedsBothClausesOfK1) {
  const Cells vertex = octree_shapes::pits_with_common_vertex(),
              edge = octree_shapes::pits_with_common_edge();
  const CommonSubdivision at_vertex = build(vertex), at_edge = build(edge);
  const Collar a = find_collar(at_vertex).value(), b = find_collar(at_edge).value();
  EXPECT_TRUE(a.boundary.bad_edges.empty());
  ASSERT_EQ(a.boundary.bad_vertices.size(), 1u);
  EXPECT_EQ(a.boundary.bad_vertices[0].num_cycles, 2u);
  EXPECT_EQ(a.message, "the boundary faces at vertex (4 4 8) / 16 form 2 cycles");
  ASSERT_EQ(b.boundary.bad_edges.size(), 1u);
  EXPECT_TRUE(b.boundary.bad_vertices.empty());
  EXPECT_EQ(name_of(at_edge, 1, b.boundary.bad_edges[0].edge), "edge (4 4 8)-(4 4 9) / 16");
  // Nothing but K1 rejects them: both sides are whole components, and both complexes collapse onto the inner one.
  for (const Cells& cells : {vertex, edge}) {
    const oracle::BruteComplex brute = oracle::brute_complex(cells, oracle::EdgeRule::kEveryVertex);
    auto components = brute.boundary_components();
    ASSERT_EQ(components.size(), 2u);
    std::sort(components.begin(), components.end(),
              [](const auto& p, const auto& q) { return p.size() < q.size(); });
    EXPECT_EQ(brute.collapse(components[0]), (std::array<std::size_t, 4>{}));
  }
}

// PROVES COLLAR-1.K3
TEST(Collar, IsNotTakenForOneBecauseItsHomologyIsRight) {
  for (const bool knotted : {true, false}) {
    const CommonSubdivision complex = build(octree_shapes::tube_in_torus(knotted));
    const Collar collar = find_collar(complex).value();
    EXPECT_TRUE(collar.boundary.is_manifold());
    ASSERT_EQ(collar.boundary.components.size(), 2u);
    for (const BoundaryComponent& c : collar.boundary.components) EXPECT_EQ(c.genus(), 1);
    EXPECT_EQ(collar.outcome, knotted ? CollarOutcome::kUndecided : CollarOutcome::kCollar);
    EXPECT_EQ(collar.remaining[2] > 0, knotted);
    EXPECT_EQ(collar.remaining[3], 0u);
    EXPECT_EQ(collar.message.find(
                  "no order that was tried collapses the body of cell (level 6: 0 0 0): ") == 0,
              knotted);
  }
}

TEST(Collar, SaysWhyABodyIsNoProduct) {
  const auto message = [](const Cells& cells) { return find_collar(build(cells)).value().message; };
  EXPECT_EQ(message({{0, 0, 0, 0}}), "the body of cell (level 0: 0 0 0) has 1 boundary component");
  Cells tunnel = octree_shapes::without(octree_shapes::thick_wall(),
                                        octree_shapes::block(5, {6, 4, 15}, {7, 28, 16}));
  EXPECT_EQ(message(tunnel),
            "the body of cell (level 5: 4 4 4) has boundary components of genus 1 and 0");
}

// One body is a product, its neighbour is not: the outcome is the neighbour's, the first's collapses are kept.
TEST(Collar, KeepsWhatIsProvedOfOtherBodies) {
  Cells cells = octree_shapes::into_octant(octree_shapes::thick_wall(), 0, 0, 0);
  const auto add = [&](const Cells& more) { cells.insert(cells.end(), more.begin(), more.end()); };
  add({{2, 2, 0, 0}});
  const CommonSubdivision complex = build(cells);
  const Collar collar = find_collar(complex).value();
  EXPECT_EQ(collar.outcome, CollarOutcome::kNotProduct);
  ASSERT_EQ(collar.bodies.size(), 2u);
  EXPECT_TRUE(collar.bodies[0].is_product);
  EXPECT_FALSE(collar.bodies[1].is_product);
  EXPECT_EQ(collar.bodies[1].attempts, 0u);
  EXPECT_EQ(collar.collapses.cells.size(), collar.boundary.bodies[0].cells);
  // Without the other body the same collapses prove it.
  cells.pop_back();
  const Collar alone = find_collar(build(cells)).value();
  EXPECT_EQ(alone.outcome, CollarOutcome::kCollar);
  EXPECT_EQ(alone.collapses.size(), collar.collapses.size());
}

// Beside a knotted collar, which stays undecided, the collapses of the unknotted one still replay alone.
TEST(Collar, ForgetsTheCollapsesOfStuckBodiesOnly) {
  const Cells unknotted = octree_shapes::coarsen(octree_shapes::tube_in_torus(false));
  Cells cells = octree_shapes::into_octant(
      octree_shapes::coarsen(octree_shapes::tube_in_torus(true)), 1, 1, 1);
  const std::size_t knotted = cells.size();
  const Cells other = octree_shapes::into_octant(unknotted, 0, 0, 0);
  cells.insert(cells.end(), other.begin(), other.end());
  const Collar both = find_collar(build(cells)).value();
  EXPECT_EQ(both.outcome, CollarOutcome::kUndecided);
  ASSERT_EQ(both.bodies.size(), 2u);
  EXPECT_TRUE(both.bodies[0].is_product);
  EXPECT_FALSE(both.bodies[1].is_product);
  EXPECT_EQ(both.bodies[1].attempts, 8u);
  EXPECT_EQ(both.boundary.bodies[1].cells, knotted);
  const CommonSubdivision alone = build(other);
  const Collar one = find_collar(alone).value();
  EXPECT_EQ(one.outcome, CollarOutcome::kCollar);
  EXPECT_EQ(one.collapses.size(), both.collapses.size());
  expect_replays(alone, one);
}

TEST(Collar, RefusesChoicesOfDPlusThatNameNoSide) {
  const CommonSubdivision complex = build(octree_shapes::thick_wall());
  const ComplexBoundary boundary = analyse_boundary(complex);
  const auto code = [&](std::vector<std::uint32_t> faces, unsigned attempts = 1) {
    const auto collar = find_collar(complex, {.d_plus = faces, .max_attempts = attempts});
    return collar ? std::optional<Code>() : collar.error().code;
  };
  const std::uint32_t outer = boundary.components[0].first_face,
                      inner = boundary.components[1].first_face;
  std::uint32_t between = 0;
  while (complex.faces()[between].num_cells() != 2) ++between;
  EXPECT_EQ(code({outer, inner}), Code::kBadArgument);
  EXPECT_EQ(code({between}), Code::kBadArgument);
  EXPECT_EQ(code({complex.num_faces()}), Code::kBadArgument);
  EXPECT_EQ(code({inner}, 0), Code::kBadArgument);
  EXPECT_EQ(code({inner, boundary.faces_of(1).back()}), std::nullopt);
}

TEST(Collar, ResultDependsOnCellsAndOptionsAlone) {
  const Cells cells = octree_shapes::coarsen(octree_shapes::tube_in_torus(false));
  const CommonSubdivision complex = build(cells);
  const Collar a = find_collar(complex, {.seed = 5}).value(),
               b = find_collar(complex, {.seed = 5}).value();
  EXPECT_EQ(a.outcome, b.outcome);
  EXPECT_EQ(a.collapses, b.collapses);
}

}  // namespace
}  // namespace veritope
