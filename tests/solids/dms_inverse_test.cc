// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_inverse_test.cc: preimages of exact images are the points they came from; points beside the solid
// have none.
#include "solids/dms/fast/dms_inverse.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solids/dms/dms_evaluator.h"
#include "solids/dms/fast/dms_inverse_internal.h"
#include "tests/support/dms_truth.h"

namespace veritope {
namespace {

using dms_truth::drawn_box;
using dms_truth::ratio;
using dms_truth::warp_control;

// A box of cubes that is bent and sheared, with an attribute whose coefficients are drawn. The map is one to one: its
// derivative differs from the identity by less than 1/2 in each norm.
DmsModel bent_box(std::uint64_t seed, int degree, bool has_clouds,
                  const std::array<int, 3>& size = {2, 1, 1}) {
  Random random(seed);
  DmsModel model = drawn_box(random, size, degree, has_clouds);
  warp_control(model, [](const DmsPoint& p) {
    return DmsPoint{p[0] + p[1] * p[1] / Rational(8),
                    p[1] - p[0] * p[0] / Rational(16) + p[2] / Rational(8),
                    p[2] + p[0] * p[1] / Rational(16)};
  });
  const std::vector<Rational> old = model.control.values;
  model.attributes = {"a"};
  model.control.values.clear();
  for (std::size_t i = 0; i < old.size(); ++i) {
    model.control.values.push_back(old[i]);
    if (i % 3 == 2) model.control.values.push_back(Rational(random.between(-9, 9)));
  }
  return model;
}

DmsPoint drawn_point(Random& random) {
  return {ratio(random.between(1, 1999), 1000), ratio(random.between(1, 999), 1000),
          ratio(random.between(1, 999), 1000)};
}
Point3d rounded(const DmsPoint& p) {
  return {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
}

TEST(InverseMonomials, AreThoseOfThePolynomial) {
  // x y^2 + 3 z - 2 of degree 3: the Bernstein coefficients are its blossom.
  std::vector<double> coefficients;
  for_each_tetrahedral_index(3, [&](const TetrahedralIndex& i) {
    const double xyy = i[1] == 1 && i[2] == 2 ? 1.0 / 3 : 0;
    coefficients.push_back(xyy + 3 * (i[3] / 3.0) - 2);
  });
  const std::vector<double> monomials = internal::monomials_of(3, coefficients);
  for_each_tetrahedral_index(3, [&](const TetrahedralIndex& i) {
    const bool is_xyy = i[1] == 1 && i[2] == 2, is_z = i[3] == 1 && i[0] == 2, is_one = i[0] == 3;
    EXPECT_NEAR(monomials[tetrahedral_index(i)], is_xyy ? 1 : is_z ? 3 : is_one ? -2 : 0, 1e-14);
  });
}

TEST(DmsInverse, FindsThePointsThatImagesCameFrom) {
  for (int degree = 1; degree <= 3; ++degree)
    for (const bool has_clouds : {false, true}) {
      if (degree == 3 && has_clouds) continue;  // thousands of cells
      const DmsModel model = bent_box(5, degree, has_clouds);
      DmsInverseOptions options;
      options.component = 3;
      const auto inverse = DmsInverse::make(model, options);
      ASSERT_TRUE(inverse);
      DmsEvaluator evaluator(model);
      Random random(17);
      for (int i = 0; i < 200; ++i) {
        const DmsPoint u = drawn_point(random);
        const auto place = evaluator.locate(u);
        ASSERT_TRUE(place.has_value());
        const DmsValue value = evaluator.evaluate(*place);
        const auto found = inverse->find(rounded({value.value[0], value.value[1], value.value[2]}));
        ASSERT_TRUE(found.has_value()) << "degree " << degree << ", point " << i;
        const Point3d at = inverse->domain_point(*found), truth = rounded(u);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(at[c], truth[c], 1e-8);
        EXPECT_NEAR(inverse->value(*found), nearest_double(value.value[3]), 1e-6);
      }
    }
}

TEST(DmsInverse, FindsNothingBesideTheSolid) {
  const DmsModel model = bent_box(6, 2, true);
  const auto inverse = DmsInverse::make(model, {});
  ASSERT_TRUE(inverse);
  DmsEvaluator evaluator(model);
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    // A point of a side of the box, and the image of its normal by the cofactors.
    DmsPoint u = drawn_point(random);
    const std::size_t axis = random.below(3);
    const bool is_far = random.below(2) == 1;
    u[axis] = is_far ? Rational(axis == 0 ? 2 : 1) : Rational();
    const auto place = evaluator.locate(u);
    ASSERT_TRUE(place.has_value());
    const DmsValue value = evaluator.evaluate(*place);
    std::array<Point3d, 3> rows;
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) rows[r][c] = nearest_double(value.gradient[r][c]);
    Point3d normal{};
    for (std::size_t r = 0; r < 3; ++r) {
      const Point3d &a = rows[(r + 1) % 3], &b = rows[(r + 2) % 3];
      const std::size_t s = (axis + 1) % 3, t = (axis + 2) % 3;
      normal[r] = a[s] * b[t] - a[t] * b[s];
    }
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    for (const double step : {1e-6, 1e-3, 0.1})
      for (const int side : {-1, 1}) {
        Point3d x = rounded({value.value[0], value.value[1], value.value[2]});
        for (std::size_t c = 0; c < 3; ++c) x[c] += side * step * normal[c] / length;
        const bool is_inside = side == (is_far ? -1 : 1);
        if (is_inside && step > 1e-3) continue;  // beyond another side
        if (is_inside && step == 1e-3 && i % 8 != 0) continue;
        EXPECT_EQ(inverse->find(x).has_value(), is_inside) << i << ", step " << step * side;
      }
  }
  EXPECT_FALSE(inverse->find({100, 0, 0}).has_value());
  EXPECT_FALSE(inverse->find({std::nan(""), 0, 0}).has_value());
  EXPECT_FALSE(inverse->find({INFINITY, 0, 0}).has_value());
}

TEST(DmsInverse, DoesNotDependOnScaleOrThreads) {
  const DmsModel model = bent_box(7, 2, true, {1, 1, 1});
  const auto inverse = DmsInverse::make(model, {});
  ASSERT_TRUE(inverse);
  DmsInverseOptions parallel;
  parallel.jobs = 2;
  for (const int exponent : {-400, 400}) {
    DmsModel scaled = model;
    for (std::size_t i = 0; i < scaled.control.values.size(); ++i)
      if (i % 4 != 3) scaled.control.values[i] *= Rational::power_of_two(exponent);
    const auto other = DmsInverse::make(scaled, parallel);
    ASSERT_TRUE(other);
    EXPECT_EQ(other->num_parts(), inverse->num_parts());
    Random random(1);
    int found = 0;
    for (int i = 0; i < 100; ++i) {
      Point3d x;
      for (double& c : x) c = static_cast<double>(random.between(-50, 250)) / 128;
      const auto one = inverse->find(x);
      for (double& c : x) c = std::ldexp(c, exponent);
      const auto two = other->find(x);
      ASSERT_EQ(one.has_value(), two.has_value());
      if (!one) continue;
      ++found;
      EXPECT_EQ(one->leaf, two->leaf);
      EXPECT_EQ(one->at, two->at);
    }
    EXPECT_GT(found, 5);
  }
}

TEST(DmsInverse, FindsPreimagesBesideThinTetrahedra) {
  DmsModel model;
  model.degree = 1;
  model.clouds = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
  const Rational apex = ratio(1, 3) + Rational::power_of_two(-60);
  model.clouds.push_back({{apex, apex, apex}});
  model.tetrahedra = {{0, 1, 2, 3}, {1, 2, 3, 4}};
  set_control_by_rule(model, DmsControlRule::kGreville, {});
  const auto inverse = DmsInverse::make(model, {});
  ASSERT_TRUE(inverse);
  EXPECT_EQ(inverse->num_parts(), 1u);
  EXPECT_TRUE(inverse->find({0.25, 0.25, 0.25}).has_value());
  EXPECT_TRUE(inverse->find({0.25, 0.25, 0.5}).has_value());
  EXPECT_FALSE(inverse->find({0.25, 0.25, 0.5001}).has_value());
}

// Beside the plane x = 0 the derivative is nearly singular: x' = (1 - e) x^2 / 2 + e x.
TEST(DmsInverse, NearlySingularDerivativesTakeFewParts) {
  Random random(2);
  DmsModel model = drawn_box(random, {1, 1, 1}, 2, false);
  const Rational e = Rational::power_of_two(-12);
  // The blossom of the map, at the two knots of each control point.
  dms_truth::set_control_by_knots(model, [&](const std::vector<DmsPoint>& knots) {
    const DmsPoint &a = knots[0], &b = knots[1];
    const Rational half = ratio(1, 2);
    return DmsPoint{(Rational(1) - e) * half * a[0] * b[0] + e * half * (a[0] + b[0]),
                    half * (a[1] + b[1]), half * (a[2] + b[2])};
  });
  const auto inverse = DmsInverse::make(model, {});
  ASSERT_TRUE(inverse);
  EXPECT_LT(inverse->num_parts(), 8000u);
  for (const double x : {0x1p-30, 0x1p-20, 0x1p-10, 0.25, 0.9375}) {
    const double to = nearest_double((Rational(1) - e) * ratio(1, 2) * Rational::from_double(x) *
                                         Rational::from_double(x) +
                                     e * Rational::from_double(x));
    const auto place = inverse->find({to, 0.375, 0.6875});
    ASSERT_TRUE(place.has_value()) << x;
    EXPECT_NEAR(inverse->domain_point(*place)[0], x, 1e-6);
  }
  EXPECT_FALSE(inverse->find({-0.01, 0.375, 0.6875}).has_value());
}

// Clouds that are legal by 2^-40 leave thin cells in which the map is steep; answers there were far off.
TEST(DmsInverse, SteepMapsOfThinCellsGiveNoWrongAnswers) {
  std::size_t answers = 0;
  for (const std::uint64_t seed : {1000139u, 1000159u}) {
    const DmsModel model = dms_truth::clouded(seed, true).model;
    const auto inverse = DmsInverse::make(model, {});
    ASSERT_TRUE(inverse);
    DmsEvaluator evaluator(model);
    const Box3d& box = inverse->box();
    Random random(seed);
    for (int i = 0; i < 400; ++i) {
      Point3d x;
      for (std::size_t c = 0; c < 3; ++c)
        x[c] =
            box.lo[c] + (box.hi[c] - box.lo[c]) * static_cast<double>(random.between(0, 64)) / 64;
      const auto found = inverse->find(x);
      if (!found) continue;
      const Point3d u = inverse->domain_point(*found);
      const auto place = evaluator.locate(
          {Rational::from_double(u[0]), Rational::from_double(u[1]), Rational::from_double(u[2])});
      if (!place) continue;  // beside the boundary by rounding
      ++answers;
      const DmsValue value = evaluator.evaluate(*place);
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(nearest_double(value.value[c]), x[c], 1e-5) << "seed " << seed << ", " << i;
    }
  }
  EXPECT_GT(answers, 20u);
}

TEST(DmsInverse, FarFromTheOriginNothingIsAddedToTheSolid) {
  Random random(2);
  DmsModel model = drawn_box(random, {1, 1, 1}, 2, true);
  const double far = 0x1p40;
  for (std::size_t i = 0; i < model.control.values.size(); ++i)
    model.control.values[i] += Rational::from_double(far);
  const auto inverse = DmsInverse::make(model, {});
  ASSERT_TRUE(inverse);
  for (const double x : {-0x1p-10, 0.5, 1 + 0x1p-10}) {
    const auto place = inverse->find({far + x, far + 0.25, far + 0.625});
    ASSERT_EQ(place.has_value(), x > 0 && x < 1) << x;
    if (place) {
      EXPECT_NEAR(inverse->domain_point(*place)[0], x, 1e-9);
    }
  }
}

TEST(DmsInverse, IsRefusedForTooManyParts) {
  const DmsModel model = bent_box(8, 2, true);
  DmsInverseOptions options;
  options.max_cells = 1;
  EXPECT_EQ(DmsInverse::make(model, options).error().code, Code::kOverLimit);
  options = {};
  options.max_parts = 3;
  const auto few = DmsInverse::make(model, options);
  ASSERT_FALSE(few);
  EXPECT_EQ(few.error().code, Code::kOverLimit);
  EXPECT_TRUE(few.error().place.entity.has_value());
}

}  // namespace
}  // namespace veritope
