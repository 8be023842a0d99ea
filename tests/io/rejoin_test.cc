// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/rejoin.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "io/splines/patch_model.h"
#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "solids/patches/patch_complex.h"
#include "solids/patches/patch_transform.h"
#include "splines/bezier_degree.h"
#include "splines/bezier_domain.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

using Patches = std::vector<Patch>;

bool always(const SplineEntity&) { return true; }

PatchComplex complex_of(const SplineModel& model) {
  return make_patch_complex(patch_source(model).value().patches).value();
}
Patches halves(const Patch& patch, std::size_t axis, const Rational& at) {
  const Patch::Tensor& map = patch.tensor();
  return {make_patch(restricted(map, axis, Rational(0), at)).value(),
          make_patch(restricted(map, axis, at, Rational(1))).value()};
}
// The model with patch number `which` cut in two.
SplineModel with_cut(Patches patches, std::size_t which, std::size_t axis, const Rational& at) {
  const Patches parts = halves(patches[which], axis, at);
  patches[which] = parts[0];
  patches.push_back(parts[1]);
  return model_of(patches);
}
const Rational kThird = Rational(1) / Rational(3);

TEST(Rejoin, ACutFaceIsFollowedAllAroundAndTheSurfaceIsClosed) {
  const SplineModel torn = with_cut(patch_shapes::box({0, 0, 0}, {1, 1, 1}), 0, 0, kThird);
  ASSERT_FALSE(complex_of(torn).is_closed_oriented_surface());
  const Rejoined done = rejoined(torn, always).value();
  EXPECT_TRUE(complex_of(done.model).is_closed_oriented_surface());
  EXPECT_TRUE(done.left.empty());
  EXPECT_FALSE(done.joined.empty());
  for (const Joint& joint : done.joined)
    EXPECT_TRUE(std::find(joint.at.begin(), joint.at.end(), kThird) != joint.at.end() ||
                std::find(joint.at.begin(), joint.at.end(), Rational(1) - kThird) !=
                    joint.at.end());
}

TEST(Rejoin, AModelThatFitsIsLeftAsItIs) {
  for (const Patches& good : {patch_shapes::sphere(), patch_shapes::torus(3, 1)}) {
    const SplineModel model = model_of(good);
    const Rejoined done = rejoined(model, always).value();
    EXPECT_EQ(done.model, model);
    EXPECT_TRUE(done.joined.empty());
    EXPECT_TRUE(done.left.empty());
  }
}

// Inserted knots do not change the map, exactly: compared at rational parameters.
TEST(Rejoin, TheSurfaceStaysTheSamePointForPoint) {
  const SplineModel torn = with_cut(patch_shapes::torus(3, 1), 1, 1, kThird);
  const Rejoined done = rejoined(torn, always).value();
  ASSERT_TRUE(complex_of(done.model).is_closed_oriented_surface());
  ASSERT_EQ(done.model.entities.size(), torn.entities.size());
  for (std::size_t e = 0; e < torn.entities.size(); ++e) {
    const auto& before = std::get<ExactSurface>(torn.entities[e].shape);
    const auto& after = std::get<ExactSurface>(done.model.entities[e].shape);
    const auto pieces = bezier_pieces(after);
    const auto whole = bezier_pieces(before);
    ASSERT_EQ(whole.pieces.size(), 1u);
    for (std::size_t i = 0; i + 1 < pieces.breaks[0].size(); ++i)
      for (std::size_t j = 0; j + 1 < pieces.breaks[1].size(); ++j)
        EXPECT_EQ(pieces.at({i, j}), restricted(restricted(whole.pieces[0], 0, pieces.breaks[0][i],
                                                           pieces.breaks[0][i + 1]),
                                                1, pieces.breaks[1][j], pieces.breaks[1][j + 1]))
            << "entity " << e;
  }
}

