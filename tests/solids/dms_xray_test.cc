// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_xray_test.cc: sums along rays in doubles beside exact integrals, and changes of coefficients beside
// sums that are computed anew.
#include "solids/dms/dms_xray.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/predicates/test_scale.h"
#include "tests/support/dms_laws.h"
#include "tests/support/dms_rays.h"

namespace veritope {
namespace {

TEST(DmsXray, BoundsContainTheExactIntegrals) {
  DmsRayCounts counts;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(10)); ++seed)
    ASSERT_EQ(check_dms_rays(seed, 2, 8, counts), "");
  EXPECT_LT(counts.exact, counts.computed / 2);  // most rays are decided in doubles
  EXPECT_GT(counts.exact, 0u);                   // those along planes of knots are not
  EXPECT_LE(counts.worst, 1e-5);
}

// A quadratic box, seen along a direction without symmetry.
struct Scene {
  DmsModel model;
  DmsRayGrid grid;
};
Scene box_scene() {
  Scene out;
  DmsModel domain = kuhn_domain({2, 2, 1});
  domain.attributes = {"density"};
  std::vector<Rational> values;
  for (std::size_t v = 0; v < domain.clouds.size(); ++v) values.emplace_back(v % 5);
  set_control_by_rule(domain, DmsControlRule::kGreville, values);
  const Result<DmsModel> made =
      make_dms(domain, {2, DmsCloudDraw{Rational(1) / Rational(10), 5}, DmsControlRule::kGreville});
  EXPECT_TRUE(made.has_value());
  out.model = *made;
  out.grid = {16, 12, {-1, -0.5, 2}, {0.25, 0.01, 0.003}, {0.02, 0.25, 0.007}, {0.3, 0.21, -4}};
  return out;
}

TEST(DmsXray, RaysThatMissTheDomainHaveNoWeights) {
  Scene scene = box_scene();
  scene.grid.origin = {50, 0, 0};
  const DmsRayWeights rays(scene.model, scene.grid);
  const DmsRayRow row = rays.row(3);
  EXPECT_TRUE(row.control.empty());
  EXPECT_EQ(row.first, std::vector<std::size_t>(17, 0));
  EXPECT_EQ(row.error, std::vector<double>(16, 0.0));
}

TEST(DmsXray, SharesAreTheLengthsInTheDomain) {
  const Scene scene = box_scene();
  const DmsRayWeights rays(scene.model, scene.grid);
  const auto sums = ray_sums(rays, DmsCoefficients(scene.model, 3), 2);
  DmsEvaluator evaluator(scene.model);
  const DmsLineIntegrator integrator(evaluator);
  int inside = 0;
  for (std::size_t j = 0; j < 12; j += 3)
    for (std::size_t i = 0; i < 16; i += 3) {
      Rational length;
      for (const DmsStretch& s : integrator.stretches(scene.grid.ray(i, j)))
        length += s.end - s.begin;
      EXPECT_NEAR(sums[j * 16 + i].share, nearest_double(length), 1e-9);
      inside += length.sign() == Sign::kPositive ? 1 : 0;
    }
  EXPECT_GT(inside, 3);
}

TEST(DmsXray, DoesNotDependOnTheNumberOfThreads) {
  const Scene scene = box_scene();
  const DmsRayWeights rays(scene.model, scene.grid);
  const DmsCoefficients coefficients(scene.model, 3);
  const auto one = ray_sums(rays, coefficients, 1), two = ray_sums(rays, coefficients, 2);
  const DmsXray kept(rays, coefficients, 2);
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].mean, two[k].mean);
    EXPECT_EQ(one[k].bound, two[k].bound);
    EXPECT_EQ(one[k].mean, kept.mean(k));
  }
}

// [HHQ04] eq. 12: afterwards all bits are those of a full computation, and rays that are not named have not changed.
TEST(DmsXray, AChangedCoefficientGivesTheBitsOfAFullComputation) {
  Scene scene = box_scene();
  const DmsRayWeights rays(scene.model, scene.grid);
  DmsXray xray(rays, DmsCoefficients(scene.model, 3), 1);
  Random random(2);
  for (int round = 0; round < 6; ++round) {
    const std::size_t control = random.below(scene.model.num_control());
    const Rational value = Rational(random.between(-40, 40)) / Rational(random.between(1, 7));
    std::vector<double> before;
    for (std::size_t k = 0; k < xray.num_rays(); ++k) before.push_back(xray.mean(k));
    const std::vector<std::size_t> changed = xray.change(control, value);
    scene.model.control.values[control * 4 + 3] = value;
    const DmsRayWeights anew(scene.model, scene.grid);
    const auto sums = ray_sums(anew, DmsCoefficients(scene.model, 3), 1);
    for (std::size_t k = 0; k < sums.size(); ++k) {
      ASSERT_EQ(xray.mean(k), sums[k].mean) << "round " << round << ", ray " << k;
      EXPECT_LE(sums[k].bound, xray.sum(k).bound);
      if (!std::binary_search(changed.begin(), changed.end(), k)) {
        EXPECT_EQ(before[k], xray.mean(k));
      }
    }
  }
}

TEST(DmsXray, ChecksItsArguments) {
  const Scene scene = box_scene();
  DmsRayGrid flat = scene.grid;
  flat.along = flat.right;
  EXPECT_FALSE(flat.is_sound());
  EXPECT_THROW(DmsRayWeights(scene.model, flat), InternalError);
  flat.along = {NAN, 0, 0};
  EXPECT_FALSE(flat.is_sound());
  EXPECT_THROW(DmsCoefficients(scene.model, 4), InternalError);
  const DmsRayWeights rays(scene.model, scene.grid);
  EXPECT_THROW(rays.row(12), InternalError);
}

}  // namespace
}  // namespace veritope
