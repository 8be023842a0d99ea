// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/boolean_chains.h"

#include <gtest/gtest.h>

#include "robust/base/random.h"
#include "solids/chain/associated_function.h"
#include "solids/chain/normal_chain.h"
#include "solids/chain/simplex_cell.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

constexpr std::uint64_t kSeed = 20261131;

template <std::size_t Dim>
Chain<Dim> random_chain(Random& random) {
  Chain<Dim> out;
  while (out.terms().size() < 4) {
    typename SimplexCell<Dim>::Corners corners;
    for (auto& p : corners)
      for (auto& x : p) x = static_cast<int>(random.below(6));
    if (const auto made = SimplexCell<Dim>::make(corners))
      out = out + Chain<Dim>(Integer(static_cast<int>(random.below(5)) - 2), *made);
  }
  return out;
}

template <typename T>
class ProductIn : public testing::Test {};
using ProductDims =
    testing::Types<std::integral_constant<std::size_t, 1>, std::integral_constant<std::size_t, 2>,
                   std::integral_constant<std::size_t, 3>>;
TYPED_TEST_SUITE(ProductIn, ProductDims);

// Every row of the tables of theorems 2 to 5, and the first form of theorem 5.  PROVES CHAIN-3
TEST(BooleanChains, HaveTheValuesOfTheTables) {
  const auto segment = [](int from, int to) { return box_chain<1>({from}, {to}).value(); };
  const Chain<1> a = segment(0, 4), b = segment(2, 6);
  const AssociatedFunction<1> both(intersection_of(a, b).value()), either(union_of(a, b).value()),
      without(difference_of(a, b).value()), first_form(a - b),
      outside(complement_of<1>(a, {-9}, {9}).value());
  struct Row {
    int x, both, either, without, first_form, outside;
  };
  for (const Row& row : {Row{1, 0, 1, 1, 1, 0}, Row{3, 1, 1, 0, 0, 0}, Row{5, 0, 1, 0, -1, 1},
                         Row{8, 0, 0, 0, 0, 1}, Row{10, 0, 0, 0, 0, 0}}) {
    const PointIn<1> q{row.x};
    EXPECT_EQ(both.value(q), Integer(row.both)) << row.x;
    EXPECT_EQ(either.value(q), Integer(row.either)) << row.x;
    EXPECT_EQ(without.value(q), Integer(row.without)) << row.x;
    EXPECT_EQ(first_form.value(q), Integer(row.first_form)) << row.x;
    EXPECT_EQ(outside.value(q), Integer(row.outside)) << row.x;
  }
  // On a wall the values of single chains must not be combined: 2 + 2 - 4 = 0 inside the union.
  const Chain<1> halves = segment(0, 2) + segment(2, 4);
  const PointIn<1> wall{2};
  const AssociatedFunction<1> f(halves), all(union_of(halves, halves).value());
  EXPECT_EQ(f.regular_value(wall), Integer(2));
  EXPECT_EQ(AssociatedFunction<1>(product(halves, halves).value()).regular_value(wall), Integer(4));
  EXPECT_EQ(all.value(wall), Integer(0));
  EXPECT_EQ(all.regular_value(wall), Integer(1));
}

// Any coefficients, walls included: closed cells that meet meet in a closed cell.  PROVES CHAIN-3
TYPED_TEST(ProductIn, MultipliesFunctions) {
  constexpr std::size_t kDim = TypeParam::value;
  Random random(kSeed);
  for (int round = 0; round < 20; ++round) {
    const Chain<kDim> a = random_chain<kDim>(random), b = random_chain<kDim>(random);
    const AssociatedFunction<kDim> f(a), g(b), both(product(a, b).value()),
        swapped(product(b, a).value());
    EXPECT_TRUE((both.chain() - swapped.chain()).is_zero());  // as formal sums
    for (int i = 0; i < 30; ++i) {
      PointIn<kDim> q;
      for (auto& x : q) x = Rational(static_cast<int>(random.below(13))) / Rational(2);
      EXPECT_EQ(*both.value(q), *f.value(q) * *g.value(q)) << "seed " << kSeed;
    }
  }
}

