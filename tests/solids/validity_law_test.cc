// SPDX-License-Identifier: LGPL-3.0-or-later
// What must not change, or change in a known way, when a model is relabelled, mapped, subdivided, doubled, scaled, or decided by more
// threads.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/predicates/test_scale.h"
#include "tests/solids/decision_check.h"

namespace veritope {
namespace {

struct Model {
  std::string name;
  TriangleMesh mesh;
};

// Small models with few bits, valid and invalid in every way.
std::vector<Model> models(std::uint64_t seed) {
  Random random(seed);
  std::vector<Model> out{{"box", shapes::box({0, 0, 0}, {1, 2, 3}, 2)},
                         {"inside out", shapes::reversed(shapes::box({0, 0, 0}, {1, 2, 3}))},
                         {"torus", shapes::torus(8, 6, 3, 1)},
                         {"star", shapes::star_polyhedron(random, 1)},
                         {"saddle", shapes::saddle()},
                         {"polycube", shapes::random_polycube(random, 3, 9)},
                         {"nest", shapes::nested_boxes(4)},
                         {"wrong nest", shapes::joined(shapes::nested_boxes(3), shapes::box({-1, -1, -1}, {1, 1, 1}))},
                         {"scene", shapes::nested_scene(random, 8)},
                         {"soup", shapes::grid_soup(random, 20, 3)},
                         {"indexed soup", shapes::random_indexed(random, 20, 9, 3)}};
  TriangleMesh open = shapes::torus(6, 5, 3, 1);
  open.faces.erase(open.faces.begin() + 7, open.faces.begin() + 9);
  std::swap(open.faces[0][1], open.faces[0][2]);
  out.push_back({"open torus", open});
  return out;
}

std::string verdict(const ListedReport& r) {
  std::string out = r.is_valid ? "valid" : "invalid";
  for (std::uint64_t n : r.rule_counts) out += " " + std::to_string(n);
  return out + " shells " + std::to_string(r.counts.shells) + " bodies " + std::to_string(r.counts.bodies.value_or(99)) + " genus " +
         std::to_string(r.counts.genus.value_or(-99)) + " euler " + std::to_string(r.counts.euler);
}

TEST(ValidityLaw, RelabellingChangesNothing) {
  for (const Model& m : models(1))
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      Random random(seed);
      const ListedReport a = decide(m.mesh), b = decide(shapes::relabelled(m.mesh, random));
      EXPECT_EQ(verdict(a), verdict(b)) << m.name;
      EXPECT_EQ(spelled(a.volume), spelled(b.volume)) << m.name;
    }
}

TEST(ValidityLaw, ExactAffineMapsKeepTheVerdictOrTurnEveryShellOver) {
  for (const Model& m : models(2))
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(5)); ++seed) {
      Random random(seed);
      const shapes::Matrix matrix = shapes::random_matrix(random, 5);
      const int det = shapes::determinant(matrix);
      const TriangleMesh image = shapes::mapped(m.mesh, matrix, {-7, 100, 3});
      const ListedReport a = decide(m.mesh), b = decide(det > 0 ? image : shapes::reversed(image));
      EXPECT_EQ(verdict(a), verdict(b)) << m.name << ", seed " << seed;
      ASSERT_EQ(a.volume.has_value(), b.volume.has_value());
      if (a.volume) {
        EXPECT_EQ(*b.volume == *a.volume * Rational(std::abs(det)), true) << m.name << ", seed " << seed;
      }
      if (det < 0) {  // mirrored, not flipped: the right shells become the wrong ones
        const ListedReport c = decide(image);
        for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(a.rule_counts[i], c.rule_counts[i]) << m.name << ", M" << i + 1;
        if (a.nesting_decided) {
          std::uint64_t outer = 0, inner = 0;
          for (const ShellReport& s : a.shells) (*s.depth == 0 ? outer : inner) += 1;
          EXPECT_EQ(c.rule_counts[7], outer - a.rule_counts[7]) << m.name;
          EXPECT_EQ(c.rule_counts[8], inner - a.rule_counts[8]) << m.name;
        }
      }
    }
}

