// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/patch_cell.h"

#include <gtest/gtest.h>

#include "robust/base/random.h"
#include "solids/chain/associated_function.h"
#include "solids/chain/boolean_chains.h"
#include "solids/chain/normal_chain.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

constexpr std::uint64_t kSeed = 20261130;

Rational over(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

// A roof over the triangle (0,0), (1,0), (0,1): z = 2 h u v, with h at its top control points.
Patch roof(const Rational& h) {
  Patch::Triangle map(2, 3, false);
  for_each_triangle_index(2, [&](int, int j, int k) {
    map.component(0)[triangle_index(j, k)] = over(j, 2);
    map.component(1)[triangle_index(j, k)] = over(k, 2);
    map.component(2)[triangle_index(j, k)] = j == 1 && k == 1 ? h : Rational(0);
  });
  return make_patch(std::move(map)).value();
}

// PROVES CHAIN-2
TEST(PatchCell, HasTheValueOneBetweenPatchAndBase) {
  for (const int h : {1, -1}) {
    const PatchCell cell(roof(h));
    EXPECT_EQ(cell.sign(), h);
    EXPECT_EQ(cell.kind(), CellKind::kFreeForm);
    const auto at = [&](const Rational& z) {  // the patch is at z = 2 h / 9
      return ChainPoint<3>({over(1, 3), over(1, 3), z});
    };
    EXPECT_EQ(cell.value(at(over(h, 9))), 1);
    EXPECT_EQ(cell.value(at(over(h, 3))), 0);
    EXPECT_EQ(cell.value(at(over(-h, 9))), 0);
    EXPECT_EQ(cell.value(at(over(2 * h, 9))), std::nullopt);  // on the patch
    EXPECT_EQ(cell.value(at(0)), 1);                          // on the base
    const auto germ = cell.germ(at(0));
    ASSERT_TRUE(germ);
    ASSERT_EQ(germ->half_spaces.size(), 1u);
    EXPECT_EQ(germ->inside, h > 0 ? 1 : 0);
    EXPECT_EQ(germ->outside, h > 0 ? 0 : 1);
    EXPECT_EQ(germ->border, 1);
    EXPECT_TRUE(cell.germ(at(over(h, 9)))->half_spaces.empty());
    EXPECT_FALSE(cell.germ(at(over(2 * h, 9))));
    // On an edge of the base, which is a side of the patch.
    EXPECT_FALSE(cell.germ(ChainPoint<3>({over(1, 3), 0, 0})));
    EXPECT_EQ(cell.germ(ChainPoint<3>({5, 5, 5}))->inside, 0);
  }
}

// z = 12 u v w (u - v): above the base on one side, below it on the other; values 1 and -1.  PROVES CHAIN-2
TEST(PatchCell, HasBothSignsWhereThePatchCrossesItsBase) {
  Patch::Triangle map(4, 3, false);
  for_each_triangle_index(4, [&](int i, int j, int k) {
    map.component(0)[triangle_index(j, k)] = over(j, 4);
    map.component(1)[triangle_index(j, k)] = over(k, 4);
    map.component(2)[triangle_index(j, k)] = i == 1 && j == 2 && k == 1   ? 1
                                             : i == 1 && j == 1 && k == 2 ? -1
                                                                          : 0;
  });
  const PatchCell cell(make_patch(std::move(map)).value());
  EXPECT_EQ(cell.sign(), 1);
  const auto value = [&](const Rational& x, const Rational& y, const Rational& z) {
    return cell.value(ChainPoint<3>({x, y, z}));
  };
  const Rational a = over(1, 2), b = over(1, 4), little = over(1, 100);  // z = 3/32 over (a, b)
  EXPECT_EQ(value(a, b, little), 1);
  EXPECT_EQ(value(a, b, 0), 1);
  EXPECT_EQ(value(a, b, -little), 0);
  EXPECT_EQ(value(b, a, -little), -1);
  EXPECT_EQ(value(b, a, 0), -1);
  EXPECT_EQ(value(b, a, little), 0);
  EXPECT_EQ(value(b, b, 0), std::nullopt);  // the patch crosses there
}

// Two triangles with a diagonal that is a ridge bound no half-spaces; in one plane they do.
TEST(PatchCell, HasGermsOnTheDiagonalsOfFlatBasesOnly) {
  for (const int corner : {0, 1}) {
    // Bidegree (2, 2) over the unit square, one corner of which is raised, and the middle.
    Patch::Tensor map({2, 2}, 3, false);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const auto u = static_cast<std::int64_t>(i), v = static_cast<std::int64_t>(j);
        map.component(0)[3 * i + j] = over(u, 2);
        map.component(1)[3 * i + j] = over(v, 2);
        map.component(2)[3 * i + j] =
            Rational(i == 1 && j == 1 ? 4 : 0) + Rational(corner) * over(u * (2 - v), 4);
      }
    const PatchCell cell(make_patch(std::move(map)).value());
    const ChainPoint<3> on_diagonal({over(1, 3), over(1, 3), 0});
    const ChainPoint<3> above({over(1, 3), over(1, 3), over(1, 2)});
    EXPECT_EQ(cell.value(above), 1);
    EXPECT_EQ(cell.germ(on_diagonal).has_value(), corner == 0);
    if (corner == 0) {
      EXPECT_EQ(cell.germ(on_diagonal)->half_spaces.size(), 1u);
      EXPECT_EQ(cell.value(on_diagonal), 1);
    }
  }
}