TEST(Rejoin, ATriangleIsCutFromItsOppositeCorner) {
  // A tetrahedron, one face of which is two triangles.
  const auto flat = [](const PatchPoint& a, const PatchPoint& b, const PatchPoint& c) {
    std::vector<Rational> values;
    for (std::size_t i = 0; i < 3; ++i) values.insert(values.end(), {a[i], b[i], c[i]});
    return make_patch(Patch::Triangle(1, 3, false, std::move(values))).value();
  };
  const PatchPoint o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1},
      m{kThird, Rational(1) - kThird, 0};
  const SplineModel torn =
      model_of(Patches{flat(o, m, x), flat(o, y, m), flat(o, x, z), flat(o, z, y), flat(x, y, z)});
  const Rejoined done = rejoined(torn, always).value();
  EXPECT_TRUE(complex_of(done.model).is_closed_oriented_surface());
  ASSERT_EQ(done.joined.size(), 1u);
  EXPECT_EQ(done.joined[0].entity, 4u);
  EXPECT_EQ(done.joined[0].at, (std::vector<Rational>{kThird, Rational(1) - kThird, 0}));
  EXPECT_EQ(done.model.entities.size(), 6u);
}

TEST(Rejoin, WhatCannotBeHeldIsLeftAloneAndNamed) {
  const SplineModel torn = with_cut(patch_shapes::box({0, 0, 0}, {1, 1, 1}), 0, 0, kThird);
  const Rejoined done = rejoined(torn, [](const SplineEntity&) { return false; }).value();
  EXPECT_EQ(done.model, torn);
  EXPECT_TRUE(done.joined.empty());
  ASSERT_FALSE(done.left.empty());
  EXPECT_NE(done.left[0].find("cannot be written exactly"), std::string::npos);
}

TEST(Rejoin, SidesWithOtherParametersAreNamedAndLeft) {
  Patches patches = patch_shapes::box({0, 0, 0}, {1, 1, 1});
  Patch::Tensor quadratic = elevate(patches[5].tensor(), 0, 1);
  for (int c = 0; c < 3; ++c)
    for (std::size_t k : {std::size_t{2}, std::size_t{3}})
      quadratic.component(c)[k] =
          (quadratic.component(c)[k - 2] * 3 + quadratic.component(c)[k + 2]) / 4;
  patches[5] = make_patch(std::move(quadratic)).value();
  const SplineModel torn = model_of(patches);
  const Rejoined done = rejoined(torn, always).value();
  EXPECT_EQ(done.model, torn);
  ASSERT_EQ(done.left.size(), 2u);
  EXPECT_NE(done.left[0].find("no affine change"), std::string::npos);
}

TEST(Rejoin, OtherEntitiesAreRefused) {
  SplineModel model = model_of(patch_shapes::sphere());
  model.entities[0].shape =
      ExactCurve({KnotAxis<Rational>{1, {0, 0, 1, 1}}}, 3, false, std::vector<Rational>(6));
  const auto done = rejoined(model, always);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, Code::kBadArgument);
}

// Random cuts of closed models, and random orders and corners: the surface closes again.
TEST(Rejoin, RandomlyCutModelsCloseAgain) {
  constexpr std::uint64_t kSeed = 20260721;
  Random random(kSeed);
  for (int n = 0; n < 12; ++n) {
    Patches patches =
        n % 2 == 0 ? patch_shapes::torus(3, 1) : patch_shapes::box({0, 0, 0}, {3, 2, 1});
    patches = relabelled(patches, random);
    for (int k = 0; k < 3; ++k) {
      const auto which = static_cast<std::size_t>(random.below(patches.size()));
      const Rational at = Rational(1 + random.below(6)) / Rational(7);
      const Patches parts = halves(patches[which], random.below(2), at);
      patches[which] = parts[0];
      patches.push_back(parts[1]);
    }
    const Rejoined done = rejoined(model_of(patches), always).value();
    EXPECT_TRUE(complex_of(done.model).is_closed_oriented_surface())
        << "case " << n << " of seed " << kSeed;
    EXPECT_TRUE(done.left.empty()) << "case " << n << " of seed " << kSeed;
  }
}

}  // namespace
}  // namespace veritope
