// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/normality.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "robust/base/random.h"
#include "solids/chain/boolean_chains.h"
#include "solids/chain/chain_boundary.h"
#include "solids/chain/normal_chain.h"
#include "solids/chain/simplex_cell.h"
#include "tests/solids/patch_support.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

constexpr std::uint64_t kSeed = 20261129;
template <std::size_t Dim>
using State = typename Normality<Dim>::State;

template <std::size_t Dim>
Chain<Dim> cube(std::int64_t from, std::int64_t to) {
  PointIn<Dim> lo, hi;
  lo.fill(from);
  hi.fill(to);
  return box_chain<Dim>(lo, hi).value();
}

template <std::size_t Dim>
Normality<Dim> decide(const Chain<Dim>& chain, const NormalityOptions& options = {}) {
  const AssociatedFunction<Dim> f(chain);
  const Normality<Dim> out = is_normal(f, options);
  EXPECT_EQ(out.witness.has_value(), out.state == State<Dim>::kViolated);
  if (out.witness) {
    EXPECT_EQ(f.is_off_walls(*out.witness), true);
    EXPECT_EQ(f.value(*out.witness), out.value);
    EXPECT_FALSE(out.value == Integer(0) || out.value == Integer(1));
  }
  return out;
}

template <typename T>
class NormalityIn : public testing::Test {};
using NormalityDims =
    testing::Types<std::integral_constant<std::size_t, 1>, std::integral_constant<std::size_t, 2>,
                   std::integral_constant<std::size_t, 3>>;
TYPED_TEST_SUITE(NormalityIn, NormalityDims);

// PROVES CHAIN-4
TYPED_TEST(NormalityIn, IsDecidedForSimplices) {
  constexpr std::size_t kDim = TypeParam::value;
  using S = State<kDim>;
  const Chain<kDim> a = cube<kDim>(0, 2), b = cube<kDim>(1, 3), c = cube<kDim>(2, 4);
  EXPECT_EQ(decide(Chain<kDim>()).state, S::kHolds);
  EXPECT_EQ(decide(a).state, S::kHolds);
  EXPECT_EQ(decide(a + c).state, S::kHolds);  // they touch
  EXPECT_EQ(decide(a + cube<kDim>(9, 10)).state, S::kHolds);
  EXPECT_EQ(decide(a + b).value, Integer(2));
  EXPECT_EQ(decide(Integer(-1) * a).value, Integer(-1));
  EXPECT_EQ(decide(Integer(5) * a).value, Integer(5));
  EXPECT_EQ(decide(cube<kDim>(0, 3) - cube<kDim>(1, 2)).state, S::kHolds);  // a hollow one
}

// The paper's two forms of theorem 5.  PROVES CHAIN-3
TYPED_TEST(NormalityIn, TheDifferencesFirstFormIsNotNormal) {
  constexpr std::size_t kDim = TypeParam::value;
  using S = State<kDim>;
  const Chain<kDim> a = cube<kDim>(0, 2), b = cube<kDim>(1, 3);
  const Normality<kDim> first = decide(a - b);
  EXPECT_EQ(first.state, S::kViolated);
  EXPECT_EQ(first.value, Integer(-1));
  EXPECT_EQ(decide(difference_of(a, b).value()).state, S::kHolds);
  EXPECT_EQ(decide(union_of(a, b).value()).state, S::kHolds);
  EXPECT_EQ(decide(intersection_of(a, b).value()).state, S::kHolds);
  PointIn<kDim> lo, hi;
  lo.fill(-1);
  hi.fill(5);
  EXPECT_EQ(decide(complement_of(a, lo, hi).value()).state, S::kHolds);
}

// A thin overlap far smaller than the cells, of any shape: the decision finds it, points at random do not.
TYPED_TEST(NormalityIn, FindsThinOverlaps) {
  constexpr std::size_t kDim = TypeParam::value;
  for (const int bits : {20, 300}) {
    PointIn<kDim> lo, hi;
    lo.fill(0);
    hi.fill(2);
    lo[0] = 2 - Rational::power_of_two(-bits);
    hi[0] = 4;
    const Chain<kDim> chain = cube<kDim>(0, 2) + box_chain<kDim>(lo, hi).value();
    const Normality<kDim> found = decide(chain);
    EXPECT_EQ(found.state, State<kDim>::kViolated);
    EXPECT_EQ(found.value, Integer(2));
  }
}

TYPED_TEST(NormalityIn, IsUndecidedBeyondItsLimits) {
  constexpr std::size_t kDim = TypeParam::value;
  NormalityOptions options;
  options.max_places = 2;
  const Chain<kDim> both = union_of(cube<kDim>(0, 2), cube<kDim>(1, 3)).value();
  EXPECT_EQ(decide(both, options).state, State<kDim>::kUndecided);
  EXPECT_EQ(decide(Integer(2) * cube<kDim>(0, 2), options).state, State<kDim>::kViolated);
}

