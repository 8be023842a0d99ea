// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/pieces/exact_piece.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "solids/pieces/exact_winding.h"

namespace veritope {
namespace {

PatchComplex complex_of(patch_shapes::Patches patches) {
  PatchInput input;
  input.patches = std::move(patches);
  return make_patch_complex(std::move(input)).value();
}

// Integers and doubles with bounds are two ways to the same coefficients.
TEST(ExactPiece, AgreesWithDoublesWhereTheyDecide) {
  constexpr std::uint64_t kSeed = 11;
  for (const auto& patches :
       {patch_shapes::torus(Rational(3), Rational(1)), patch_shapes::pn_torus(4, 3)}) {
    const PatchComplex complex = complex_of(patches);
    PieceForest forest = PieceForest::make(complex).value();
    Random random(kSeed);
    int decided = 0;
    for (int trial = 0; trial < 40; ++trial) {
      PieceForest::Id id =
          forest.root(static_cast<std::uint32_t>(random.below(forest.num_roots())));
      for (auto depth = random.below(5); depth-- > 0;)
        id = forest.children(id) + static_cast<PieceForest::Id>(random.below(4));
      ExactPiece piece(forest, forest.node(id));
      EXPECT_FALSE(piece.has_determinants());
      EXPECT_TRUE(is_inside(piece.hull(), forest.node(id).hull)) << kSeed << ", " << trial;
      EXPECT_GT(1.001 * extent(piece.hull()), extent(forest.node(id).hull));
      piece.make_determinants();
      Point3d c = approx_centre(forest.node(id).hull);
      for (double& x : c) x += 3 * extent(forest.node(id).hull) * (random.unit() - 0.5);
      const Sign3 side = forest.side_of(id, c);
      if (side == Sign3::kUncertain) continue;
      ++decided;
      const ExactPiece::Side exact(piece, c);
      forest.for_each_kept(forest.node(id), [&](std::size_t i) {
        EXPECT_EQ(exact.at(i), side == Sign3::kPositive ? Sign::kPositive : Sign::kNegative);
        const auto h = piece.approx_half_space(i, c);
        EXPECT_EQ(h[3] > 0, side == Sign3::kPositive);
        const double most = std::max({std::abs(h[0]), std::abs(h[1]), std::abs(h[2])});
        EXPECT_TRUE(0.5 <= most && most <= 1) << most;
      });
    }
    EXPECT_GT(decided, 5);
  }
}

// Lines along z through and beside a cube: the top passes around the first in one direction, the bottom in the other.
TEST(ExactWinding, CountsFacesOnTheLineAndNoOthers) {
  const Rational zero, one(1);
  const PatchComplex complex = complex_of(patch_shapes::box({zero, zero, zero}, {one, one, one}));
  PieceForest forest = PieceForest::make(complex).value();
  const double half = std::ldexp(0.5, forest.scale());
  for (const bool is_beside : {false, true}) {
    const double x = is_beside ? 4 * half : half;
    const CentreLine line{{x, half, 0.5 * half}, {x, half, 1.5 * half}};
    int sum = 0, sizes = 0;
    for (std::uint32_t p = 0; p < forest.num_patches(); ++p) {
      int around = 0;
      for (PieceForest::Id r = 0; r < forest.form(p).num_roots; ++r) {
        const ExactPiece piece(forest, forest.node(forest.form(p).first_root + r));
        for (std::uint32_t s = 0; s < 4; ++s) {
          const auto whole = exact_winding(piece, complex.patch(p), s, line, {0, 1, 2}, 0, 8, 3);
          const auto left = exact_winding(piece, complex.patch(p), s, line, {0, 1, 2}, 0, 3, 3);
          const auto right = exact_winding(piece, complex.patch(p), s, line, {0, 1, 2}, 3, 8, 3);
          ASSERT_TRUE(whole && left && right);
          EXPECT_EQ(*whole, *left + *right);
          around += *whole;
        }
      }
      sum += around, sizes += std::abs(around);
    }
    EXPECT_EQ(sum, 0);
    EXPECT_EQ(sizes, is_beside ? 0 : 2);
  }
}

// At a third of an edge, slanted: no number of halvings ends there.
TEST(ExactWinding, SaysNothingOfALineThroughAnEdge) {
  const Rational zero, three(3);
  const PatchComplex complex =
      complex_of(patch_shapes::box({zero, zero, zero}, {three, three, three}));
  PieceForest forest = PieceForest::make(complex).value();
  const double unit = std::ldexp(1.0, forest.scale());
  // Through (1, 0, 0) along (1, 1, 4): the projected edge from (0, 0, 0) to (3, 0, 0) has ends on either side of 0.
  const CentreLine line{{0, -unit, -4 * unit}, {2 * unit, unit, 4 * unit}};
  int undecided = 0;
  for (std::uint32_t p = 0; p < forest.num_patches(); ++p)
    for (PieceForest::Id r = 0; r < forest.form(p).num_roots; ++r) {
      const ExactPiece piece(forest, forest.node(forest.form(p).first_root + r));
      for (std::uint32_t s = 0; s < 4; ++s) {
        const auto found = exact_winding(piece, complex.patch(p), s, line, {0, 1, 2}, 0, 1, 0);
        const auto turned = exact_winding(piece, complex.patch(p), s, line, {1, 2, 0}, 0, 1, 0);
        undecided += !found || !turned;
      }
    }
  EXPECT_GT(undecided, 0);
}

}  // namespace
}  // namespace veritope
