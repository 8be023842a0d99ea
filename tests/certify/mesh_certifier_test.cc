// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/mesh_certifier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/certify/round_trip.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/checker_call.h"

namespace veritope {
namespace {

using shapes::Cap;

std::string start(const std::string& text) { return text.substr(0, 6); }

// The certificate of the model, accepted by the C++ checker; the same bytes for other numbers of jobs.
CertifiedMesh expect_accepted(const TriangleMesh& mesh, bool as_indexed = false) {
  const CertifiedMesh c = certified(mesh, as_indexed);
  const std::string answer = check_in_process(c.file, c.certificate());
  EXPECT_EQ(start(answer), "ACCEPT") << answer << "\n" << shapes::to_text(c.mesh);
  EXPECT_EQ(answer.find("mesh-valid-1") != std::string::npos, c.report.is_valid) << answer;
  for (unsigned jobs : {2u, 5u}) EXPECT_EQ(certified(mesh, as_indexed, jobs).bytes == c.bytes, true) << jobs << " jobs\n" << shapes::to_text(c.mesh);
  return c;
}

TEST(MeshCertifier, CertifiesASolid) {
  const CertifiedMesh c = expect_accepted(shapes::box({0, 0, 0}, {1, 2, 3}));
  EXPECT_TRUE(c.report.is_valid);
  const auto body = c.decoded().valid.value();
  EXPECT_EQ(body.order.size(), 12u);
  EXPECT_TRUE(body.separators.empty());
  EXPECT_TRUE(body.nesting.empty());
  EXPECT_NE(c.decoded().statement.find("\"volume\":\"6/1\""), std::string::npos);
}

TEST(MeshCertifier, CertifiesNestedShellsAndTheirRays) {
  for (const TriangleMesh& mesh : {shapes::nested_boxes(6), shapes::box_grid(3, 0.5)}) {
    const CertifiedMesh c = expect_accepted(mesh);
    EXPECT_TRUE(c.report.is_valid);
    EXPECT_EQ(c.decoded().valid->nesting.size(), c.report.shells.size());
  }
}

TEST(MeshCertifier, LongThinModelsGetSeparators) {
  for (const TriangleMesh& mesh :
       {shapes::tilted_cylinder(150, Cap::kCentreFan), shapes::tilted_cylinder(150, Cap::kRimFan), shapes::tilted_cylinder(150, Cap::kZigzag),
        shapes::hyperboloid(120, 40)}) {
    const CertifiedMesh c = expect_accepted(mesh);
    EXPECT_TRUE(c.report.is_valid);
    EXPECT_TRUE(c.report.long_thin);
    EXPECT_FALSE(c.decoded().valid->separators.empty());
  }
}

TEST(MeshCertifier, ConesAndBipyramidsAreCertified) {
  for (const TriangleMesh& mesh : {shapes::cone(200), shapes::bipyramid(200), shapes::reversed(shapes::cone(50))}) expect_accepted(mesh);
}

// The two sides of a thin plate whose polygons are fans: the fans must not be mixed, or both the work and the certificate grow with the square.
TEST(MeshCertifierRegression, ThinPlatesOfTwoFansHaveShortCertificates) {
  for (const double height : {1e-6, 1e-3, 0.1})
    for (const Cap cap : {Cap::kRimFan, Cap::kCentreFan}) {
      const TriangleMesh mesh = shapes::tilted_cylinder(800, cap, height);
      const CertifiedMesh c = expect_accepted(mesh);
      EXPECT_TRUE(c.report.is_valid);
      EXPECT_LT(c.certificate().size(), 30 * mesh.faces.size()) << height;
    }
}

TEST(MeshCertifier, AVertexWithoutADirectionIsSettledByLeafCodes) {
  const CertifiedMesh c = expect_accepted(shapes::saddle());
  EXPECT_TRUE(c.report.is_valid);
  EXPECT_GT(c.decoded().valid->codes.size(), 10u);
  for (int n : {6, 14, 40}) EXPECT_TRUE(expect_accepted(shapes::wave(n, 30)).report.is_valid);
}

TEST(MeshCertifier, DirectionsOfVerticesOfTheirOwnAreCertified) {
  bool own = false;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    const CertifiedMesh c = expect_accepted(shapes::mapped(shapes::wave(10, 12), shapes::random_matrix(random, 5), {0, 0, 0}));
    if (c.report.is_valid) own = own || !c.decoded().valid->star_vectors.empty();
  }
  EXPECT_TRUE(own);
}

// PROVES MESH-9
TEST(MeshCertifier, EveryRuleHasAWitnessThatIsAccepted) {
  std::set<int> rules;
  for (const char* text :
       {"v 0,0,0 4,0,0 0,4,0 0,0,4 2,0,0 ; f 0,2,1 1,2,3 2,0,3 0,4,3 4,1,3 0,1,4", "v 0,0,0 4,0,0 0,4,0 ; f 0,1,2 0,2,1", "tri 0,0,0 1,0,0 0,1,0",
        "v 0,0,0 4,0,0 0,4,0 0,0,4 -1,-1,-1 ; f 0,2,1 0,1,3 1,2,3 2,0,3 0,1,4", "v 0,0,0 4,0,0 0,4,0 0,0,4 ; f 0,1,2 0,1,3 1,2,3 2,0,3",
        "tet 0,0,0 4,0,0 0,4,0 0,0,4 ; tet 0,0,0 -4,0,0 0,0,-4 0,-4,0", "tet 0,0,0 4,0,0 0,4,0 0,0,4 ; tet 1,1,0 1,2,-4 2,1,-4 1,1,-5",
        "tet 0,0,0 4,0,0 0,4,0 0,0,4 ; flip", "tet 0,0,0 9,0,0 0,9,0 0,0,9 ; tet 1,1,1 2,1,1 1,2,1 1,1,2"}) {
    const CertifiedMesh c = expect_accepted(shapes::parse(text));
    EXPECT_FALSE(c.report.is_valid);
    const auto decoded = c.decoded();
    for (const auto& w : decoded.invalid->witnesses) rules.insert(w.rule);
  }
  EXPECT_EQ(rules, (std::set<int>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

// A pair with the same vertices has no point outside its common simplex: it counts for M7, but M2 is its witness.
TEST(MeshCertifier, PillowsHaveNoWitnessOfM7) {
  const CertifiedMesh c = expect_accepted(shapes::parse("v 0,0,0 4,0,0 0,4,0 ; f 0,1,2 0,2,1"));
  EXPECT_EQ(c.report.rule_counts[6], 1u);
  ASSERT_EQ(c.decoded().invalid->witnesses.size(), 1u);
  EXPECT_EQ(c.decoded().invalid->witnesses[0].rule, 2);
}

// A face with a repeated id has no edge and is at no vertex, for the report and for the checkers.
TEST(MeshCertifierRegression, WitnessesHoldBesideFacesWithARepeatedId) {
  for (const char* text : {"v 0,0,0 4,0,0 0,4,0 ; f 0,1,2 1,1,2", "v 0,0,0 4,0,0 0,4,0 ; f 0,1,2 1,2,1 0,0,0 0,2,2 1,1,0",
                           "v 0,0,0 4,0,0 0,4,0 0,0,4 9,9,9 9,9,8 ; f 1,0,2 1,4,5 1,1,2 4,1,1", "v 0,0,0 4,0,0 0,4,0 0,0,4 ; f 0,1,2 0,1,3 0,1,1"}) {
    const CertifiedMesh c = expect_accepted(shapes::parse(text), true);
    std::set<int> rules;
    const auto decoded = c.decoded();
    for (const auto& w : decoded.invalid->witnesses) rules.insert(w.rule);
    EXPECT_TRUE(rules.contains(1));
    EXPECT_TRUE(rules.contains(3));
  }
}

TEST(MeshCertifier, ModelsReadWithTheirOwnIndicesAreCertified) {
  const TriangleMesh twice = shapes::parse("v 0,0,0 4,0,0 0,4,0 0,0,4 0,0,0 4,0,0 0,4,0 0,0,4 ; f 0,2,1 4,5,3 1,6,7 2,4,7");
  EXPECT_TRUE(expect_accepted(twice).report.is_valid);
  const CertifiedMesh own = expect_accepted(twice, true);
  EXPECT_FALSE(own.report.is_valid);
  EXPECT_NE(own.decoded().statement.find("\"as_indexed\":true"), std::string::npos);
  // Unreferenced vertices keep their ids, and may lie on others.
  TriangleMesh stray = shapes::box({0, 0, 0}, {1, 1, 1});
  stray.positions.push_back(stray.positions[3]);
  stray.positions.push_back({1e300, -1e300, 0});
  EXPECT_TRUE(expect_accepted(stray, true).report.is_valid);
  EXPECT_TRUE(expect_accepted(stray, false).report.is_valid);
}

TEST(MeshCertifier, ExtremeCoordinatesAreCertified) {
  for (const char* text : {"tet 0,0,0 5e-324,0,0 0,5e-324,0 0,0,5e-324", "tet -1.7e308,-1.7e308,-1.7e308 1.7e308,0,0 0,1.7e308,5e-324 0,1,1.7e308",
                           "tet 0,0,0 1e308,0,0 0,5e-324,0 0,0,1", "tet 0,0,0 4,0,0 0,4,0 0,0,4 ; tet 1,1,-0x1p-1074 1,2,-4 2,1,-4 1,1,-5",
                           "box 0,0,0 1e300,1e300,1e300 ; box 1e-300,1e-300,1e-300 2e-300,2e-300,2e-300 ; flip",
                           "tri 0,0,0 1e308,0,0 0,1e308,0 ; tri 5e-324,5e-324,-1e308 5e-324,5e-324,1e308 1e308,1e308,1e308"})
    expect_accepted(shapes::parse(text));
}

TEST(MeshCertifierLaw, EveryModelGetsACertificateThatTheCheckerAccepts) {
  std::array<int, 2> seen{};
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(40)); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto n = [&](int low, int high) { return static_cast<int>(random.between(low, high)); };
    TriangleMesh star = shapes::star_polyhedron(random, 1);
    star.positions[random.below(star.positions.size())] = {0.25, 0.125, 0.5};
    for (const TriangleMesh& mesh :
         {shapes::grid_soup(random, n(1, 20), n(2, 4)), shapes::random_indexed(random, n(1, 20), n(3, 10), 3), shapes::random_polycube(random, 3, n(1, 14)),
          shapes::star_polyhedron(random, 2), star, shapes::nested_scene(random, n(1, 12)), shapes::needles(random, n(1, 12)), shapes::needle_soup(random, n(1, 60)),
          shapes::mapped(shapes::random_polycube(random, 2, n(1, 6)), shapes::random_matrix(random, 4), {n(-9, 9), 0, 5}),
          shapes::mapped(shapes::saddle(), shapes::random_matrix(random, 7), {0, 0, 0}), shapes::hyperboloid(n(5, 40), n(1, 4)),
          shapes::scaled(shapes::torus(n(3, 9), n(3, 9), 3, 1), n(-1000, 1000)), shapes::joined(shapes::tilted_cylinder(n(3, 60), Cap::kZigzag), shapes::box({20, 20, 20}, {21, 21, 21}))}) {
      ++seen[expect_accepted(mesh, random.below(2) == 0).report.is_valid];
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(seen[0], 50);
  EXPECT_GT(seen[1], 50);
}

// Several blocks of every parallel loop.
TEST(MeshCertifierLaw, LargeModelsGetTheSameBytesForEveryNumberOfJobs) {
  const CertifiedMesh c = expect_accepted(shapes::torus(130, 80, 30, 12));
  EXPECT_TRUE(c.report.is_valid);
  EXPECT_LE(c.bytes.size(), 12 * c.mesh.faces.size());
  const CertifiedMesh thin = expect_accepted(shapes::tilted_cylinder(2000, Cap::kZigzag));
  EXPECT_LE(thin.bytes.size(), 40 * thin.mesh.faces.size());
}

}  // namespace
}  // namespace veritope
