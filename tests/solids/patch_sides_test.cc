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
