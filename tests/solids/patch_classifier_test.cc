// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/patch_classifier.h"

#include <gtest/gtest.h>

#include <functional>

#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

constexpr std::uint64_t kSeed = 20261127;

Rational ratio(std::int64_t p, std::int64_t q = 1) { return Rational(p) / Rational(q); }

struct Model {
  PatchComplex complex;
  PatchClassifier classifier;

  explicit Model(Patches patches, bool has_shells = true)
      : complex(complex_of(std::move(patches))),
        classifier(PatchClassifier::make(complex, has_shells)) {}
  PointAnswer operator()(const ExactPoint& p) const { return classifier.classify(p); }
  PointAnswer operator()(const Vec3d& p) const { return classifier.classify(p); }
};

// 1 - |p|^2
Sign in_ball(const ExactPoint& p) {
  return (Rational(1) - p[0] * p[0] - p[1] * p[1] - p[2] * p[2]).sign();
}
// (|p|^2 + 8)^2 < 36 (x^2 + y^2): radii 3 and 1.
Sign in_torus(const ExactPoint& p) {
  const Rational xy = p[0] * p[0] + p[1] * p[1], s = xy + p[2] * p[2] + Rational(8);
  return (Rational(36) * xy - s * s).sign();
}

void expect_truth(const PointAnswer& a, Sign truth, const std::string& where) {
  ASSERT_TRUE(a.is_decided) << where;
  EXPECT_EQ(a.is_on(), truth == 0) << where;
  if (!a.is_on()) {
    EXPECT_EQ(a.winding, truth > 0 ? 1 : 0) << where;
  }
}

void expect_truth_at_random(const Model& model, const std::function<Sign(const ExactPoint&)>& truth,
                            double reach, int steps) {
  Random random(kSeed);
  for (int i = 0; i < 600; ++i) {
    ExactPoint p;
    for (Rational& x : p) {
      const double c = (2 * random.unit() - 1) * reach;
      // Every other point has coordinates with common values: axis rays through poles, along seams, on tangent planes.
      x = Rational::from_double(i % 2 == 0 ? c : std::round(c * steps) / steps);
    }
    expect_truth(model(p), truth(p),
                 "seed " + std::to_string(kSeed) + " point " + std::to_string(i));
  }
}

TEST(PatchClassifier, KnowsQuadricsAndTori) {
  expect_truth_at_random(Model(patch_shapes::sphere()), in_ball, 1.25, 4);
  expect_truth_at_random(Model(patch_shapes::octant_sphere()), in_ball, 1.25, 4);
  expect_truth_at_random(Model(patch_shapes::torus(3, 1)), in_torus, 4.25, 2);
  expect_truth_at_random(Model(patch_shapes::one_patch_torus(3, 1)), in_torus, 4.25, 2);
}

// PROVES POINT-5
TEST(PatchClassifier, KnowsBoxesWithTheirSidesEdgesAndCorners) {
  const Model box(unit_box());
  for (int i = 0; i < 125; ++i) {
    const ExactPoint p{ratio(i % 5 - 1, 2), ratio(i / 5 % 5 - 1, 2), ratio(i / 25 - 1, 2)};
    int in = 0, on = 0;
    for (const Rational& x : p) {
      in += x.sign() > 0 && x < Rational(1) ? 1 : 0;
      on += x.sign() == 0 || x == Rational(1) ? 1 : 0;
    }
    const Sign truth = in == 3 ? Sign::kPositive : in + on == 3 ? Sign::kZero : Sign::kNegative;
    expect_truth(box(p), truth, std::to_string(i));
  }
}

TEST(PatchClassifier, NamesRationalParametersThatAreThere) {
  const Patches patches = patch_shapes::octant_sphere();
  const Model model(patches);
  Random random(kSeed);
  for (int i = 0; i < 60; ++i) {
    const Patch& patch = patches[random.below(patches.size())];
    const auto parameter = [&] {
      return i % 3 == 0 ? Rational::from_double(random.unit())
                        : ratio(static_cast<std::int64_t>(random.below(8)), 7);
    };
    const std::array<Rational, 2> uv{parameter(), parameter()};
    const ExactPoint p = *point_of(evaluate(patch.tensor(), uv));
    std::optional<OnPatch> where;
    const PointAnswer a = model.classifier.classify(p, &where);
    ASSERT_TRUE(a.is_on()) << "seed " << kSeed << " point " << i;
    ASSERT_TRUE(where.has_value());
    EXPECT_EQ(where->patch, a.facet);
    const auto& [u, v] = where->parameters.numbers;
    ASSERT_TRUE(u.is_rational() && v.is_rational());
    EXPECT_EQ(
        *point_of(evaluate(patches[where->patch].tensor(), std::array<Rational, 2>{u.lo, v.lo})),
        p);
  }
}

