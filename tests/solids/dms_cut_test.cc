// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_cut_test.cc: vertices in two or six tetrahedra, beside what must change and what must not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_insert.h"
#include "solids/dms/dms_make.h"
#include "tests/support/random_dms.h"

namespace veritope {
namespace {

bool is_zero(const Rational& x) { return x.sign() == Sign::kZero; }

// Two tetrahedra with the face (0, 0, 0), (1, 0, 0), (0, 1, 0), quadratic.
DmsModel two_tetrahedra(const Rational& height_of_knot) {
  DmsModel model;
  model.degree = 2;
  model.clouds = {
      {{0, 0, 0}, {0, 0, height_of_knot}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{0, 0, -1}}};
  model.tetrahedra = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  set_control_by_rule(model, DmsControlRule::kGreville, {});
  return model;
}

// PROVES DMS-3.S2, DMS-3.S3
TEST(DmsCut, ChangesAFaceWithAKnotOffItsPlaneAlone) {
  const Rational third = Rational(1) / Rational(3);
  const DmsPoint at{third, third, 0};
  for (const Rational& height : {Rational(), Rational(1) / Rational(16)}) {
    DmsModel model = two_tetrahedra(height);
    // x of one control point of the upper tetrahedron alone: now the polynomials differ.
    const std::vector<std::uint32_t> apex{0, 3};
    model.control.values[*find_control(model, apex) * 3] += Rational(1);
    const DmsInsertion inserted = insert_dms_vertex(model, {at}).value();
    ASSERT_EQ(inserted.defects.count, 0u);
    EXPECT_EQ(inserted.cut.simplex, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(inserted.cut.tetrahedra, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(inserted.model.tetrahedra.size(), 6u);
    EXPECT_TRUE(is_zero(inserted.change[1].hi));
    EXPECT_TRUE(is_zero(inserted.change[2].hi));
    EXPECT_EQ(is_zero(inserted.change[0].hi), is_zero(height));
    EXPECT_EQ(is_zero(inserted.change[0].lo), is_zero(height));
    EXPECT_LE(inserted.change[0].hi, Rational(1));
  }
}

// PROVES DMS-3, DMS-3.S1
TEST(DmsCut, InsideOfATetrahedronNothingChanges) {
  DmsModel model = two_tetrahedra(Rational(1) / Rational(16));
  model.control.values[4] += Rational(1);
  const Rational fifth = Rational(1) / Rational(5);
  const DmsInsertion inserted = insert_dms_vertex(model, {{fifth, fifth, fifth}}).value();
  ASSERT_EQ(inserted.defects.count, 0u);
  EXPECT_EQ(inserted.cut.simplex.size(), 4u);
  for (const DmsChange& change : inserted.change) EXPECT_TRUE(is_zero(change.hi));
  DmsEvaluator before(model), after(inserted.model);
  for (const int n : {3, 5, 6, 7, 11}) {
    const Rational part = Rational(1) / Rational(n);
    for (const DmsPoint& u : {DmsPoint{part, part, part}, DmsPoint{part, part / Rational(2), 0},
                              DmsPoint{part, part, -part}}) {
      const auto place = before.locate(u);
      ASSERT_TRUE(place);
      const DmsValue old_value = before.evaluate(*place);
      const DmsValue new_value = after.evaluate({after.locate(u)->tetrahedron, place->path});
      EXPECT_EQ(old_value.value, new_value.value);
      EXPECT_EQ(old_value.gradient, new_value.gradient);
    }
  }
}

TEST(DmsCut, AnotherControlPointRaisesTheBoundOfItsComponentAlone) {
  DmsModel model = two_tetrahedra(Rational());
  DmsInsertion inserted = insert_dms_vertex(model, {{Rational(1) / Rational(2), 0, 0}}).value();
  ASSERT_EQ(inserted.cut.simplex, (std::vector<std::uint32_t>{0, 1}));
  const std::vector<std::uint32_t> at{5, 5};
  inserted.model.control.values[*find_control(inserted.model, at) * 3 + 1] += Rational(1);
  const auto change = bound_dms_change(model, inserted.model, inserted.cut);
  EXPECT_TRUE(is_zero(change[0].hi));
  EXPECT_GT(change[1].lo, Rational(1) / Rational(4));
  EXPECT_GE(change[1].hi, change[1].lo);
  EXPECT_LE(change[1].hi, Rational(1));
}

// PROVES DMS-3.S3
TEST(DmsCut, AnEdgeKeepsTheNumbersOfOtherTetrahedra) {
  DmsModel model = kuhn_domain({1, 1, 1});
  set_control_by_rule(model, DmsControlRule::kGreville, {});
  const Rational half = Rational(1) / Rational(2);
  const DmsInsertion inserted = insert_dms_vertex(model, {{half, half, half}}).value();
  EXPECT_EQ(inserted.cut.tetrahedra.size(), 6u);
  EXPECT_EQ(inserted.model.tetrahedra.size(), 12u);
  for (std::size_t t = 0; t < 6; ++t) {
    const auto& part = inserted.model.tetrahedra[t];
    EXPECT_EQ(std::count(part.begin(), part.end(), 8u), 1) << t;
  }
  EXPECT_EQ(inserted.model.control.values.size(), 9u * 3);
  EXPECT_FALSE(insert_dms_vertex(model, {{1, 1, 1}}));
}

}  // namespace
}  // namespace veritope
