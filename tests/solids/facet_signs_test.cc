// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/facet_signs.h"

#include <gtest/gtest.h>

#include "tests/predicates/point_generators.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/exact_geometry.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

std::string expect_right(const TriangleMesh& mesh, const FacetSigns& got) {
  std::vector<std::uint32_t> degenerate;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const oracle::RVec n = oracle::normal_of(oracle::rational_triangle(mesh, f));
    for (std::size_t k = 0; k < 3; ++k) {
      const unsigned bits = got.signs[f] >> (2 * k) & 3u;
      if (bits == 3 || (bits == 1 && oracle::sgn(n[k]) != 1) || (bits == 2 && oracle::sgn(n[k]) != -1))
        return "component " + std::to_string(k) + " of facet " + std::to_string(f) + " of " + shapes::to_text(mesh);
    }
    if (oracle::is_zero(n)) degenerate.push_back(f);
    if (oracle::is_zero(n) != (got.signs[f] == 0)) return "facet " + std::to_string(f) + " of " + shapes::to_text(mesh);
  }
  return degenerate == got.degenerate ? "" : "the list of degenerate facets of " + shapes::to_text(mesh);
}

TEST(FacetSigns, AreThoseOfTheNormal) {
  const TriangleMesh mesh = shapes::parse("tri 0,0,0 1,0,0 0,1,0 ; tri 0,0,0 0,1,0 1,0,0 ; tri 0,0,0 1,1,1 2,2,2 ; tri 1,0,0 0,1,0 0,0,1");
  const FacetSigns s = facet_signs(mesh, 1);
  EXPECT_EQ(s.signs, (std::vector<NormalSigns>{1u << 4, 2u << 4, 0, 1u | 1u << 2 | 1u << 4}));
  EXPECT_EQ(s.degenerate, (std::vector<std::uint32_t>{2}));
}

TEST(FacetSigns, ARepeatedIdIsDegenerate) {
  const FacetSigns s = facet_signs(shapes::parse("v 0,0,0 1,0,0 0.1,0.7,3 ; f 0,1,0 2,2,2 1,1,2 0,1,2"), 1);
  EXPECT_EQ(s.degenerate, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(FacetSigns, NeverContradictRationalsAndFindEveryDegenerateFacet) {
  for (int kind = 0; kind < generate::kNumKinds; ++kind) {
    TriangleMesh mesh;
    for (long i = 0; i < scaled(500); ++i) {
      Random random(static_cast<std::uint64_t>(i) * generate::kNumKinds + static_cast<std::uint64_t>(kind));
      const auto p = generate::points(static_cast<generate::Kind>(kind), random);
      const auto v = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.insert(mesh.positions.end(), p.begin(), p.begin() + 3);
      mesh.faces.push_back({v, v + 1, v + 2});
    }
    const std::string wrong = expect_right(mesh, facet_signs(mesh, 1));
    EXPECT_EQ(wrong.substr(0, 60), "") << generate::kKindNames[kind];
  }
}

TEST(FacetSigns, CollinearCornersAreFoundAtAnyScale) {
  for (int e : {-1070, -900, -500, 0, 500, 900}) {
    const double s = std::ldexp(1.0, e);
    TriangleMesh mesh;
    mesh.positions = {{s, 2 * s, 3 * s}, {3 * s, 6 * s, 9 * s}, {7 * s, 14 * s, 21 * s}, {7 * s, 14 * s, 22 * s}};
    mesh.faces = {{0, 1, 2}, {0, 1, 3}};
    EXPECT_EQ(facet_signs(mesh, 1).degenerate, (std::vector<std::uint32_t>{0})) << e;
  }
}

TEST(FacetSigns, DoNotDependOnJobs) {
  Random random(5);
  TriangleMesh mesh = shapes::grid_soup(random, 40000, 5);  // several chunks, many degenerate facets
  const FacetSigns one = facet_signs(mesh, 1);
  EXPECT_GT(one.degenerate.size(), 1000u);
  for (unsigned jobs : {2u, 3u, 7u}) {
    const FacetSigns many = facet_signs(mesh, jobs);
    EXPECT_EQ(one.signs, many.signs);
    EXPECT_EQ(one.degenerate, many.degenerate);
  }
}

}  // namespace
}  // namespace veritope
