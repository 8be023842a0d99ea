// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/chain.h"

#include <gtest/gtest.h>

#include "robust/base/random.h"
#include "solids/chain/associated_function.h"
#include "solids/chain/simplex_cell.h"

namespace veritope {
namespace {

constexpr std::uint64_t kSeed = 20261128;

template <std::size_t Dim>
Chain<Dim> block(std::int64_t from, std::int64_t to) {
  PointIn<Dim> lo, hi;
  lo.fill(0);
  hi.fill(1);
  lo[0] = from;
  hi[0] = to;
  return box_chain<Dim>(lo, hi).value();
}

// x along the first axis; a point inside along the others, off the diagonals along which boxes are cut.
template <std::size_t Dim>
PointIn<Dim> point_at(const Rational& x) {
  PointIn<Dim> out{x};
  for (std::size_t k = 1; k < Dim; ++k) out[k] = Rational(static_cast<int>(k)) / Rational(7);
  return out;
}

Rational half(std::int64_t p) { return Rational(p) / Rational(2); }

template <typename T>
class ChainIn : public testing::Test {};
using Dims =
    testing::Types<std::integral_constant<std::size_t, 1>, std::integral_constant<std::size_t, 2>,
                   std::integral_constant<std::size_t, 3>>;
TYPED_TEST_SUITE(ChainIn, Dims);

TYPED_TEST(ChainIn, AddsCoefficientsOfTheSameCell) {
  constexpr std::size_t kDim = TypeParam::value;
  const Chain<kDim> a = block<kDim>(0, 1), b = block<kDim>(0, 1);
  EXPECT_EQ((a + a).terms().size(), a.terms().size());
  EXPECT_EQ((a + a).terms()[0].coefficient, Integer(2));
  EXPECT_EQ((a + b).terms().size(), 2 * a.terms().size());  // other cells
  EXPECT_TRUE((a - a).is_zero());
  EXPECT_TRUE((Integer(0) * a).is_zero());
  EXPECT_TRUE((a + Integer(-1) * a).is_zero());
  EXPECT_TRUE(Chain<kDim>(Integer(0), a.terms()[0].cells[0]).is_zero());
  EXPECT_EQ(Chain<kDim>().box(), empty_box());
  EXPECT_EQ((Integer(3) * a).box(), a.box());
}

// PROVES CHAIN-2
TYPED_TEST(ChainIn, CountsClosedCells) {
  constexpr std::size_t kDim = TypeParam::value;
  const AssociatedFunction<kDim> f(block<kDim>(0, 1) + block<kDim>(1, 2));
  const auto at = [&](const Rational& x) { return f.value(point_at<kDim>(x)); };
  EXPECT_EQ(at(half(1)), Integer(1));
  EXPECT_EQ(at(half(3)), Integer(1));
  EXPECT_EQ(at(1), Integer(2));  // on a face of two closed cells
  EXPECT_EQ(at(0), Integer(1));
  EXPECT_EQ(at(half(5)), Integer(0));
  EXPECT_EQ(f.holds(point_at<kDim>(half(1))), true);
  EXPECT_EQ(f.holds(point_at<kDim>(half(-1))), false);
  EXPECT_EQ(f.is_off_walls(point_at<kDim>(half(1))), true);
  EXPECT_EQ(f.is_off_walls(point_at<kDim>(1)), false);
  EXPECT_EQ(f.is_off_walls(point_at<kDim>(half(9))), true);
}

// Definition 6.  PROVES CHAIN-2
TYPED_TEST(ChainIn, RegularValuesAreExtremesOfTheNeighbourhood) {
  constexpr std::size_t kDim = TypeParam::value;
  const Chain<kDim> a = block<kDim>(0, 2), b = block<kDim>(1, 2);
  const auto at = [](const Chain<kDim>& chain, const Rational& x) {
    return AssociatedFunction<kDim>(chain).regular_value(point_at<kDim>(x));
  };
  EXPECT_EQ(at(a + b, 1), Integer(2));
  EXPECT_EQ(at(a + b, half(1)), Integer(1));
  EXPECT_EQ(at(a - b, 1), Integer(1));  // f is 0 there
  EXPECT_EQ(AssociatedFunction<kDim>(a - b).value(point_at<kDim>(1)), Integer(0));
  EXPECT_EQ(at(Integer(-1) * (a + b), 1), Integer(-2));
  EXPECT_EQ(at(a + block<kDim>(2, 3), 2), Integer(2));  // even f* counts both
  EXPECT_EQ(at(a, 0), Integer(1));
  EXPECT_EQ(at(a, -1), Integer(0));
  EXPECT_EQ(at(a, half(1)), Integer(1));
}

TYPED_TEST(ChainIn, ValuesBesideWallsAreThoseOfOneDirection) {
  constexpr std::size_t kDim = TypeParam::value;
  const AssociatedFunction<kDim> f(block<kDim>(0, 1) + block<kDim>(1, 2));
  EXPECT_EQ(f.value_beside(point_at<kDim>(1)), Integer(1));
  EXPECT_EQ(f.value_beside(point_at<kDim>(half(1))), Integer(1));
  EXPECT_EQ(f.value_beside(point_at<kDim>(7)), Integer(0));
  PointIn<kDim> corner;
  corner.fill(0);  // on the diagonals of the box as well
  EXPECT_EQ(f.value_beside(corner), Integer(1));
  corner[0] = 2;
  EXPECT_EQ(f.value_beside(corner), Integer(0));
}

// [0,2] - [0,1] - [1,2] has f = 0 off walls and f* = 0 everywhere, but it changes f* of what it is added to: only
// classes of equal f are a module.  PROVES CHAIN-2
TYPED_TEST(ChainIn, RegularFunctionsAreNoModule) {
  constexpr std::size_t kDim = TypeParam::value;
  const Chain<kDim> null = block<kDim>(0, 2) - block<kDim>(0, 1) - block<kDim>(1, 2);
  const AssociatedFunction<kDim> f(null), sum(null - block<kDim>(0, 2));
  const AssociatedFunction<kDim> minus(Integer(-1) * block<kDim>(0, 2));
  for (int i = -1; i <= 5; ++i) {
    const PointIn<kDim> q = point_at<kDim>(half(i));
    EXPECT_EQ(f.regular_value(q), Integer(0)) << i;
    if (f.is_off_walls(q) == true) {
      EXPECT_EQ(f.value(q), Integer(0)) << i;
    }
  }
  const PointIn<kDim> wall = point_at<kDim>(1);
  EXPECT_EQ(f.value(wall), Integer(-1));
  EXPECT_EQ(minus.regular_value(wall), Integer(-1));
  EXPECT_EQ(sum.regular_value(wall), Integer(-2));
}

// PROVES CHAIN-2
TYPED_TEST(ChainIn, FunctionsAreLinear) {
  constexpr std::size_t kDim = TypeParam::value;
  Random random(kSeed);
  const auto number = [&] { return Rational(static_cast<std::int64_t>(random.below(9)) - 4); };
  const auto simplex = [&] {
    for (;;) {
      typename SimplexCell<kDim>::Corners corners;
      for (auto& p : corners)
        for (auto& x : p) x = number();
      if (auto made = SimplexCell<kDim>::make(corners)) return *made;
    }
  };
  for (int round = 0; round < 40; ++round) {
    Chain<kDim> a, b;
    for (int i = 0; i < 5; ++i) {
      a = a + Chain<kDim>(Integer(static_cast<int>(random.below(7)) - 3), simplex());
      b = b + Chain<kDim>(Integer(static_cast<int>(random.below(7)) - 3), simplex());
    }
    const Integer k(static_cast<int>(random.below(9)) - 4);
    const AssociatedFunction<kDim> f(a), g(b), sum(a + b), multiple(k * a);
    for (int i = 0; i < 20; ++i) {
      PointIn<kDim> q;
      for (auto& x : q) x = number();  // many of them on walls
      EXPECT_EQ(*sum.value(q), *f.value(q) + *g.value(q)) << "seed " << kSeed;
      EXPECT_EQ(*multiple.value(q), k * *f.value(q)) << "seed " << kSeed;
      if (f.is_off_walls(q) == true) {
        EXPECT_EQ(f.regular_value(q), f.value(q)) << "seed " << kSeed;
      }
    }
  }
}

TYPED_TEST(ChainIn, BoxesHaveTheValueOneInside) {
  constexpr std::size_t kDim = TypeParam::value;
  const AssociatedFunction<kDim> f(block<kDim>(-3, 5));
  EXPECT_EQ(f.chain().terms().size(), kDim == 3 ? 6u : kDim);
  Random random(kSeed);
  for (int i = 0; i < 100; ++i) {
    PointIn<kDim> q;
    bool is_inside = true;
    for (std::size_t k = 0; k < kDim; ++k) {
      q[k] = Rational::from_double(random.unit() * 12 - 5);
      is_inside = is_inside && (k == 0 ? Rational(-3) < q[k] && q[k] < Rational(5)
                                       : Rational(0) < q[k] && q[k] < Rational(1));
    }
    EXPECT_EQ(f.value(q), Integer(is_inside ? 1 : 0)) << "seed " << kSeed;
  }
}

TYPED_TEST(ChainIn, FlatBoxesAndFlatSimplicesAreRefused) {
  constexpr std::size_t kDim = TypeParam::value;
  PointIn<kDim> lo, hi;
  lo.fill(0);
  hi.fill(1);
  hi[kDim - 1] = 0;
  const auto box = box_chain<kDim>(lo, hi);
  ASSERT_FALSE(box);
  EXPECT_EQ(box.error().code, Code::kBadArgument);
  EXPECT_EQ(box.error().message, "the box has no interior: it extends from 0 to 0 along axis " +
                                     std::to_string(kDim - 1));
  typename SimplexCell<kDim>::Corners corners;
  corners.fill(lo);
  const auto simplex = SimplexCell<kDim>::make(corners);
  ASSERT_FALSE(simplex);
  EXPECT_EQ(simplex.error().code, Code::kBadArgument);
  EXPECT_NE(simplex.error().message.find("has no interior"), std::string::npos);
}

// The polygon of the paper's plane, and a point as its one-dimensional boundary.
TEST(OriginalSimplices, HaveTheSignsOfTheirVolumes) {
  const std::vector<FacetIn<2>> square = {
      {{{1, 1}, {3, 1}}}, {{{3, 1}, {3, 3}}}, {{{3, 3}, {1, 3}}}, {{{1, 3}, {1, 1}}}};
  for (const PointIn<2>& origin : {PointIn<2>{0, 0}, {2, 2}, {1, 1}, {9, -5}}) {
    const AssociatedFunction<2> f(original_simplices<2>(square, origin));
    EXPECT_EQ(f.value({Rational(5) / Rational(3), Rational(9) / Rational(4)}), Integer(1));
    EXPECT_EQ(f.value({Rational(7) / Rational(9), Rational(1) / Rational(2)}), Integer(0));
  }
  EXPECT_EQ(original_simplices<2>(square, {1, 1}).terms().size(), 2u);  // two have no area
  EXPECT_EQ(original_simplices<2>(square, {0, 0}).terms()[0].coefficient, Integer(-1));
}

}  // namespace
}  // namespace veritope
