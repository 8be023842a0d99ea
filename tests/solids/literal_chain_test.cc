// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/literal_chain.h"

#include <gtest/gtest.h>

#include "models/patch_shapes.h"
#include "solids/classify/patch_classifier.h"
#include "tests/solids/literal_support.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

using literal::fraction;
using literal::monomial;
using literal::moved;
using literal::tetrahedron_with;
using literal::valley_with;

const ExactPoint kOrigin{fraction(1, 97), fraction(1, 89), fraction(-1, 83)};

int winding(const PatchComplex& complex, const ExactPoint& q) {
  return PatchClassifier::make(complex, false).classify(q).winding;
}

// At the points of a grid that lies askew to all planes.
void expect_f_is_w(const PatchComplex& complex, const ExactPoint& origin, int reach) {
  const LiteralChain chain(complex);
  const PatchClassifier service = PatchClassifier::make(complex, false);
  int inside = 0;
  for (int i = -9; i <= 9; ++i)
    for (int j = -9; j <= 9; ++j)
      for (int k = -9; k <= 9; ++k) {
        const ExactPoint q{fraction(reach * i, 9) + fraction(1, 101),
                           fraction(reach * j, 9) + fraction(1, 103),
                           fraction(reach * k, 9) + fraction(1, 107)};
        const int w = service.classify(q).winding;
        const LiteralValue value = chain.value(q, origin);
        EXPECT_EQ(value.f, w) << i << " " << j << " " << k;
        EXPECT_EQ(value.regular, w);
        inside += w;
      }
  EXPECT_GT(inside, 500);
}

// PROVES CHAIN-6
TEST(LiteralChain, IsTheWindingNumberForPnTrianglesOfTheOctahedron) {
  const PatchComplex complex = complex_of(literal::pn_octahedron());
  for (const ExactPoint& origin :
       {ExactPoint{0, 0, 0}, kOrigin, ExactPoint{3, -1, fraction(1, 2)}, ExactPoint{1, 0, 0}})
    expect_f_is_w(complex, origin, 1);
}

// PROVES CHAIN-6
TEST(LiteralChain, IsTheWindingNumberForPnTrianglesOfTheTetrahedron) {
  expect_f_is_w(complex_of(literal::pn_tetrahedron()), kOrigin, 1);
}

TEST(LiteralChain, AllHypothesesHoldForPnTrianglesOfRegularSolids) {
  for (const Patches& patches : {literal::pn_octahedron(), literal::pn_tetrahedron()}) {
    const PatchComplex complex = complex_of(patches);
    const LiteralHypotheses h = LiteralChain(complex).hypotheses();
    EXPECT_EQ(h.planes_share_lines.holds(), true) << h.planes_share_lines.first;
    EXPECT_EQ(h.curves_in_planes.holds(), true) << h.curves_in_planes.first;
    EXPECT_EQ(h.graphs.holds(), true) << h.graphs.first;
    EXPECT_EQ(h.planes_share_lines.places, complex.num_vertices());
    EXPECT_EQ(h.curves_in_planes.places, complex.num_edges());
    EXPECT_EQ(h.graphs.places, patches.size());
    EXPECT_EQ(h.graphs.first, "");
  }
}

TEST(LiteralChain, PlanesInGeneralPositionShareNoLine) {
  const PatchComplex complex = complex_of(tetrahedron_with({}));
  const LiteralHypotheses h = LiteralChain(complex).hypotheses();
  EXPECT_EQ(h.planes_share_lines.holds(), false);
  EXPECT_EQ(h.planes_share_lines.violations, 4u);
  EXPECT_EQ(h.planes_share_lines.first,
            "the vertex at (0, 0, 0) of patch 0: the planes of its 3 edges have no line in common");
  EXPECT_EQ(h.curves_in_planes.holds(), true);
  EXPECT_EQ(h.graphs.holds(), true);
}

