// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/patch_collar.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/patch_shapes_internal.h"
#include "robust/base/random.h"
#include "solids/patches/patch_transform.h"
#include "solids/polyhedron/validity.h"
#include "tests/certify/collar_model.h"
#include "tests/support/collar_examples.h"
#include "topology/thicken.h"
#include "verify/certify/collar_defects.h"
#include "verify/certify/collar_solids.h"

namespace veritope {
namespace {

using collar_model::complex_of;
using collar_model::genus_of_shells;
using collar_model::Model;
using collar_model::uniform_cells;
using patch_shapes::Patches;

Rational ratio(int p, int q = 1) { return Rational(p) / Rational(q); }
patch_shapes::Point at(const Rational& x, const Rational& y, const Rational& z) {
  return {x, y, z};
}
Patches ball(const Rational& radius) {
  return patch_shapes::placed(patch_shapes::sphere(), radius, at(0, 0, 0));
}

// A cube of edge 2 with a cubic cavity.
Patches cube(const Rational& half) {
  return patch_shapes::box(at(-half, -half, -half), at(half, half, half));
}
Patches hollow_box(const Rational& wall) {
  return patch_shapes::joined({cube(1), patch_shapes::reversed(cube(Rational(1) - wall))});
}

TEST(PatchCollar, IsFoundAroundSmallModelsWithTheirGenus) {
  struct Case {
    const char* name;
    Patches patches;
    std::vector<int> genus;
  };
  const std::vector<Case> cases = {
      {"box", patch_shapes::box(at(0, 0, 0), at(1, 2, 3)), {0}},
      {"sphere", patch_shapes::sphere(), {0}},
      {"octants", patch_shapes::octant_sphere(), {0}},
      {"torus", patch_shapes::torus(ratio(3), ratio(1)), {1}},
      {"two balls",
       patch_shapes::joined({ball(1), patch_shapes::placed(ball(1), 1, at(3, 0, 0))}),
       {0, 0}},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    Model m(c.patches);
    ASSERT_TRUE(m.has_collar()) << (m.search.open ? m.search.open->message : "");
    EXPECT_EQ(genus_of_shells(m.collar()), c.genus);
    EXPECT_EQ(m.collar().collar.outcome, CollarOutcome::kCollar);
    EXPECT_EQ(replay_collapse(m.collar().complex, m.collar().collar.d_plus_faces(),
                              m.collar().collar.collapses)
                  .fault,
              CollapseFault::kNone);
    for (const CollarBody& body : m.collar().collar.bodies)
      EXPECT_EQ(m.collar().shores[body.d_plus].winding + m.collar().shores[body.d_minus].winding,
                1);
  }
}

// Exact points of the surface lie in cells of their shell's body, and no neighbour outside K is near: hulls of points are points.
// PROVES COLLAR-2.INSIDE
TEST(PatchCollar, HoldsExactPointsOfTheSurfaceInItsInterior) {
  Model m(patch_shapes::joined({patch_shapes::torus(ratio(3), ratio(1)),
                                patch_shapes::placed(ball(1), ratio(1, 2), at(0, 0, 0))}));
  ASSERT_TRUE(m.has_collar());
  const PatchCollar& collar = m.collar();
  const OctreeKeySet& cells = collar.complex.cells();
  Random random(11);
  for (int trial = 0; trial < 2000; ++trial) {
    const auto p = static_cast<std::uint32_t>(random.below(m.complex.patches().size()));
    const auto q = evaluate(m.complex.patch(p).tensor(), {Rational::from_double(random.unit()),
                                                          Rational::from_double(random.unit())});
    Point3d near;
    for (std::size_t k = 0; k < 3; ++k)
      near[k] = nearest_double(Rational::power_of_two(m.forest.scale()) * q[k] / q[3]);
    // A box of 2^-40 around the point lies in cells of K, all of one body.
    const Box3d around{{near[0] - 0x1p-40, near[1] - 0x1p-40, near[2] - 0x1p-40},
                       {near[0] + 0x1p-40, near[1] + 0x1p-40, near[2] + 0x1p-40}};
    std::size_t met = 0;
    double volume = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Box3d box = collar.root.box(cells[i]);
      if (!meets(box, around)) continue;
      ++met;
      EXPECT_EQ(collar.collar.boundary.body_of_cell[i],
                collar.place.body_of_shell[m.complex.shell(p)]);
      double part = 1;
      for (std::size_t k = 0; k < 3; ++k)
        part *= (std::min(box.hi[k], around.hi[k]) - std::max(box.lo[k], around.lo[k])) * 0x1p39;
      volume += part;
    }
    EXPECT_GE(met, 1u) << "trial " << trial;
    EXPECT_NEAR(volume, 1, 1e-9) << "trial " << trial << ": cells leave a part free";
  }
}

// A cube whose faces lie on planes between cells: exactly the cells that meet its surface, some of them in a corner only,
// are needed.
// PROVES COLLAR-2.INSIDE
TEST(PatchCollar, EveryCellThatTheSurfaceMeetsIsNeededAndNoOther) {
  const PatchComplex complex = complex_of(cube(1));
  PieceForest forest = PieceForest::make(complex, PieceForest::FrameChoice::kPlain).value();
  const StarCover cover = find_star_cover(forest, {});
  ASSERT_TRUE(cover.is_complete());
  const double one = std::ldexp(1.0, forest.scale());
  OctreeRoot root;
  root.unit = 4 * one / OctreeKey::kGrid;
  root.corner = {-2 * one, -2 * one, -2 * one};
  const auto holds = [&](const std::vector<OctreeKey>& keys, const OctreeRoot& place) {
    const auto cells = CommonSubdivision::build(OctreeKeySet::make(keys).value()).value();
    Misplaced why;
    return place_surface(forest, cover, place, cells, analyse_boundary(cells), &why).has_value();
  };
  // Eight cells of half a unit along each axis; of the middle six, those that are not inside of the cube.
  std::vector<OctreeKey> needed;
  for (std::uint32_t x = 1; x < 7; ++x)
    for (std::uint32_t y = 1; y < 7; ++y)
      for (std::uint32_t z = 1; z < 7; ++z) {
        const auto is_middle = [](std::uint32_t i) { return i == 3 || i == 4; };
        if (!(is_middle(x) && is_middle(y) && is_middle(z))) needed.push_back(OctreeKey::make({3, x, y, z}).value());
      }
  ASSERT_EQ(needed.size(), 208u);
  EXPECT_TRUE(holds(needed, root));
  for (std::size_t i = 0; i < needed.size(); ++i) {
    auto fewer = needed;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_FALSE(holds(fewer, root)) << i;
  }
  // The first cell meets the cube in a corner: of its eighths only the one at that corner does.
  for (unsigned octant = 0; octant < 8; ++octant) {
    auto parts = needed;
    parts[0] = needed[0].child(octant);
    EXPECT_EQ(holds(parts, root), octant == 7) << octant;
  }
  // All cells of a root whose border the surface touches.
  std::vector<OctreeKey> all{OctreeKey()};
  EXPECT_TRUE(holds(all, root));
  root.corner[0] = -one;
  EXPECT_FALSE(holds(all, root));
}

// The leaves below the cover's leaves form whole trees.
TEST(PatchCollar, HasOneLeafOnEveryWayDown) {
  Model m(patch_shapes::torus(ratio(3), ratio(1)));
  ASSERT_TRUE(m.has_collar());
  const CollarPlace& place = m.collar().place;
  std::size_t leaves = 0;
  const auto visit = [&](auto& self, PieceForest::Id id, int covers, int collars) -> void {
    covers +=
        id < m.cover.box_of_node.size() && m.cover.box_of_node[id] != StarCover::kNone ? 1 : 0;
    if (place.is_leaf[id]) {
      ++leaves, ++collars;
      EXPECT_EQ(covers, 1);
      return;
    }
    ASSERT_NE(m.forest.node(id).first_child, PieceForest::kNone);
    for (PieceForest::Id k = 0; k < 4; ++k)
      self(self, m.forest.node(id).first_child + k, covers, collars);
  };
  for (std::uint32_t r = 0; r < m.forest.num_roots(); ++r) visit(visit, m.forest.root(r), 0, 0);
  EXPECT_EQ(leaves, place.num_leaves);
}

TEST(PatchCollar, OuterAndInnerSolidsAreCertifiedWithTheGenus) {
  const std::vector<std::pair<Patches, std::uint64_t>> models = {
      {patch_shapes::torus(ratio(3), ratio(1)), 1},
      {patch_shapes::sphere(), 0},
      {patch_shapes::plate(1), 1}};
  for (const auto& [patches, genus] : models) {
    Model m(patches);
    ASSERT_TRUE(m.has_collar());
    for (const auto& solid :
         {outer_solid(m.collar(), m.forest.scale()), inner_solid(m.collar(), m.forest.scale())}) {
      const ValidityReport report = decide_validity(solid.value(), {});
      EXPECT_TRUE(report.is_valid);
      EXPECT_EQ(report.counts.genus, std::optional<std::int64_t>(genus));
      EXPECT_EQ(report.counts.bodies, std::optional<std::uint64_t>(1));
    }
  }
}

// Walls of 1/8, of which the first covers hold both shells.
TEST(PatchCollar, RefinesShellsApart) {
  Model m(hollow_box(ratio(1, 8)));
  ASSERT_TRUE(m.has_collar());
  EXPECT_EQ(m.collar().collar.bodies.size(), 2u);
  EXPECT_NE(m.collar().place.body_of_shell[0], m.collar().place.body_of_shell[1]);
  EXPECT_GE(m.search.rounds, 3u);
  const ValidityReport outer =
      decide_validity(outer_solid(m.collar(), m.forest.scale()).value(), {});
  EXPECT_TRUE(outer.is_valid);
  EXPECT_EQ(outer.counts.shells, 2u);
}

// A thin tunnel: cells as large as around the rest close it, and are refined there only.
TEST(PatchCollar, IsFineOnlyWhereTheModelIs) {
  Model m(patch_shapes::joined(
      {patch_shapes::box(at(0, 0, 0), at(1, 1, 1)),
       patch_shapes::placed(patch_shapes::torus(ratio(3), ratio(1)), ratio(1, 100), at(2, 2, 2))}));
  ASSERT_TRUE(m.has_collar());
  EXPECT_EQ(genus_of_shells(m.collar()), (std::vector<int>{0, 1}));
  EXPECT_LT(m.collar().complex.num_cells(), 3000u);
  EXPECT_GE(m.collar().complex.cells().finest_level(), 8u);
}

TEST(PatchCollar, SaysWhereThereIsNone) {
  CollarSearchOptions coarse;
  coarse.max_level = 3;
  Model torus(patch_shapes::torus(ratio(3), ratio(1)), coarse);
  EXPECT_FALSE(torus.has_collar());
  EXPECT_TRUE(torus.search.open->place.box.has_value());
  EXPECT_NE(torus.search.open->message.find("shell 0"), std::string::npos)
      << (torus.search.open ? torus.search.open->message : "");
  CollarSearchOptions few;
  few.max_cells = 100;
  Model shell(hollow_box(ratio(1, 8)), few);
  EXPECT_FALSE(shell.has_collar());
  EXPECT_NE(shell.search.open->message.find("more than 100 cells"), std::string::npos)
      << (shell.search.open ? shell.search.open->message : "");
}

// Cells of the size of the gap would fill memory.
TEST(PatchCollar, IsLookedForAmongFewCellsWhereSheetsPassTooNear) {
  const Rational far = Rational(1) + Rational::power_of_two(-20);
  Model m(patch_shapes::joined(
      {patch_shapes::box(at(0, 0, 0), at(1, 1, 1)), patch_shapes::box({0, 0, far}, {1, 1, 2})}));
  ASSERT_TRUE(m.cover.is_complete());
  EXPECT_FALSE(m.has_collar());
  EXPECT_LT(m.search.cells_tried, std::uint64_t{1} << 17);
  EXPECT_NE(m.search.open->message.find("so near each other"), std::string::npos);
  ASSERT_TRUE(m.search.open->place.box);
}

// A collar may swallow what is thinner than its cells.
TEST(PatchCollar, IsFoundAroundAThinFinAndAThinSlot) {
  const Rational low = ratio(1, 2), high = low + Rational::power_of_two(-20);
  const std::vector<Rational> x = {0, 1, 2}, y = {0, 1}, z = {0, low, high, 1};
  const auto place = [&](const std::array<int, 3>& p) {
    return at(x[static_cast<std::size_t>(p[0])], y[static_cast<std::size_t>(p[1])],
              z[static_cast<std::size_t>(p[2])]);
  };
  const std::vector<std::array<int, 3>> fin = {{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {1, 0, 1}},
                                        slot = {
                                            {0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {1, 0, 0}, {1, 0, 2}};
  for (const auto& cubes : {fin, slot}) {
    Model m(patch_shapes::internal::block_faces(cubes, place));
    ASSERT_TRUE(m.has_collar()) << (m.search.open ? m.search.open->message : "");
    EXPECT_LT(m.search.collar->complex.cells().size(), 1000u);
  }
}

// Sheets in one plane whose normals are opposite face nothing.
TEST(PatchCollar, IsFoundBesideSheetsOfOnePlane) {
  Model m(patch_shapes::joined({patch_shapes::box(at(0, 0, 0), at(1, 1, 1)),
                                patch_shapes::box({ratio(5, 4), 0, 1}, {2, 1, 2})}));
  ASSERT_TRUE(m.has_collar()) << (m.search.open ? m.search.open->message : "");
}

// Doubles of 53 bits hold no octree around something of size 2^-34 at distance 1.
TEST(PatchCollar, OfATinyModelFarAwayIsRefusedByName) {
  Model m(patch_shapes::placed(patch_shapes::box(at(0, 0, 0), at(1, 1, 1)),
                               Rational::power_of_two(-34), at(1, 1, 1)));
  ASSERT_TRUE(m.cover.is_complete());
  EXPECT_FALSE(m.has_collar());
  EXPECT_NE(m.search.open->message.find("does not fit"), std::string::npos);
}

TEST(PatchCollar, DoesNotDependOnPlaceSizeOrLabels) {
  Random random(5);
  const Patches torus = patch_shapes::torus(ratio(3), ratio(1));
  std::vector<Patches> images = {relabelled(torus, random), subdivided(torus), elevated(torus, 1)};
  for (const int exponent : {-700, 700}) {
    const Rational f = Rational::power_of_two(exponent);
    images.push_back(patch_shapes::placed(torus, f, at(f * ratio(5), f, f * ratio(1, 3))));
  }
  for (int trial = 0; trial < 4; ++trial) {
    const auto draw = [&] { return Rational::from_double(random.unit()) * ratio(100) - ratio(50); };
    images.push_back(patch_shapes::placed(torus, ratio(1 + static_cast<int>(random.below(50)), 7),
                                          at(draw(), draw(), draw())));
  }
  for (std::size_t i = 0; i < images.size(); ++i) {
    Model m(images[i]);
    ASSERT_TRUE(m.cover.is_complete()) << "image " << i;
    ASSERT_TRUE(m.has_collar()) << "image " << i << ": " << (m.search.open ? m.search.open->message : "");
    EXPECT_EQ(genus_of_shells(m.collar()), std::vector<int>{1}) << "image " << i;
    EXPECT_LT(m.collar().complex.num_cells(), 8000u) << "image " << i;
  }
}

// Three cubes, one in the other: uniform cells that hold all of them are a collar, but of three shells.
// PROVES COLLAR-2.ONE
TEST(CollarTraps, ThreeParallelShellsInOneCollarAreRefused) {
  const PatchComplex complex =
      complex_of(patch_shapes::joined({hollow_box(ratio(1, 8)), cube(ratio(3, 4))}));
  PieceForest forest = PieceForest::make(complex, PieceForest::FrameChoice::kPlain).value();
  const StarCover cover = find_star_cover(forest, {});
  ASSERT_TRUE(cover.is_complete());
  const OctreeRoot root = root_around(hull_of_roots(forest)).value();
  const CommonSubdivision cells = uniform_cells(forest, root, 3);
  const Collar collar = find_collar(cells).value();
  ASSERT_EQ(collar.outcome, CollarOutcome::kCollar) << collar.message;
  ASSERT_EQ(collar.bodies.size(), 1u);
  Misplaced why;
  EXPECT_FALSE(place_surface(forest, cover, root, cells, collar.boundary, &why).has_value());
  EXPECT_EQ(why.message, "two shells lie in one component of the cells");
  EXPECT_EQ(find_body_defects(complex, {{0, 1, 2}}, collar.boundary).size(), 1u);
}

// A small torus inside one body of a wall: the wall is a collar, the surface inside and alone.
struct SmallInWall {
  SmallInWall(Patches patches, const octree_shapes::Cells& wall,
              const std::array<std::uint32_t, 3>& place)
      : complex(complex_of(std::move(patches))),
        forest(PieceForest::make(complex, PieceForest::FrameChoice::kPlain).value()),
        cells(octree_shapes::build(wall)) {
    cover = find_star_cover(forest, {});
    const Box3d all = hull_of_roots(forest);
    // The cell `place` of level 5 is 4 times as large as the model, which lies in its middle.
    const double cell = std::exp2(std::ceil(std::log2(extent(all))) + 2);
    root.unit = cell * 32 / OctreeKey::kGrid;
    for (std::size_t k = 0; k < 3; ++k)
      root.corner[k] =
          std::floor((approx_centre(all)[k] - (place[k] + 0.5) * cell) / root.unit) * root.unit;
    collar = find_collar(cells).value();
  }
  PatchComplex complex;
  PieceForest forest;
  StarCover cover;
  OctreeRoot root;
  CommonSubdivision cells;
  Collar collar;
};

// PROVES COLLAR-2.CHI
TEST(CollarTraps, ASmallHandleIsRefusedByEulersNumber) {
  SmallInWall m(patch_shapes::torus(ratio(3), ratio(1)), octree_shapes::thick_wall(), {6, 14, 14});
  ASSERT_EQ(m.collar.outcome, CollarOutcome::kCollar) << m.collar.message;
  Misplaced why;
  ASSERT_TRUE(
      place_surface(m.forest, m.cover, m.root, m.cells, m.collar.boundary, &why).has_value())
      << why.message;
  const auto defects = find_body_defects(m.complex, {{0}}, m.collar.boundary);
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_NE(defects[0].message.find("genus 1, have a boundary component of genus 0"),
            std::string::npos)
      << defects[0].message;
}

// PROVES COLLAR-2.W
TEST(CollarTraps, ASurfaceThatSeparatesNothingIsRefusedByItsWindingNumbers) {
  SmallInWall m(patch_shapes::sphere(), octree_shapes::thick_wall(), {6, 14, 14});
  ASSERT_EQ(m.collar.outcome, CollarOutcome::kCollar) << m.collar.message;
  Misplaced why;
  ASSERT_TRUE(
      place_surface(m.forest, m.cover, m.root, m.cells, m.collar.boundary, &why).has_value())
      << why.message;
  ASSERT_TRUE(find_body_defects(m.complex, {{0}}, m.collar.boundary).empty());
  const auto shores = find_shores(m.forest, m.cover, m.root, m.cells, m.collar.boundary);
  ASSERT_EQ(shores.size(), 2u);
  ASSERT_TRUE(shores[0] && shores[1]);
  EXPECT_EQ(shores[0]->winding, 0);
  EXPECT_EQ(shores[1]->winding, 0);
}

// With the wrong side out, taken for the right one: what is reached from c+ is inside the ball.
// PROVES COLLAR-2.W
TEST(CollarTraps, AReversedShellIsRefusedByItsWindingNumbers) {
  const PatchComplex complex = complex_of(patch_shapes::reversed(ball(1)));
  PieceForest forest = PieceForest::make(complex, PieceForest::FrameChoice::kPlain).value();
  const StarCover cover = find_star_cover(forest, {});
  const OctreeRoot root = root_around(hull_of_roots(forest)).value();
  const CommonSubdivision cells = uniform_cells(forest, root, 4);
  const Collar collar = find_collar(cells).value();
  ASSERT_EQ(collar.outcome, CollarOutcome::kCollar);
  const auto shores = find_shores(forest, cover, root, cells, collar.boundary);
  ASSERT_TRUE(shores[0] && shores[1]);
  EXPECT_EQ(shores[0]->winding, shores[1]->winding);
}

TEST(CollarTraps, APieceOutsideTheCellsIsNamed) {
  Model m(patch_shapes::sphere());
  ASSERT_TRUE(m.has_collar());
  const auto keys = m.collar().complex.cells().keys();
  std::size_t refused = 0;
  for (std::size_t left_out = 0; left_out < keys.size(); ++left_out) {
    std::vector<OctreeKey> fewer(keys.begin(), keys.end());
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(left_out));
    const CommonSubdivision cells =
        CommonSubdivision::build(OctreeKeySet::make(fewer).value()).value();
    Misplaced why;
    if (place_surface(m.forest, m.cover, m.collar().root, cells, analyse_boundary(cells), &why))
      continue;
    ++refused;
    ASSERT_NE(why.piece, PieceForest::kNone);
    EXPECT_TRUE(meets(m.forest.node(why.piece).hull, m.collar().root.box(keys[left_out])));
  }
  EXPECT_GT(refused, keys.size() / 2);  // some cells only fill a gap, or a hull just reaches them
}

}  // namespace
}  // namespace veritope
