// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/patch_sides.h"

#include <gtest/gtest.h>

#include "robust/base/random.h"
#include "solids/patches/patch_net.h"
#include "splines/bezier_domain.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

Rational random_number(Random& random) {
  return Rational(random.between(-9, 9)) / Rational(random.between(1, 5));
}
Patch::Curve random_curve(Random& random, int degree, bool is_rational) {
  Patch::Curve curve({degree}, is_rational ? 4 : 3, is_rational);
  for (Rational& v : curve.coefficients()) v = random_number(random);
  if (is_rational)
    for (Rational& w : curve.component(3)) w = Rational(random.between(1, 9)) / 4;
  return curve;
}

TEST(CanonicalCurve, IsOneForAllDegreesFactorsAndDirections) {
  Random random(6001);
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE("round " + std::to_string(round) + " of seed 6001");
    const Patch::Curve curve =
        random_curve(random, 1 + static_cast<int>(random.below(5)), round % 2 == 0);
    Patch::Curve other = elevate(curve, 0, static_cast<int>(random.below(4)));
    if (round % 3 == 0) other = to_rational(other);
    if (other.is_rational()) {
      const Rational factor = Rational(random.between(1, 9)) / 7;
      for (Rational& v : other.coefficients()) v *= factor;
    }
    const bool is_reversed = random.below(2) == 1;
    if (is_reversed) other = reversed(other, 0);
    const CanonicalCurve a = canonical(curve), b = canonical(other);
    EXPECT_EQ(a, b);
    EXPECT_EQ(hash_of(a), hash_of(b));
    EXPECT_TRUE(a.travel == Travel::kBoth || (a.travel != b.travel) == is_reversed);
  }
}
TEST(CanonicalCurve, DiffersWhereACoefficientDoes) {
  Random random(6002);
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE("round " + std::to_string(round) + " of seed 6002");
    const Patch::Curve curve =
        random_curve(random, 1 + static_cast<int>(random.below(5)), round % 2 == 0);
    Patch::Curve other = curve;
    other.coefficients()[random.below(other.coefficients().size())] += Rational(1) / 1000;
    // The changed curve run backwards is another one but by chance, which the seed has not.
    EXPECT_FALSE(canonical(curve) == canonical(other));
  }
}
TEST(CanonicalCurve, OfItsOwnReverseTravelsBothWays) {
  const Patch::Curve there_and_back({2}, 3, false, {0, 1, 0, 0, 2, 0, 5, 5, 5});
  EXPECT_EQ(canonical(there_and_back).travel, Travel::kBoth);
}
TEST(CanonicalCurve, ANegativeFactorIsAnotherCurve) {
  Random random(6003);
  const Patch::Curve curve = random_curve(random, 2, true);
  Patch::Curve other = curve;
  for (Rational& v : other.coefficients()) v = -v;
  EXPECT_FALSE(canonical(curve) == canonical(other));
}
TEST(CanonicalCurve, OfNoughtsOnlyIsAForm) {
  EXPECT_EQ(canonical(Patch::Curve({3}, 4, true)), canonical(Patch::Curve({5}, 4, true)));
}

TEST(CollapsedSide, IsOnePointWhateverTheWeights) {
  const auto with_weights = [](const std::vector<Rational>& w) {
    Patch::Curve curve({2}, 4, true);
    for (std::size_t i = 0; i < 3; ++i)
      for (int c = 0; c < 4; ++c) curve.component(c)[i] = w[i] * Rational(c == 3 ? 1 : c - 1);
    return curve;
  };
  EXPECT_TRUE(is_collapsed(with_weights({1, 2, 3})));
  EXPECT_FALSE(is_collapsed(with_weights({1, 0, 3})));
  EXPECT_TRUE(is_collapsed(Patch::Curve({3}, 3, false)));
  Patch::Curve nearly({3}, 3, false);
  nearly.component(1)[2] = Rational::power_of_two(-1074);
  EXPECT_FALSE(is_collapsed(nearly));
}

