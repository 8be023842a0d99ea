// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/refine_domain_test.cc: domains under limits of volume and of radius over edge stay the same set.
#include "solids/dms/domain/refine_domain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "predicates/distance.h"
#include "robust/base/random.h"
#include "solids/dms/dms_identity.h"
#include "solids/dms/dms_make.h"
#include "solids/dms/domain/mesh_domain.h"
#include "solids/tetrahedra/delaunay.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/mesh_domain_check.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

DmsModel domain_of(const TriangleMesh& mesh) {
  const Result<MeshDomain> made = domain_of_mesh(mesh, {});
  if (!made) throw std::runtime_error(to_string(made.error()));
  return made->model;
}

DmsModel hull_of(const std::vector<Vec3d>& points) {
  const Result<DelaunayTetrahedra> made = delaunay_tetrahedra(points);
  if (!made) throw std::runtime_error(to_string(made.error()));
  std::vector<DmsPoint> places;
  for (const Vec3d& p : points) places.push_back(exact_place(p));
  return *identity_dms(places, made->tetrahedra);
}

RefinedDomain refined(const DmsModel& domain, const RefineLimits& limits) {
  Result<RefinedDomain> out = refine_domain(domain, limits);
  if (!out) throw std::runtime_error(to_string(out.error()));
  return std::move(*out);
}

Rational volume_of(const DmsModel& model, std::size_t t) {
  const auto at = [&](std::size_t k) { return model.clouds[model.tetrahedra[t][k]][0]; };
  return dot(minus(at(1), at(0)), cross(minus(at(2), at(0)), minus(at(3), at(0)))) / Rational(6);
}

// The squared circumradius by fractions, from the linear equations of the centre.
Rational squared_radius(const DmsModel& model, std::size_t t) {
  const auto at = [&](std::size_t k) { return model.clouds[model.tetrahedra[t][k]][0]; };
  const DmsPoint u = minus(at(1), at(0)), v = minus(at(2), at(0)), w = minus(at(3), at(0));
  const DmsPoint vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const Rational uu = dot(u, u), vv = dot(v, v), ww = dot(w, w), d = Rational(2) * dot(u, vw);
  DmsPoint centre;
  for (std::size_t k = 0; k < 3; ++k) centre[k] = (uu * vw[k] + vv * wu[k] + ww * uv[k]) / d;
  return dot(centre, centre);
}

Rational squared_shortest_edge(const DmsModel& model, std::size_t t) {
  std::optional<Rational> least;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const DmsPoint e =
          minus(model.clouds[model.tetrahedra[t][i]][0], model.clouds[model.tetrahedra[t][j]][0]);
      if (!least || dot(e, e) < *least) least = dot(e, e);
    }
  return *least;
}

// By fractions, on all tetrahedra but the protected ones.
void expect_within(const RefinedDomain& out, const RefineLimits& limits, const std::string& what) {
  for (std::size_t t = 0; t < out.model.tetrahedra.size(); ++t) {
    if (limits.max_volume) {
      ASSERT_LE(volume_of(out.model, t), *limits.max_volume) << what;
    }
    if (!limits.max_radius_edge) continue;
    const Rational& b = *limits.max_radius_edge;
    const bool is_within =
        squared_radius(out.model, t) <= b * b * squared_shortest_edge(out.model, t);
    const bool is_protected =
        std::binary_search(out.protected_tetrahedra.begin(), out.protected_tetrahedra.end(), t);
    ASSERT_NE(is_within, is_protected) << what << ", tetrahedron " << t;
  }
}

// With vertices that cuts made, and without as many of them as can go.
void expect_refined(const TriangleMesh& mesh, RefineLimits limits, const std::string& what) {
  const Result<MeshDomain> made = domain_of_mesh(mesh, {});
  ASSERT_TRUE(made) << what;
  limits.num_fixed = made->from_mesh;
  const RefinedDomain out = refined(made->model, limits);
  EXPECT_STREQ(refine_end_name(out.end), "limits") << what;
  EXPECT_EQ(out.over_volume + out.over_radius_edge, 0u) << what;
  EXPECT_LE(out.removed, made->steiner_on_mesh + made->steiner_inside) << what;
  EXPECT_EQ(out.model.clouds.size(),
            made->model.clouds.size() - out.removed + out.on_boundary + out.inside)
      << what;
  for (std::size_t v = 0; v < made->from_mesh; ++v)
    ASSERT_EQ(out.model.clouds[v], made->model.clouds[v]) << what;
  EXPECT_EQ(mesh_domain_fault(mesh, out.model), "") << what;
  if (out.model.clouds.size() <= 500) {
    EXPECT_EQ(six_volumes(out.model), six_volumes(mesh)) << what;
    EXPECT_TRUE(is_boundary_on_mesh(mesh, out.model)) << what;
  }
  expect_within(out, limits, what);
}

Rational ratio(int p, int q) { return Rational(Integer(p), Integer(q)); }

