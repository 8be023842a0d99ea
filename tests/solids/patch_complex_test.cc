// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patch_complex.h"

#include <gtest/gtest.h>

#include "solids/patch_shapes.h"
#include "solids/patch_transform.h"

namespace veritope {
namespace {

PatchComplex complex_of(std::vector<Patch> patches) {
  return make_patch_complex(std::move(patches)).value();
}

std::string all_findings(const PatchComplex& complex) {
  std::string text;
  for (const PatchFinding& f : complex.findings()) text += describe(complex, f) + "\n";
  return text;
}

// Vertices, edges, patches and the genus of the only shell.
void expect_one_shell(const PatchComplex& complex, std::uint64_t v, std::uint64_t e,
                      std::uint64_t f, std::int64_t genus) {
  EXPECT_TRUE(complex.is_closed_oriented_surface()) << all_findings(complex);
  ASSERT_EQ(complex.shells().size(), 1u);
  const PatchShell& shell = complex.shells()[0];
  EXPECT_EQ(shell.vertices, v);
  EXPECT_EQ(shell.edges, e);
  EXPECT_EQ(shell.patches, f);
  EXPECT_EQ(shell.genus(), std::optional(genus));
  EXPECT_EQ(complex.num_vertices(), v);
  EXPECT_EQ(complex.num_edges(), e);
}

TEST(PatchComplex, CountsTheCellsOfABox) {
  expect_one_shell(complex_of(patch_shapes::box({0, 0, 0}, {1, 2, 3})), 8, 12, 6, 0);
}
TEST(PatchComplex, CountsTheCellsOfASphereOfSixPatches) {
  expect_one_shell(complex_of(patch_shapes::sphere()), 8, 12, 6, 0);
}
// S0 with poles: 8, 0 and -2 are what the wrong rules for collapsed rows give.
TEST(PatchComplex, AnOctantSphereIsSixMinusTwelvePlusEight) {
  expect_one_shell(complex_of(patch_shapes::octant_sphere()), 6, 12, 8, 0);
}
TEST(PatchComplex, CountsTheCellsOfATorus) {
  expect_one_shell(complex_of(patch_shapes::torus(3, 1)), 16, 32, 16, 1);
}
TEST(PatchComplex, OnePatchMayCloseOnItself) {
  expect_one_shell(complex_of(patch_shapes::one_patch_torus(3, 1)), 1, 2, 1, 1);
}

}  // namespace
}  // namespace veritope