// The form that borrows the patch's numbers is the one that copies them.
TEST(SideForm, AgreesWithTheCanonicalCurve) {
  Random random(6004);
  std::vector<Patch> patches;
  for (const auto& shape : patch_shapes::sound_shapes())
    if (shape.patches.size() < 40)
      patches.insert(patches.end(), shape.patches.begin(), shape.patches.end());
  for (int degree = 1; degree < 4; ++degree) {
    Patch::Triangle map(degree, 3, false);
    for (Rational& v : map.coefficients()) v = random_number(random);
    patches.push_back(make_patch(elevated(map)).value());
    patches.push_back(make_patch(std::move(map)).value());
  }
  for (const Patch& p : patches)
    for (const Patch& patch : {p, reversed(p)})
      for (std::uint32_t s = 0; s < patch.num_sides(); ++s) {
        const internal::SideForm form(patch, s);
        ASSERT_EQ(form.is_collapsed(), is_collapsed(patch.side(s)));
        if (form.is_collapsed()) continue;
        const CanonicalCurve curve = canonical(patch.side(s));
        EXPECT_EQ(form.hash(), hash_of(curve));
        EXPECT_EQ(form.travel(), curve.travel);
      }
}

// x, y, z (w) of one control point after the other.
Patch::Curve curve_of(int degree, bool is_rational, const std::vector<int>& by_points) {
  Patch::Curve curve({degree}, is_rational ? 4 : 3, is_rational);
  const int width = curve.num_components();
  for (int i = 0; i <= degree; ++i)
    for (int c = 0; c < width; ++c)
      curve.component(c)[static_cast<std::size_t>(i)] =
          Rational(by_points[static_cast<std::size_t>(width * i + c)]);
  return curve;
}
// A patch with this curve as two of its sides.
Patch patch_along(const Patch::Curve& curve) {
  std::vector<Rational> c;
  for (int k = 0; k < curve.num_components(); ++k)
    for (const Rational& v : curve.component(k)) c.insert(c.end(), 2, v);
  return make_patch(BezierSurface<Rational>({curve.degree(0), 1}, curve.num_components(),
                                            curve.is_rational(), c))
      .value();
}
std::vector<Patch::Curve> unlike_curves() {
  return {
      curve_of(1, false, {0, 0, 0, 1, 2, 3}),
      curve_of(1, false, {0, 0, 0, 1, 2, 4}),
      // It begins with the numbers of the first.
      curve_of(2, false, {0, 0, 0, 1, 2, 3, 5, 5, 5}),
      // Twelve numbers, taken without weights and with them.
      curve_of(3, false, {0, 1, 2, 1, 3, 5, 4, 2, 7, 6, 9, 3}),
      curve_of(2, true, {0, 1, 2, 1, 3, 5, 4, 2, 7, 6, 9, 3}),
      // Without an end, or without any point.
      curve_of(2, true, {0, 1, 2, 0, 3, 5, 4, 2, 7, 6, 9, 3}),
      curve_of(2, true, {0, 1, 2, 1, 3, 5, 4, 2, 7, 6, 9, 0}),
      curve_of(2, true, {0, 1, 2, 0, 3, 5, 4, 0, 7, 6, 9, 0}),
      // From a point back to it: the first number that differs is an inner one.
      curve_of(3, false, {1, 1, 1, 5, 0, 0, 0, 2, 0, 1, 1, 1}),
      curve_of(3, true, {1, 1, 1, 1, 0, 2, 0, 2, 5, 0, 0, 3, 1, 1, 1, 1}),
      curve_of(2, false, {1, 1, 1, 5, 0, 0, 1, 1, 1}),
  };
}

TEST(CanonicalCurve, UnlikeCurvesHaveUnlikeForms) {
  const auto curves = unlike_curves();
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (std::size_t k = 0; k < curves.size(); ++k) {
      const CanonicalCurve a = canonical(curves[i]), b = canonical(curves[k]);
      EXPECT_EQ(a == b, i == k) << i << " " << k;
      EXPECT_EQ((a <=> b) == 0, i == k) << i << " " << k;
      EXPECT_EQ((a <=> b) < 0, (b <=> a) > 0) << i << " " << k;
    }
}
TEST(CanonicalCurve, AFactorOfACurveWithoutPointsDoesNotCount) {
  Patch::Curve curve = curve_of(2, true, {0, 1, 2, 0, 3, 5, 4, 0, 7, 6, 9, 0});
  const CanonicalCurve before = canonical(curve);
  for (Rational& v : curve.coefficients()) v *= Rational(3);
  EXPECT_EQ(canonical(curve), before);
}

