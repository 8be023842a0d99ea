// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/auto_domain_test.cc: domains of dense data contain the data and have the topology of the object; what is
// chosen for them, and where gradients add vertices.
#include "solids/dms/domain/auto_domain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "robust/base/random.h"
#include "solids/dms/dms_defects.h"
#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_identity.h"
#include "solids/dms/domain/domain_samples.h"
#include "solids/dms/domain/gradient_splits.h"
#include "solids/dms/domain/tetrahedra_cover.h"
#include "solids/tetrahedra/delaunay.h"
#include "topology/tetrahedral_complex.h"

namespace veritope {
namespace {

// Points of a grid in an object, moved at random by so many distances.
template <typename IsIn>
std::vector<ExactPoint3> scan(double distance, double noise, std::uint64_t seed, IsIn is_in) {
  Random random(seed);
  const int most = static_cast<int>(2 / distance) + 1;
  std::vector<ExactPoint3> out;
  for (int i = -most; i <= most; ++i)
    for (int j = -most; j <= most; ++j)
      for (int k = -most; k <= most; ++k) {
        const auto moved = [&](int n) {
          const double unit = static_cast<double>(random.below(2001)) / 1000 - 1;
          return (n + noise * unit) * distance;
        };
        if (is_in(i * distance, j * distance, k * distance))
          out.emplace_back(Vec3d{moved(i), moved(j), moved(k)});
      }
  return out;
}
bool is_in_cube(double x, double y, double z) {
  return std::max({std::abs(x), std::abs(y), std::abs(z)}) <= 1;
}
bool is_in_ring(double x, double y, double z) {
  const double r = std::hypot(x, y) - 1.2;
  return r * r + z * z <= 0.36;
}

AutoDomain made(const std::vector<ExactPoint3>& points, const AutoDomainOptions& options = {}) {
  Result<AutoDomain> out = auto_domain(points, options);
  if (!out) throw std::runtime_error(to_string(out.error()));
  return std::move(*out);
}

// By rule H.
std::size_t count_outside(const DmsModel& domain, const std::vector<ExactPoint3>& points) {
  const DmsEvaluator evaluator(domain);
  return static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(),
                    [&](const ExactPoint3& p) { return !evaluator.locate(p.at()); }));
}

TEST(AutoDomain, OfAGridInACubeIsTheCubeWithEightVertices) {
  const auto points = scan(0.25, 0, 1, is_in_cube);
  const AutoDomain domain = made(points);
  EXPECT_STREQ(auto_domain_name(domain.kind), "hull");
  EXPECT_EQ(domain.samples, 8u);
  EXPECT_EQ(domain.spacing, 0.25);
  EXPECT_EQ(count_outside(domain.model, points), 0u);
  EXPECT_EQ(find_dms_defects(domain.model).count, 0u);
}

TEST(AutoDomain, OfNoisyConvexDataIsTheirHull) {
  const auto points = scan(0.25, 0.3, 2, is_in_cube);
  const AutoDomain domain = made(points);
  EXPECT_EQ(domain.kind, AutoDomainKind::kHull);
  EXPECT_EQ(count_outside(domain.model, points), 0u);
  EXPECT_LT(domain.samples, points.size() / 4);
}

TEST(AutoDomain, OfARingHasATunnelAndReportsExactlyWhatItDoesNotContain) {
  const auto points = scan(0.2, 0.1, 3, is_in_ring);
  const AutoDomain domain = made(points);
  EXPECT_STREQ(auto_domain_name(domain.kind), "occupancy");
  EXPECT_EQ(domain.outside, count_outside(domain.model, points));
  EXPECT_EQ(domain.outside, 0u);
  EXPECT_LT(domain.samples, points.size() * 2 / 3);
  EXPECT_EQ(find_dms_defects(domain.model).count, 0u);
  const TetrahedralComplex complex(domain.model.tetrahedra,
                                   static_cast<std::uint32_t>(domain.model.clouds.size()));
  EXPECT_EQ(complex.euler(), 0);
  AutoDomainOptions one;
  one.max_rounds = 1;
  const AutoDomain coarse = made(points, one);
  EXPECT_EQ(coarse.outside, count_outside(coarse.model, points));
  EXPECT_GT(coarse.outside, 0u);
}

TEST(AutoDomain, RefusesDataWithoutVolume) {
  std::vector<ExactPoint3> flat;
  for (int i = 0; i < 9; ++i) flat.emplace_back(Vec3d{double(i % 3), double(i / 3), 0});
  EXPECT_EQ(auto_domain(flat, {}).error().code, Code::kBadArgument);
}

TEST(TetrahedraCover, FindsClosedTetrahedraExactly) {
  const std::vector<ExactPoint3> points{ExactPoint3(Vec3d{0, 0, 0}), ExactPoint3(Vec3d{1, 0, 0}),
                                        ExactPoint3(Vec3d{0, 1, 0}), ExactPoint3(Vec3d{0, 0, 1})};
  const TetrahedraCover cover(points, {{0, 1, 2, 3}});
  const Rational third(Integer(1), Integer(3)), tiny = Rational::power_of_two(-300);
  EXPECT_TRUE(cover.contains(ExactPoint3({third, third, third})));
  EXPECT_FALSE(cover.contains(ExactPoint3({third, third, third + tiny})));
  EXPECT_FALSE(cover.contains(ExactPoint3({third, third, Rational(0) - tiny})));
}

