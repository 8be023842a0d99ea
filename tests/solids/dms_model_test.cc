// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_model_test.cc: what a model may hold, the order of its control points, and defects of its domain.
#include "solids/dms/dms_model.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "solids/dms/dms_defects.h"
#include "solids/dms/dms_make.h"
#include "solids/dms/dms_validity.h"
#include "tests/support/dms_laws.h"
#include "tests/support/random_dms.h"

namespace veritope {
namespace {

DmsModel two_tetrahedra(int degree) {
  DmsModel model;
  model.degree = degree;
  model.clouds = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{1, 1, 1}}};
  model.tetrahedra = {{0, 1, 2, 3}, {4, 2, 1, 3}};
  set_control_by_rule(model, DmsControlRule::kGreville, {});
  return model;
}

std::string refusal(const DmsModel& model) {
  const Status status = validate(model);
  return status ? "" : status.error().message;
}

TEST(DmsModel, HasAControlPointForEachMultisetOfVertices) {
  for (int n = 1; n <= 9; ++n) {
    const DmsModel model = two_tetrahedra(n);
    const std::size_t of_face = static_cast<std::size_t>((n + 1) * (n + 2) / 2);
    EXPECT_EQ(model.num_control(), 2 * num_tetrahedral_indices(n) - of_face) << n;
    EXPECT_EQ(refusal(model), "") << n;
    for (std::uint32_t t = 0; t < 2; ++t)
      for_each_tetrahedral_index(n, [&](const TetrahedralIndex& beta) {
        const std::size_t found = control_of(model, t, beta);
        const auto vertices = control_vertices(model.tetrahedra[t], beta);
        EXPECT_TRUE(std::equal(
            vertices.begin(), vertices.end(),
            model.control.at.begin() + static_cast<std::ptrdiff_t>(found * vertices.size())));
      });
    const DmsModel separate = internal::separated(model);
    EXPECT_EQ(refusal(separate), "") << n;
    EXPECT_EQ(control_of(separate, 1, {0, 0, 0, n}), 2 * num_tetrahedral_indices(n) - 1);
  }
  const DmsModel model = two_tetrahedra(2);
  EXPECT_FALSE(find_control(model, std::vector<std::uint32_t>{0, 4}).has_value());
  EXPECT_THROW((void)find_control(model, std::vector<std::uint32_t>{0}), InternalError);
}

TEST(DmsModel, IsRefusedWithTheReason) {
  const DmsModel good = two_tetrahedra(3);
  DmsModel bad = good;
  bad.degree = 0;
  EXPECT_EQ(refusal(bad), "the degree must be from 1 to 9, not 0");
  bad.degree = 10;
  EXPECT_EQ(refusal(bad), "the degree must be from 1 to 9, not 10");
  bad = good, bad.tetrahedra.clear();
  EXPECT_EQ(refusal(bad), "there are 0 tetrahedra");
  bad = good, bad.attributes = {"a", "a"};
  EXPECT_EQ(refusal(bad), "attributes 0 and 1 have the same name");
  bad = good, bad.attributes = {""};
  EXPECT_EQ(refusal(bad), "the name of attribute 0 is empty");
  bad = good, bad.clouds[2].resize(2);
  EXPECT_EQ(refusal(bad), "vertex 2 must have 1, 3 or 4 knots, not 2");
  bad = good, bad.tetrahedra[1][2] = 5;
  EXPECT_EQ(refusal(bad), "tetrahedron 1 has vertex 5 of 5");
  bad = good, bad.tetrahedra[1][2] = 2;
  EXPECT_EQ(refusal(bad), "tetrahedron 1 has vertex 2 twice");
  bad = good, bad.clouds[0][0][1] = Rational::power_of_two(2048);
  EXPECT_EQ(refusal(bad), "numerators and denominators must be below 2^2048");
  bad = good, bad.control.values.pop_back();
  EXPECT_EQ(refusal(bad), "the numbers of keys and values of control points do not agree");
  bad = good, bad.control.at[0] = 7;
  EXPECT_EQ(refusal(bad), "a control point is at vertex 7 of 5");
  bad = good, bad.control.at[0] = 1;
  EXPECT_EQ(refusal(bad), "the vertices of a control point must not decrease, as 1, 0 do");
  bad = good, bad.control.at[2] = 4;
  EXPECT_EQ(refusal(bad), "no tetrahedron has the control point of the vertices [0,0,4]");
  bad = good, bad.control.at[2] = 1;
  EXPECT_EQ(refusal(bad), "there are two control points of the vertices [0,0,1]");
  bad = good;
  bad.control.at.erase(bad.control.at.begin(), bad.control.at.begin() + 3);
  bad.control.values.erase(bad.control.values.begin(), bad.control.values.begin() + 3);
  EXPECT_EQ(refusal(bad), "there is no control point of the vertices [0,0,0]");
  bad = good;
  std::swap_ranges(bad.control.at.begin(), bad.control.at.begin() + 3, bad.control.at.begin() + 3);
  EXPECT_EQ(refusal(bad), "the control points are not in ascending order");
  DmsModel separate = internal::separated(good);
  separate.clouds[1].resize(3);
  EXPECT_EQ(refusal(separate),
            "with separate control points vertex 1 must have 1 or 4 knots, not 3");
  separate = internal::separated(good), separate.control.values.resize(57);
  EXPECT_EQ(refusal(separate), "there is no control point of tetrahedron 0, beta [0,0,0,3]");
}

