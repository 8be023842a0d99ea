// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/validity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robust/base/check.h"
#include "robust/base/work_share.h"
#include "tests/solids/decision_check.h"

namespace veritope {
namespace {

using Counts = std::array<std::uint64_t, kNumMeshRules>;

struct RuleCase {
  const char* name;
  const char* text;
  Counts counts;
};

// For each rule a smallest model that breaks it (and what else cannot be avoided), and next to it a valid one.
// PROVES MESH-1, MESH-2
const RuleCase kCases[] = {
    {"M1: a facet between three points of an edge", "v 0,0,0 4,0,0 0,4,0 0,0,4 2,0,0 ; f 0,2,1 1,2,3 2,0,3 0,4,3 4,1,3 0,1,4", {1, 0, 0, 0, 0, 0, 2, 0, 0}},
    {"M1 valid: the same edge split in both facets", "v 0,0,0 4,0,0 0,4,0 0,0,4 2,0,0 ; f 0,2,4 4,2,1 1,2,3 2,0,3 0,4,3 4,1,3", {}},
    {"M1: a repeated id", "v 0,0,0 4,0,0 0,4,0 0,0,4 ; f 0,2,1 0,1,3 1,2,3 2,0,3 0,0,1", {1, 0, 0, 0, 0, 0, 0, 0, 0}},
    {"M1: nothing but a degenerate facet", "v 1,2,3 ; f 0,0,0", {1, 0, 0, 0, 0, 0, 0, 0, 0}},
    {"M2: a pillow", "v 0,0,0 4,0,0 0,4,0 ; f 0,1,2 0,2,1", {0, 1, 0, 0, 0, 0, 1, 0, 0}},
    {"M2 valid: a pillow with a point pulled out", "v 0,0,0 4,0,0 0,4,0 1,1,0x1p-1074 ; f 0,2,1 0,1,3 1,2,3 2,0,3", {}},
    {"M2: a facet twice", "v 0,0,0 4,0,0 0,4,0 0,0,4 ; f 0,2,1 0,1,3 1,2,3 2,0,3 1,0,2", {0, 1, 0, 3, 0, 0, 1, 0, 0}},
    {"M2: a facet three times is two duplicates and three pairs", "tri 0,0,0 1,0,0 0,1,0 ; tri 0,1,0 0,0,0 1,0,0 ; tri 0,0,0 0,1,0 1,0,0",
     {0, 2, 0, 3, 0, 0, 3, 0, 0}},
    {"M3: one facet", "tri 0,0,0 1,0,0 0,1,0", {0, 0, 3, 0, 0, 0, 0, 0, 0}},
    {"M3: a facet missing", "v 0,0,0 4,0,0 0,4,0 0,0,4 ; f 0,2,1 0,1,3 1,2,3", {0, 0, 3, 0, 0, 0, 0, 0, 0}},
    {"M3 valid: none missing", "tet 0,0,0 4,0,0 0,4,0 0,0,4", {}},
    {"M4: a facet on an edge", "v 0,0,0 4,0,0 0,4,0 0,0,4 -1,-1,-1 ; f 0,2,1 0,1,3 1,2,3 2,0,3 0,1,4", {0, 0, 2, 1, 0, 0, 0, 0, 0}},
    {"M4: two tetrahedra on one edge", "tet 0,0,0 0,0,4 4,0,0 0,4,0 ; tet 0,0,0 0,0,4 -4,0,0 0,-4,0", {0, 0, 0, 1, 0, 0, 0, 0, 0}},
    {"M4 valid: apart by the least number", "tet 0,0,0 0,0,4 4,0,0 0,4,0 ; tet -0x1p-1074,0,0 -0x1p-1074,0,4 -4,0,0 -1,-4,0", {}},
    {"M5: a facet turned over", "v 0,0,0 4,0,0 0,4,0 0,0,4 ; f 0,1,2 0,1,3 1,2,3 2,0,3", {0, 0, 0, 0, 3, 0, 0, 0, 0}},
    {"M6: two tetrahedra on one vertex", "tet 0,0,0 4,0,0 0,4,0 0,0,4 ; tet 0,0,0 -4,0,0 0,0,-4 0,-4,0", {0, 0, 0, 0, 0, 1, 0, 0, 0}},
    {"M6 valid: apart by the least number", "tet 0,0,0 4,0,0 0,4,0 0,0,4 ; tet 0,0,-0x1p-1074 -4,0,-1 0,0,-4 0,-4,-1", {}},
    {"M7: a corner touches a facet", "tet 0,0,0 4,0,0 0,4,0 0,0,4 ; tet 1,1,0 1,2,-4 2,1,-4 1,1,-5", {0, 0, 0, 0, 0, 0, 3, 0, 0}},
    {"M7 valid: the corner is below by the least number", "tet 0,0,0 4,0,0 0,4,0 0,0,4 ; tet 1,1,-0x1p-1074 1,2,-4 2,1,-4 1,1,-5", {}},
    {"M7: equal points under two ids", "v 0,0,0 4,0,0 0,4,0 0,0,4 0,0,0 -4,0,0 0,-4,0 0,0,-4 ; f 0,2,1 0,1,3 1,2,3 2,0,3 4,5,6 4,7,5 5,7,6 6,7,4",
     {0, 0, 0, 0, 0, 0, 9, 0, 0}},
    {"M8: a tetrahedron inside out", "tet 0,0,0 4,0,0 0,4,0 0,0,4 ; flip", {0, 0, 0, 0, 0, 0, 0, 1, 0}},
    {"M8: one of two", "tet 0,0,0 4,0,0 0,4,0 0,0,4 ; tet 9,0,0 12,0,0 9,4,0 9,0,4 ; flip", {0, 0, 0, 0, 0, 0, 0, 1, 0}},
    {"M9: a void that is solid", "tet 0,0,0 9,0,0 0,9,0 0,0,9 ; tet 1,1,1 2,1,1 1,2,1 1,1,2", {0, 0, 0, 0, 0, 0, 0, 0, 1}},
    {"M9 valid: the void turned over", "tet 0,0,0 9,0,0 0,9,0 0,0,9 ; tet 1,1,1 2,1,1 1,2,1 1,1,2 ; flip", {}},
    {"M8 and M9: everything inside out", "tet 0,0,0 9,0,0 0,9,0 0,0,9 ; flip ; tet 1,1,1 2,1,1 1,2,1 1,1,2", {0, 0, 0, 0, 0, 0, 0, 1, 1}},
    {"out, in, out", "box 0,0,0 9,9,9 ; box 1,1,1 8,8,8 ; flip ; box 2,2,2 7,7,7", {}},
    {"out, in, in", "box 0,0,0 9,9,9 ; box 1,1,1 8,8,8 ; flip ; box 2,2,2 7,7,7 ; flip", {0, 0, 0, 0, 0, 0, 0, 0, 1}},
};

TEST(Validity, OfEveryRulesSmallestModelsIsExact) {
  for (const RuleCase& c : kCases) {
    SCOPED_TRACE(c.name);
    const TriangleMesh mesh = shapes::parse(c.text);
    const ListedReport r = expect_as_brute_force(mesh);
    EXPECT_EQ(r.rule_counts, c.counts);
    EXPECT_EQ(r.is_valid, c.counts == Counts{});
  }
}

TEST(Validity, OfRingsAndNestsHasGenusDepthAndBodies) {
  const ListedReport torus = decide(shapes::torus(9, 7, 3, 1));
  EXPECT_TRUE(torus.is_valid);
  EXPECT_EQ(torus.counts.genus, 1);
  EXPECT_EQ(torus.counts.bodies, 1u);
  const ListedReport nest = decide(shapes::nested_boxes(6));
  EXPECT_TRUE(nest.is_valid);
  EXPECT_EQ(nest.counts.bodies, 3u);
  for (std::uint32_t i = 0; i < 6; ++i) EXPECT_EQ(nest.shells[i].depth, i);
  EXPECT_EQ(spelled(nest.volume), std::to_string(8 * (12 * 12 * 12 - 10 * 10 * 10 + 8 * 8 * 8 - 6 * 6 * 6 + 4 * 4 * 4 - 2 * 2 * 2)));
  EXPECT_EQ(decide(shapes::box_grid(3, 0.5)).counts.bodies, 27u);
}

TEST(Validity, GeneratorsOfValidModelsKeepTheirPromise) {
  Random random(1);
  using shapes::Cap;
  for (const TriangleMesh& mesh :
       {shapes::box({0, 0, 0}, {1, 2, 3}, 4), shapes::prism(30, 5, 2), shapes::torus(20, 15, 3, 1), shapes::star_polyhedron(random, 3),
        shapes::bipyramid(500), shapes::cone(500), shapes::tilted_cylinder(500, Cap::kCentreFan), shapes::tilted_cylinder(500, Cap::kRimFan),
        shapes::tilted_cylinder(500, Cap::kZigzag), shapes::hyperboloid(500, 150), shapes::saddle(), shapes::wave(12, 30),
        shapes::nested_boxes(7), shapes::box_grid(4, 0.25), shapes::nested_scene(random, 40), shapes::needles(random, 200)}) {
    const ListedReport r = decide(mesh);
    EXPECT_TRUE(r.is_valid) << summary(r).substr(0, 300);
  }
}

TEST(Validity, UnreferencedVerticesDoNotMatter) {
  TriangleMesh mesh = shapes::box({0, 0, 0}, {1, 1, 1});
  const ListedReport plain = decide(mesh);
  mesh.positions.push_back({1e300, -5, 0.5});
  mesh.positions.insert(mesh.positions.begin(), {0.5, 0.5, 0.5});
  for (auto& f : mesh.faces)
    for (auto& v : f) ++v;
  const ListedReport r = decide(mesh);
  EXPECT_EQ(summary(r), summary(plain));
  EXPECT_EQ(r.box.hi, (Point3d{1, 1, 1}));
}

// A vertex that no face has made the boxes of all others points, and the decision quadratic.
TEST(ValidityRegression, AStrayVertexFarAwayCostsNothing) {
  for (double far : {-1e9, 1e15, -1e300}) {
    TriangleMesh mesh = shapes::torus(40, 30, 3, 1);
    mesh.positions.push_back({far, far, far});
    const ListedReport r = decide(mesh);
    EXPECT_TRUE(r.is_valid);
    EXPECT_FALSE(r.long_thin) << far;
  }
}

TEST(Validity, ListsAtMostTheDefectsAskedForButCountsAll) {
  Random random(4);
  const TriangleMesh soup = shapes::random_indexed(random, 40, 10, 3);
  for (std::size_t max_defects : {0u, 1u, 3u, 1000u}) expect_as_brute_force(soup, 1, max_defects);
}

TEST(Validity, BoxIsThatOfTheReferencedVertices) {
  const ListedReport r = decide(shapes::parse("v -9,0,0 1,2,3 4,0,0 0,5,0 ; f 1,2,3"));
  EXPECT_EQ(r.box.lo, (Point3d{0, 0, 0}));
  EXPECT_EQ(r.box.hi, (Point3d{4, 5, 3}));
}

TEST(Validity, RefusesNoFaces) {
  ValidityOptions options;
  EXPECT_THROW((void)decide_validity(shapes::parse("v 0,0,0"), options), InternalError);
}

TEST(Validity, JobsOfZeroMeansOne) {
  ValidityOptions options;
  options.jobs = 0;
  EXPECT_TRUE(decide_validity(shapes::box({0, 0, 0}, {1, 1, 1}), options).is_valid);
}

TEST(Validity, SizesAreInModelUnitsAtEveryScale) {
  // Two crossing facets: they run together along one unit.
  const TriangleMesh mesh = shapes::parse("tri 0,0,0 4,0,0 0,4,0 ; tri 1,1,-1 1,1,1 3,1,1");
  for (int e : {-1000, -600, -100, 0, 100, 600, 1000}) {
    const ListedReport r = decide(shapes::scaled(mesh, e));
    bool found = false;
    for (const Finding& d : r.defects)
      if (rule_of(d) == MeshRule::kM7) {
        found = true;
        EXPECT_EQ(d.place.size, std::ldexp(1.0, e)) << e;
      }
    EXPECT_TRUE(found);
  }
  for (int e : {-1000, -600, -400, 0, 600, 1000}) {
    const ListedReport r =
        decide(shapes::scaled(shapes::reversed(shapes::box({0, 0, 0}, {2, 2, 2})), e));
    ASSERT_EQ(r.defects.size(), 1u);
    EXPECT_DOUBLE_EQ(r.defects[0].place.size, std::ldexp(2.0, e)) << e;
  }
}

TEST(Validity, StepsOfTheSearchForPairsEndWithTheWholeOfThem) {
  for (const bool is_thin : {false, true}) {
    const TriangleMesh mesh = is_thin ? shapes::hyperboloid(300, 90) : shapes::box({0, 0, 0}, {1, 2, 3});
    for (const unsigned jobs : {1u, 3u}) {
      WorkShare work;
      ValidityOptions options;
      options.jobs = jobs;
      options.work = &work;
      EXPECT_EQ(decide_validity(mesh, options).long_thin, is_thin);
      EXPECT_EQ(work.view().percent(), std::nullopt);
      EXPECT_GT(work.view().done, 0);
      EXPECT_EQ(work.view().done, work.view().whole);
      work.begin(1);
      EXPECT_EQ(work.view().step, is_thin ? 3u : 2u) << "the walk is a step of its own";
    }
  }
}

}  // namespace
}  // namespace veritope
