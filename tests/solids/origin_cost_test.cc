// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/origin_cost.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "solids/chain/free_form_cell.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

constexpr std::uint64_t kSeed = 20261127;

struct Bounds {
  ExactPoint lo, hi;
  void add(const ExactPoint& p, bool is_first) {
    for (std::size_t k = 0; k < 3; ++k) {
      lo[k] = is_first ? p[k] : std::min(lo[k], p[k]);
      hi[k] = is_first ? p[k] : std::max(hi[k], p[k]);
    }
  }
};

Bounds of_control_points(const Patch& patch) {
  Bounds out;
  for (std::size_t i = 0; i < patch.num_control(); ++i) {
    ExactPoint p;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = patch.component(static_cast<int>(k))[i];
      if (patch.is_rational()) p[k] /= patch.component(3)[i];
    }
    out.add(p, i == 0);
  }
  return out;
}

Rational share(const Bounds& box, const Bounds& model) {
  Rational out(1);
  for (std::size_t k = 0; k < 3; ++k)
    out *= (std::min(box.hi[k], model.hi[k]) - std::max(box.lo[k], model.lo[k])) /
           (model.hi[k] - model.lo[k]);
  return out;
}

// The definition, in rationals.
Rational slow_cost(const PatchComplex& complex, const ExactPoint& origin) {
  Bounds model;
  for (std::size_t i = 0; i < complex.patches().size(); ++i) {
    const Bounds box = of_control_points(complex.patches()[i]);
    model.add(box.lo, i == 0);
    model.add(box.hi, false);
  }
  Rational out;
  for (const Patch& patch : complex.patches()) {
    if (!patch.is_flat_triangle()) out += share(of_control_points(patch), model);
    for (const BaseTriangle& base : base_triangles(patch)) {
      Bounds box;
      box.add(origin, true);
      for (const PatchPoint& p : base) box.add(p, false);
      out += share(box, model);
    }
  }
  return out;
}

// PROVES CHAIN-7
TEST(OriginCosts, AreTheDefinitionWithinTheirErrors) {
  Random random(kSeed);
  for (const Patches& patches :
       {patch_shapes::plate(1), patch_shapes::pn_torus(12, 8), unit_box()}) {
    const PatchComplex complex = complex_of(patches);
    const OriginCosts costs(complex);
    for (int i = 0; i < 20; ++i) {
      ExactPoint origin;
      for (Rational& x : origin) x = Rational::from_double(random.unit() * 6 - 3);
      const CellTests tests = costs.at(origin);
      const Rational exact = slow_cost(complex, origin);
      EXPECT_LT(abs(Rational::from_double(tests.value) - exact), Rational::from_double(tests.error))
          << "seed " << kSeed;
      EXPECT_LT(tests.error, 1e-12 * tests.value);
    }
  }
}

// An oracle of another kind: count the boxes that hold random points.
TEST(OriginCosts, AreTheMeanNumbersOfBoxesAroundRandomPoints) {
  Random random(kSeed);
  const PatchComplex complex = complex_of(patch_shapes::pn_torus(12, 8));
  const OriginCosts costs(complex);
  const ExactPoint origin{2, 1, 0};
  std::vector<Bounds> boxes;
  for (const Patch& patch : complex.patches()) {
    boxes.push_back(of_control_points(patch));
    Bounds box;
    box.add(origin, true);
    const BaseTriangle base = base_triangles(patch)[0];
    for (const PatchPoint& p : base) box.add(p, false);
    boxes.push_back(box);
  }
  const int kPoints = 2000;
  std::uint64_t hits = 0;
  for (int i = 0; i < kPoints; ++i) {
    ExactPoint q;
    for (std::size_t k = 0; k < 3; ++k)
      q[k] = Rational::from_double(costs.box().lo[k] +
                                   random.unit() * (costs.box().hi[k] - costs.box().lo[k]));
    for (const Bounds& b : boxes) {
      bool is_inside = true;
      for (std::size_t k = 0; k < 3 && is_inside; ++k)
        is_inside = b.lo[k] <= q[k] && q[k] <= b.hi[k];
      hits += is_inside ? 1 : 0;
    }
  }
  const double mean = static_cast<double>(hits) / kPoints;
  EXPECT_NEAR(mean, costs.at(origin).value, 0.05 * mean) << "seed " << kSeed;
}

// PROVES CHAIN-7
TEST(OriginCosts, TheBestCandidateIsNoWorseThanAnyOriginOnAGrid) {
  for (const Patches& patches :
       {patch_shapes::plate(1), patch_shapes::pn_torus(12, 8), patch_shapes::octant_sphere(),
        patch_shapes::placed(patch_shapes::frustum(1, 1, 3), 1, {100, 0, 0})}) {
    const OriginCosts costs(complex_of(patches));
    const OriginCost best = costs.best();
    for (int i = 0; i <= 10; ++i)
      for (int j = 0; j <= 10; ++j)
        for (int k = 0; k <= 10; ++k) {
          ExactPoint p;
          const std::array<int, 3> at{i, j, k};
          for (std::size_t c = 0; c < 3; ++c)
            p[c] = Rational::from_double(costs.box().lo[c] +
                                         at[c] / 10.0 * (costs.box().hi[c] - costs.box().lo[c]));
          EXPECT_LE(best.tests.value, costs.at(p).value * 1.02);
        }
  }
}

TEST(OriginCosts, OfVeryLargeAndVerySmallModels) {
  for (const int bits : {1023, -1072}) {
    const Rational size = Rational::power_of_two(bits);
    const PatchComplex complex = complex_of(
        patch_shapes::box({-size, -size, -size}, {size, size, size + size / Rational(2)}));
    const OriginCosts costs(complex);
    const ExactPoint origin{size / Rational(4), size / Rational(4), -size / Rational(2)};
    const CellTests tests = costs.at(origin);
    EXPECT_LE(abs(Rational::from_double(tests.value) - slow_cost(complex, origin)),
              Rational::from_double(tests.error))
        << bits;
    EXPECT_LE(costs.best().tests.value, tests.value);
  }
}

// PROVES CHAIN-7
TEST(OriginCosts, OutsideOfTheBoxAnOriginCostsWhatTheNearestPointOfTheBoxCosts) {
  const OriginCosts costs(complex_of(unit_box()));
  EXPECT_EQ(costs.at({5, Rational(1) / Rational(2), -3}).value,
            costs.at({1, Rational(1) / Rational(2), 0}).value);
  EXPECT_EQ(costs.at({5, 5, 5}).value, costs.at({1, 1, 1}).value);
}

// The boxes of the bases of a face are the face. Over both bases of two opposite faces an origin in the cube has boxes
// of the volumes d, d, 1 - d and 1 - d.
TEST(OriginCosts, OfACubeAreSixEverywhere) {
  const OriginCosts costs(complex_of(unit_box()));
  for (const Rational& x : {Rational(0), Rational(1) / Rational(3), Rational(1)})
    EXPECT_DOUBLE_EQ(costs.at({x, Rational(1) / Rational(7), x}).value, 6);
}

}  // namespace
}  // namespace veritope