// PROVES POINT-4
TEST(PatchClassifier, ProvesIrrationalParameters) {
  const Model model(bent_graph());
  const auto is_root_of_cubic = [](const AlgebraicNumber& t, const Rational& x) {
    // 2 g(t) = t + 3 t^2 - 2 t^3
    const Rational unit = Rational(1) / Rational(t.polynomial.back());
    return t.polynomial.size() == 4 && Rational(t.polynomial[1]) * unit == ratio(-1, 2) &&
           Rational(t.polynomial[2]) * unit == ratio(-3, 2) &&
           Rational(t.polynomial[0]) * unit == x;
  };
  for (const auto& [x, y] :
       {std::pair(ratio(1, 3), ratio(2, 7)), std::pair(ratio(1, 5), ratio(1, 5)),
        std::pair(ratio(1, 3), ratio(2, 3)), std::pair(ratio(1, 2), ratio(2, 3))}) {
    std::optional<OnPatch> where;
    const ExactPoint p{x, y, Rational(1) + x * y};
    const PointAnswer a = model.classifier.classify(p, &where);
    ASSERT_TRUE(a.is_decided && a.is_on()) << x.to_string() << ' ' << y.to_string();
    ASSERT_EQ(where->patch, 0u);
    const auto& [u, v] = where->parameters.numbers;
    EXPECT_TRUE(u.is_rational() ? x == ratio(1, 2) : is_root_of_cubic(u, x));
    EXPECT_TRUE(is_root_of_cubic(v, y));
    // Its neighbours are on neither side of the surface by accident.
    for (const int bits : {40, 300}) {
      const Rational d = Rational::power_of_two(-bits);
      expect_truth(model({x, y, p[2] - d}), Sign::kPositive, "below");
      expect_truth(model({x, y, p[2] + d}), Sign::kNegative, "above");
    }
  }
  expect_truth(model({0, ratio(1, 3), ratio(1, 2)}), Sign::kZero, "on a wall");
}

TEST(PatchClassifier, DecidesPointsNearTheSurface) {
  const Model ball(patch_shapes::octant_sphere()), cone(patch_shapes::frustum(1, 0, 2));
  for (const int bits : {30, 60, 300, 1000}) {
    const Rational d = Rational::power_of_two(-bits);
    for (const ExactPoint& p :
         {ExactPoint{ratio(1, 3), ratio(2, 3), ratio(2, 3)}, ExactPoint{0, 0, 1},
          ExactPoint{ratio(3, 5), 0, ratio(-4, 5)}, ExactPoint{-1, 0, 0}})
      for (const int side : {-1, 1}) {
        ExactPoint q = p;
        for (Rational& x : q) x *= Rational(1) + Rational(side) * d;
        expect_truth(ball(q), side < 0 ? Sign::kPositive : Sign::kNegative, std::to_string(bits));
      }
    expect_truth(cone({0, 0, Rational(2) - d}), Sign::kPositive, "below the apex");
    expect_truth(cone({0, 0, Rational(2) + d}), Sign::kNegative, "above the apex");
    expect_truth(cone({d, 0, Rational(2) - d}), Sign::kNegative, "beside the apex");
  }
  expect_truth(cone(ExactPoint{0, 0, 2}), Sign::kZero, "the apex");
}

// PROVES POINT-3
// The lens x = 2 + 2 t, |y| <= 2 t (1 - t), extruded along z: the ray from (1, 1/20, 0) away from the origin crosses the
// upper wall twice.
TEST(PatchClassifier, IsNotMisledByTheLens) {
  Patches lens;
  for (const int side : {-1, 1}) {
    Patch::Tensor wall({2, 1}, 3, false);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 2; ++j) {
        wall.component(0)[2 * i + j] = Rational(static_cast<std::int64_t>(2 + i));
        wall.component(1)[2 * i + j] = i == 1 ? Rational(side) : Rational(0);
        wall.component(2)[2 * i + j] = (j == 0) == (side > 0) ? Rational(1) : Rational(-1);
      }
    lens.push_back(make_patch(std::move(wall)).value());
    Patch::Tensor cap({2, 1}, 3, false);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 2; ++j) {
        cap.component(0)[2 * i + j] = Rational(static_cast<std::int64_t>(2 + i));
        cap.component(1)[2 * i + j] =
            i == 1 ? Rational((j == 0) == (side > 0) ? -1 : 1) : Rational(0);
        cap.component(2)[2 * i + j] = Rational(side);
      }
    lens.push_back(make_patch(std::move(cap)).value());
  }
  const Model model(lens);
  EXPECT_EQ(model(Vec3d{1, 0.05, 0}), PointAnswer{});
  EXPECT_EQ(model(Vec3d{3, 0.05, 0}).winding, 1);
  EXPECT_EQ(model(Vec3d{2.001, 0.05, 0}).winding, 0);
}