TEST(ValidityLaw, FlippingFlipsEveryShell) {
  for (const Model& m : models(3)) {
    const ListedReport a = decide(m.mesh), b = decide(shapes::reversed(m.mesh));
    for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(a.rule_counts[i], b.rule_counts[i]) << m.name;
    if (a.nesting_decided) {
      EXPECT_EQ(a.rule_counts[7] + a.rule_counts[8] + b.rule_counts[7] + b.rule_counts[8], a.counts.shells) << m.name;
    }
  }
}

TEST(ValidityLaw, SubdivisionKeepsVerdictGenusAndVolume) {
  for (const Model& m : models(4)) {
    const ListedReport a = decide(m.mesh);
    if (m.name.find("soup") != std::string::npos) continue;  // counts of crossings change there
    const ListedReport b = decide(shapes::subdivided(m.mesh));
    EXPECT_EQ(a.is_valid, b.is_valid) << m.name;
    EXPECT_EQ(a.counts.genus, b.counts.genus) << m.name;
    EXPECT_EQ(a.counts.bodies, b.counts.bodies) << m.name;
    EXPECT_EQ(a.counts.shells, b.counts.shells) << m.name;
    EXPECT_EQ(spelled(a.volume), spelled(b.volume)) << m.name;
    EXPECT_EQ(b.counts.faces, 4 * a.counts.faces) << m.name;
    EXPECT_EQ(b.rule_counts[2], 2 * a.rule_counts[2]) << m.name << ": boundary edges";
  }
}

TEST(ValidityLaw, ADisjointCopyDoublesEveryCount) {
  for (const Model& m : models(5)) {
    const ListedReport a = decide(m.mesh),
                       b = decide(shapes::joined(m.mesh, shapes::moved(m.mesh, {16384, 8192, 0})));
    EXPECT_EQ(a.is_valid, b.is_valid) << m.name;
    for (std::size_t i = 0; i < kNumMeshRules; ++i) EXPECT_EQ(2 * a.rule_counts[i], b.rule_counts[i]) << m.name << ", M" << i + 1;
    EXPECT_EQ(2 * a.counts.shells, b.counts.shells) << m.name;
    if (a.volume) {
      EXPECT_EQ(*a.volume * Rational(2) == *b.volume, true) << m.name;
    }
    if (a.counts.genus) {
      EXPECT_EQ(2 * *a.counts.genus, *b.counts.genus) << m.name;
    }
  }
}

TEST(ValidityLaw, PowersOfTwoScaleTheVolumeAndNothingElse) {
  for (const Model& m : models(6)) {
    const ListedReport a = decide(m.mesh);
    for (int e : {-900, -400, -31, 17, 450, 900}) {
      const ListedReport b = decide(shapes::scaled(m.mesh, e));
      EXPECT_EQ(verdict(a), verdict(b)) << m.name << ", 2^" << e;
      if (a.volume) {
        EXPECT_EQ(*a.volume * Rational::power_of_two(3 * e) == *b.volume, true) << m.name << ", 2^" << e;
      }
    }
  }
}

TEST(ValidityLaw, ReportsDoNotDependOnJobs) {
  Random random(8);
  auto all = models(7);
  all.push_back({"long thin", shapes::needle_soup(random, 100)});
  all.push_back({"cylinder", shapes::tilted_cylinder(300, shapes::Cap::kRimFan)});
  TriangleMesh big = shapes::torus(150, 120, 30, 12);  // several chunks of every loop
  all.push_back({"big torus", big});
  for (int i = 0; i < 60; ++i) big.positions[random.below(big.positions.size())] = big.positions[random.below(big.positions.size())];
  for (int i = 0; i < 50; ++i) std::swap(big.faces[random.below(big.faces.size())][0], big.faces[random.below(big.faces.size())][1]);
  all.push_back({"big and broken", big});
  for (const Model& m : all) {
    SCOPED_TRACE(m.name);
    const ListedReport one = decide(m.mesh);
    for (unsigned jobs : {2u, 3u, 4u}) expect_same_report(one, decide(m.mesh, jobs));
  }
}

}  // namespace
}  // namespace veritope
