// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/patch_model.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "io/splines/spline_builder.h"
#include "io/splines/write_splines.h"
#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "solids/patches/patch_complex.h"
#include "splines/bspline_domain.h"
#include "splines/bspline_pieces.h"
#include "splines/de_boor.h"
#include "splines/knot_insertion.h"
#include "tests/io/spline_test_util.h"

namespace veritope {
namespace {

bool same_map(const Patch& a, const Patch& b) {
  if (a.is_triangle() != b.is_triangle()) return false;
  return a.is_triangle() ? a.triangle() == b.triangle() : a.tensor() == b.tensor();
}

ExactSurface bilinear() {
  ExactSurface::Axis axis{1, bezier_knots(1)};
  return {{axis, axis},
          3,
          false,
          {Rational(0), Rational(0), Rational(1), Rational(1), Rational(0), Rational(1),
           Rational(0), Rational(2), Rational(0), Rational(0), Rational(0), Rational(5)}};
}
ExactTriangle corner(int components) {
  ExactTriangle out(1, components, false);
  out.component(0)[1] = Rational(1), out.component(1)[2] = Rational(1);
  return out;
}
SplineEntity entity(auto shape) { return {std::move(shape), {}, {}, {}}; }

TEST(PatchModel, EveryShapeComesBackFromItsFile) {
  std::vector<patch_shapes::Shape> shapes = patch_shapes::sound_shapes();
  for (patch_shapes::Shape& broken : patch_shapes::broken_shapes())
    shapes.push_back(std::move(broken));
  std::size_t num_triangles = 0;
  for (const patch_shapes::Shape& shape : shapes) {
    SCOPED_TRACE(shape.name);
    const SplineModel model = model_of(shape.patches);
    const std::string bytes = spline_json_bytes(model);
    const SplineModel read = io_test::model_of(SplineFormat::kJson, bytes);
    EXPECT_TRUE(read == model);
    EXPECT_EQ(spline_json_bytes(read), bytes);
    const PatchSource source = patch_source(read).value();
    EXPECT_TRUE(source.foreign.empty());
    ASSERT_EQ(source.patches.size(), shape.patches.size());
    ASSERT_EQ(source.entities.size(), shape.patches.size());
    for (std::size_t p = 0; p < source.patches.size(); ++p) {
      const Patch& patch = source.patches[p];
      const PatchEntity& from = source.entities[p];
      EXPECT_TRUE(same_map(patch, shape.patches[p])) << p;
      EXPECT_EQ(patch.origin().number, p);
      EXPECT_EQ(from.first_patch, p);
      EXPECT_EQ(from.num_patches, 1u);
      const std::vector<Rational> whole{Rational(0), Rational(1)};
      for (const auto& breaks : from.breaks)
        EXPECT_EQ(breaks, patch.is_triangle() ? std::vector<Rational>{} : whole) << p;
      num_triangles += patch.is_triangle() ? 1 : 0;
    }
  }
  EXPECT_GE(num_triangles, 192u);
}

TEST(PatchModel, PatchesAreInTheOrderOfTheEntitiesAndOfTheirPieces) {
  const ExactSurface cut =
      refine(refine(bilinear(), 0, {Rational(1) / 3}), 1, {Rational(1) / 4, Rational(1) / 2});
  // Far from the first surface, so that no side ties them.
  ExactSurface aside = bilinear();
  for (Rational& x : aside.component(0)) x += Rational(10);
  const SplineModel model{
      {}, {entity(corner(3)), entity(cut), entity(corner(3)), entity(aside), entity(corner(3))}};
  const PatchSource source = patch_source(model).value();
  ASSERT_EQ(source.entities.size(), 5u);
  const std::size_t first[] = {0, 1, 7, 8, 9}, count[] = {1, 6, 1, 1, 1};
  for (std::size_t e = 0; e < 5; ++e) {
    EXPECT_EQ(source.entities[e].first_patch, first[e]);
    EXPECT_EQ(source.entities[e].num_patches, count[e]);
    for (std::size_t k = 0; k < count[e]; ++k)
      EXPECT_EQ(source.patches[first[e] + k].origin().number, e);
  }
  EXPECT_EQ(to_string(source.patches[0].origin()), "triangle 0");
  EXPECT_EQ(to_string(source.patches[2].origin()), "surface 1, span (0, 1)");  // v fastest
  EXPECT_EQ(to_string(source.patches[4].origin()), "surface 1, span (1, 0)");
  EXPECT_EQ(source.entities[1].breaks[0],
            (std::vector<Rational>{Rational(0), Rational(1) / 3, Rational(1)}));
  EXPECT_EQ(source.entities[1].breaks[1],
            (std::vector<Rational>{Rational(0), Rational(1) / 4, Rational(1) / 2, Rational(1)}));
}

// Corners of each piece are the surface's points at the breaks.
void expect_pieces_at_breaks(const ExactSurface& surface, const PatchSource& source,
                             const PatchEntity& from) {
  const auto& [u, v] = from.breaks;
  ASSERT_GE(u.size(), 2u);
  ASSERT_GE(v.size(), 2u);
  ASSERT_EQ(from.num_patches, (u.size() - 1) * (v.size() - 1));
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto& breaks = from.breaks[axis];
    const auto& knots = surface.axis(axis);
    EXPECT_EQ(breaks.front(), knots.domain_begin());
    EXPECT_EQ(breaks.back(), knots.domain_end());
    EXPECT_TRUE(std::is_sorted(breaks.begin(), breaks.end()));
    EXPECT_EQ(std::adjacent_find(breaks.begin(), breaks.end()), breaks.end());
    for (const Rational& k : knots.knots)
      if (breaks.front() <= k && k <= breaks.back()) {
        EXPECT_TRUE(std::binary_search(breaks.begin(), breaks.end(), k)) << k.to_string();
      }
  }
  for (std::size_t i = 0; i + 1 < u.size(); ++i)
    for (std::size_t j = 0; j + 1 < v.size(); ++j) {
      const Patch& patch = source.patches[from.first_patch + i * (v.size() - 1) + j];
      const std::size_t at[4][2] = {{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}};
      for (std::uint32_t c = 0; c < 4; ++c)
        EXPECT_EQ(patch.corner(c),
                  evaluate(surface, std::array<Rational, 2>{u[at[c][0]], v[at[c][1]]}).value())
            << i << " " << j << " " << c;
    }
}

TEST(PatchModel, KnotsSpreadAndBreaksAreInTheSurfacesOwnParameters) {
  Random random(20251130);
  for (int round = 0; round < 5; ++round) {
    SCOPED_TRACE("seed 20251130, round " + std::to_string(round));
    SplineModel model;
    for (const Patch& patch : patch_shapes::octant_sphere()) {
      ExactSurface s = to_bspline(patch.tensor());
      for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
        if (random.below(3) == 0) s = refine(s, axis, {Rational(random.between(1, 6)) / 7});
        s = with_domain(s, axis, Rational(random.between(-5, 5)), Rational(random.between(6, 9)))
                .value();
      }
      model.entities.push_back(entity(s));
    }
    const PatchSource source = patch_source(model).value();
    for (std::size_t e = 0; e < model.entities.size(); ++e)
      expect_pieces_at_breaks(std::get<ExactSurface>(model.entities[e].shape), source,
                              source.entities[e]);
    EXPECT_TRUE(make_patch_complex(source.patches).value().is_closed_oriented_surface());
  }
}

