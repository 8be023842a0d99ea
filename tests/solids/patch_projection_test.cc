// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/patch_projection.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/patch_shapes.h"
#include "models/round_parts.h"
#include "solids/classify/mesh_projection.h"
#include "solids/patches/patch_sources.h"
#include "tests/predicates/test_scale.h"
#include "tests/solids/patch_support.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

constexpr std::uint64_t kFootSeed = 20261204;

Rational fq(std::int64_t p, std::int64_t d = 1) { return Rational(p) / Rational(d); }

PatchProjectionAnswer projected(const Patches& patches, const ExactPoint& p,
                                std::size_t max_parts = 20000) {
  const PatchComplex complex = complex_of(patches);
  return PatchProjection(complex).project(p, max_parts);
}
bool holds(const Interval& a, const Rational& x) {
  return Rational::from_double(a.lo()) <= x && x <= Rational::from_double(a.hi());
}
bool holds(const Box3& box, const ExactPoint& p) {
  return holds(box[0], p[0]) && holds(box[1], p[1]) && holds(box[2], p[2]);
}
double width_of(const Box3& box) {
  return std::max(
      {box[0].hi() - box[0].lo(), box[1].hi() - box[1].lo(), box[2].hi() - box[2].lo()});
}

TEST(PatchProjection, FindsFeetOnFacesEdgesAndVerticesOfABox) {
  const Patches box = patch_shapes::box({0, 0, 0}, {4, 4, 4});
  const auto above = projected(box, {fq(1), fq(2), fq(7)});
  ASSERT_EQ(above.places.size(), 1u);
  EXPECT_TRUE(above.places[0].is_single);
  EXPECT_TRUE(holds(above.places[0].point, {fq(1), fq(2), fq(4)}));
  EXPECT_LT(width_of(above.places[0].point), 1e-13);
  EXPECT_TRUE(holds(above.squared_distance, fq(9)));
  EXPECT_EQ(above.places[0].feature, PatchFeature::kPatch);
  const auto edge = projected(box, {fq(5), fq(1, 3), fq(6)});
  ASSERT_EQ(edge.places.size(), 1u);
  EXPECT_EQ(edge.places[0].feature, PatchFeature::kEdge);
  EXPECT_TRUE(edge.places[0].is_single);
  EXPECT_TRUE(holds(edge.places[0].point, {fq(4), fq(1, 3), fq(4)}));
  EXPECT_TRUE(holds(edge.squared_distance, fq(5)));
  const auto corner = projected(box, {fq(5), fq(6), fq(7)});
  ASSERT_EQ(corner.places.size(), 1u);
  EXPECT_EQ(corner.places[0].feature, PatchFeature::kVertex);
  EXPECT_TRUE(corner.places[0].is_single);
  EXPECT_TRUE(holds(corner.squared_distance, fq(14)));
}

TEST(PatchProjection, ReportsTiesInLexicographicOrder) {
  const Patches box = patch_shapes::box({0, 0, 0}, {4, 4, 4});
  const auto tie = projected(box, {fq(1), fq(1), fq(2)});
  ASSERT_EQ(tie.places.size(), 2u);
  EXPECT_TRUE(tie.is_tie());
  EXPECT_TRUE(holds(tie.places[0].point, {fq(0), fq(1), fq(2)}));
  EXPECT_TRUE(holds(tie.places[1].point, {fq(1), fq(0), fq(2)}));
  EXPECT_EQ(projected(box, {fq(2), fq(2), fq(2)}).places.size(), 6u);
  // On the axis of a torus there are whole circles: all work is spent, and nothing is left out.
  const auto circle = projected(patch_shapes::torus(3, 1), {fq(0), fq(0), fq(0)}, 2000);
  EXPECT_FALSE(circle.is_decided);
  EXPECT_TRUE(holds(circle.squared_distance, fq(4)));
  bool is_there = false;
  for (const NearestPlace& p : circle.places)
    is_there = is_there || holds(p.point, {fq(0), fq(-2), fq(0)});
  EXPECT_TRUE(is_there);
}

TEST(PatchProjection, TheCentreOfABallIsNotDecidedButItsDistanceIs) {
  const auto all = projected(patch_shapes::sphere(), {fq(0), fq(0), fq(0)}, 3000);
  EXPECT_FALSE(all.is_decided);
  EXPECT_TRUE(holds(all.squared_distance, fq(1)));
  EXPECT_GT(all.squared_distance.lo(), 0.9);
}

TEST(PatchProjection, APointOfTheSurfaceIsItsOwnFoot) {
  const Patches ball = patch_shapes::sphere();
  const auto p = *point_of(evaluate<Rational, 2>(ball[3].tensor(), {fq(1, 3), fq(2, 7)}));
  const auto foot = projected(ball, p);
  ASSERT_EQ(foot.places.size(), 1u);
  EXPECT_TRUE(holds(foot.places[0].point, p));
  EXPECT_TRUE(holds(foot.squared_distance, fq(0)));
}

