// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fast/overlap_search.h"

#include <gtest/gtest.h>

#include "solids/dms/dms_covering.h"
#include "solids/dms/dms_make.h"
#include "tests/support/random_dms.h"

namespace veritope {
namespace {

Rational ratio(long p, long q) { return Rational(p) / Rational(q); }

// Two cubes of six tetrahedra, the second one three units along x from the first.
DmsModel two_cubes(int degree, const Rational& clouds) {
  DmsModel domain = kuhn_domain({1, 1, 1});
  const auto count = static_cast<std::uint32_t>(domain.clouds.size());
  const std::size_t tetrahedra = domain.tetrahedra.size();
  for (std::uint32_t v = 0; v < count; ++v) {
    DmsCloud cloud = domain.clouds[v];
    for (DmsPoint& knot : cloud) knot[0] += Rational(3);
    domain.clouds.push_back(std::move(cloud));
  }
  for (std::size_t t = 0; t < tetrahedra; ++t) {
    auto moved = domain.tetrahedra[t];
    for (std::uint32_t& v : moved) v += count;
    domain.tetrahedra.push_back(moved);
  }
  set_control_by_rule(domain, DmsControlRule::kGreville, {});
  std::optional<DmsCloudDraw> draw;
  if (clouds != Rational(0)) draw = DmsCloudDraw{clouds, 5};
  return make_dms(domain, {degree, draw, DmsControlRule::kGreville}).value();
}
// The image of the second cube, in a third of its size, is moved by `along` from the middle of the first one.
DmsModel with_second_image(DmsModel model, const Rational& along) {
  for (std::size_t i = 0; i < model.num_control(); ++i) {
    const auto p = model.control.values.begin() + static_cast<std::ptrdiff_t>(3 * i);
    if (p[0] < Rational(2)) continue;
    p[0] = (p[0] - Rational(2)) * ratio(1, 3) + along;
    p[1] = (p[1] + Rational(1)) * ratio(1, 3) + p[2] * p[2] / Rational(20);
    p[2] = (p[2] + Rational(1)) * ratio(1, 3);
  }
  return model;
}

// PROVES DMS-2.W13
void expect_overlap(const DmsModel& model, const std::optional<DmsCoveredPlace>& overlap) {
  ASSERT_TRUE(overlap.has_value());
  DmsEvaluator evaluator(model);
  const auto place = evaluator.locate(overlap->at);
  ASSERT_TRUE(place.has_value());
  const auto value = evaluator.evaluate(*place).value;
  EXPECT_FALSE(contains(overlap->corners, overlap->at));
  EXPECT_EQ(six_volumes(overlap->corners).sign(), Sign::kPositive);
  const DmsKnotTable knots(model);
  DmsCovering covering(model, knots, evaluator);
  EXPECT_TRUE(
      covering.covers(overlap->tetrahedron, overlap->corners, {value[0], value[1], value[2]}));
}

TEST(OverlapSearch, FindsABodyInsideOfAnotherOneInEveryDegree) {
  for (const int degree : {1, 2, 3, 4})
    for (const Rational& clouds : {Rational(0), ratio(1, 10)}) {
      if (degree == 1 && clouds != Rational(0)) continue;
      SCOPED_TRACE(degree);
      const DmsModel model = two_cubes(degree, clouds);
      EXPECT_FALSE(find_overlap(with_second_image(model, Rational(2))).has_value());
      const DmsModel inside = with_second_image(model, Rational(0));
      expect_overlap(inside, find_overlap(inside));
    }
}

TEST(OverlapSearch, FindsASecondSheetOfOneBody) {
  // z -> z^2 in the plane, on 2 x 2 x 1 cubes around the axis: every point but the axis has two preimages.
  DmsModel domain = kuhn_domain({2, 2, 1});
  for (DmsCloud& cloud : domain.clouds)
    for (DmsPoint& knot : cloud) knot[0] -= Rational(1), knot[1] -= Rational(1);
  set_control_by_rule(domain, DmsControlRule::kGreville, {});
  DmsModel model = make_dms(domain, {2, std::nullopt, DmsControlRule::kGreville}).value();
  // The blossom of x^2 - y^2 and 2 x y at the two knots of a control point.
  for (std::size_t i = 0; i < model.num_control(); ++i) {
    const std::uint32_t* const at = model.control.at.data() + 2 * i;
    const DmsPoint &p = model.knot(at[0], 0), &q = model.knot(at[1], 0);
    model.control.values[3 * i] = p[0] * q[0] - p[1] * q[1];
    model.control.values[3 * i + 1] = p[0] * q[1] + p[1] * q[0];
  }
  expect_overlap(model, find_overlap(model));
}

TEST(OverlapSearch, EndsAtItsLimits) {
  const DmsModel model = with_second_image(two_cubes(2, ratio(1, 10)), Rational(0));
  OverlapSearchOptions options;
  options.max_points = 0;
  EXPECT_FALSE(find_overlap(model, options).has_value());
  options.max_points = 1 << 12;
  options.max_pairs = 0;
  EXPECT_FALSE(find_overlap(model, options).has_value());
  options.max_pairs = 1 << 12;
  options.max_places = 0;
  EXPECT_FALSE(find_overlap(model, options).has_value());
  options.max_places = 16;
  expect_overlap(model, find_overlap(model, options));
}

TEST(DmsCovering, NeedsThePointInsideOfTheImage) {
  const DmsModel model = two_cubes(2, ratio(1, 10));
  const DmsKnotTable knots(model);
  const DmsEvaluator evaluator(model);
  DmsCovering covering(model, knots, evaluator);
  // The identity: the image of a part is the part itself.
  const auto large = knots.corners(0);
  std::array<DmsPoint, 4> part;
  DmsPoint middle;
  for (const DmsPoint& p : large)
    for (std::size_t c = 0; c < 3; ++c) middle[c] += p[c] * ratio(1, 4);
  for (std::size_t m = 0; m < 4; ++m)
    for (std::size_t c = 0; c < 3; ++c)
      part[m][c] = middle[c] + (large[m][c] - middle[c]) * ratio(1, 1024);
  EXPECT_TRUE(covering.covers(0, part, middle));
  EXPECT_FALSE(covering.covers(0, part, part[0]));
  EXPECT_FALSE(covering.covers(0, part, large[0]));
  EXPECT_FALSE(covering.covers(1, part, middle));   // not in that tetrahedron
  EXPECT_FALSE(covering.covers(0, large, middle));  // cut by triangles of knots
  DmsPoint beside = middle;
  for (std::size_t c = 0; c < 3; ++c)
    beside[c] += (large[0][c] - middle[c]) * ratio(-1, 3) * ratio(1, 1024);
  EXPECT_FALSE(covering.covers(0, part, beside));  // on a face
}

}  // namespace
}  // namespace veritope
