// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/pieces/patch_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "interval/numeric.h"
#include "interval/upward.h"
#include "models/patch_shapes.h"
#include "solids/patches/patch_transform.h"
#include "solids/pieces/volume_remainder_internal.h"

namespace veritope {
namespace {

Rational ratio(int p, int q = 1) { return Rational(p) / Rational(q); }

std::vector<Interval> volumes(patch_shapes::Patches patches, double tolerance = 1e-5,
                              PieceForest::FrameChoice frame = PieceForest::FrameChoice::kFitted) {
  PatchInput input;
  input.patches = std::move(patches);
  const PatchComplex complex = make_patch_complex(std::move(input)).value();
  PieceForest forest = PieceForest::make(complex, frame).value();
  return shell_volumes(forest, tolerance);
}

void expect_near(const Interval& volume, double expected, double relative) {
  EXPECT_LE(volume.lo(), expected * (1 + 1e-15)) << to_string(volume);
  EXPECT_GE(volume.hi(), expected * (1 - 1e-15)) << to_string(volume);
  EXPECT_LE(wid(volume), relative * expected) << to_string(volume);
}

TEST(ShellVolumes, HoldTheExactVolumes) {
  const patch_shapes::Point low{ratio(1), ratio(-2), ratio(1, 3)},
      high{ratio(3), ratio(1), ratio(7, 3)};
  const auto box = volumes(patch_shapes::box(low, high));
  ASSERT_EQ(box.size(), 1u);
  EXPECT_TRUE(contains(box[0], ratio(12)));
  EXPECT_LE(wid(box[0]), 1e-12);
  constexpr double kPi = std::numbers::pi;
  expect_near(volumes(patch_shapes::sphere())[0], 4 * kPi / 3, 1e-4);
  expect_near(volumes(patch_shapes::octant_sphere())[0], 4 * kPi / 3, 1e-4);
  expect_near(volumes(patch_shapes::torus(ratio(3), ratio(1)))[0], 6 * kPi * kPi, 1e-4);
  expect_near(volumes(patch_shapes::frustum(ratio(2), ratio(0), ratio(5)))[0], 20 * kPi / 3, 1e-4);
}

// Tolerances are kept whatever the model's size is in its frame, and cost a moment.
TEST(ShellVolumes, KeepSmallTolerances) {
  constexpr double kPi = std::numbers::pi;
  for (const double tolerance : {1e-5, 1e-8, 1e-10}) {
    const Interval ball = volumes(patch_shapes::sphere(), tolerance)[0];
    expect_near(ball, 4 * kPi / 3, tolerance);
    const Interval ring = volumes(patch_shapes::torus(ratio(3), ratio(1)), tolerance)[0];
    expect_near(ring, 6 * kPi * kPi, 64 * tolerance);
    const Interval can = volumes(patch_shapes::frustum(ratio(2), ratio(2), ratio(5)), tolerance)[0];
    expect_near(can, 20 * kPi, 125 * tolerance);
  }
}

TEST(ShellVolumes, AreAsNarrowFarFromTheOrigin) {
  for (const int away : {10, 1000, 1000000})
    for (const auto frame : {PieceForest::FrameChoice::kFitted, PieceForest::FrameChoice::kPlain}) {
      const auto ring = patch_shapes::placed(patch_shapes::torus(ratio(3), ratio(1)), ratio(1),
                                             {ratio(away), ratio(0), ratio(-away)});
      expect_near(volumes(ring, 1e-5, frame)[0], 6 * std::numbers::pi * std::numbers::pi, 1e-4);
    }
}

// What no enclosure in binary64 can keep ends, too, where rounding weighs more than what is asked for.
TEST(ShellVolumes, EndAtWhatRoundingAdds) {
  const PatchComplex complex = make_patch_complex(patch_shapes::torus(ratio(3), ratio(1))).value();
  PieceForest forest = PieceForest::make(complex).value();
  const Interval ring = shell_volumes(forest, 1e-300)[0];
  expect_near(ring, 6 * std::numbers::pi * std::numbers::pi, 1e-11);
  EXPECT_LE(forest.num_nodes(), complex.patches().size() * 4096);
}

// Products of degree 71: binomials beyond 64 bits.
TEST(ShellVolumes, HoldForHighRationalDegrees) {
  const auto v = volumes(elevated(patch_shapes::octant_sphere(), 7), 1);
  expect_near(v[0], 4 * std::numbers::pi / 3, 1);
}

TEST(ShellVolumes, AreSignedAndOneAShell) {
  const auto shells = volumes(patch_shapes::thin_shell(ratio(1, 2)));
  ASSERT_EQ(shells.size(), 2u);
  constexpr double kPi = std::numbers::pi;
  expect_near(shells[0], 4 * kPi / 3, 1e-4);
  expect_near(-shells[1], kPi / 6, 1e-4);
}

TEST(ShellVolumes, AreAsNarrowAsAskedFor) {
  double last = 1;
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    const Interval v = volumes(patch_shapes::sphere(), tolerance)[0];
    EXPECT_LE(wid(v), 8 * tolerance);  // coordinates are up to 1, so halved: 1/8 of the volume
    EXPECT_LE(wid(v), last);
    last = wid(v);
  }
}

// What is promised in the frame, whose scale is a power of two; half of it is reached for some tolerance.
TEST(ShellVolumes, KeepTheToleranceAndUseHalfOfIt) {
  const PatchComplex complex = make_patch_complex(patch_shapes::octant_sphere()).value();
  double most = 0;
  for (int k = 0; k < 80; ++k) {
    const double tolerance = std::exp2(-8 - k / 8.0);
    PieceForest forest = PieceForest::make(complex, PieceForest::FrameChoice::kPlain).value();
    const double share = wid(shell_volumes(forest, tolerance)[0]) / tolerance;
    EXPECT_LE(share, 1) << "tolerance " << tolerance;
    most = std::max(most, share);
  }
  EXPECT_GE(most, 0.5);
}

// A face in a plane has its area whatever its weights are; a control point inside may almost have none. Where another
// weight is a third, the enclosure of that one contains 0.
TEST(ShellVolumes, AreFiniteWhereAnInnerWeightAlmostVanishes) {
  const Rational tiny = Rational::power_of_two(-60);
  for (const Rational& other : {ratio(1), ratio(1, 3)}) {
    patch_shapes::Patches box = elevated(
        patch_shapes::box({ratio(0), ratio(0), ratio(0)}, {ratio(1), ratio(1), ratio(1)}), 2);
    const Patch::Tensor& face = box[0].tensor();
    ASSERT_EQ(face.degrees(), (std::array<int, 2>{3, 3}));
    Patch::Tensor map({3, 3}, 4, true);
    for (std::size_t i = 0; i < 16; ++i) {
      const bool is_inner = i == 6 || i == 9 || i == 10;
      const Rational w = i == 5 ? tiny : is_inner ? other : ratio(1);
      for (int c = 0; c < 3; ++c) map.component(c)[i] = w * face.component(c)[i];
      map.component(3)[i] = w;
    }
    box[0] = make_patch(std::move(map)).value();
    const auto v = volumes(box, 1e-6);
    ASSERT_EQ(v.size(), 1u);
    EXPECT_TRUE(contains(v[0], ratio(1))) << to_string(v[0]);
    EXPECT_LE(wid(v[0]), 1e-6);
  }
}

// Sizes far from 1: the interval is that of the unit model times a power of two.
TEST(ShellVolumes, ScaleWithTheModel) {
  for (const int exponent : {-300, 300}) {
    const Rational f = Rational::power_of_two(exponent);
    const auto v = volumes(patch_shapes::placed(
        patch_shapes::box({ratio(0), ratio(0), ratio(0)}, {ratio(1), ratio(1), ratio(1)}), f,
        {ratio(0), ratio(0), ratio(0)}));
    EXPECT_TRUE(contains(v[0], f * f * f)) << exponent;
  }
}

// Triangles have half the domain of tensors, with and without weights of their own.
TEST(ShellVolumes, HoldThoseOfTetrahedra) {
  const PatchPoint o{ratio(1), ratio(0), ratio(-1)}, x{ratio(4), ratio(0), ratio(-1)},
      y{ratio(1, 3), ratio(2), ratio(-1)}, z{ratio(1), ratio(1), ratio(4)};
  const std::vector<std::array<PatchPoint, 3>> faces{{o, y, x}, {o, x, z}, {o, z, y}, {x, y, z}};
  for (const bool is_rational : {false, true}) {
    patch_shapes::Patches patches;
    for (const auto& face : faces) {
      Patch::Triangle map(1, is_rational ? 4 : 3, is_rational);
      for (std::size_t i = 0; i < 3; ++i) {
        const Rational w = !is_rational   ? ratio(1)
                           : face[i] == o ? ratio(2)
                           : face[i] == z ? ratio(5, 7)
                                          : ratio(1);
        for (int c = 0; c < 3; ++c) map.component(c)[i] = w * face[i][static_cast<std::size_t>(c)];
        if (is_rational) map.component(3)[i] = w;
      }
      patches.push_back(make_patch(std::move(map)).value());
    }
    const auto v = volumes(patches, 1e-9);
    ASSERT_EQ(v.size(), 1u);
    EXPECT_TRUE(contains(v[0], ratio(5))) << to_string(v[0]);
    EXPECT_LE(wid(v[0]), is_rational ? 1e-7 : 1e-12);
  }
}

// The product of all t - c_j, exactly: no more than the bound anywhere, and as much at an end.
TEST(VolumeRemainder, BoundsTheProductOfTheNodesAndIsNearlyReached) {
  for (int order = 0; order <= 9; ++order) {
    const ScopedUpward upward;
    const internal::InterpolationNodes nodes(order);
    ASSERT_EQ(nodes.nodes.size(), static_cast<std::size_t>(order) + 1);
    Rational greatest;
    for (int i = -60; i <= 60; ++i) {
      Rational product(1);
      for (const double c : nodes.nodes) product *= ratio(i, 60) - Rational::from_double(c);
      greatest = std::max(greatest, abs(product));
    }
    const Rational bound = Rational::from_double(nodes.product);
    EXPECT_TRUE(greatest <= bound) << order;
    EXPECT_TRUE(bound <= Rational::power_of_two(-order) * (ratio(1) + Rational::power_of_two(-30)))
        << order;
  }
}

// What Newton's polynomial loses of (1 + x)^-3 at the ends of [-d, d], in rationals: for small d nearly the bound.
TEST(VolumeRemainder, BoundsWhatTheInterpolantLosesAndIsNearlyReached) {
  for (int order = 0; order <= 9; ++order)
    for (const double d : {0x1p-12, 0x1p-4, 0.375}) {
      const ScopedUpward upward;
      const internal::InterpolationNodes nodes(order);
      const double most = 3, m = 0.75;
      const Rational bound = Rational::from_double(
          internal::volume_remainder(order, nodes.product, d, most, Interval(m)));
      const auto f = [](const Rational& x) {
        const Rational w = ratio(1) + x;
        return ratio(1) / (w * w * w);
      };
      Rational greatest;
      for (const int end : {-1, 1}) {
        const Rational x = Rational::from_double(d) * ratio(end);
        Rational value;  // by Lagrange
        for (std::size_t i = 0; i < nodes.nodes.size(); ++i) {
          const Rational xi = Rational::from_double(d) * Rational::from_double(nodes.nodes[i]);
          Rational term = f(xi);
          for (std::size_t j = 0; j < nodes.nodes.size(); ++j) {
            if (j == i) continue;
            const Rational xj = Rational::from_double(d) * Rational::from_double(nodes.nodes[j]);
            term *= (x - xj) / (xi - xj);
          }
          value += term;
        }
        greatest = std::max(greatest, abs(f(x) - value));
      }
      const Rational m3 = Rational::from_double(m * m * m);
      greatest = greatest * Rational::from_double(most) / m3;
      EXPECT_TRUE(greatest <= bound) << order << ", " << d;
      if (d == 0x1p-12) {
        EXPECT_TRUE(bound <= ratio(51, 50) * greatest) << order;
      }
    }
}

TEST(VolumeRemainder, IsInfiniteWhereTheWeightMayVanish) {
  const ScopedUpward upward;
  const internal::InterpolationNodes nodes(3);
  EXPECT_FALSE(std::isfinite(internal::volume_remainder(3, nodes.product, 1, 1, Interval(1.0))));
}

}  // namespace
}  // namespace veritope