// The foot of q on the unit sphere is q / |q|: exact for q with a rational length.
TEST(PatchProjectionLaw, FeetOnASphereAreOnTheLineToItsCentre) {
  for (const Patches& ball : {patch_shapes::sphere(), patch_shapes::octant_sphere()}) {
    const PatchComplex complex = complex_of(ball);
    const PatchProjection projection(complex);
    for (int n = 0; n < scaled(60); ++n) {
      Random random(kFootSeed + static_cast<std::uint64_t>(n));
      // A rational point of the sphere, by stereographic projection.
      const Rational s(random.between(-40, 40)), t(random.between(-40, 40)),
          k(random.between(3, 30));
      const Rational ss = s / k, tt = t / k, w = fq(1) + ss * ss + tt * tt;
      const ExactPoint foot{(ss + ss) / w, (tt + tt) / w, (w - fq(2)) / w};
      const Rational length = fq(random.between(1, 40), 16);
      if (length == fq(1)) continue;
      const ExactPoint q{foot[0] * length, foot[1] * length, foot[2] * length};
      const auto out = projection.project(q);
      const std::string where = "seed " + std::to_string(kFootSeed) + " case " + std::to_string(n) +
                                ": " + q[0].to_string() + " " + q[1].to_string() + " " +
                                q[2].to_string();
      ASSERT_TRUE(out.is_decided) << where;
      ASSERT_EQ(out.places.size(), 1u) << where;
      EXPECT_TRUE(holds(out.places[0].point, foot)) << where;
      EXPECT_TRUE(holds(out.squared_distance, (length - fq(1)) * (length - fq(1)))) << where;
      EXPECT_LT(width_of(out.places[0].point), 1e-5) << where;
    }
  }
}

// Flat triangles as patches, beside the exact projection onto the mesh.
TEST(PatchProjectionLaw, AgreesWithMeshesWhereBothSpeak) {
  const TriangleMesh mesh = shapes::torus(9, 7, 2, 0.75);
  const PatchComplex complex = make_patch_complex(patches_of(mesh).value()).value();
  const PatchProjection projection(complex);
  const MeshProjection exact(mesh);
  for (int n = 0; n < scaled(100); ++n) {
    Random random(kFootSeed + static_cast<std::uint64_t>(n));
    ExactPoint q;
    for (Rational& x : q) x = fq(random.between(-50, 50), 16);
    const auto out = projection.project(q);
    const auto truth = exact.project(q);
    const std::string where = "seed " + std::to_string(kFootSeed) + " case " + std::to_string(n);
    EXPECT_TRUE(holds(out.squared_distance, truth.squared_distance)) << where;
    for (const NearestPoint& p : truth.nearest) {
      bool is_there = false;
      for (const NearestPlace& place : out.places)
        is_there = is_there || holds(place.point, p.point);
      EXPECT_TRUE(is_there) << where;
    }
    if (out.places.size() == 1 && out.places[0].is_single) {
      EXPECT_EQ(truth.nearest.size(), 1u) << where;
    }
  }
}

// No sampled point is nearer than the answer says, on patches of every kind.
TEST(PatchProjectionLaw, NoPointOfThePatchesIsNearer) {
  for (const Patches& patches : {patch_shapes::teapot(), patch_shapes::torus(3, 1),
                                 patch_shapes::pn_torus(12, 8), patch_shapes::ball_with_neck()}) {
    const PatchComplex complex = complex_of(patches);
    const PatchProjection projection(complex);
    std::vector<Vec3d> samples;
    for (const Patch& p : patches) {
      const RoundedPatch map(p);
      for (int i = 0; i <= 24; ++i)
        for (int j = 0; j <= 24; ++j)
          if (!p.is_triangle() || i + j <= 24) samples.push_back(map.at(i / 24.0, j / 24.0));
    }
    for (int n = 0; n < scaled(25); ++n) {
      Random random(kFootSeed + static_cast<std::uint64_t>(n));
      ExactPoint q;
      for (Rational& x : q) x = fq(random.between(-80, 80), 16);
      const auto out = projection.project(q);
      double least = HUGE_VAL;
      const double x = nearest_double(q[0]), y = nearest_double(q[1]), z = nearest_double(q[2]);
      for (const Vec3d& s : samples)
        least =
            std::min(least, (s.x - x) * (s.x - x) + (s.y - y) * (s.y - y) + (s.z - z) * (s.z - z));
      EXPECT_LE(out.squared_distance.lo(), least + 1e-9) << "seed " << kFootSeed << " case " << n;
      EXPECT_GE(out.squared_distance.hi(), least - 0.5) << "seed " << kFootSeed << " case " << n;
      EXPECT_FALSE(out.places.empty());
    }
  }
}

}  // namespace
}  // namespace veritope
