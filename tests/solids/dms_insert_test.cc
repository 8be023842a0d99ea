// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_insert_test.cc: vertices inside of tetrahedra leave the map what it is, exactly; what is refused.
// The experiment soak_dms_insertions makes more insertions.
#include "solids/dms/dms_insert.h"

#include <gtest/gtest.h>

#include "solids/dms/dms_surface.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/dms_insertions.h"
#include "tests/support/dms_laws.h"

namespace veritope {
namespace {

void expect_insertions(std::uint64_t first, long insertions, int points) {
  DmsInsertionCounts counts;
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(scaled(insertions)); ++i)
    ASSERT_EQ(check_dms_insertion(first + i, 4, points, counts), "");
  EXPECT_GE(counts.insertions, static_cast<std::uint64_t>(scaled(insertions)) * 3 / 4);
  EXPECT_GE(counts.inside, counts.points / 4);
  EXPECT_GE(counts.collapsed, counts.insertions / 8);
  EXPECT_LT(counts.collapsed, counts.insertions);
}

TEST(DmsInsert, LeavesTheMapEqual) { expect_insertions(1, 12, 6); }

TEST(DmsInsert, LeavesTheMapEqualInManyModels) { expect_insertions(100, 100, 20); }

TEST(DmsInsert, WithAnotherControlPointTheMapChanges) {
  const DmsModel model = draw_dms(5, 3, 0).model;
  Random random(5);
  std::string text;
  DmsInsertion inserted = internal::draw_insertion(random, model, text).value();
  inserted.model.control.values.back() += Rational(1);  // of the new vertex alone
  DmsEvaluator before(model), after(inserted.model);
  const DmsPoint at = inserted.model.clouds.back()[0];
  EXPECT_NE(before.evaluate(*before.locate(at)).value, after.evaluate(*after.locate(at)).value)
      << text;
}

TEST(DmsInsert, MakesGrevillesPointsOfTheIdentity) {
  int insertions = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    DmsModel model = draw_dms(seed, 5, 0).model;
    set_control_by_rule(model, DmsControlRule::kGreville, {});
    Random random(seed);
    std::string text;
    const auto inserted = internal::draw_insertion(random, model, text);
    if (!inserted) continue;
    DmsModel expected = inserted->model;
    set_control_by_rule(expected, DmsControlRule::kGreville, {});
    EXPECT_EQ(inserted->model, expected) << "seed " << seed << text;
    EXPECT_EQ(inserted->model.tetrahedra.size(), model.tetrahedra.size() + 3);
    ++insertions;
  }
  EXPECT_GE(insertions, 15);
}

TEST(DmsInsert, BlossomsHaveTheControlPointsAndAreSymmetric) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const DmsModel model = draw_dms(seed, 4, 1).model;
    const BPatch<Rational> patch = patch_of_tetrahedron(model, 0);
    const TetrahedronCorners& corners = model.tetrahedra[0];
    for_each_tetrahedral_index(model.degree, [&](const TetrahedralIndex& beta) {
      std::vector<DmsPoint> knots;
      for (std::size_t m = 0; m < 4; ++m)
        for (int i = 0; i < beta[m]; ++i) knots.push_back(model.knot(corners[m], i));
      const auto control = model.value(control_of(model, 0, beta));
      EXPECT_TRUE(std::ranges::equal(patch.blossom(knots), control)) << seed;
      std::ranges::reverse(knots);
      EXPECT_TRUE(std::ranges::equal(patch.blossom(knots), control)) << seed;
    });
  }
}

DmsModel four_tetrahedra(int degree) {
  DmsModel domain = kuhn_domain({1, 1, 1});
  set_control_by_rule(domain, DmsControlRule::kGreville, {});
  return make_dms(domain, {degree, std::nullopt, DmsControlRule::kGreville}).value();
}

TEST(DmsInsert, RefusesPointsOutsideAndAtVertices) {
  const DmsModel model = four_tetrahedra(2);
  const auto message = [&](const DmsPoint& at) {
    const auto out = insert_dms_vertex(model, {at});
    return out ? "" : out.error().message;
  };
  const Rational half = Rational(1) / Rational(2), third = Rational(1) / Rational(3);
  EXPECT_EQ(message({2, 0, 0}), "the point is outside of the domain");
  EXPECT_EQ(message({0, 0, 0}), "the point is at vertex 0");
  EXPECT_EQ(message({half, half, half}), "");
  EXPECT_EQ(message({half, third, 0}), "");
  EXPECT_EQ(message({half, third, third / Rational(2)}), "");
  EXPECT_FALSE(insert_dms_vertex(internal::separated(model), {{half, third, third / Rational(2)}}));
  EXPECT_FALSE(
      insert_dms_vertex(four_tetrahedra(4), DmsCloud(2, {half, third, third / Rational(2)})));
}

TEST(DmsInsert, ListsTheDefectsOfAWideCloud) {
  const DmsModel model = four_tetrahedra(2);
  const DmsPoint at{Rational(1) / Rational(2), Rational(1) / Rational(3),
                    Rational(1) / Rational(6)};
  const auto out = insert_dms_vertex(model, {at, {2, 2, 2}});
  ASSERT_TRUE(out);
  ASSERT_GT(out->defects.count, 0u);
  EXPECT_EQ(out->defects.first[0].fault, DmsFault::kDegenerate);
}

TEST(DmsSurface, HasTheValuesOfTheMapOnTheBoundary) {
  std::uint64_t patches = 0;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    const DmsModel model = draw_dms(seed, 2, 0).model;
    if (model.tetrahedra.size() > 6) continue;  // the tiles of many faces take long
    const TetrahedralComplex complex(model.tetrahedra,
                                     static_cast<std::uint32_t>(model.clouds.size()));
    const auto surface = boundary_patches(model, complex);
    if (std::holds_alternative<DmsOpenFace>(surface)) continue;
    const auto tiles = tile_boundary(model, complex);
    DmsEvaluator evaluator(model);
    std::size_t number = 0;
    for (const auto& of_face : std::get<0>(tiles))
      for (const DmsTile& tile : of_face) {
        const auto& patch = std::get<0>(surface)[number++];
        const std::array<Rational, 3> uvw{Rational(1) / Rational(7), Rational(2) / Rational(7),
                                          Rational(4) / Rational(7)};
        DmsPoint u;
        for (std::size_t m = 0; m < 3; ++m)
          for (std::size_t c = 0; c < 3; ++c) u[c] += uvw[m] * tile.corners[m][c];
        DmsValue value = evaluator.evaluate(*evaluator.locate(u));
        EXPECT_EQ(evaluate(patch, uvw), value.value) << "seed " << seed;
        ++patches;
      }
    EXPECT_EQ(number, std::get<0>(surface).size());
  }
  EXPECT_GT(patches, 20u);
}

}  // namespace
}  // namespace veritope