TEST(DmsModel, TakesControlPointsInAnyOrder) {
  const DmsModel good = two_tetrahedra(4);
  DmsModel bare = good;
  bare.control = {};
  const std::size_t n = good.num_control();
  DmsEntries entries{false, {}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t e = (i * 7 + 5) % n;  // n = 55
    entries.keys.insert(entries.keys.end(),
                        good.control.at.begin() + static_cast<std::ptrdiff_t>(4 * e),
                        good.control.at.begin() + static_cast<std::ptrdiff_t>(4 * e + 4));
    const auto value = good.value(e);
    entries.values.insert(entries.values.end(), value.begin(), value.end());
  }
  ASSERT_TRUE(set_dms_control(bare, entries).has_value());
  EXPECT_EQ(bare, good);
  EXPECT_THROW((void)set_dms_control(bare, entries), InternalError);
  // The later one of two entries with one key is named.
  bare.control = {};
  for (std::size_t i = 0; i < 4; ++i) entries.keys[4 * 7 + i] = entries.keys[4 * 3 + i];
  const Status status = set_dms_control(bare, entries);
  ASSERT_FALSE(status.has_value());
  EXPECT_EQ(status.error().place.entity, 7u);
}

TEST(DmsModel, HasKnotsUpToItsDegree) {
  DmsModel model = two_tetrahedra(2);
  model.clouds[1].push_back({2, 0, 0});
  EXPECT_EQ(model.knot(1, 1), (DmsPoint{2, 0, 0}));
  EXPECT_EQ(model.knot(1, 2), (DmsPoint{1, 0, 0}));
  EXPECT_EQ(model.knot(0, 2), (DmsPoint{0, 0, 0}));
  EXPECT_EQ(model.condition_degree(), 1);
  EXPECT_EQ(internal::separated(model).condition_degree(), 2);
  EXPECT_EQ(to_string(TetrahedralIndex{1, 0, 2, 0}), "(1,0,2,0)");
}

TEST(DmsDefects, AreFoundWithTheirPlace) {
  EXPECT_EQ(find_dms_defects(two_tetrahedra(4)).count, 0u);
  DmsModel model = two_tetrahedra(2);
  std::swap(model.tetrahedra[1][0], model.tetrahedra[1][1]);
  DmsDefects defects = find_dms_defects(model);
  ASSERT_EQ(defects.first.size(), 2u);
  EXPECT_EQ(to_string(defects.first[0]), "tetrahedron 1: d < 0");
  EXPECT_STREQ(fault_name(defects.first[0].fault), "tet-reversed");
  EXPECT_EQ(to_string(defects.first[1]),
            "the vertices 1, 2, 3 are a face of the tetrahedra 0, 1 in one orientation");
  EXPECT_STREQ(fault_name(defects.first[1].fault), "tet-face-overused");
  model = two_tetrahedra(2);
  model.clouds[4][0] = {0, 0, 0};
  model.tetrahedra.push_back({4, 1, 2, 3});
  defects = find_dms_defects(model, 1);  // reversed, and 1, 2, 3 is a face of three
  EXPECT_EQ(defects.count, 2u);
  EXPECT_EQ(defects.first.size(), 1u);
}

// Claim 2 iv in small: a knot that is 2^-40 beyond the plane where d(W) vanishes, on it, and before it.
TEST(DmsDefects, CloudsAreDegenerateFromTheExactPlaneOn) {
  const auto num_degenerate = [](const DmsModel& model) {
    const DmsDefects defects = find_dms_defects(model);
    return std::count_if(defects.first.begin(), defects.first.end(),
                         [](const DmsDefect& d) { return d.fault == DmsFault::kDegenerate; });
  };
  DmsModel model = two_tetrahedra(2);
  const auto count = [&](const Rational& z) {
    model.clouds[3] = {{0, 0, 1}, {0, 0, z}};
    return num_degenerate(model);
  };
  const Rational tiny = Rational::power_of_two(-40);
  EXPECT_EQ(count(tiny), 0);
  EXPECT_EQ(count(0), 1);
  EXPECT_EQ(to_string(find_dms_defects(model).first[0]), "tetrahedron 0, beta (0,0,0,1): d = 0");
  EXPECT_STREQ(fault_name(find_dms_defects(model).first[0].fault), "cloud-degenerate");
  EXPECT_EQ(count(-tiny), 1);
  EXPECT_EQ(to_string(find_dms_defects(model).first[0]), "tetrahedron 0, beta (0,0,0,1): d < 0");
  // Knots of the number n count with separate control points only.
  model = two_tetrahedra(2);
  model.clouds[3] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 0}};
  EXPECT_EQ(find_dms_defects(model).count, 0u);
  EXPECT_EQ(num_degenerate(internal::separated(model)), 1);
}

}  // namespace
}  // namespace veritope