TEST(PatchClassifier, NamesTheInnermostShell) {
  const Model model(patch_shapes::thin_shell(ratio(1, 4)));
  const std::uint32_t outer = model(Vec3d{0.9, 0, 0}).shell;
  const PointAnswer hole = model(Vec3d{0.1, 0.2, 0.3});
  EXPECT_EQ(model(Vec3d{0.9, 0, 0}).winding, 1);
  EXPECT_EQ(hole.winding, 0);
  EXPECT_NE(hole.shell, outer);
  EXPECT_NE(hole.shell, kNowhere);
  EXPECT_EQ(model(Vec3d{2, 0, 0}).shell, kNowhere);
  EXPECT_EQ(model(Vec3d{1, 0, 0}).shell, outer);
  EXPECT_EQ(model(Vec3d{0.75, 0, 0}).shell, hole.shell);
  const std::vector<std::uint32_t>& depths = model.classifier.depths();
  ASSERT_EQ(depths.size(), 2u);
  EXPECT_EQ(depths[outer], 0u);
  EXPECT_EQ(depths[hole.shell], 1u);
}

TEST(PatchClassifier, KnowsTheValuesOfBoxes) {
  const Model model(patch_shapes::octant_sphere());
  const auto value = [&](double a, double b) {
    return model.classifier.value({{a, a, a}, {b, b, b}});
  };
  EXPECT_EQ(value(-0.5, 0.5), Value3::kOne);
  EXPECT_EQ(value(0.1, 0.1), Value3::kOne);
  EXPECT_EQ(value(0.6, 0.7), Value3::kZero);
  EXPECT_EQ(value(0.5, 0.6), Value3::kMixed);
  EXPECT_EQ(value(-2, 2), Value3::kMixed);
  EXPECT_EQ(value(3, 4), Value3::kZero);
  EXPECT_EQ(model.classifier.value({{0.6, 0, 0.8}, {0.6, 0, 0.9}}), Value3::kMixed);
  EXPECT_EQ(model.classifier.value({{-1, -1, 1}, {1, 1, 2}}), Value3::kMixed);  // touches a pole
  // Boxes whose values are known agree with their points.
  Random random(kSeed);
  int counts[3] = {0, 0, 0};
  for (int i = 0; i < 500; ++i) {
    Box3d box;
    const double size = std::ldexp(random.unit(), -static_cast<int>(random.below(8)));
    for (std::size_t k = 0; k < 3; ++k) {
      box.lo[k] = 2.4 * random.unit() - 1.2;
      box.hi[k] = box.lo[k] + size * random.unit();
    }
    const Value3 v = model.classifier.value(box);
    ++counts[static_cast<int>(v)];
    for (unsigned c = 0; c < 8 && is_constant(v); ++c) {
      ExactPoint p;
      for (std::size_t k = 0; k < 3; ++k)
        p[k] = Rational::from_double((c >> k & 1) != 0 ? box.hi[k] : box.lo[k]);
      EXPECT_EQ(in_ball(p), v == Value3::kOne ? Sign::kPositive : Sign::kNegative)
          << "seed " << kSeed << " box " << i;
    }
  }
  for (const int n : counts) EXPECT_GT(n, 20);
}

// Whether all points of a box are off the unit ball, or in its interior.
Value3 value_of_ball(const Box3d& box) {
  Rational least, most;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational a = Rational::from_double(box.lo[k]), b = Rational::from_double(box.hi[k]),
                   a2 = a * a, b2 = b * b;
    most += a2 < b2 ? b2 : a2;
    if (b < Rational(0) || Rational(0) < a) least += a2 < b2 ? a2 : b2;
  }
  if (most < Rational(1)) return Value3::kOne;
  return Rational(1) < least ? Value3::kZero : Value3::kMixed;
}

// Small boxes at all distances from the surface, most of which cells of the look-up decide; some lie beyond all cells.
TEST(PatchClassifier, ValuesOfBoxesAreExactAndSeldomMixedForNothing) {
  const Model model(patch_shapes::octant_sphere());
  Random random(kSeed + 1);
  int in_vain = 0, counts[3] = {0, 0, 0};
  for (int i = 0; i < 4000; ++i) {
    const double size = std::ldexp(1 + random.unit(), -static_cast<int>(random.below(14)));
    const double far =
        1 + (random.unit() - 0.5) * std::ldexp(4.0, -static_cast<int>(random.below(12)));
    Point3d middle{random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5};
    const double length =
        std::sqrt(middle[0] * middle[0] + middle[1] * middle[1] + middle[2] * middle[2]);
    Box3d box;
    for (std::size_t k = 0; k < 3; ++k) {
      box.lo[k] = middle[k] / length * far - size * random.unit();
      box.hi[k] = middle[k] / length * far + size * random.unit();
    }
    const Value3 want = value_of_ball(box), got = model.classifier.value(box);
    ++counts[static_cast<int>(want)];
    if (got == Value3::kMixed && want != got)
      ++in_vain;
    else
      EXPECT_EQ(got, want) << "seed " << kSeed + 1 << " box " << i;
  }
  for (const int n : counts) EXPECT_GT(n, 400);
  EXPECT_LT(in_vain, 200);
}