// The condition that a model violates, where all others hold; f and w at a point that shows it.
void expect_only(const PatchComplex& complex, LiteralHypothesis LiteralHypotheses::*violated,
                 const ExactPoint& q, int f, int w) {
  const LiteralChain chain(complex);
  const LiteralHypotheses h = chain.hypotheses();
  for (const auto condition : {&LiteralHypotheses::curves_in_planes, &LiteralHypotheses::in_wedges,
                               &LiteralHypotheses::facing, &LiteralHypotheses::upright})
    EXPECT_EQ((h.*condition).holds(), condition != violated) << (h.*condition).first;
  EXPECT_EQ(h.graphs.holds(), false);
  EXPECT_EQ(h.graphs.violations, (h.*violated).violations);
  EXPECT_EQ(winding(complex, q), w);
  EXPECT_EQ(chain.value(q, kOrigin).f, f);
}

// PROVES CHAIN-6.G1
TEST(LiteralChain, LosesWhatIsBeyondTheWedge) {
  // The right face bulges over the plane of the valley, along its normal.
  const Patches patches = valley_with({{{-1, 0, 1}, monomial({1, 1, 1}, Rational(6))}}, {});
  expect_only(complex_of(patches), &LiteralHypotheses::in_wedges,
              {fraction(-1, 100), fraction(1, 2), fraction(1, 5)}, 0, 1);
}

// PROVES CHAIN-6.G2
TEST(LiteralChain, FillsTheFoldsOfAPatch) {
  // A bump that hangs over to the right: z = b, x = x0 + 300 b^2 with b = uvw.
  const auto b = monomial({1, 1, 1});
  const Patches patches = tetrahedron_with({{{0, 0, 1}, b}, {{300, 0, 0}, b * b}});
  const PatchComplex complex = complex_of(patches);
  const LiteralHypotheses h = LiteralChain(complex).hypotheses();
  expect_only(complex, &LiteralHypotheses::facing,
              {fraction(655, 1000), fraction(1, 3), fraction(8, 1000)}, 1, 0);
  EXPECT_EQ(h.facing.violations, 1u);
}

// PROVES CHAIN-6.G3
TEST(LiteralChain, MissesWhatIsBelowAWallThatLeansOver) {
  // Both faces at the valley are raised along it.
  const literal::Move up{{0, 0, 1}, monomial({1, 1, 0}, fraction(1, 10))};
  expect_only(complex_of(valley_with({up}, {up})), &LiteralHypotheses::upright,
              {fraction(1, 1000), fraction(1, 2), fraction(1, 100)}, 0, 1);
}

TEST(LiteralChain, NamesTheFirstViolations) {
  const LiteralHypotheses h = LiteralChain(complex_of(patch_shapes::pn_torus(12, 8))).hypotheses();
  EXPECT_EQ(h.planes_share_lines.violations, 96u);
  EXPECT_EQ(h.curves_in_planes.first,
            "facet 0: the curve of the edge from (4, 0, 0) to (3.4641, 2, 0) leaves its plane");
  EXPECT_EQ(h.curves_in_planes.violations, 280u);
  EXPECT_EQ(h.graphs.violations, 192u);
}

void expect_value(const LiteralChain& chain, const ExactPoint& q, const ExactPoint& origin, int f,
                  int regular) {
  const LiteralValue value = chain.value(q, origin);
  EXPECT_EQ(value.f, f);
  EXPECT_EQ(value.regular, regular);
}

// Definitions 3 and 6: all cells are closed, and f* is the greatest value near the point.
TEST(LiteralValue, OnFlatWallsCountsAllCellsThatMeetThere) {
  const PatchComplex complex = complex_of(literal::pn_octahedron());
  const LiteralChain chain(complex);
  const ExactPoint centre{0, 0, 0};
  expect_value(chain, {fraction(1, 3), fraction(1, 3), fraction(1, 3)}, centre, 2, 2);  // a base
  expect_value(chain, {fraction(11, 20), fraction(11, 20), 0}, centre, 2, 2);  // between two cells
  expect_value(chain, {0, 0, fraction(1, 2)}, centre, 4, 4);  // an edge of four simplices
  expect_value(chain, centre, centre, 8, 8);
  expect_value(chain, {fraction(1, 2), fraction(1, 2), 0}, centre, 4, 4);  // a chord
  expect_value(chain, {2, 2, 2}, centre, 0, 0);
}

