// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/crossing_search.h"

#include <gtest/gtest.h>

#include "models/thin_shapes.h"
#include "solids/pieces/exact_piece.h"
#include "tests/certify/crossing_planes.h"
#include "tests/certify/planted_crossings.h"
#include "verify/certify/patch_decision.h"
#include "verify/certify/piece_neighbours.h"

namespace veritope {
namespace {

using patch_shapes::Patches;
using patch_shapes::Truth;
using planted::broken;
using planted::complex_of;
using planted::flat;
using planted::floor_patch;
using planted::image;
using planted::ratio;
using planted::wall_patch;

PatchDecision decide(const PatchComplex& complex, int max_level) {
  PatchDecisionOptions options;
  options.cover.max_level = max_level;
  options.tolerance = 1e-2;
  std::optional<PieceForest> forest;
  return decide_patches(complex, options, &forest);
}

// A = (2u - 1, 2v - 1, 0), B = (0, 2s - 1, 2t - 1): equal where u = t = 1/2, v = s. v is fixed.
CrossingWitness plane_witness() {
  CrossingWitness w;
  const DyadicInterval around{3, 3, 5};  // 1/2 -+ 1/8
  w.sheets[0] = {0, {around, {1, 1, 1}}};
  w.sheets[1] = {1, {around, around}};
  w.rows = {{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
  return w;
}

// PROVES INVALID-1
TEST(CrossingWitness, OfTwoPlanesIsAProof) {
  EXPECT_EQ(broken_condition(floor_patch(), wall_patch(), plane_witness()), std::nullopt);
}

TEST(CrossingWitness, EachConditionIsNeeded) {
  const Patch a = floor_patch(), b = wall_patch();
  const auto expect = [&](const CrossingWitness& w, CrossingCondition condition) {
    EXPECT_EQ(broken_condition(a, b, w), condition);
  };
  CrossingWitness w = plane_witness();
  w.sheets[0].at[1] = {0, 0, 0};  // A on the border, v = 0
  w.sheets[1].at[0] = {3, 0, 2};
  expect(w, CrossingCondition::kX1);
  w = plane_witness();
  w.sheets[0].at[0] = {1, 0, 1};
  expect(w, CrossingCondition::kX1);
  w = plane_witness();
  w.sheets[0].at[0] = {1, 1, 2};
  expect(w, CrossingCondition::kX1);
  w = plane_witness();
  w.sheets[0].at[1] = {3, 3, 5};  // none is fixed
  expect(w, CrossingCondition::kX1);
  w = plane_witness();
  w.sheets[0].at[0] = {1, 1, 1};  // two are
  expect(w, CrossingCondition::kX1);
  w = plane_witness();
  w.sheets[1].at[0] = {3, 5, 3};  // no interval
  expect(w, CrossingCondition::kX1);
  w = plane_witness();
  w.sheets[1].at[0] = {63, 1, 2};
  expect(w, CrossingCondition::kX1);
  w = plane_witness();
  w.rows[2] = {0, -2, 0};  // singular
  expect(w, CrossingCondition::kX2);
  w = plane_witness();
  w.rows[0] = {-1, 0, 0};  // wrong sign
  expect(w, CrossingCondition::kX3);
  w = plane_witness();
  w.sheets[0].at[0] = {3, 1, 3};  // the common point has u = 1/2
  expect(w, CrossingCondition::kX3);
  w.sheets[0].at[0] = {3, 2, 4};  // touched by one end, and by the other
  expect(w, CrossingCondition::kX3);
  w.sheets[0].at[0] = {3, 4, 6};
  expect(w, CrossingCondition::kX3);
  w = plane_witness();
  w.sheets[1].at[1] = {3, 5, 7};  // above the floor
  expect(w, CrossingCondition::kX3);
}

// All of a sheet must lie before, or behind, the end of the other one: not only its least or its
// greatest control value.
TEST(CrossingWitness, ASheetThatReachesBeyondOneEndIsNoProof) {
  const Patch a = floor_patch();
  for (const auto& [sign, runs] : {std::pair{1, 1}, {1, -1}, {-1, 1}, {-1, -1}})
    for (const bool is_far : {true, false}) {
      // x = c + m (2 s - 1) over the rectangle; u ends where x is -1/4 and 1/4. If B is far, x runs
      // from -1/10 to 1/2, or from -1/2 to 1/10.
      const Rational c = planted::ratio(sign, is_far ? 5 : 40),
                     m = planted::ratio(runs * (is_far ? 6 : 3), 5);
      const Rational shift = c - m;
      const Patch b = flat({shift, -1, -1}, {m + m, 2, 0}, {0, 0, 2});
      CrossingWitness w = plane_witness();
      EXPECT_EQ(broken_condition(a, b, w) == std::nullopt, !is_far) << sign;
    }
}

// Numbers of 62 bits are the finest that a certificate can name.
TEST(CrossingWitness, ParametersOfSixtyTwoBitsAreProofs) {
  CrossingWitness w = plane_witness();
  w.sheets[0].at[1] = {62, std::uint64_t{1} << 61, std::uint64_t{1} << 61};
  EXPECT_EQ(broken_condition(floor_patch(), wall_patch(), w), std::nullopt);
}

// Two rectangles of one patch must have no common place: otherwise every sheet crosses itself.
TEST(CrossingWitness, OverlappingRectanglesOfOnePatchAreNoProof) {
  // One map occurs twice, once under another number: A = B has solutions, along the diagonal.
  const Patch a = flat({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  CrossingWitness w;
  const DyadicInterval around{3, 3, 5};
  w.sheets[0] = {0, {around, around}};
  w.sheets[1] = {0, {around, {1, 1, 1}}};
  w.rows = {{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}};
  EXPECT_EQ(broken_condition(a, a, w), CrossingCondition::kX1);
  EXPECT_FALSE(are_apart(w.sheets[0], w.sheets[1]));
  w.sheets[1].at[1] = {3, 6, 6};
  EXPECT_TRUE(are_apart(w.sheets[0], w.sheets[1]));
  w.sheets[1].at[1] = {3, 5, 5};  // closed intervals: one common number
  EXPECT_FALSE(are_apart(w.sheets[0], w.sheets[1]));
  EXPECT_FALSE(are_apart(w.sheets[1], w.sheets[0]));
  w.sheets[1].at = {DyadicInterval{3, 1, 3}, around};
  EXPECT_FALSE(are_apart(w.sheets[0], w.sheets[1]));
  EXPECT_FALSE(are_apart(w.sheets[1], w.sheets[0]));
  w.sheets[1].at[0] = {3, 1, 2};
  EXPECT_TRUE(are_apart(w.sheets[0], w.sheets[1]));
  EXPECT_TRUE(are_apart(w.sheets[1], w.sheets[0]));
}

// A triangle's tensor form is the same map, and where its first parameter is 0 nothing is proved.
TEST(CrossingWitness, TrianglesInTensorForm) {
  const Patches torus = patch_shapes::pn_torus(12, 8);
  const Patch& patch = torus[7];
  for (const auto& [s, t] :
       {std::pair(ratio(1, 3), ratio(2, 5)), std::pair(ratio(1, 1), ratio(1, 7))}) {
    const Barycentric<Rational> at{Rational(1) - s, s * (Rational(1) - t), s * t};
    EXPECT_EQ(evaluate(patch.triangle(), at), (evaluate<Rational, 2>(tensor_form(patch), {s, t})));
  }
  CrossingWitness w = plane_witness();
  w.sheets[1].at[0] = {1, 0, 1};
  EXPECT_NE(broken_condition(floor_patch(), wall_patch(), w), CrossingCondition::kX1);
  EXPECT_EQ(broken_condition(floor_patch(), patch, w), CrossingCondition::kX1);
}

// What holds for patches holds for their reversed forms, in other parameters.
TEST(CrossingWitness, SurvivesReversedPatches) {
  Random random(11);
  for (int trial = 0; trial < 12; ++trial) {
    const planted::PlantedModel m = planted::two_shells(random);
    const PatchComplex complex = complex_of(m.patches);
    const PatchDecision decision = decide(complex, 8);
    ASSERT_TRUE(decision.refutation) << "trial " << trial << ": " << m.name;
    const auto& w = std::get<CrossingWitness>(*decision.refutation);
    const Patch &a = complex.patch(w.sheets[0].patch), &b = complex.patch(w.sheets[1].patch);
    EXPECT_EQ(broken_condition(a, b, w), std::nullopt);
    for (const bool first : {false, true})
      for (const bool second : {false, true}) {
        const CrossingWitness r = with_reversed(a, b, {first, second}, w);
        EXPECT_EQ(broken_condition(first ? reversed(a) : a, second ? reversed(b) : b, r),
                  std::nullopt)
            << m.name;
        EXPECT_EQ(
            with_reversed(first ? reversed(a) : a, second ? reversed(b) : b, {first, second}, r),
            w);
      }
  }
}

// Law: no witness for an embedded model; all that the solver finds there are common points of neighbours.
TEST(CrossingSearch, FindsNothingInSoundModels) {
  for (const auto& shape : patch_shapes::sound_shapes()) {
    const PatchComplex complex = complex_of(shape.patches);
    PieceForest forest = PieceForest::make(complex).value();
    CrossingSearch search(forest);
    EXPECT_FALSE(search.among_patches()) << shape.name;
    for (std::uint32_t r = 0; r < std::min<std::size_t>(forest.num_roots(), 8); ++r)
      EXPECT_FALSE(search.near(forest.root(r))) << shape.name;
  }
}

TEST(CrossingSearch, FindsEveryCrossingAndEveryContactAtSimpleParameters) {
  std::vector<std::string> undecided;
  for (const auto& shape : patch_shapes::broken_shapes()) {
    const PatchComplex complex = complex_of(shape.patches);
    const PatchDecision decision = decide(complex, 5);
    EXPECT_FALSE(decision.is_valid) << shape.name;
    if (shape.truth == Truth::kTouching && !decision.refutation) {
      undecided.push_back(shape.name);
      continue;
    }
    ASSERT_TRUE(decision.refutation) << shape.name;
    if (shape.truth == Truth::kTouching) {
      EXPECT_EQ(broken_condition(complex, std::get<MeetingWitness>(*decision.refutation)),
                std::nullopt)
          << shape.name;
      continue;
    }
    EXPECT_EQ(broken(complex, std::get<CrossingWitness>(*decision.refutation)), std::nullopt);
  }
  // Their common points have irrational parameters.
  EXPECT_EQ(undecided, (std::vector<std::string>{"lid-touching-in-an-irrational-line", "box-folded",
                                                 "spindle-torus", "one-patch-spindle-torus"}));
}

// The rows of a witness are those of the model's coordinates, whatever frame it was found in.
TEST(CrossingSearch, FindsCrossingsInStretchedModels) {
  for (const auto& shape : patch_shapes::broken_shapes()) {
    if (shape.truth != Truth::kCrossing) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      AffineMap map{3, 3, std::vector<Rational>(9), std::vector<Rational>(3)};
      for (std::size_t k = 0; k < 3; ++k)
        map.linear[4 * k] = k == axis ? ratio(1, 1000) : Rational(1);
      const PatchComplex complex = complex_of(affine_image(shape.patches, map).value());
      ASSERT_FALSE(PieceForest::make(complex).value().frame().is_plain());
      const PatchDecision decision = decide(complex, 5);
      ASSERT_TRUE(decision.refutation) << shape.name << " along " << axis;
      EXPECT_EQ(broken(complex, std::get<CrossingWitness>(*decision.refutation)), std::nullopt);
    }
  }
}

// A number of a row is below 2^63 in a certificate, however far apart the units of a flat model's axes are.
TEST(CrossingSearch, FindsCrossingsInModelsFlatterThanBinary64) {
  const auto block = patch_shapes::box({0, 0, 0}, {1, 1, 1});
  const auto blocks = patch_shapes::joined(
      {block, patch_shapes::placed(block, 1, {ratio(1, 2), ratio(1, 3), ratio(1, 5)})});
  for (const int exponent : {-1050, -1100, -2000}) {
    AffineMap map{3, 3, std::vector<Rational>(9), std::vector<Rational>(3)};
    map.linear[0] = map.linear[4] = Rational(1);
    map.linear[8] = Rational::power_of_two(exponent);
    const PatchComplex complex = complex_of(affine_image(blocks, map).value());
    const PatchDecision decision = decide(complex, 5);
    ASSERT_TRUE(decision.refutation) << exponent;
    const auto& witness = std::get<CrossingWitness>(*decision.refutation);
    EXPECT_EQ(broken(complex, witness), std::nullopt);
    for (const auto& row : witness.rows)
      for (const std::int64_t y : row) EXPECT_LE(std::abs(y), std::int64_t{1} << 42);
  }
}

TEST(CrossingSearch, FindsPlantedCrossings) {
  constexpr int kModels = 60;
  Random random(5);
  int missed = 0;
  for (int i = 0; i < kModels; ++i) {
    const planted::PlantedModel m = planted::two_shells(random);
    ASSERT_EQ(image(m.patches[m.places[0].patch], m.places[0].at),
              image(m.patches[m.places[1].patch], m.places[1].at));
    const PatchComplex complex = complex_of(m.patches);
    PieceForest forest = PieceForest::make(complex).value();
    CrossingSearch search(forest);
    const auto w = search.everywhere();
    missed += w ? 0 : 1;
    if (!w) continue;
    EXPECT_EQ(broken(complex, *w), std::nullopt) << i << ": " << m.name;
  }
  EXPECT_LE(50 * missed, kModels);
}

// The spheres cross at an angle of about the gap, and near it their distance is less than doubles tell.
TEST(CrossingSearch, FindsCrossingsOfSheetsThatNearlyCoincide) {
  const std::vector<thin_shapes::Family> families = thin_shapes::families();
  for (const thin_shapes::Family& family : families) {
    if (family.name != "spheres" && family.name != "eccentric") continue;
    for (int bits = 8; bits <= 40; bits += 4) {
      SCOPED_TRACE(family.name + ", gap 2^-" + std::to_string(bits));
      const Rational gap = Rational::power_of_two(-bits);
      const auto found = [&](thin_shapes::Walls walls, std::optional<CrossingWitness>* witness) {
        const PatchComplex complex = complex_of(thin_shapes::turned(family.make(gap, walls)));
        PieceForest forest = PieceForest::make(complex).value();
        CrossingSearch search(forest);
        *witness = search.among_patches();
        if (*witness) {
          EXPECT_EQ(broken(complex, **witness), std::nullopt);
        }
        return witness->has_value();
      };
      std::optional<CrossingWitness> witness;
      if (family.name == "spheres" || bits <= 20) {
        EXPECT_TRUE(found(thin_shapes::Walls::kCrossing, &witness));
      }
      EXPECT_FALSE(found(thin_shapes::Walls::kApart, &witness));
    }
  }
}

// 3,000 parallel sheets, one just above the other: the hulls of all of them meet, 4.5 million pairs.
TEST(CrossingSearch, SplitsABoundedNumberOfPairs) {
  std::vector<Patch> sheets;
  for (int i = 0; i < 3000; ++i)
    sheets.push_back(flat({0, 0, ratio(i, 1 << 20)}, {1, 0, 1}, {0, 1, 0}));
  const PatchComplex complex = complex_of(std::move(sheets));
  PieceForest forest = PieceForest::make(complex).value();
  CrossingSearch search(forest);
  EXPECT_FALSE(search.among_patches());
  constexpr std::size_t kLevels = 3, kRootsVisited = 2 * 64 * 3000 + 3000;
  EXPECT_LE(search.num_pairs, kRootsVisited + kLevels * 16 * CrossingSearch::kMostSplit);
  EXPECT_GT(search.num_pairs, CrossingSearch::kMostSplit);
}

TEST(PieceNeighbours, AreThoseWithACommonPointOfTheSurface) {
  const PatchComplex complex = complex_of(patch_shapes::octant_sphere());
  PieceForest forest = PieceForest::make(complex).value();
  ASSERT_EQ(forest.num_roots(), 8u);
  // Octants on one side of the equator have the pole in common; an octant has no point in common with the opposite one.
  int apart = 0;
  for (std::uint32_t a = 0; a < 8; ++a)
    for (std::uint32_t b = 0; b < 8; ++b)
      if (!are_neighbours(forest, a, b)) ++apart;
  EXPECT_EQ(apart, 8);
  const PieceForest::Id child = forest.children(forest.root(0));
  for (PieceForest::Id k = 0; k < 4; ++k) EXPECT_TRUE(are_neighbours(forest, child, child + k));
  const PieceForest::Id corner = forest.children(child), other = forest.children(child + 3);
  EXPECT_TRUE(are_neighbours(forest, corner + 3, other));
  EXPECT_FALSE(are_neighbours(forest, corner, other + 3));
}

// In models without crossings, pieces of one level have a common point of the surface iff they have
// a common corner in space.
TEST(PieceNeighbours, AreThosePiecesOfALevelThatShareACorner) {
  for (const Patches& patches :
       {patch_shapes::octant_sphere(), patch_shapes::box({0, 0, 0}, {1, 1, 1}),
        patch_shapes::pn_torus(12, 8)}) {
    SCOPED_TRACE(patches.size());
    const PatchComplex complex = complex_of(patches);
    PieceForest forest = PieceForest::make(complex).value();
    std::vector<PieceForest::Id> pieces;
    for (std::uint32_t r = 0; r < std::min<std::size_t>(forest.num_roots(), 8); ++r) {
      const PieceForest::Id first = forest.children(forest.root(r));
      for (PieceForest::Id k = 0; k < 4; ++k)
        for (PieceForest::Id j = 0; j < 4; ++j) pieces.push_back(forest.children(first + k) + j);
    }
    std::vector<std::vector<PatchPoint>> corners;
    for (const PieceForest::Id id : pieces) {
      const ExactPiece piece(forest, forest.node(id));
      const Patch& patch = complex.patch(forest.node(id).patch);
      corners.emplace_back();
      for (std::uint32_t s = 0; s < patch.num_sides(); ++s) {
        const auto p = piece.control(patch.side_index(s, 0));
        corners.back().push_back(
            {Rational(*p[0], *p[3]), Rational(*p[1], *p[3]), Rational(*p[2], *p[3])});
      }
    }
    std::size_t alike = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (std::size_t k = 0; k < pieces.size(); ++k) {
        const bool share = std::any_of(corners[i].begin(), corners[i].end(), [&](const auto& c) {
          return std::find(corners[k].begin(), corners[k].end(), c) != corners[k].end();
        });
        alike += are_neighbours(forest, pieces[i], pieces[k]) == share ? 1 : 0;
      }
    EXPECT_EQ(alike, pieces.size() * pieces.size());
  }
}

// Points of one patch that is glued to itself: pieces at opposite borders are neighbours.
TEST(PieceNeighbours, AcrossTheSeamOfOnePatch) {
  const PatchComplex complex = complex_of(patch_shapes::one_patch_torus(3, 1));
  PieceForest forest = PieceForest::make(complex).value();
  const auto last = static_cast<std::uint32_t>(forest.num_roots() - 1);
  const PieceForest::Id first = forest.children(forest.children(forest.root(0))),
                        end = forest.children(forest.children(forest.root(last)) + 3);
  EXPECT_TRUE(are_neighbours(forest, first, end + 3));  // (0, 0) and (1, 1): one vertex
  EXPECT_FALSE(are_neighbours(forest, first, end));     // a quarter of the domain away from it
}

}  // namespace
}  // namespace veritope
