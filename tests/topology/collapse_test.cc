// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/collapse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "tests/support/collar_examples.h"
#include "topology/collar.h"

namespace veritope {
namespace {

using octree_shapes::build;
using octree_shapes::Cells;

// A wall of 26 cells around one, some in eight: small, with all kinds of incidence.
Cells small_wall() {
  Cells cells =
      octree_shapes::without(octree_shapes::block(2, {0, 0, 0}, {3, 3, 3}), {{2, 1, 1, 1}});
  return octree_shapes::refine(cells, [](const OctreeCell& c) { return c.i == 2 && c.j < 2; });
}

struct Proof {
  std::vector<std::uint32_t> d_plus;
  CollapseSequence sequence;
};

Proof proof(const CommonSubdivision& complex) {
  const Collar collar = find_collar(complex).value();
  EXPECT_EQ(collar.outcome, CollarOutcome::kCollar) << collar.message;
  return {collar.d_plus_faces(), collar.collapses};
}

// K3 word by word: sets of faces of any dimension; "exactly one remaining proper coface", also counting dimensions above.
class SlowReplay {
 public:
  explicit SlowReplay(const CommonSubdivision& c) {
    const std::array<std::uint32_t, 4> size{c.num_vertices(), c.num_edges(), c.num_faces(),
                                            c.num_cells()};
    for (unsigned d = 0; d < 4; ++d) below_[d].resize(size[d]);
    for (std::uint32_t e = 0; e < size[1]; ++e)
      add(1, e, {{0, c.edges()[e].lower}, {0, c.edges()[e].upper}});
    for (std::uint32_t f = 0; f < size[2]; ++f) {
      for (const std::uint32_t e : c.edges_of_face(f)) add(2, f, {{1, e}});
      for (const std::uint32_t cell : {c.faces()[f].below, c.faces()[f].above})
        if (cell != CommonSubdivision::kNone) add(3, cell, {{2, f}});
    }
    // Faces of all dimensions, from below.
    for (unsigned d = 2; d < 4; ++d)
      for (auto& set : below_[d])
        for (const auto& [e, id] : std::set<Id>(set))
          set.insert(below_[e][id].begin(), below_[e][id].end());
    for (unsigned d = 0; d < 4; ++d)
      for (std::uint32_t id = 0; id < size[d]; ++id) {
        present_.insert({d, id});
        for (const Id& s : below_[d][id]) cofaces_[s].insert({d, id});
      }
  }

  bool accepts(const CommonSubdivision& c, const Proof& p) {
    std::set<Id> stays;
    for (const std::uint32_t f : p.d_plus) {
      if (f >= c.num_faces()) return false;
      stays.insert({2, f});
      stays.insert(below_[2][f].begin(), below_[2][f].end());
    }
    return remove(3, p.sequence.cells, stays) && remove(2, p.sequence.faces, stays) &&
           remove(1, p.sequence.edges, stays) && present_ == stays;
  }

 private:
  using Id = std::pair<unsigned, std::uint32_t>;
  void add(unsigned d, std::uint32_t id, std::initializer_list<Id> sides) {
    below_[d][id].insert(sides);
  }

  bool remove(unsigned d, const std::vector<Collapse>& collapses, const std::set<Id>& stays) {
    for (const Collapse& step : collapses) {
      const Id s{d - 1, step.face}, t{d, step.coface};
      if (stays.contains(s) || stays.contains(t) || !present_.contains(s) || !present_.contains(t))
        return false;
      std::set<Id> remaining;
      for (const Id& u : cofaces_[s])
        if (present_.contains(u)) remaining.insert(u);
      if (remaining != std::set<Id>{t}) return false;
      present_.erase(s);
      present_.erase(t);
    }
    return true;
  }