TEST(RefineDomain, LeavesADomainWithinTheLimitsAsItIs) {
  const DmsModel domain = domain_of(shapes::box({0, 0, 0}, {1, 1, 1}));
  const RefinedDomain out = refined(domain, {ratio(1, 3), ratio(2, 1), 0});
  EXPECT_EQ(out.end, RefineEnd::kLimits);
  EXPECT_EQ(out.model.tetrahedra, domain.tetrahedra);
  EXPECT_EQ(out.model.clouds, domain.clouds);
}

TEST(RefineDomain, MakesTetrahedraOfABoxSmall) {
  for (const int n : {7, 50, 1000}) {
    const RefineLimits limits{ratio(1, n), {}, 100'000};
    expect_refined(shapes::box({0, 0, 0}, {1, 1, 1}), limits, "1 / " + std::to_string(n));
  }
}

TEST(RefineDomain, IsTheSameFarFromTheOriginAndInOtherUnits) {
  const DmsModel domain = hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}});
  for (const bool by_volume : {true, false}) {
    const auto limits = [&](const Rational& unit) {
      RefineLimits out;
      if (by_volume) out.max_volume = unit * unit * unit / Rational(100);
      if (!by_volume) out.max_radius_edge = Rational(3);
      out.max_points = 500;
      return out;
    };
    const RefinedDomain expected = refined(domain, limits(Rational(1)));
    for (const std::int64_t exponent : {0, 1000, -1000}) {
      const Rational unit = Rational::power_of_two(exponent);
      DmsModel moved = domain;
      for (DmsCloud& cloud : moved.clouds)
        for (Rational& x : cloud[0]) x = unit * (x + Rational::power_of_two(60));
      set_control_by_rule(moved, DmsControlRule::kGreville, {});
      const RefinedDomain found = refined(moved, limits(unit));
      EXPECT_EQ(found.end, expected.end) << exponent;
      EXPECT_EQ(found.model.tetrahedra, expected.model.tetrahedra) << exponent;
      EXPECT_EQ(found.largest_radius_edge, expected.largest_radius_edge) << exponent;
      EXPECT_EQ(found.largest_volume,
                std::ldexp(expected.largest_volume, static_cast<int>(3 * exponent)))
          << exponent;
    }
  }
}

