// SPDX-License-Identifier: LGPL-3.0-or-later
// Points in and near the planes of flat patches, whose parameters no short polynomials have. The truth is that of a
// cube, of which the models are images under one-to-one maps of space.
#include <gtest/gtest.h>

#include "models/restless_faces.h"
#include "robust/base/random.h"
#include "solids/classify/flat_place_internal.h"
#include "solids/classify/patch_classifier.h"
#include "solids/expression/expression_classifier.h"
#include "solids/patches/patch_transform.h"
#include "splines/de_casteljau.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

using patch_shapes::Patches;

constexpr std::uint64_t kSeedOfFaces = 20261210;

Rational part(std::int64_t p, std::int64_t q = 1) { return Rational(p) / Rational(q); }

// The cube's image under y += x^2 / 2, if `is_bent`, then under an affine map that leaves no face along an axis, if
// `is_oblique`. All faces stay flat but two, if it is bent.
class CubeImage {
 public:
  CubeImage(int n, std::uint64_t seed, bool is_bent, bool is_oblique)
      : is_bent_(is_bent), is_oblique_(is_oblique) {
    map_.rows = map_.columns = 3;
    map_.linear = {3, 1, part(1, 7), -1, 2, part(1, 3), part(1, 3), part(-1, 5), 1};
    map_.translation = {part(1, 9), 0, 2};
    Patches patches = patch_shapes::restless_cube(n, seed);
    if (is_bent) patches = sheared(patches, {1, 0, 0, part(1, 2)});
    if (is_oblique) patches = affine_image(patches, map_).value();
    complex = std::make_unique<PatchComplex>(make_patch_complex(std::move(patches)).value());
  }

  ExactPoint of(ExactPoint p) const {
    if (is_bent_) p[1] += part(1, 2) * p[0] * p[0];
    if (!is_oblique_) return p;
    ExactPoint out = {map_.translation[0], map_.translation[1], map_.translation[2]};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) out[i] += map_.linear[3 * i + j] * p[j];
    return out;
  }

  std::unique_ptr<PatchComplex> complex;

 private:
  bool is_bent_, is_oblique_;
  AffineMap map_;
};

std::string word_in_cube(const ExactPoint& p) {
  int inside = 0, on = 0;
  for (const Rational& x : p) {
    inside += x.sign() > 0 && x < Rational(1) ? 1 : 0;
    on += x.sign() == 0 || x == Rational(1) ? 1 : 0;
  }
  return inside == 3 ? "in" : inside + on == 3 ? "on" : "out";
}
std::string word_of(const PointAnswer& a) {
  return !a.is_decided ? "undecided" : a.is_on() ? "on" : a.winding != 0 ? "in" : "out";
}
std::string text(const ExactPoint& p) {
  return p[0].to_string() + "," + p[1].to_string() + "," + p[2].to_string();
}

// PROVES POINT-4
TEST(FlatFaces, HaveEveryPointOfTheirPlanes) {
  Random random(kSeedOfFaces);
  for (const auto& [n, is_bent, is_oblique] :
       {std::tuple(7, false, true), std::tuple(7, false, false), std::tuple(4, true, true)}) {
    const CubeImage cube(n, random.below(1000), is_bent, is_oblique);
    const PatchClassifier valid = PatchClassifier::make(*cube.complex, true),
                          unknown = PatchClassifier::make(*cube.complex, false);
    for (int i = 0; i < scaled(20); ++i) {
      const auto coordinate = [&] {
        return part(static_cast<std::int64_t>(random.below(160)) - 30, 100 + i % 3);
      };
      const ExactPoint p{coordinate(), coordinate(), static_cast<std::int64_t>(random.below(2))};
      const std::string where = "seed " + std::to_string(kSeedOfFaces) + " degree " +
                                std::to_string(n) + " point " + text(p);
      EXPECT_EQ(word_of(valid.classify(cube.of(p))), word_in_cube(p)) << where;
      EXPECT_EQ(word_of(unknown.classify(cube.of(p))), word_in_cube(p)) << where;
    }
  }
}

// Far below what pieces of patches tell apart.
// PROVES POINT-4
TEST(FlatFaces, AreToldFromPointsBesideThem) {
  const CubeImage straight(7, kSeedOfFaces, false, true), bent(5, kSeedOfFaces, true, true);
  for (const int bits : {40, 700, 3000}) {
    const Rational d = Rational::power_of_two(-bits);
    for (const CubeImage* cube : {&straight, &bent}) {
      const PatchClassifier classifier = PatchClassifier::make(*cube->complex, true);
      const auto expect_word = [&](const ExactPoint& p) {
        EXPECT_EQ(word_of(classifier.classify(cube->of(p))), word_in_cube(p))
            << bits << " bits, " << (cube == &bent ? "bent" : "straight");
      };
      for (const Rational& e : {d, -d}) {
        expect_word({part(1, 3), part(2, 5), Rational(1) + e});
        expect_word({part(1, 3), part(2, 5), e});
        expect_word({e, part(2, 5), part(1, 3)});
        expect_word({e, part(2, 5), 1});
        expect_word({e, Rational(1) + e, 0});  // in one plane, beside three
        if (cube == &straight || bits < 1000) {
          expect_word({part(1, 3), e, 1});
          expect_word({part(1, 3), e, part(1, 7)});
        }
      }
      expect_word({part(1, 3), d, 1});  // on the top, near a side that may be a curve
    }
  }
}

