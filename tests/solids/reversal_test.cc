// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/reversal.h"

#include <gtest/gtest.h>

#include "robust/base/check.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

ValidityReport decide(const TriangleMesh& mesh) { return decide_validity(mesh, {1, 20}); }

TriangleMesh with_reversed(TriangleMesh mesh, const std::vector<bool>& which) {
  for (std::size_t f = 0; f < which.size(); ++f)
    if (which[f]) std::swap(mesh.faces[f][1], mesh.faces[f][2]);
  return mesh;
}

// Reversing is possible, and leads back to the valid mesh of which the faces in `which` were reversed.
ReversedSolid expect_back(const TriangleMesh& valid, const std::vector<bool>& which) {
  const TriangleMesh mesh = with_reversed(valid, which);
  const ValidityReport report = decide(mesh);
  EXPECT_TRUE(is_valid_once_reversed(report)) << shapes::to_text(mesh);
  ReversedSolid out = reverse_to_solid(mesh, report, 2);
  EXPECT_EQ(out.reversal.is_reversed, which) << shapes::to_text(mesh);
  EXPECT_EQ(out.mesh.faces, valid.faces);
  const ValidityReport again = decide(out.mesh);
  EXPECT_TRUE(again.is_valid && out.report.is_valid);
  EXPECT_EQ(out.report.rule_counts, again.rule_counts);
  EXPECT_TRUE(list_defects(out.mesh, out.report).defects.empty());
  EXPECT_EQ(out.report.volume, again.volume);
  EXPECT_EQ(out.report.counts.bodies, again.counts.bodies);
  EXPECT_EQ(out.report.counts.genus, again.counts.genus);
  EXPECT_EQ(out.report.nesting.axis_code, again.nesting.axis_code);
  EXPECT_EQ(out.report.stars.code, again.stars.code);
  EXPECT_EQ(out.report.shells.size(), again.shells.size());
  for (std::size_t s = 0; s < again.shells.size(); ++s) {
    EXPECT_EQ(out.report.shells[s].volume, again.shells[s].volume);
    EXPECT_EQ(out.report.shells[s].outward, again.shells[s].outward);
    EXPECT_EQ(out.report.shells[s].depth, again.shells[s].depth);
  }
  return out;
}

// PROVES MESH-12
TEST(Reversal, OfAllOrientationsOfATetrahedronOneIsValidAndTheOthersLeadToIt) {
  const TriangleMesh tet = shapes::parse("tet 0,0,0 1,0,0 0,1,0 0,0,1");
  for (unsigned bits = 1; bits < 16; ++bits) {
    std::vector<bool> which;
    for (int f = 0; f < 4; ++f) which.push_back((bits >> f & 1) != 0);
    EXPECT_FALSE(decide(with_reversed(tet, which)).is_valid);
    const Reversal r = expect_back(tet, which).reversal;
    EXPECT_EQ(r.whole_shells, bits == 15 ? 1u : 0u);
    EXPECT_EQ(r.mixed_shells, bits == 15 ? 0u : 1u);
    EXPECT_EQ(r.faces, static_cast<std::uint64_t>(__builtin_popcount(bits)));
  }
}

// PROVES MESH-12
TEST(Reversal, NestedShellsAlternateWhicheverOfThemWereReversed) {
  const TriangleMesh nested = shapes::nested_boxes(3);
  const std::size_t faces = nested.faces.size() / 3;
  for (unsigned bits = 1; bits < 8; ++bits) {
    std::vector<bool> which;
    for (std::size_t f = 0; f < nested.faces.size(); ++f)
      which.push_back((bits >> (f / faces) & 1) != 0);
    const Reversal r = expect_back(nested, which).reversal;
    EXPECT_EQ(r.whole_shells, static_cast<std::uint64_t>(__builtin_popcount(bits)));
    EXPECT_EQ(r.mixed_shells, 0u);
    for (std::size_t s = 0; s < 3; ++s) {
      EXPECT_EQ(r.shells[s].faces, faces);
      EXPECT_EQ(r.shells[s].reversed, (bits >> s & 1) != 0 ? faces : 0);
    }
  }
}

TEST(Reversal, RandomFacesOfRandomScenesAreFoundAgain) {
  for (long seed = 1; seed <= scaled(40); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(static_cast<std::uint64_t>(seed));
    const TriangleMesh scene =
        seed % 2 == 0 ? shapes::nested_scene(random, 5)
                      : shapes::joined(shapes::star_polyhedron(random, 1),
                                       shapes::moved(shapes::torus(6, 5, 4, 1), {20, 0, 0}));
    const TriangleMesh valid = shapes::relabelled(scene, random);
    ASSERT_TRUE(decide(valid).is_valid);
    std::vector<bool> which;
    for (std::size_t f = 0; f < valid.faces.size(); ++f) which.push_back(random.below(4) == 0);
    which[random.below(which.size())] = true;
    expect_back(valid, which);
  }
}

TEST(Reversal, IsNoneOfMeshesThatAreValidOrBreakAnotherRule) {
  const TriangleMesh box = shapes::box({0, 0, 0}, {1, 1, 1});
  EXPECT_FALSE(is_valid_once_reversed(decide(box)));
  EXPECT_THROW((void)reverse_to_solid(box, decide(box), 1), InternalError);
  TriangleMesh open = shapes::reversed(box);
  open.faces.pop_back();
  EXPECT_FALSE(is_valid_once_reversed(decide(open)));
  TriangleMesh crossing =
      shapes::reversed(shapes::joined(box, shapes::moved(box, {0.5, 0.5, 0.5})));
  EXPECT_FALSE(is_valid_once_reversed(decide(crossing)));
  EXPECT_THROW((void)reverse_to_solid(crossing, decide(crossing), 1), InternalError);
  TriangleMesh twice = box;
  twice.faces.push_back(twice.faces[0]);
  EXPECT_FALSE(is_valid_once_reversed(decide(twice)));
}

}  // namespace
}  // namespace veritope