TYPED_TEST(ProductIn, HasALimit) {
  constexpr std::size_t kDim = TypeParam::value;
  PointIn<kDim> lo, hi;
  lo.fill(0);
  hi.fill(1);
  const Chain<kDim> a = box_chain<kDim>(lo, hi).value();
  const std::uint64_t pairs = a.terms().size() * a.terms().size();
  EXPECT_TRUE(product(a, a, pairs));
  for (const auto& made : {product(a, a, pairs - 1), union_of(a, a, pairs - 1),
                           difference_of(a, a, pairs - 1), intersection_of(a, a, pairs - 1)}) {
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, Code::kOverLimit);
  }
  EXPECT_TRUE(product(a, Chain<kDim>(), 0));
}

TYPED_TEST(ProductIn, ComplementsNeedABoxAroundAllCells) {
  constexpr std::size_t kDim = TypeParam::value;
  PointIn<kDim> lo, hi;
  lo.fill(0);
  hi.fill(1);
  const Chain<kDim> a = box_chain<kDim>(lo, hi).value();
  const auto touching = complement_of(a, lo, hi);
  ASSERT_FALSE(touching);
  EXPECT_EQ(touching.error().code, Code::kBadArgument);
  EXPECT_EQ(touching.error().message,
            "the box from 0 to 1 along axis 0 has not all cells of the chain in its interior");
  PointIn<kDim> far_lo, far_hi;
  far_lo.fill(-1);
  far_hi.fill(2);
  EXPECT_FALSE(complement_of(a, lo, far_hi));
  EXPECT_FALSE(complement_of(a, far_lo, hi));
  EXPECT_TRUE(complement_of(a, far_lo, far_hi));
  const AssociatedFunction<kDim> f(complement_of(a, far_lo, far_hi).value());
  PointIn<kDim> q;
  for (std::size_t k = 0; k < kDim; ++k) q[k] = Rational(static_cast<int>(k) + 1) / Rational(7);
  EXPECT_EQ(f.value(q), Integer(0));
  q[0] = Rational(3) / Rational(2);
  EXPECT_EQ(f.value(q), Integer(1));
  q[0] = 3;
  EXPECT_EQ(f.value(q), Integer(0));
  EXPECT_FALSE(complement_of(a, far_hi, far_lo));
  EXPECT_TRUE(complement_of(Chain<kDim>(), far_lo, far_hi));
}

// A sphere without a block that reaches into it, with two origins.  PROVES CHAIN-3
TEST(BooleanChains, AreSolidsOfPatches) {
  const NormalChain sphere(complex_of(patch_shapes::octant_sphere()));
  const NormalChain block(complex_of(unit_box()));
  const Chain<3> a = sphere.chain({0, 0, 0}),
                 b = block.chain({Rational(1) / Rational(3), -2, Rational(1) / Rational(7)});
  const AssociatedFunction<3> both(intersection_of(a, b).value()), either(union_of(a, b).value()),
      without(difference_of(a, b).value()),
      outside(complement_of(a, {-5, -5, -5}, {5, 5, 5}).value());
  Random random(kSeed);
  std::array<int, 4> seen{};
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p{3 * random.unit() - 1.5, 3 * random.unit() - 1.5, 3 * random.unit() - 1.5};
    const ExactPoint q{Rational::from_double(p.x), Rational::from_double(p.y),
                       Rational::from_double(p.z)};
    const int s = (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] - Rational(1)).sign() < 0 ? 1 : 0;
    const int t = p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1 && p.z > 0 && p.z < 1 ? 1 : 0;
    ++seen[static_cast<std::size_t>(2 * s + t)];
    EXPECT_EQ(both.value(q), Integer(s & t)) << "seed " << kSeed;
    EXPECT_EQ(either.value(q), Integer(s | t)) << "seed " << kSeed;
    EXPECT_EQ(without.value(q), Integer(s & (1 - t))) << "seed " << kSeed;
    EXPECT_EQ(outside.value(q), Integer(1 - s)) << "seed " << kSeed;
  }
  for (const int n : seen) EXPECT_GT(n, 5);
}

}  // namespace
}  // namespace veritope