  std::array<std::vector<std::set<Id>>, 4> below_;
  std::map<Id, std::set<Id>> cofaces_;
  std::set<Id> present_;
};

TEST(Replay, AcceptsWhatTheSearchFoundAndTheDefinitionAgrees) {
  const CommonSubdivision complex = build(small_wall());
  const Proof p = proof(complex);
  EXPECT_EQ(replay_collapse(complex, p.d_plus, p.sequence).fault, CollapseFault::kNone);
  EXPECT_TRUE(SlowReplay(complex).accepts(complex, p));
  // Everything but the closed surface d+ goes, two cells a step.
  const ComplexBoundary boundary = analyse_boundary(complex);
  const BoundaryComponent& side = boundary.components[boundary.component_of_face[p.d_plus[0]]];
  EXPECT_EQ(2 * p.sequence.size() + side.vertices + side.edges + side.faces,
            std::uint64_t{complex.num_vertices()} + complex.num_edges() + complex.num_faces() +
                complex.num_cells());
}

// Collapses one cell onto one of its faces: first the face across, then the sides from there, then their far edges' ends.
CollapseSequence collapse_of_cube(const CommonSubdivision& cube, std::uint32_t onto) {
  CollapseSequence out;
  const auto has_edge = [&](std::uint32_t f, std::uint32_t e) {
    return std::ranges::find(cube.edges_of_face(f), e) != cube.edges_of_face(f).end();
  };
  std::uint32_t across = 0;
  while (across == onto || cube.faces()[across].axis != cube.faces()[onto].axis) ++across;
  out.cells.push_back({across, 0});
  std::set<std::uint32_t> floor;
  for (const std::uint32_t e : cube.edges_of_face(onto))
    floor.insert({cube.edges()[e].lower, cube.edges()[e].upper});
  for (const std::uint32_t e : cube.edges_of_face(across))
    for (std::uint32_t f = 0; f < 6; ++f)
      if (f != across && has_edge(f, e)) out.faces.push_back({e, f});
  for (std::uint32_t e = 0; e < 12; ++e) {
    const auto [lower, upper] = cube.edges()[e];
    if (floor.contains(lower) != floor.contains(upper))
      out.edges.push_back({floor.contains(lower) ? upper : lower, e});
  }
  return out;
}

// PROVES COLLAR-1.K2
TEST(Replay, RefusesACubeOntoOneOfItsFaces) {
  const CommonSubdivision cube = build({{0, 0, 0, 0}});
  const std::vector<std::uint32_t> d_plus{5};
  const CollapseSequence sequence = collapse_of_cube(cube, d_plus[0]);
  EXPECT_TRUE(SlowReplay(cube).accepts(cube, {d_plus, sequence}))
      << "K3 holds: the fault is K2's alone";
  const CollapseCheck check = replay_collapse(cube, d_plus, sequence);
  EXPECT_EQ(check.fault, CollapseFault::kPartOfComponent);
  EXPECT_EQ(check.dimension, 1u);
  EXPECT_NE(check.message.find("has boundary faces in d+ and others"), std::string::npos);
  // Two opposite faces, five faces, none: no better.
  for (const std::vector<std::uint32_t>& some :
       {std::vector<std::uint32_t>{0, 5}, std::vector<std::uint32_t>{0, 1, 2, 3, 4}})
    EXPECT_EQ(replay_collapse(cube, some, sequence).fault, CollapseFault::kPartOfComponent);
  // The whole boundary is whole, but then no face is free; and nothing collapses to nothing.
  EXPECT_EQ(replay_collapse(cube, std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}, sequence).fault,
            CollapseFault::kInDPlus);
  EXPECT_EQ(replay_collapse(cube, std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}, {}).fault,
            CollapseFault::kLeft);
  EXPECT_EQ(replay_collapse(cube, {}, sequence).fault, CollapseFault::kLeft);
}

// PROVES COLLAR-1.K2, COLLAR-1.K3
TEST(Replay, NamesTheFaultOfEachForgery) {
  const CommonSubdivision complex = build(small_wall());
  const Proof good = proof(complex);
  const auto fault = [&](const Proof& p) {
    return replay_collapse(complex, p.d_plus, p.sequence).fault;
  };
  const auto expect = [&](CollapseFault want, auto change) {
    Proof p = good;
    change(p);
    EXPECT_EQ(fault(p), want) << replay_collapse(complex, p.d_plus, p.sequence).message;
    EXPECT_FALSE(SlowReplay(complex).accepts(complex, p) &&
                 want != CollapseFault::kPartOfComponent && want != CollapseFault::kNoSuchCell);
  };
  expect(CollapseFault::kPartOfComponent, [](Proof& p) { p.d_plus.pop_back(); });
  expect(CollapseFault::kNoSuchCell, [](Proof& p) { std::swap(p.d_plus[0], p.d_plus[1]); });
  expect(CollapseFault::kNoSuchCell, [&](Proof& p) { p.d_plus.push_back(complex.num_faces()); });
  expect(CollapseFault::kNotBoundary, [&](Proof& p) {
    std::uint32_t f = 0;
    while (complex.faces()[f].num_cells() != 2) ++f;
    p.d_plus.insert(std::lower_bound(p.d_plus.begin(), p.d_plus.end(), f), f);
  });
  expect(CollapseFault::kLeft, [](Proof& p) { p.sequence.edges.pop_back(); });
  expect(CollapseFault::kNotFree,
         [](Proof& p) { std::reverse(p.sequence.cells.begin(), p.sequence.cells.end()); });
  expect(CollapseFault::kAbsent,
         [](Proof& p) { p.sequence.cells.push_back(p.sequence.cells.front()); });
  expect(CollapseFault::kAbsent,
         [](Proof& p) { p.sequence.cells[1].coface = p.sequence.cells[0].coface; });
  expect(CollapseFault::kNotCoface,
         [](Proof& p) { p.sequence.cells[0].coface = p.sequence.cells.back().coface; });
  expect(CollapseFault::kInDPlus, [](Proof& p) { p.sequence.cells[0].face = p.d_plus[0]; });
  expect(CollapseFault::kNoSuchCell,
         [&](Proof& p) { p.sequence.faces[0].face = complex.num_edges(); });
  expect(CollapseFault::kNoSuchCell,
         [&](Proof& p) { p.sequence.edges[0].coface = CommonSubdivision::kNone; });
  // The other side's faces with this side's collapses.
  const ComplexBoundary boundary = analyse_boundary(complex);
  expect(CollapseFault::kInDPlus,
         [&](Proof& p) { p.d_plus = boundary.faces_of(p.d_plus == boundary.faces_of(0) ? 1 : 0); });
}