// PROVES POINT-4
TEST(FlatFaces, EncloseTheParametersOfTheirPoints) {
  const CubeImage cube(7, kSeedOfFaces, true, true);
  const PatchClassifier classifier = PatchClassifier::make(*cube.complex, true);
  int enclosed = 0;
  for (int i = 1; i < 6; ++i) {
    const ExactPoint p = cube.of({part(i, 7), part(i * i, 41), 1});
    std::optional<OnPatch> where;
    ASSERT_TRUE(classifier.classify(p, &where).is_on());
    ASSERT_TRUE(where.has_value());
    const auto& [u, v] = where->parameters.numbers;
    enclosed += u.is_known() ? 0 : 1;
    for (const AlgebraicNumber* t : {&u, &v})
      EXPECT_LT(t->hi - t->lo, Rational::power_of_two(-100));
    const Rational half = part(1, 2);
    const ExactPoint q =
        *point_of(evaluate(cube.complex->patch(where->patch).tensor(),
                           std::array<Rational, 2>{half * (u.lo + u.hi), half * (v.lo + v.hi)}));
    for (std::size_t k = 0; k < 3; ++k) EXPECT_LT(abs(p[k] - q[k]), Rational::power_of_two(-90));
    EXPECT_FALSE(primitive_pair(where->parameters).has_value() && !u.is_known());
  }
  EXPECT_GT(enclosed, 0);
  // On a border the parameter is a root: x = t, in spite of the degree of the curve.
  std::optional<OnPatch> where;
  ASSERT_TRUE(classifier.classify(cube.of({part(1, 3), 0, 1}), &where).is_on());
  EXPECT_TRUE(where->parameters.is_rational());
}

// PROVES POINT-4
TEST(FlatFaces, AreInsideOfBoxesOfParametersAroundAPointOnly) {
  const CubeImage cube(7, kSeedOfFaces, false, true);
  std::uint32_t top = 0;
  const ExactPoint p = cube.of({part(1, 3), part(2, 5), 1});
  std::optional<OnPatch> where;
  ASSERT_TRUE(PatchClassifier::make(*cube.complex, true).classify(p, &where).is_on());
  top = where->patch;
  const TensorForm form(*cube.complex, top, scale_of(*cube.complex));
  ASSERT_TRUE(form.plane.has_value());
  const internal::FlatPlace place(form, RayPoint(p, scale_of(*cube.complex)));
  const auto at = [](int m, int bits) { return Dyadic(m, -bits); };
  int holders = 0;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j)
      holders += place.is_inside({at(i, 3), at(j, 3)}, {at(i + 1, 3), at(j + 1, 3)}) ? 1 : 0;
  EXPECT_EQ(holders, 1);
  EXPECT_EQ(std::abs(place.border().winding), 1);
  const RayPoint outside(cube.of({part(1, 3), part(-2, 5), 1}), scale_of(*cube.complex));
  EXPECT_EQ(internal::FlatPlace(form, outside).border().winding, 0);
}

TEST(FlatFaces, AreThoseInOnePlane) {
  const auto has_plane = [](const Patch& patch) {
    const TensorForm form(patch.tensor(), 0);
    if (!form.plane) return false;
    for (std::size_t i = 0; i < form.count(); ++i) {
      Integer height = -(form.plane->offset * form.exact[3][i]);
      for (std::size_t k = 0; k < 3; ++k) height += form.plane->normal[k] * form.exact[k][i];
      EXPECT_TRUE(height.is_zero());
    }
    return true;
  };
  for (const Patch& patch : patch_shapes::sphere()) EXPECT_FALSE(has_plane(patch));
  int flat = 0;
  for (const Patch& patch : patch_shapes::frustum(1, 2, 2)) flat += has_plane(patch) ? 1 : 0;
  EXPECT_EQ(flat, 10);  // five at each end
  for (const Patch& patch : patch_shapes::restless_cube(5, kSeedOfFaces))
    EXPECT_TRUE(has_plane(patch));
}

// Walls that abut in a face at parameters that are not known.
TEST(FlatFaces, AbutInExpressions) {
  const CubeImage cube(7, kSeedOfFaces, true, false);
  const auto solid = [](const Patches& patches) -> std::shared_ptr<const Operand> {
    return patch_operand(std::make_unique<const PatchComplex>(make_patch_complex(patches).value()));
  };
  const Patches patches(cube.complex->patches().begin(), cube.complex->patches().end());
  const std::shared_ptr<const Operand> lower = solid(patches),
                                       upper = solid(patch_shapes::placed(patches, 1, {0, 0, 1})),
                                       block = box_operand({ExactInterval{-2, 2}, {-2, 2}, {1, 3}});
  const Formula a = Formula::variable(0), b = Formula::variable(1);
  for (const auto& other : {upper, block}) {
    const auto word = [&](const Formula& f) {
      return ExpressionClassifier(f, {lower, other}).classify(cube.of({part(1, 3), part(2, 5), 1}));
    };
    EXPECT_EQ(word(Formula::any_of({a, b})), PointWord::kIn);
    EXPECT_EQ(word(Formula::all_of({a, b})), PointWord::kOut);
    EXPECT_EQ(word(Formula::all_of({a, b.negated()})), PointWord::kOn);
  }
}

}  // namespace
}  // namespace veritope