// Cells are closed: points of patches are in them. There is no f* beside curved walls.
TEST(LiteralValue, OnPatchesAtRationalParametersIsKnown) {
  const PatchComplex complex = complex_of(literal::pn_octahedron());
  const LiteralChain chain(complex);
  const auto at = [&](const Barycentric<Rational>& b) {
    return *point_of(evaluate<Rational>(complex.patch(0).triangle(), b));
  };
  const Rational o(1), z, half = fraction(1, 2), third = fraction(1, 3);
  for (const auto& [b, f] :
       {std::pair(Barycentric<Rational>{half, fraction(1, 4), fraction(1, 4)}, 1),
        std::pair(Barycentric<Rational>{third, third, third}, 1),
        std::pair(Barycentric<Rational>{fraction(2, 7), fraction(4, 7), fraction(1, 7)}, 1),
        std::pair(Barycentric<Rational>{third, fraction(2, 3), z}, 2),
        std::pair(Barycentric<Rational>{z, o, z}, 8)}) {
    const LiteralValue value = chain.value(at(b), {0, 0, 0});
    EXPECT_EQ(value.f, f);
    EXPECT_EQ(value.regular, std::nullopt);
  }
  // Below the boundary curve, along the base's normal (1, 1, 1), where it leans out of the base's prism.
  ExactPoint below = at({half, half, z});
  for (Rational& x : below) x -= fraction(1, 100);
  EXPECT_EQ(chain.value(below, {0, 0, 0}).f, 1);
}

// Where a patch crosses the plane of its base, the point is in the closures of both parts, or of none.
TEST(LiteralValue, OnAPatchThatCrossesItsBaseIsOpen) {
  const auto h =
      monomial({1, 1, 1}) * (monomial({1, 0, 0}, Rational(2)) + monomial({0, 1, 0}, Rational(-2)));
  const PatchComplex complex = complex_of(tetrahedron_with({{{0, 0, 1}, h}}, fraction(-1, 3)));
  const LiteralValue value =
      LiteralChain(complex).value({fraction(1, 4), fraction(1, 2), 0}, kOrigin);
  EXPECT_EQ(value.f, std::nullopt);
  EXPECT_EQ(value.regular, std::nullopt);
}

// Seen from above, the faces at the lower edge from (0,0,0) have coefficient 1, the upper face -1. On the triangle
// between the origin and that edge, above the solid, f is 1, and 0 on both sides of it.
TEST(LiteralValue, IsRegularisedWhereOnlyAWallHasAValue) {
  const PatchComplex complex = complex_of(tetrahedron_with({}));
  const LiteralChain chain(complex);
  const ExactPoint origin{fraction(1, 4), fraction(1, 5), 10};
  expect_value(chain, {fraction(1, 8), fraction(1, 10), 1}, origin, 1, 0);
  for (const Rational& aside : {fraction(1, 1000), fraction(-1, 1000)})
    expect_value(chain, {fraction(1, 8) + aside, fraction(1, 10) - aside, 1}, origin, 0, 0);
  // On the upper face f* is 1, as it is next to it inside.
  expect_value(chain, {fraction(1, 8), fraction(1, 7), 0}, {fraction(1, 5), fraction(1, 5), -1}, 1,
               1);
}

TEST(LiteralValue, OfASurfaceInsideOutIsNegative) {
  const PatchComplex complex = complex_of(patch_shapes::reversed(literal::pn_octahedron()));
  const LiteralChain chain(complex);
  expect_value(chain, {fraction(1, 5), fraction(1, 7), fraction(1, 3)}, kOrigin, -1, -1);
  expect_value(chain, {fraction(1, 3), fraction(1, 3), fraction(1, 3)}, {0, 0, 0}, -2, -2);
}

}  // namespace
}  // namespace veritope
