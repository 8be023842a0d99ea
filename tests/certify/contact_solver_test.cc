// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/contact_solver.h"

#include <gtest/gtest.h>

#include "models/thin_shapes.h"
#include "robust/base/random.h"
#include "solids/patches/patch_transform.h"
#include "tests/solids/patch_support.h"
#include "verify/certify/affine_patch.h"
#include "verify/certify/patch_decision.h"

namespace veritope {
namespace {

using patch_shapes::joined;

Rational ratio(int n, int d) { return Rational(n) / Rational(d); }

// The common point that the solver finds from two whole patches, or nothing.
std::optional<PatchPoint> contact_of(const Patches& patches, std::uint32_t a, std::uint32_t b) {
  const PatchComplex complex = complex_of(patches);
  const PieceForest forest = PieceForest::make(complex).value();
  SheetMaps maps(forest);
  ContactSolver solver(maps);
  const auto found = solver.solve(range_of_piece(forest, forest.form(a).first_root),
                                  range_of_piece(forest, forest.form(b).first_root));
  if (!found) return std::nullopt;
  EXPECT_EQ(broken_condition(complex, *found), std::nullopt);
  return point_of(complex, *found);
}

// The top of a box and the lowest patch of another model, by where it lies.
Patches on_a_box(const Patches& other) {
  return joined({patch_shapes::box({0, 0, 0}, {1, 1, 1}), other});
}

TEST(ContactSolver, FindsContactsOfEveryKindOfPlace) {
  const Patches box = unit_box();
  const auto box_at = [](const PatchPoint& low, const PatchPoint& high) {
    return on_a_box(patch_shapes::box(low, high));
  };
  const auto has_contact = [](const Patches& patches) {
    for (std::uint32_t a = 0; a < 6; ++a)
      for (std::uint32_t b = 6; b < 12; ++b)
        if (contact_of(patches, a, b)) return true;
    return false;
  };
  const Rational low = ratio(1, 4), high = ratio(3, 4);
  EXPECT_TRUE(has_contact(box_at({low, low, 1}, {high, high, 2}))) << "face in face";
  EXPECT_TRUE(has_contact(box_at({low, low, 1}, {2, high, 2}))) << "faces that overlap";
  EXPECT_TRUE(has_contact(box_at({1, low, 1}, {2, high, 2}))) << "edge in edge";
  EXPECT_TRUE(has_contact(box_at({1, 1, 1}, {2, 2, 2}))) << "vertex on vertex";
  EXPECT_FALSE(has_contact(box_at({1, 1, ratio(1000001, 1000000)}, {2, 2, 2}))) << "a gap";
  // A corner of a turned box, at the middle of a face, of an edge.
  const Rational length(2);
  const AffineMap to_corner{3, 3, {1, 1, -2, 1, -2, 1, 1, 1, 1}, {ratio(1, 3), ratio(1, 5), 1}};
  const Patches turned = affine_image(patch_shapes::box({0, 0, 0}, {1, 1, 1}), to_corner).value();
  EXPECT_TRUE(has_contact(on_a_box(turned))) << "vertex in face";
}

TEST(ContactSolver, FindsTangentSheetsAtSimpleParametersUnderEveryMap) {
  Random random(3);
  const Patches ball = patch_shapes::sphere();
  for (int i = 0; i < 20; ++i) {
    AffineMap map{3, 3, {}, {}};
    for (int k = 0; k < 9; ++k)
      map.linear.push_back(ratio(static_cast<int>(random.between(-9, 9)), 4));
    for (int k = 0; k < 3; ++k) map.translation.push_back(Rational(random.between(-9, 9)));
    const auto image = affine_image(joined({ball, patch_shapes::placed(ball, 1, {2, 0, 0})}), map);
    if (!image) continue;  // a singular map
    const auto found = contact_of(*image, 2, 10);
    ASSERT_TRUE(found) << i;
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ((*found)[k], map.linear[3 * k] + map.translation[k]) << i;
  }
}

// Law: sheets that touch are found although they part like 2^-k of their size only.
TEST(ContactSolver, FindsContactsOfSheetsThatNearlyCoincide) {
  for (const int k : {4, 10, 20, 28}) {
    const Rational gap = Rational::power_of_two(-k);
    const auto found = contact_of(thin_shapes::spheres(gap, gap), 2, 8);
    ASSERT_TRUE(found) << k;
    EXPECT_EQ(*found, (PatchPoint{1, 0, 0})) << k;
    EXPECT_FALSE(contact_of(thin_shapes::spheres(gap, gap * ratio(7, 8)), 2, 8)) << k;
  }
}

TEST(ContactSolver, StopsAtItsLimits) {
  const PatchComplex complex = complex_of(patch_shapes::sound_shapes()[1].patches);
  const PieceForest forest = PieceForest::make(complex).value();
  SheetMaps maps(forest);
  ContactSolver solver(maps);
  const SheetRange all{0, {{{0, 1}, {0, 1}}}}, other{1, {{{0, 1}, {0, 1}}}};
  for (int i = 0; i < 1000; ++i) EXPECT_FALSE(solver.solve(all, other));
  EXPECT_LE(solver.num_solved, ContactSolver::kMostSolved);
  EXPECT_EQ(solver.num_tested, 0u) << "neighbours meet where they are glued";
}

TEST(AffinePatch, InvertsWhatIsAffineAndNothingElse) {
  const Patch square = bilinear({{{0, 0, 0}, {2, 0, 1}, {2, 3, 1}, {0, 3, 0}}});
  const Patch saddle = bilinear({{{0, 0, 0}, {2, 0, 1}, {2, 3, 1}, {0, 3, 5}}});
  const Patch triangle = flat({1, 0, 0}, {0, 2, 0}, {0, 0, 3});
  const Patch raised = make_patch(elevate_to(square.tensor(), {3, 2})).value();
  EXPECT_FALSE(AffinePatch::make(saddle));
  EXPECT_FALSE(AffinePatch::make(flat({1, 0, 0}, {2, 0, 0}, {3, 0, 0})));
  EXPECT_FALSE(AffinePatch::make(patch_shapes::sphere()[0]));
  for (const Patch& patch : {square, raised, triangle}) {
    const PatchComplex complex = complex_of({patch});
    const auto map = AffinePatch::make(patch);
    ASSERT_TRUE(map);
    for (const auto& at :
         {std::array{ratio(1, 3), ratio(2, 7)}, std::array{Rational(1), Rational(0)}})
      EXPECT_EQ(map->parameters_of(point_of(complex, PatchPlace{0, at})), at);
    EXPECT_FALSE(map->parameters_of({-1, -1, 0}));
  }
}

TEST(RangeOfPiece, HoldsTheTensorFormOfThePiece) {
  const PatchComplex complex = complex_of({flat({0, 0, 0}, {1, 0, 0}, {0, 1, 0})});
  PieceForest forest = PieceForest::make(complex).value();
  const auto first = forest.children(forest.root(0));
  // Around corner 0 any t, and s up to a half; the quarter in the middle has s from a half on.
  const SheetRange corner = range_of_piece(forest, first),
                   middle = range_of_piece(forest, first + 3);
  EXPECT_EQ(corner.at, (std::array<std::array<double, 2>, 2>{{{0, 0.5}, {0, 1}}}));
  EXPECT_EQ(middle.at, (std::array<std::array<double, 2>, 2>{{{0.5, 1}, {0, 1}}}));
}

}  // namespace
}  // namespace veritope
