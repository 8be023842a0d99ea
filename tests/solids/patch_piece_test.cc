// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/patch_piece.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "interval/box_geometry.h"
#include "interval/numeric.h"
#include "interval/upward.h"
#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "solids/classify/patch_cuts.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

using internal::dot;

constexpr std::uint64_t kPieceSeed = 20261203;

BezierSurface<Rational> tensor_map(const Patch& patch) {
  return patch.is_triangle() ? as_tensor_product(patch.triangle()) : patch.tensor();
}

// An exact point of the part, at random.
PatchPoint random_point_of(const PatchPiece& piece, const Patch& patch, Random& random) {
  std::array<Rational, 2> uv;
  for (std::size_t a = 0; a < 2; ++a) {
    const Rational lo = piece.parameter(a, 0), hi = piece.parameter(a, std::size_t{1} << a);
    uv[a] = lo + (hi - lo) * Rational(random.between(0, 16)) / Rational(16);
  }
  return *point_of(evaluate<Rational, 2>(tensor_map(patch), uv));
}

bool is_in(const PatchPoint& p, const Box3& box) {
  for (std::size_t c = 0; c < 3; ++c)
    if (p[c] < Rational::from_double(box[c].lo()) || Rational::from_double(box[c].hi()) < p[c])
      return false;
  return true;
}

Patches many_patches() {
  Patches out = patch_shapes::octant_sphere();
  for (const Patches& more : {patch_shapes::sphere(), patch_shapes::torus(3, 1),
                              patch_shapes::teapot(), patch_shapes::pn_torus(12, 8), unit_box()})
    out.insert(out.end(), more.begin(), more.begin() + 6);
  return out;
}

TEST(PatchPiece, ContainsItsPointsInItsBoxAndBeyondNoPlane) {
  const Patches patches = many_patches();
  for (std::uint32_t number = 0; number < patches.size(); ++number) {
    Random random(kPieceSeed + number);
    const ScopedUpward upward;
    PatchPiece piece(patches[number], number);
    for (int depth = 0; depth < 14; ++depth) {
      EXPECT_EQ(piece.patch(), number);
      for (int i = 0; i < 6; ++i) {
        const PatchPoint p = random_point_of(piece, patches[number], random);
        const Box3d& b = piece.box();
        const Box3 box(Interval::from_bounds(b.lo[0], b.hi[0]),
                       Interval::from_bounds(b.lo[1], b.hi[1]),
                       Interval::from_bounds(b.lo[2], b.hi[2]));
        ASSERT_TRUE(is_in(p, box)) << "seed " << kPieceSeed << " patch " << number;
        // No direction has the point beyond all corners by more than the excess.
        Box3 d;
        for (std::size_t c = 0; c < 3; ++c)
          d[c] = Interval(static_cast<double>(random.between(-8, 8)));
        Interval most = dot(d, piece.corners()[0]), reach;
        for (const Box3& q : piece.corners()) most = hull(most, dot(d, q));
        for (std::size_t c = 0; c < 3; ++c)
          reach += Interval(mag(d[c])) * Interval(piece.excess()[c]);
        const Box3 at(enclose(p[0]), enclose(p[1]), enclose(p[2]));
        ASSERT_LE(dot(d, at).lo(), (most + reach).hi())
            << "seed " << kPieceSeed << " patch " << number << " depth " << depth;
      }
      auto parts = piece.halves(random.below(2) == 0 ? piece.longer_axis() : random.below(2));
      piece = random.below(2) == 0 ? parts.first : parts.second;
    }
  }
}

TEST(PatchPiece, CornersAreExactPoints) {
  const Patches patches = many_patches();
  for (std::uint32_t number = 0; number < patches.size(); ++number) {
    Random random(kPieceSeed + number);
    const ScopedUpward upward;
    PatchPiece piece(patches[number], number);
    for (int depth = 0; depth < 10; ++depth) {
      for (std::size_t i = 0; i < 4; ++i) {
        const PatchPoint p = *point_of(evaluate<Rational, 2>(
            tensor_map(patches[number]), {piece.parameter(0, i), piece.parameter(1, i)}));
        ASSERT_TRUE(is_in(p, piece.corners()[i])) << number << " " << i;
      }
      for (std::size_t a = 0; a < 2; ++a) {
        EXPECT_EQ(Rational::from_double(piece.range(a).lo()), piece.parameter(a, 0));
        EXPECT_EQ(Rational::from_double(piece.range(a).hi()),
                  piece.parameter(a, std::size_t{1} << a));
        EXPECT_EQ(piece.begins_at_zero(a), piece.parameter(a, 0).sign() == Sign::kZero);
        EXPECT_EQ(piece.ends_at_one(a), piece.parameter(a, std::size_t{1} << a) == Rational(1));
      }
      auto parts = piece.halves(random.below(2));
      piece = random.below(2) == 0 ? parts.first : parts.second;
    }
  }
}

// What is beyond the hull of the corners falls with the square of the size.
TEST(PatchPiece, IsNearlyFlatWhenSmall) {
  for (const Patch& patch : patch_shapes::torus(3, 1)) {
    const ScopedUpward upward;
    PatchPiece piece(patch, 0);
    const auto excess = [](const PatchPiece& p) {
      return p.excess()[0] + p.excess()[1] + p.excess()[2];
    };
    const double whole = excess(piece);
    for (int i = 0; i < 8; ++i) piece = piece.halves(static_cast<std::size_t>(i % 2)).second;
    EXPECT_LT(excess(piece), whole / 100);
  }
}

TEST(PatchCuts, MakeManyPartsOfTheSameSurface) {
  const ScopedUpward upward;
  const PatchComplex complex = complex_of(patch_shapes::sphere());
  for (const std::size_t about : {1u, 6u, 7u, 100u}) {
    const std::vector<PatchPiece> pieces = pieces_of(complex, about);
    EXPECT_EQ(pieces.size(), std::max<std::size_t>(about, 6));
    // The squares of parameters of a patch's parts have the area 1 together.
    std::vector<double> areas(complex.patches().size());
    for (const PatchPiece& p : pieces) areas[p.patch()] += wid(p.range(0)) * wid(p.range(1));
    for (const double area : areas) EXPECT_EQ(area, 1);
  }
}

}  // namespace
}  // namespace veritope