// Changed proofs: accepted exactly if the definition accepts them (some changes are harmless), and the message has the step.
TEST(Replay, AgreesWithTheDefinitionOnChangedProofs) {
  const Cells cells =
      octree_shapes::without(octree_shapes::block(2, {0, 0, 0}, {3, 3, 3}), {{2, 1, 1, 1}});
  const CommonSubdivision complex = build(cells);
  const Proof good = proof(complex);
  const SlowReplay fresh(complex);
  int accepted = 0, rejected = 0;
  for (std::uint64_t seed = 1; seed <= 600; ++seed) {
    Random random(seed);
    Proof p = good;
    std::vector<Collapse>* const lists[] = {&p.sequence.cells, &p.sequence.faces,
                                            &p.sequence.edges};
    std::vector<Collapse>& list = *lists[random.below(3)];
    const std::size_t i = random.below(list.size()), j = random.below(list.size());
    switch (random.below(4)) {
      case 0: std::swap(list[i], list[j]); break;
      case 1: std::swap(list[i].face, list[j].face); break;
      case 2: std::swap(list[i], list[i + 1 < list.size() ? i + 1 : i - 1]); break;
      default:
        (random.below(2) == 0 ? list[i].face : list[i].coface) =
            static_cast<std::uint32_t>(random.below(120));
        break;
    }
    SlowReplay slow = fresh;
    const CollapseCheck check = replay_collapse(complex, p.d_plus, p.sequence);
    EXPECT_EQ(check.fault == CollapseFault::kNone, slow.accepts(complex, p))
        << "seed " << seed << ": " << check.message;
    EXPECT_LE(check.step, p.sequence.size());
    (check.fault == CollapseFault::kNone ? accepted : rejected) += 1;
  }
  EXPECT_GT(accepted, 50);
  EXPECT_GT(rejected, 200);
}

TEST(Collapse, InEveryOrderEndsInTheSameSurfaceAndReplays) {
  const CommonSubdivision complex = build(octree_shapes::thick_wall());
  const ComplexBoundary boundary = analyse_boundary(complex);
  const std::uint32_t body[] = {0};
  std::set<std::vector<std::uint32_t>> orders;
  for (const auto order : {CollapseOrder::kBreadthFirst, CollapseOrder::kShuffledBreadthFirst,
                           CollapseOrder::kRandomFront})
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const std::uint32_t side[] = {static_cast<std::uint32_t>(seed % 2)};
      const CollapseAttempt attempt = collapse_greedily(complex, boundary, body, side, order, seed);
      EXPECT_TRUE(attempt.stuck.empty()) << "order " << static_cast<int>(order) << " seed " << seed;
      const CollapseCheck check =
          replay_collapse(complex, boundary.faces_of(side[0]), attempt.sequence);
      EXPECT_EQ(check.fault, CollapseFault::kNone) << check.message;
      std::vector<std::uint32_t> cells;
      for (const Collapse& c : attempt.sequence.cells) cells.push_back(c.coface);
      orders.insert(cells);
    }
  EXPECT_EQ(orders.size(), 2u + 4u + 4u)
      << "the seed does not matter to the first order, and matters to the others";
}

TEST(Names, SayWhereACellLies) {
  const CommonSubdivision complex = build({{2, 1, 2, 3}});
  EXPECT_EQ(name_of(complex, 3, 0), "cell (level 2: 1 2 3)");
  EXPECT_EQ(name_of(complex, 2, 0), "face (1 2 3)-(1 3 4) / 4");
  EXPECT_EQ(name_of(complex, 1, 0), "edge (1 2 3)-(2 2 3) / 4");
  EXPECT_EQ(name_of(complex, 0, 0), "vertex (1 2 3) / 4");
}

}  // namespace
}  // namespace veritope