// Sides are matched by this order: two forms that it takes for equal are one edge.
TEST(SideForm, IsOrderedAsTheCanonicalCurvesAre) {
  std::vector<Patch> patches = patch_shapes::sphere();
  for (const auto& curve : unlike_curves())
    for (const auto& c : {curve, reversed(curve, 0)}) patches.push_back(patch_along(c));
  patches.push_back(reversed(patch_shapes::pn_torus(4, 4)[0]));
  struct Side {
    internal::SideForm form;
    CanonicalCurve curve;
  };
  std::vector<Side> sides;
  for (const Patch& patch : patches)
    for (std::uint32_t s = 0; s < patch.num_sides(); ++s) {
      internal::SideForm form(patch, s);
      ASSERT_EQ(form.is_collapsed(), is_collapsed(patch.side(s)));
      if (form.is_collapsed()) continue;
      const CanonicalCurve curve = canonical(patch.side(s));
      EXPECT_EQ(form.hash(), hash_of(curve));
      EXPECT_EQ(form.travel(), curve.travel);
      sides.push_back({std::move(form), curve});
    }
  for (const Side& a : sides)
    for (const Side& b : sides) {
      EXPECT_EQ((a.form <=> b.form) == 0, a.curve == b.curve);
      EXPECT_EQ(a.form <=> b.form, a.curve <=> b.curve);
    }
}
TEST(SideForm, APointWithoutAWeightIsNotCollapsed) {
  for (const auto& points : {std::vector{0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 3},
                             std::vector{-1, 0, 1, 1, 0, 0, 0, 0, -3, 0, 3, 3}}) {
    const Patch patch = patch_along(curve_of(2, true, points));
    for (std::uint32_t s = 0; s < 4; ++s)
      EXPECT_EQ(internal::SideForm(patch, s).is_collapsed(), is_collapsed(patch.side(s))) << s;
  }
}

TEST(Patch, SidesRunFromCornerToCornerInSymmetriesToo) {
  const auto ends = [](const Patch& patch, std::uint32_t s) {
    const Patch::Curve curve = patch.side(s);
    std::array<std::vector<Rational>, 2> out;
    for (int c = 0; c < curve.num_components(); ++c) {
      out[0].push_back(curve.component(c).front());
      out[1].push_back(curve.component(c).back());
    }
    return out;
  };
  std::vector<Patch> patches = patch_shapes::sphere();
  patches.push_back(patch_shapes::pn_torus(4, 4)[0]);
  for (const Patch& patch : patches) {
    const std::uint32_t n = patch.num_sides();
    EXPECT_EQ(reversed(reversed(patch)), patch);
    EXPECT_EQ(turned(turned(patch, 1), n - 1), patch);
    for (std::uint32_t s = 0; s < n; ++s) {
      EXPECT_EQ(ends(patch, s)[0], patch.corner(s));
      EXPECT_EQ(ends(patch, s)[1], patch.corner((s + 1) % n));
      EXPECT_EQ(reversed(patch).side(n - 1 - s), reversed(patch.side(s), 0));
      EXPECT_EQ(reversed(patch).corner((n - s) % n), patch.corner(s));
      for (std::uint32_t by = 0; by < n; ++by)
        EXPECT_EQ(turned(patch, by).side(s), patch.side((s + by) % n));
    }
  }
}

TEST(CanonicalNet, IsOneForAllSymmetriesDegreesAndFactors) {
  const Patches ring = patch_shapes::torus(3, 1);
  Patches patches(ring.begin(), ring.begin() + 2);
  patches.push_back(patch_shapes::pn_torus(4, 4)[3]);
  for (const Patch& patch : patches) {
    const CanonicalNet net = canonical_net(patch);
    const Patch high = patch.is_triangle() ? make_patch(elevated(patch.triangle())).value()
                                           : make_patch(elevate_to(patch.tensor(), {4, 3})).value();
    for (std::uint32_t by = 0; by < patch.num_sides(); ++by)
      for (const bool is_reversed : {false, true}) {
        const Patch same = turned(is_reversed ? reversed(high) : high, by);
        const CanonicalNet other = canonical_net(same);
        EXPECT_TRUE((net <=> other) == 0);
        EXPECT_EQ(net.is_reversed != other.is_reversed, is_reversed);
      }
    EXPECT_EQ(with_least_degrees(high).coefficients().size(), patch.coefficients().size());
  }
  EXPECT_FALSE((canonical_net(patches[0]) <=> canonical_net(patches[1])) == 0);
}

}  // namespace
}  // namespace veritope
