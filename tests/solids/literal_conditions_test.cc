// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/literal_conditions.h"

#include <gtest/gtest.h>

#include "models/patch_shapes.h"
#include "solids/chain/literal_chain.h"
#include "tests/solids/literal_support.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

using literal::fraction;
using literal::monomial;
using literal::Poly;
using literal::tetrahedron_with;

LiteralCells cells_of(const Patches& patches) {
  const PatchComplex complex = complex_of(patches);
  return LiteralChain(complex).cells();
}

Patches raised(const Poly& height, const Rational& bottom = -2) {
  return tetrahedron_with({{{0, 0, 1}, height}}, bottom);
}

const Poly kBump = monomial({1, 1, 1});
// (u - v)^2 - (u + v + w)^2 / 16: positive at both ends of the side from u to v, and negative between.
Poly two_humps() {
  return kBump * (monomial({2, 0, 0}) + monomial({0, 2, 0}) + monomial({1, 1, 0}, Rational(-2)) +
                  literal::unit() * literal::unit() * Poly{0, {{{0, 0, 0}, fraction(-1, 16)}}});
}

TEST(LiteralCells, OfTheOctahedronAreAcceptedOrOpen) {
  const LiteralCells cells = cells_of(literal::pn_octahedron());
  EXPECT_EQ(cells.plus, 8u);
  EXPECT_EQ(cells.minus, 0u);
  EXPECT_EQ(cells.split, 0u);
  EXPECT_EQ(cells.connected.holds(), true);
  EXPECT_EQ(cells.with_vertices_on_patch.holds(), true);
  EXPECT_EQ(cells.on_one_side.violations, 0u);
  EXPECT_TRUE(cells.refused.empty());
}

TEST(LiteralCells, OfFlatPatchesDoNotExist) {
  const LiteralCells cells = cells_of(unit_box());
  EXPECT_EQ(cells.plus + cells.minus + cells.undecided, 0u);
  EXPECT_EQ(cells.connected.places, 0u);
}

// Figure 8: z = 2 uvw (u - v) crosses the plane of its base in a line.
TEST(LiteralCells, APatchThatCrossesItsBaseIsSplit) {
  const Poly h = kBump * (monomial({1, 0, 0}, Rational(2)) + monomial({0, 1, 0}, Rational(-2)));
  const PatchComplex complex = complex_of(raised(h, fraction(-1, 3)));
  const LiteralChain chain(complex);
  const LiteralCells cells = chain.cells();
  EXPECT_EQ(cells.plus, 1u);
  EXPECT_EQ(cells.minus, 1u);
  EXPECT_EQ(cells.split, 1u);
  EXPECT_EQ(cells.connected.places, 2u);
  EXPECT_EQ(cells.connected.holds(), true) << cells.connected.first;
  EXPECT_EQ(cells.on_one_side.holds(), true);  // the graph of a polynomial
  EXPECT_EQ(cells.with_vertices_on_patch.holds(), true);
  EXPECT_TRUE(cells.refused.empty());
  // u = 3/5, v = 1/5: h = 2 * 3/125 * 2/5 = 0.0192; the other way round -0.0192.
  const ExactPoint origin{fraction(1, 4), fraction(1, 4), fraction(-1, 9)};
  EXPECT_EQ(chain.value({fraction(1, 5), fraction(1, 5), fraction(18, 1000)}, origin).f, 1);
  EXPECT_EQ(chain.value({fraction(1, 5), fraction(1, 5), fraction(20, 1000)}, origin).f, 0);
  EXPECT_EQ(chain.value({fraction(3, 5), fraction(1, 5), fraction(-18, 1000)}, origin).f, 0);
  EXPECT_EQ(chain.value({fraction(3, 5), fraction(1, 5), fraction(-20, 1000)}, origin).f, 1);
}

// PROVES CHAIN-8
TEST(LiteralCells, ASetAsInFigure1aIsRefused) {
  const LiteralCells cells = cells_of(raised(two_humps()));
  EXPECT_EQ(cells.split, 1u);
  EXPECT_EQ(cells.connected.violations, 1u);
  ASSERT_EQ(cells.refused.size(), 1u);
  EXPECT_EQ(cells.refused[0].patch, 0u);
  EXPECT_TRUE(cells.refused[0].is_plus);
  EXPECT_STREQ(cells.refused[0].figure, "1a");
  EXPECT_EQ(cells.refused[0].why, cells.connected.first);
  EXPECT_NE(cells.refused[0].why.find("patch 0, plus part: the points ("), std::string::npos);
}

// The planes of the upper face's sides meet below it; a patch that hangs further down holds that point.
// PROVES CHAIN-8
TEST(LiteralCells, ASetAsInFigure3aIsRefused) {
  const LiteralCells shallow = cells_of(raised(kBump * Poly{0, {{{0, 0, 0}, Rational(-1)}}}));
  EXPECT_EQ(shallow.minus, 1u);
  EXPECT_EQ(shallow.with_vertices_on_patch.holds(), true);
  const LiteralCells deep = cells_of(raised(kBump * Poly{0, {{{0, 0, 0}, Rational(-30)}}}));
  EXPECT_EQ(deep.with_vertices_on_patch.violations, 1u);
  ASSERT_EQ(deep.refused.size(), 1u);
  EXPECT_STREQ(deep.refused[0].figure, "3a");
  EXPECT_FALSE(deep.refused[0].is_plus);
  EXPECT_EQ(
      deep.refused[0].why.rfind("patch 0, minus part: the planes of the three sides meet at (", 0),
      0u)
      << deep.refused[0].why;
}

// x = v + 2 uvw, z = uvw (1 - 0.447 v): beyond the side u = 0 the surface turns, and passes below the patch.
TEST(LiteralCells, ASurfaceThatReturnsIsOnBothSides) {
  const Poly h = kBump * (literal::unit() + monomial({0, 1, 0}, fraction(-447, 1000)));
  const LiteralCells cells = cells_of(tetrahedron_with({{{0, 0, 1}, h}, {{2, 0, 0}, kBump}}));
  EXPECT_EQ(cells.plus, 1u);
  EXPECT_EQ(cells.on_one_side.violations, 1u);
  EXPECT_EQ(cells.on_one_side.first,
            "patch 0, plus part: the surface beyond the patch passes through the cell at (0.5625, "
            "0.25, 0.00485156)");
  EXPECT_TRUE(cells.refused.empty());
}

TEST(LiteralCells, WithoutAWedgeAreNotDefined) {
  // The second halves of octants have bases without an area.
  const LiteralCells cells = cells_of(patch_shapes::octant_sphere());
  EXPECT_EQ(cells.without_wedge, 8u);
}

}  // namespace
}  // namespace veritope