TEST(RefineDomain, MakesTetrahedraShort) {
  const RefineLimits limits{{}, ratio(2, 1), 20'000};
  expect_refined(shapes::box({0, 0, 0}, {1, 1, 1}), limits, "box");
  expect_refined(shapes::box({0, 0, 0}, {1, 4, 0.25}), limits, "plate");
  expect_refined(shapes::prism(7, 2, 3), limits, "prism");
  expect_refined(shapes::torus(9, 6, 3, 1), limits, "torus");
  expect_refined(shapes::nested_boxes(2), limits, "nested boxes");
}

TEST(RefineDomain, KeepsTheBoundaryOfMeshesUnderBothLimits) {
  for (const TriangleMesh& mesh : {shapes::bipyramid(6), shapes::cone(7), shapes::saddle(),
                                   shapes::tilted_cylinder(9, shapes::Cap::kRimFan)}) {
    const Rational volume = six_volumes(mesh) / Rational(6 * 100);
    expect_refined(mesh, {volume, {}, 20'000}, "volume of a hundredth");
  }
}

TEST(RefineDomain, StopsAtTheBudgetAndSaysWhatWasReached) {
  const DmsModel domain = domain_of(shapes::box({0, 0, 0}, {1, 1, 1}));
  const RefinedDomain all = refined(domain, {ratio(1, 50), {}, 100'000});
  for (std::size_t v = 0; v < domain.clouds.size(); ++v)
    ASSERT_EQ(all.model.clouds[v], domain.clouds[v]);
  const std::size_t needed = all.on_boundary + all.inside;
  EXPECT_EQ(refined(domain, {ratio(1, 50), {}, needed}).model, all.model);
  const RefinedDomain less = refined(domain, {ratio(1, 50), {}, needed - 1});
  EXPECT_EQ(less.end, RefineEnd::kBudget);
  EXPECT_EQ(less.on_boundary + less.inside, needed - 1);
  EXPECT_GT(less.over_volume, 0u);
  EXPECT_GT(less.largest_volume, 0.02);
  EXPECT_EQ(mesh_domain_fault(shapes::box({0, 0, 0}, {1, 1, 1}), less.model), "");
}

// The volumes are compared exactly: a limit of the volume itself is kept, a limit below it by 2^-200 is not.
TEST(RefineDomain, ComparesVolumesExactly) {
  const DmsModel domain = hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_EQ(refined(domain, {ratio(1, 6), {}, 0}).end, RefineEnd::kLimits);
  const RefinedDomain below = refined(domain, {ratio(1, 6) - Rational::power_of_two(-200), {}, 0});
  EXPECT_EQ(below.end, RefineEnd::kBudget);
  EXPECT_EQ(below.over_volume, 1u);
}

// With right angles at the origin the sphere's diameter is that of the box, here 3, and the shortest edge is 1.
TEST(RefineDomain, ComparesRatiosExactly) {
  const DmsModel domain = hull_of({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}});
  const Rational three_halves = ratio(3, 2);
  const RefinedDomain within = refined(domain, {{}, three_halves, 0});
  EXPECT_EQ(within.over_radius_edge + within.protected_tetrahedra.size(), 0u);
  const RefinedDomain below = refined(domain, {{}, three_halves - Rational::power_of_two(-200), 0});
  EXPECT_EQ(below.over_radius_edge + below.protected_tetrahedra.size(), 1u);
}

TEST(RefineDomain, TakesVerticesAwayThatCutsMade) {
  const TriangleMesh mesh = shapes::torus(9, 6, 3, 1);
  const Result<MeshDomain> made = domain_of_mesh(mesh, {});
  ASSERT_TRUE(made);
  ASSERT_GT(made->steiner_on_mesh + made->steiner_inside, 0u);
  const RefinedDomain out = refined(made->model, {Rational(1000), {}, 0, made->from_mesh});
  EXPECT_GT(out.removed, 0u);
  EXPECT_EQ(out.on_boundary + out.inside, 0u);
  EXPECT_EQ(mesh_domain_fault(mesh, out.model), "");
  EXPECT_TRUE(is_boundary_on_mesh(mesh, out.model));
}

TEST(RefineDomain, ListsSmallAnglesAndDoesNotCutThereForever) {
  // A wedge with an edge of about 3 degrees.
  const TriangleMesh wedge = shapes::parse(
      "v 0,0,0 0,0,2 4,0.125,0 4,0.125,2 4,-0.125,0 4,-0.125,2; "
      "f 0,2,4 1,5,3 0,1,3 0,3,2 0,4,5 0,5,1 2,3,5 2,5,4");
  const RefineLimits limits{{}, ratio(2, 1), 50'000};
  const RefinedDomain out = refined(domain_of(wedge), limits);
  EXPECT_EQ(out.end, RefineEnd::kLimits);
  EXPECT_EQ(mesh_domain_fault(wedge, out.model), "");
  std::size_t dihedral = 0, plane = 0;
  for (const SmallAngle& a : out.small_angles) {
    ++(a.is_dihedral ? dihedral : plane);
    EXPECT_NEAR(a.degrees, 3.58, 0.01);
  }
  EXPECT_EQ(dihedral, 1u);
  EXPECT_EQ(plane, 2u);
  EXPECT_GT(out.protected_tetrahedra.size(), 0u);
  expect_within(out, limits, "wedge");
}

TEST(RefineDomain, RefinesHullsOfRandomPointsAtRationalPlaces) {
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(6)); ++seed) {
    Random random(seed);
    std::vector<Vec3d> points;
    for (int i = 0; i < 40; ++i)
      points.push_back({static_cast<double>(random.below(17)) / 3,
                        static_cast<double>(random.below(17)) / 7,
                        static_cast<double>(random.below(17)) / 5});
    const DmsModel domain = hull_of(points);
    const RefineLimits limits{ratio(1, 20), {}, 20'000};
    const RefinedDomain out = refined(domain, limits);
    const std::string what = "seed " + std::to_string(seed);
    EXPECT_EQ(out.end, RefineEnd::kLimits) << what;
    EXPECT_EQ(six_volumes(out.model), six_volumes(domain)) << what;
    EXPECT_EQ(find_dms_defects(out.model).count, 0u) << what;
    expect_within(out, limits, what);
  }
}

TEST(RefineDomain, DoesNotDependOnTheRunAndKeepsEveryVertex) {
  const DmsModel domain = domain_of(shapes::torus(7, 5, 3, 1));
  const RefineLimits limits{ratio(1, 10), ratio(3, 1), 3'000};
  const RefinedDomain one = refined(domain, limits), two = refined(domain, limits);
  EXPECT_EQ(one.model, two.model);
  std::vector<bool> is_used(one.model.clouds.size());
  for (const TetrahedronCorners& t : one.model.tetrahedra)
    for (const std::uint32_t v : t) is_used[v] = true;
  EXPECT_EQ(std::count(is_used.begin(), is_used.end(), false), 0);
}

TEST(RefineDomain, RefusesLimitsOutOfRangeAndBoundariesThatAreNoManifolds) {
  const DmsModel domain = hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_EQ(refine_domain(domain, {Rational(0), {}, 9}).error().code, Code::kBadArgument);
  EXPECT_EQ(refine_domain(domain, {{}, ratio(99, 100), 9}).error().code, Code::kBadArgument);
  const std::vector<DmsPoint> points{{0, 0, 0}, {0, 0, 1},  {1, 0, 0},
                                     {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  const std::vector<TetrahedronCorners> two{{0, 2, 3, 1}, {0, 4, 5, 1}};
  EXPECT_EQ(refine_domain(*identity_dms(points, two), {Rational(1), {}, 9}).error().code,
            Code::kBadArgument);
}

}  // namespace
}  // namespace veritope