// f* on a base that a simplex and a free-form cell share is 2, f* on the outer face of a simplex 1.  PROVES CHAIN-2
TEST(PatchCell, IsCountedBesideSimplicesOnItsBase) {
  const Chain<3> cell(Integer(1), std::make_shared<const PatchCell>(roof(1)));
  const FacetIn<3> base{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const AssociatedFunction<3> f(cell +
                                original_simplices<3>({&base, 1}, {over(1, 4), over(1, 4), -1}));
  const PointIn<3> q{over(1, 3), over(1, 3), 0};
  EXPECT_EQ(f.value(q), Integer(2));
  EXPECT_EQ(f.regular_value(q), Integer(2));
  EXPECT_EQ(f.value({over(1, 3), over(1, 3), over(1, 9)}), Integer(1));
  EXPECT_EQ(f.value({over(1, 3), over(1, 3), over(-1, 9)}), Integer(1));
  EXPECT_EQ(f.regular_value({over(1, 3), over(1, 3), over(2, 9)}), std::nullopt);
}

// PROVES CHAIN-1
TEST(NormalChainAsChain, HasTheSameFunctionOffWalls) {
  Random random(kSeed);
  for (const Patches& patches :
       {patch_shapes::octant_sphere(), patch_shapes::sphere(), patch_shapes::one_patch_torus(3, 1),
        patch_shapes::pn_torus(12, 8), patch_shapes::frustum(1, 0, 2)}) {
    const PatchComplex complex = complex_of(patches);
    const NormalChain normal(complex);
    for (const ExactPoint& origin : {ExactPoint{0, 0, 0}, ExactPoint{over(7, 3), -5, over(1, 9)}}) {
      const AssociatedFunction<3> f(normal.chain(origin));
      std::size_t inside = 0;
      for (int i = 0; i < 60; ++i) {
        ExactPoint q;
        for (Rational& x : q) x = Rational::from_double(8 * random.unit() - 4);
        const auto w = normal.value(q, origin);
        ASSERT_TRUE(w);
        EXPECT_EQ(f.value(q), Integer(*w)) << "seed " << kSeed;
        inside += *w != 0 ? 1 : 0;
      }
      EXPECT_GT(inside + patches.size(), 2u);
    }
  }
}

// Patches in their bases have the coefficient 0.
TEST(NormalChainAsChain, HasNoCellsOverFlatPatches) {
  const NormalChain block(complex_of(unit_box()));
  const Chain<3> chain = block.chain({over(1, 3), over(1, 2), over(1, 5)});
  EXPECT_EQ(chain.terms().size(), 12u);
  for (const ChainTerm<3>& t : chain.terms()) EXPECT_EQ(t.cells[0]->kind(), CellKind::kSimplex);
  EXPECT_EQ(block.chain({0, 0, 0}).terms().size(), 6u);
}

// The intersection with a cell off which the point lies is 0 on every wall of the other.  PROVES CHAIN-3
TEST(PatchCell, DoesNotMatterWhereAnotherFactorIsZero) {
  const Chain<3> cell(Integer(1), std::make_shared<const PatchCell>(roof(1)));
  const FacetIn<3> facet{{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}};
  // Its box holds the cell's, but x + y + z < 2 does not.
  const Chain<3> far = original_simplices<3>({&facet, 1}, {2, 2, 2});
  const PointIn<3> on_patch{over(1, 3), over(1, 3), over(2, 9)};
  const AssociatedFunction<3> both(product(cell, far).value()), sum(cell + far);
  ASSERT_EQ(both.chain().terms().size(), 1u);
  EXPECT_EQ(both.value(on_patch), Integer(0));
  EXPECT_EQ(both.regular_value(on_patch), Integer(0));
  EXPECT_EQ(both.is_off_walls(on_patch), true);
  EXPECT_EQ(sum.value(on_patch), std::nullopt);
  EXPECT_EQ(sum.is_off_walls(on_patch), std::nullopt);
}

TEST(NormalChainAsChain, HasTheCellsOfThePaper) {
  const NormalChain normal(complex_of(patch_shapes::octant_sphere()));
  const Chain<3> chain = normal.chain({0, 0, 0});
  std::size_t simplices = 0, free_form = 0;
  for (const ChainTerm<3>& t : chain.terms()) {
    ASSERT_EQ(t.cells.size(), 1u);
    EXPECT_EQ(t.coefficient, Integer(1));
    ++(t.cells[0]->kind() == CellKind::kSimplex ? simplices : free_form);
  }
  EXPECT_EQ(simplices, 8u);
  EXPECT_EQ(free_form, 8u);
  // An edge of four simplices: definition 3 counts all of them, the value beside the point is 1.
  EXPECT_EQ(AssociatedFunction<3>(chain).value({0, 0, over(1, 2)}), Integer(4));
  EXPECT_EQ(normal.value({0, 0, over(1, 2)}, {0, 0, 0}), 1);
  EXPECT_EQ(AssociatedFunction<3>(chain).value({over(3, 5), 0, over(4, 5)}), std::nullopt);
}

}  // namespace
}  // namespace veritope