TEST(DomainSamples, OfALineAreMoreWhereItIsCurvedMore) {
  std::vector<Vec3d> points;
  std::vector<std::uint32_t> line;
  for (int i = 0; i <= 100; ++i) points.push_back({i / 100.0, 0, 0});
  for (int i = 1; i <= 100; ++i) {
    const double a = i * 0.0157;
    points.push_back({1 + 0.2 * std::sin(a), 0.2 * (1 - std::cos(a)), 0});
  }
  for (std::uint32_t i = 0; i < points.size(); ++i) line.push_back(i);
  const auto samples = sample_feature_line(points, line, 0.002, 10);
  EXPECT_EQ(samples.front(), 0u);
  EXPECT_EQ(samples.back(), 200u);
  const auto straight =
      std::count_if(samples.begin(), samples.end(), [](std::uint32_t v) { return v < 95; });
  EXPECT_EQ(straight, 1);
  EXPECT_GE(samples.size(), 5u);
  EXPECT_LE(samples.size(), 14u);
  EXPECT_GE(sample_feature_line(points, line, 1, 0.1).size(), 12u);
  EXPECT_EQ(sample_feature_line(points, line, 1, 10), (std::vector<std::uint32_t>{0, 200}));
}

TEST(DomainSamples, OfASurfaceKeepTheirDistances) {
  std::vector<Vec3d> points;
  std::vector<std::uint32_t> all;
  std::vector<double> curvature;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j) {
      all.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back({double(i), double(j), 0});
      curvature.push_back(i < 10 ? 0 : 1);
    }
  const auto samples = sample_surface(points, curvature, all, {}, {1.5, 5, 2});
  std::size_t flat = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    flat += samples[i] < 200;
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GE(std::hypot(points[samples[i]].x - points[samples[j]].x,
                           points[samples[i]].y - points[samples[j]].y),
                2 - 1e-12);
  }
  EXPECT_LT(4 * flat, samples.size());
  EXPECT_TRUE(sample_surface(points, curvature, all, all, {1.5, 5, 2}).empty());
}

TEST(DomainSamples, OfTheInsideFollowTheDensity) {
  Random random(4);
  std::vector<Vec3d> points;
  std::vector<std::uint32_t> all;
  for (int i = 0; i < 4000; ++i) {
    const auto unit = [&] { return static_cast<double>(random.below(1 << 20)) / (1 << 20); };
    const double x = i % 4 == 0 ? unit() + 1 : unit();  // three quarters on the left
    points.push_back({x, unit(), unit()});
    all.push_back(static_cast<std::uint32_t>(i));
  }
  const auto samples = sample_interior(points, all, 200);
  EXPECT_EQ(samples.size(), 200u);
  const auto left = std::count_if(samples.begin(), samples.end(),
                                  [&](std::uint32_t v) { return points[v].x < 1; });
  EXPECT_NEAR(static_cast<double>(left), 150, 12);
  EXPECT_EQ(sample_interior(points, all, 10'000).size(), all.size());
  EXPECT_TRUE(sample_interior(points, {}, 5).empty());
}

struct Field {
  std::vector<ExactPoint3> points;
  std::vector<std::array<double, 3>> gradients;
  DmsModel domain;
};
template <typename Value>
Field field_in_cube(Value value) {
  Field out;
  out.points = scan(0.2, 0.2, 5, is_in_cube);
  const AutoDomain domain = made(out.points);
  std::vector<double> values;
  for (const ExactPoint3& p : out.points) values.push_back(value(p.rounded()));
  out.gradients = approx_gradients(out.points, domain.data_tetrahedra, values);
  out.domain = domain.model;
  return out;
}

TEST(GradientSplits, LinearValuesHaveOneGradientAndAddNothing) {
  const Field field =
      field_in_cube([](const Vec3d& p) { return 3 * p.x - 2 * p.y + 0.5 * p.z + 7; });
  for (const auto& g : field.gradients) {
    EXPECT_NEAR(g[0], 3, 1e-9);
    EXPECT_NEAR(g[1], -2, 1e-9);
    EXPECT_NEAR(g[2], 0.5, 1e-9);
  }
}

TEST(GradientSplits, AddVerticesWhereGradientsDiffer) {
  const Field field = field_in_cube([](const Vec3d& p) { return std::tanh(12 * (p.x + 0.5)); });
  const Result<GradientSplits> split =
      split_by_gradients(field.domain, field.points, field.gradients, 0.25, 40, 100'000);
  ASSERT_TRUE(split);
  EXPECT_GT(split->inserted, 5u);
  EXPECT_EQ(split->model.clouds.size(), field.domain.clouds.size() + split->inserted);
  EXPECT_EQ(find_dms_defects(split->model).count, 0u);
  EXPECT_EQ(count_outside(split->model, field.points), 0u);
  std::size_t near = 0;
  for (std::size_t v = field.domain.clouds.size(); v < split->model.clouds.size(); ++v)
    near += std::abs(nearest_double(split->model.clouds[v][0][0]) + 0.5) < 0.4;
  EXPECT_GT(2 * near, split->inserted);
  const auto none =
      split_by_gradients(field.domain, field.points, field.gradients, 0.25, 0, 100'000);
  EXPECT_EQ(none->model.tetrahedra.size(), field.domain.tetrahedra.size());
  const std::size_t budget = field.domain.tetrahedra.size() + 20;
  const auto few =
      split_by_gradients(field.domain, field.points, field.gradients, 0.25, 40, budget);
  EXPECT_LE(few->model.tetrahedra.size(), budget);
}

}  // namespace
}  // namespace veritope
