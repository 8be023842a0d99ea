// SPDX-License-Identifier: LGPL-3.0-or-later
#include "models/patch_shapes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solids/patches/patch_complex.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

using patch_shapes::Shape;
using patch_shapes::Truth;

void expect_surface(const Shape& shape) {
  SCOPED_TRACE(shape.name);
  const PatchComplex complex = make_patch_complex(shape.patches).value();
  EXPECT_TRUE(complex.is_closed_oriented_surface()) << all_findings(complex);
  ASSERT_EQ(complex.shells().size(), shape.genus.size());
  for (std::size_t s = 0; s < shape.genus.size(); ++s)
    EXPECT_EQ(complex.shells()[s].genus(), std::optional<std::int64_t>(shape.genus[s]));
}

TEST(PatchShapes, SoundOnesAreClosedSurfacesOfTheGenusThatTheySay) {
  for (const Shape& shape : patch_shapes::sound_shapes()) {
    expect_surface(shape);
    EXPECT_EQ(shape.truth, Truth::kEmbedded) << shape.name;
  }
}
TEST(PatchShapes, BrokenOnesAreClosedSurfacesToo) {
  for (const Shape& shape : patch_shapes::broken_shapes()) {
    expect_surface(shape);
    EXPECT_NE(shape.truth, Truth::kEmbedded) << shape.name;
  }
}

// The volume of the tessellations, by Gauss: positive iff normals point out.
TEST(PatchShapes, NormalsPointOutOfSoundShapes) {
  for (const Shape& shape : patch_shapes::sound_shapes())
    EXPECT_GT(approx_volume(shape.patches), 0.01) << shape.name;
}
TEST(PatchShapes, VolumesAreThoseOfTheSolids) {
  const double pi = 3.14159265358979;
  const auto expect = [](const std::vector<Patch>& patches, double volume) {
    EXPECT_NEAR(approx_volume(patches, patches.size() == 1 ? 64 : 8), volume,
                0.02 * std::abs(volume));
  };
  expect(patch_shapes::box({0, 0, 0}, {1, 2, 3}), 6);
  expect(patch_shapes::sphere(), 4 * pi / 3);
  expect(patch_shapes::octant_sphere(), 4 * pi / 3);
  expect(patch_shapes::torus(3, 1), 6 * pi * pi);
  expect(patch_shapes::one_patch_torus(3, 1), 6 * pi * pi);
  expect(patch_shapes::frustum(1, 1, 2), 2 * pi);
  expect(patch_shapes::frustum(1, 0, 2), 2 * pi / 3);
  expect(patch_shapes::plate(3), 18);
  expect(patch_shapes::thin_shell(Rational(1) / 2), 4 * pi / 3 * 7 / 8);
  expect(patch_shapes::reversed(patch_shapes::placed(patch_shapes::torus(3, 1), -2, {1, 2, 3})),
         -48 * pi * pi);
}

}  // namespace
}  // namespace veritope
