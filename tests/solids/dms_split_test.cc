// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_split_test.cc: vertices on faces and edges: the map stays equal where that is proved, and changes by
// no more than the bounds elsewhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
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
  std::array<double, 4> sum{}, count{};  // of log2(hi / lo), by degrees
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(60)); ++seed) {
    const auto split = draw_split(seed, 3, false);
    if (!split) continue;
    for (const DmsChange& change : split->inserted.change) {
      EXPECT_LE(change.lo, change.hi) << split->text;
      if (is_zero(change.lo)) continue;
      const auto degree = static_cast<std::size_t>(split->model.degree);
      sum[degree] += std::log2(nearest_double(change.hi / change.lo));
      ++count[degree];
      ++changed;
    }
    Random random(seed);
    EXPECT_EQ(check_bounds(*split, random, 12), "") << split->text;
  }
  EXPECT_GE(changed, scaled(10));
  for (const std::size_t degree : {2, 3})  // seen with --gtest_output=xml:FILE
    RecordProperty("mean_log2_of_hi_by_lo_of_degree_" + std::to_string(degree),
                   std::to_string(sum[degree] / count[degree]));
}

}  // namespace
}  // namespace veritope