TEST(PatchClassifier, CountsSurfacesThatFaceInward) {
  Patches patches = patch_shapes::sphere();
  for (Patch& p : patches) p = reversed(p);
  const Model model(patches, false);
  EXPECT_EQ(model(Vec3d{0.1, 0.2, 0.3}).winding, -1);
  EXPECT_EQ(model(Vec3d{0.1, 0.2, 0.3}).shell, kNowhere);
  EXPECT_EQ(model(Vec3d{2, 2, 2}).winding, 0);
}

TEST(PatchClassifier, AnswersDoNotDependOnThreads) {
  const Model model(patch_shapes::pn_torus(12, 8));
  Random random(kSeed);
  std::vector<Vec3d> points(4000);
  for (Vec3d& p : points) p = {8 * random.unit() - 4, 8 * random.unit() - 4, 2 * random.unit() - 1};
  std::vector<PointAnswer> one(points.size()), three(points.size());
  model.classifier.classify(points, one, 1);
  model.classifier.classify(points, three, 3);
  EXPECT_EQ(one, three);
  std::size_t in = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(one[i], model(points[i]));
    in += one[i].winding == 1 ? 1 : 0;
  }
  EXPECT_GT(in, 500u);
}

// Powers of two change no answer, whatever binary64 can hold; distances from the origin neither.
TEST(PatchClassifier, ModelsMayBeLargeSmallOrFarAway) {
  for (const int power : {-1000, -300, 0, 300, 1000})
    for (const int away : {0, 1, 30}) {
      const Rational size = Rational::power_of_two(power);
      const Rational shift = away == 0 ? Rational(0) : size * Rational::power_of_two(2 * away);
      const Model model(patch_shapes::placed(patch_shapes::sphere(), size, {shift, 0, 0}));
      const auto at = [&](std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t unit) {
        return ExactPoint{ratio(x, unit) * size + shift, ratio(y, unit) * size,
                          ratio(z, unit) * size};
      };
      const std::string name = std::to_string(power) + " " + std::to_string(away);
      expect_truth(model(at(1, 2, 2, 3)), Sign::kZero, name);
      expect_truth(model(at(100001, 200000, 200000, 300000)), Sign::kNegative, name);
      expect_truth(model(at(99999, 200000, 200000, 300000)), Sign::kPositive, name);
      expect_truth(model(at(2, 0, 0, 1)), Sign::kNegative, name);
      EXPECT_EQ(model(Vec3d{0x1p1023, -0x1p1023, 0}).winding, 0);
    }
}

// Doubles tell little there: integers find where to search for the parameters.
TEST(PatchClassifier, FindsPointsOnModelsThatAreFarAway) {
  for (const int away : {44, 48, 60}) {
    const Rational shift = Rational::power_of_two(away);
    const Patches patches = patch_shapes::placed(patch_shapes::torus(3, 1), 1, {shift, 0, 0});
    const Model model(patches);
    for (std::size_t p = 0; p < patches.size(); p += 3)
      for (int i = 0; i < 16; i += 3) {
        const std::array<Rational, 2> uv{ratio(i % 4, 3), ratio(i / 4, 3)};
        const auto on = *point_of(evaluate(patches[p].tensor(), uv));
        expect_truth(model(on), Sign::kZero, std::to_string(away) + " patch " + std::to_string(p));
      }
  }
}

// Thin plates in a stack: the look-up is bounded, and near a plate one slab has both of its sides.
TEST(PatchClassifier, BoundsTheLookUpOfStacks) {
  Patches stack;
  for (std::int64_t k = 0; k < 30; ++k) {
    const Patches plate =
        patch_shapes::box({0, 0, Rational(2 * k)}, {100'000, 100'000, Rational(2 * k + 1)});
    stack.insert(stack.end(), plate.begin(), plate.end());
  }
  const Model model(stack);
  EXPECT_LT(model.classifier.lookup().cells, 1'000'000u);
  for (std::int64_t k = 0; k < 59; ++k) {
    const ExactPoint p{50'001, 50'003, ratio(2 * k + 1, 2)};
    EXPECT_EQ(model(p).winding, k % 2 == 0 ? 1 : 0) << k;
  }
}

}  // namespace
}  // namespace veritope