// Random sums of simplices against many points.  PROVES CHAIN-4
TEST(Normality, NeverHoldsWhereAPointSaysOtherwise) {
  Random random(kSeed);
  std::size_t holds = 0, violated = 0;
  for (int round = 0; round < 300; ++round) {
    Chain<2> chain;
    for (int i = 0; i < 3; ++i) {
      SimplexCell<2>::Corners corners;
      for (auto& p : corners)
        for (auto& x : p) x = static_cast<int>(random.below(7));
      if (const auto made = SimplexCell<2>::make(corners))
        chain = chain + Chain<2>(Integer(i == 2 ? -1 : 1), *made);
    }
    const Normality<2> found = decide(chain);
    ASSERT_NE(found.state, State<2>::kUndecided) << "seed " << kSeed;
    ++(found.state == State<2>::kHolds ? holds : violated);
    if (found.state != State<2>::kHolds) continue;
    const AssociatedFunction<2> f(chain);
    for (int i = 0; i < 200; ++i) {
      const PointIn<2> q{Rational::from_double(7 * random.unit()),
                         Rational::from_double(7 * random.unit())};
      const Integer v = *f.value(q);
      EXPECT_TRUE(v == Integer(0) || v == Integer(1)) << "seed " << kSeed << " round " << round;
    }
  }
  EXPECT_GT(holds, 20u);
  EXPECT_GT(violated, 20u);
}

std::vector<FacetIn<3>> facets_of(const TriangleMesh& mesh) {
  std::vector<FacetIn<3>> out;
  for (const auto& face : mesh.faces) {
    FacetIn<3>& facet = out.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        facet[i][static_cast<std::size_t>(k)] = Rational::from_double(mesh.positions[face[i]][k]);
  }
  return out;
}

// Hundreds of simplices that all meet at the origin, by their boundary.  PROVES CHAIN-4
TEST(Normality, HoldsForNormalChainsOfLargeMeshes) {
  const TriangleMesh torus = shapes::torus(24, 16, 3, 1);
  const PointIn<3> origin{Rational(1) / Rational(3), Rational(1) / Rational(7), 5};
  const Chain<3> chain = original_simplices<3>(facets_of(torus), origin);
  EXPECT_EQ(decide(chain).state, State<3>::kHolds);
  EXPECT_EQ(boundary_of(chain)->size(), torus.faces.size());
  NormalityOptions few;
  few.max_places = 100;
  EXPECT_EQ(decide(Integer(2) * chain, few).state, State<3>::kViolated);
  // Two tori that cross, or the same one turned inside out.
  const TriangleMesh moved = shapes::moved(torus, {1, 0, 0});
  const Chain<3> other = original_simplices<3>(facets_of(moved), origin);
  EXPECT_EQ(decide(chain + other, few).value, Integer(2));
  EXPECT_EQ(decide(original_simplices<3>(facets_of(shapes::reversed(torus)), origin), few).value,
            Integer(-1));
  EXPECT_FALSE(boundary_of(intersection_of(cube<3>(0, 1), cube<3>(0, 1)).value()));
}

// Facets have their normals where f is less; those between cells cancel.
TEST(ChainBoundary, HasTheFacetsThatDoNotCancel) {
  const auto inner = boundary_of(cube<2>(0, 2));
  ASSERT_TRUE(inner);
  EXPECT_EQ(inner->size(), 4u);
  for (const BoundaryFacet<2>& f : *inner) {
    EXPECT_EQ(f.multiplicity, Integer(1));
    EXPECT_EQ(orientation_of<2>({f.corners[0], f.corners[1], {1, 1}}), Sign::kPositive);
  }
  for (const auto& [factor, sign] :
       {std::pair(3, Sign::kNegative), std::pair(-3, Sign::kPositive)}) {
    const auto facets = boundary_of(Integer(factor) * cube<3>(0, 2));
    ASSERT_TRUE(facets);
    for (const BoundaryFacet<3>& f : *facets) {
      EXPECT_EQ(f.multiplicity, Integer(3));
      EXPECT_EQ(orientation_of<3>({f.corners[0], f.corners[1], f.corners[2], {1, 1, 1}}), sign);
    }
  }
  EXPECT_EQ(boundary_of(cube<3>(0, 2))->size(), 12u);
  EXPECT_TRUE(boundary_of(Chain<3>())->empty());
  EXPECT_TRUE(boundary_of(cube<3>(0, 2) - cube<3>(0, 2))->empty());
  EXPECT_FALSE(
      boundary_of(NormalChain(complex_of(patch_shapes::octant_sphere())).chain({0, 0, 0})));
}

// The normal chain of a polyhedron is normal for every origin; closed cells count twice on its faces.  PROVES CHAIN-4
TEST(Normality, HoldsForNormalChainsOfBlocks) {
  const PatchComplex complex = complex_of(unit_box());
  const NormalChain chain(complex);
  for (const ExactPoint& origin :
       {ExactPoint{0, 0, 0}, ExactPoint{Rational(1) / Rational(3), Rational(1) / Rational(5), 2},
        ExactPoint{7, -9, 4}})
    EXPECT_EQ(decide(chain.chain(origin)).state, State<3>::kHolds);
}

TEST(Normality, OfCurvedCellsIsRefutedOrUndecided) {
  const NormalChain chain(complex_of(patch_shapes::octant_sphere()));
  const Chain<3> a = chain.chain({0, 0, 0});
  EXPECT_EQ(decide(a).state, State<3>::kUndecided);
  EXPECT_EQ(decide(Integer(2) * a).state, State<3>::kViolated);
  EXPECT_EQ(decide(a - cube<3>(-2, 2)).value, Integer(-1));
}

}  // namespace
}  // namespace veritope
