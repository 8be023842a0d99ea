// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_split_test.cc: vertices on faces and edges: the map stays equal where that is proved, and changes by
// no more than the bounds elsewhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_insert.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/dms_laws.h"
#include "tests/support/random_dms.h"

namespace veritope {
namespace {

bool is_zero(const Rational& x) { return x.sign() == Sign::kZero; }

// A point inside of an edge or a face of a random tetrahedron.
DmsPoint draw_on(Random& random, const DmsModel& model, std::size_t corners) {
  TetrahedronCorners t = model.tetrahedra[random.below(model.tetrahedra.size())];
  for (std::size_t m = 0; m < 3; ++m) std::swap(t[m], t[m + random.below(4 - m)]);
  DmsPoint sum;
  Rational total;
  for (std::size_t m = 0; m < corners; ++m) {
    const Rational weight(random.between(1, 5));
    for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * model.knot(t[m], 0)[c];
    total += weight;
  }
  for (Rational& c : sum) c /= total;
  return sum;
}

bool has_one_knot_each(const DmsModel& model) {
  return std::all_of(model.clouds.begin(), model.clouds.end(),
                     [](const DmsCloud& cloud) { return cloud.size() == 1; });
}

struct Split {
  DmsModel model;
  DmsInsertion inserted;
  std::string text;
};
// A model with a collapsed vertex on an edge or a face; nothing if its knots are not admissible.
std::optional<Split> draw_split(std::uint64_t seed, int max_degree, bool is_collapsed,
                                bool is_identity = false) {
  RandomDms drawn = draw_dms(seed, max_degree, 1);
  if (has_one_knot_each(drawn.model) != is_collapsed) return std::nullopt;
  Random random(seed + 77);
  Split out;
  out.model = std::move(drawn.model);
  if (is_identity) {
    out.model.attributes.clear();
    out.model.control.values.clear();
    out.model.control.at.clear();
    set_control_by_rule(out.model, DmsControlRule::kGreville, {});
  }
  const std::size_t corners = 2 + random.below(2);
  const DmsPoint at = draw_on(random, out.model, corners);
  out.text = drawn.text + ", vertex " + text_of(at);
  auto inserted = insert_dms_vertex(out.model, {at});
  EXPECT_TRUE(inserted) << out.text;
  if (!inserted || inserted->defects.count > 0) return std::nullopt;
  EXPECT_EQ(inserted->cut.simplex.size(), corners) << out.text;
  out.inserted = std::move(*inserted);
  return out;
}

// "" or which component changes by more than its bound.
std::string check_bounds(const Split& split, Random& random, int points) {
  DmsEvaluator before(split.model), after(split.inserted.model);
  for (int i = 0; i < points; ++i) {
    const DmsPoint u = draw_dms_point(random, i % 3 == 0 ? split.model : split.inserted.model);
    const auto from = before.locate(u), to = after.locate(u);
    if (!from || !to) return "the point is not in both domains";
    const DmsValue old_value = before.evaluate(*from);
    const DmsValue new_value = after.evaluate({to->tetrahedron, from->path});
    for (std::size_t c = 0; c < old_value.value.size(); ++c) {
      const Rational& most = split.inserted.change[c].hi;
      if (abs(new_value.value[c] - old_value.value[c]) > most)
        return "component " + std::to_string(c) + " changes by more at " + text_of(u);
      if (is_zero(most) && new_value.gradient[c] != old_value.gradient[c])
        return "the derivative of component " + std::to_string(c) + " changes at " + text_of(u);
    }
  }
  return "";
}

// PROVES DMS-3.S2
TEST(DmsSplit, KeepsTheMapOfCollapsedClouds) {
  long splits = 0, faces = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(60)); ++seed) {
    const auto split = draw_split(seed, 3, true);
    if (!split) continue;
    ASSERT_TRUE(validate(split->inserted.model)) << split->text;
    for (const DmsChange& change : split->inserted.change)
      EXPECT_TRUE(is_zero(change.hi)) << split->text;
    Random random(seed);
    EXPECT_EQ(check_bounds(*split, random, 10), "") << split->text;
    ++splits, faces += split->inserted.cut.simplex.size() == 3 ? 1 : 0;
  }
  EXPECT_GE(splits, scaled(10));
  EXPECT_GE(faces, scaled(3));
  EXPECT_LT(faces, splits);
}

// PROVES DMS-3.S2
TEST(DmsSplit, KeepsTheIdentityOfAnyClouds) {
  long splits = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(40)); ++seed) {
    const auto split = draw_split(seed, 3, false, true);
    if (!split) continue;
    for (const DmsChange& change : split->inserted.change)
      EXPECT_TRUE(is_zero(change.hi)) << split->text;
    Random random(seed);
    EXPECT_EQ(check_bounds(*split, random, 8), "") << split->text;
    ++splits;
  }
  EXPECT_GE(splits, scaled(8));
}

// PROVES DMS-3.S3
TEST(DmsSplit, ChangesByNoMoreThanTheBounds) {
  long changed = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(60)); ++seed) {
    const auto split = draw_split(seed, 3, false);
    if (!split) continue;
    for (const DmsChange& change : split->inserted.change) {
      EXPECT_LE(change.lo, change.hi) << split->text;
      changed += is_zero(change.lo) ? 0 : 1;
    }
    Random random(seed);
    EXPECT_EQ(check_bounds(*split, random, 12), "") << split->text;
  }
  EXPECT_GE(changed, scaled(10));
}

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
TEST(DmsSplit, ChangesAFaceWithAKnotOffItsPlaneAlone) {
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

// PROVES DMS-3.S1
TEST(DmsSplit, InsideOfATetrahedronNothingChanges) {
  DmsModel model = two_tetrahedra(Rational(1) / Rational(16));
  model.control.values[4] += Rational(1);
  const Rational fifth = Rational(1) / Rational(5);
  const DmsInsertion inserted = insert_dms_vertex(model, {{fifth, fifth, fifth}}).value();
  ASSERT_EQ(inserted.defects.count, 0u);
  EXPECT_EQ(inserted.cut.simplex.size(), 4u);
  for (const DmsChange& change : inserted.change) EXPECT_TRUE(is_zero(change.hi));
  Random random(1);
  EXPECT_EQ(check_bounds({model, inserted, ""}, random, 20), "");
}

TEST(DmsSplit, AnotherControlPointRaisesTheBoundOfItsComponentAlone) {
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
TEST(DmsSplit, AnEdgeKeepsTheNumbersOfOtherTetrahedra) {
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