TEST(PatchModel, APeriodicSurfaceIsCutInItsDomain) {
  // Quadratic and closed along u, with knots outside of the domain.
  const SplineModel model = io_test::model_of(
      SplineFormat::kItd,
      "[SURFACE BSPLINE 4 2 3 2 E3 [KVP 0 1 2 3 4 5 6 7 8] [KV 0 0 1 1] [0 0 0] [1 0 0] [1 1 0] "
      "[0 1 0] [0 0 2] [1 0 2] [1 1 2] [0 1 2]]");
  const auto& surface = std::get<ExactSurface>(model.entities[0].shape);
  ASSERT_TRUE(surface.axis(0).is_periodic);
  const PatchSource source = patch_source(model).value();
  EXPECT_EQ(source.patches.size(), 4u);
  expect_pieces_at_breaks(surface, source, source.entities[0]);
}

TEST(PatchModel, WhatIsNoSurfaceOrTriangleInSpaceIsNamedAndPlaced) {
  SplineModel model = io_test::sample("groups.itd").model;  // curves, a surface, a volume
  model.entities.push_back(entity(corner(3)));
  model.entities.push_back(entity(corner(2)));
  const ExactSurface planar{bilinear().axes(), 2, false, std::vector<Rational>(8)};
  model.entities.push_back(entity(planar));
  model.entities.push_back(entity(TrimmedSurface{bilinear(), {}}));
  model.entities.push_back(entity(SplineBrep{}));
  const PatchSource source = patch_source(model).value();
  EXPECT_TRUE(source.patches.empty());
  EXPECT_TRUE(source.entities.empty());
  std::vector<std::string> named;
  for (const ForeignEntity& f : source.foreign) named.push_back(to_string(f));
  EXPECT_EQ(named,
            (std::vector<std::string>{
                "entity 0, a curve", "entity 2, a curve", "entity 3, a curve", "entity 4, a volume",
                "entity 6, a triangle with 2 coordinates", "entity 7, a surface with 2 coordinates",
                "entity 8, a trimmed surface", "entity 9, a model"}));
  EXPECT_EQ(source.foreign[0].place.line, model.entities[0].place.line);
  EXPECT_EQ(source.foreign[5].dimension, 2);
  EXPECT_EQ(source.foreign[0].dimension, std::nullopt);
}

TEST(PatchModel, NothingHasNoPatches) {
  const PatchSource source = patch_source({}).value();
  EXPECT_TRUE(source.patches.empty() && source.entities.empty() && source.foreign.empty());
  EXPECT_TRUE(model_of(std::span<const Patch>{}).entities.empty());
}

TEST(PatchModel, DegreesThatNoFileHasAreRefusedWithTheirEntity) {
  const ExactSurface::Axis constant{0, {Rational(0), Rational(1)}}, high{64, bezier_knots(64)},
      one{1, bezier_knots(1)};
  const auto refusal = [](auto shape) {
    const auto source = patch_source({{}, {entity(corner(3)), entity(std::move(shape))}});
    EXPECT_FALSE(source);
    return source ? Error{Code::kEmpty, {}, ""} : source.error();
  };
  const Error flat = refusal(ExactSurface({constant, one}, 3, false, std::vector<Rational>(6)));
  EXPECT_EQ(flat.code, Code::kBadArgument);
  EXPECT_EQ(flat.place.entity, 1u);
  const Error steep = refusal(ExactSurface({one, high}, 3, false, std::vector<Rational>(390)));
  EXPECT_EQ(steep.code, Code::kOverLimit);
  EXPECT_EQ(steep.place.entity, 1u);
  const Error point = refusal(ExactTriangle(0, 3, false));
  EXPECT_EQ(point.code, Code::kBadArgument);
  EXPECT_EQ(point.place.entity, 1u);
  EXPECT_EQ(refusal(ExactTriangle(64, 3, false)).code, Code::kOverLimit);
}

}  // namespace
}  // namespace veritope
