// SPDX-License-Identifier: LGPL-3.0-or-later
// Words where curved walls of several operands abut or touch.
#include <gtest/gtest.h>

#include "models/patch_shapes.h"
#include "models/refined_patches.h"
#include "robust/base/random.h"
#include "solids/expression/expression_classifier.h"
#include "splines/bezier_triangle.h"
#include "splines/de_casteljau.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

using patch_shapes::Patches;
using Solids = std::vector<std::shared_ptr<const Operand>>;

Rational ratio(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

std::shared_ptr<const Operand> solid(const Patches& shape) {
  auto complex = make_patch_complex(shape).value();
  EXPECT_TRUE(complex.is_closed_oriented_surface());
  return patch_operand(std::make_unique<const PatchComplex>(std::move(complex)));
}
std::shared_ptr<const Operand> block(const PatchPoint& lo, const PatchPoint& hi) {
  ExactBox<3> box;
  for (std::size_t k = 0; k < 3; ++k) box[k] = {lo[k], hi[k]};
  return box_operand(box);
}

// The words for union, intersection, difference and the other difference.
std::string words(const Solids& solids, const ExactPoint& p) {
  constexpr const char* kNames[] = {"in", "on", "out", "undecided"};
  const Formula a = Formula::variable(0), b = Formula::variable(1);
  std::string out;
  for (const Formula& f : {Formula::any_of({a, b}), Formula::all_of({a, b}),
                           Formula::all_of({a, b.negated()}), Formula::all_of({b, a.negated()})})
    out +=
        (out.empty() ? "" : " ") +
        std::string(kNames[static_cast<std::size_t>(ExpressionClassifier(f, solids).classify(p))]);
  return out;
}

// PROVES POINT-8
TEST(CurvedWalls, AbutAlongCommonRims) {
  const Patches tall = patch_shapes::frustum(1, 1, 2);
  const Solids stacked = {solid(tall), solid(patch_shapes::placed(tall, 1, {0, 0, 2}))};
  EXPECT_EQ(words(stacked, {ratio(3, 5), ratio(4, 5), 2}), "on out on on");
  EXPECT_EQ(words(stacked, {1, 0, 2}), "on out on on");  // a vertex of both
  EXPECT_EQ(words(stacked, {0, 0, 2}), "in out on on");
  // A cylinder on a block: the rim lies in a face.
  const Solids standing = {solid(tall), block({-2, -2, -1}, {2, 2, 0})};
  EXPECT_EQ(words(standing, {ratio(3, 5), ratio(4, 5), 0}), "on out on on");
  EXPECT_EQ(words(standing, {-1, 0, 0}), "on out on on");
  EXPECT_EQ(words(standing, {ratio(1, 5), ratio(1, 3), 0}), "in out on on");
  // A cylinder in a block, both ends in its faces.
  const Solids inside = {solid(tall), block({-2, -2, 0}, {2, 2, 2})};
  EXPECT_EQ(words(inside, {ratio(3, 5), ratio(4, 5), 0}), "on on out on");
  EXPECT_EQ(words(inside, {ratio(3, 5), ratio(4, 5), 1}), "in on out on");
}

// Places on a patch: inside, on its sides, at its corners.
std::vector<ExactPoint> points_on(const Patch& patch, Random& random) {
  const auto at = [&](const Rational& u, const Rational& v) {
    const auto h = patch.is_triangle() ? evaluate(patch.triangle(), {Rational(1) - u - v, u, v})
                                       : evaluate(patch.tensor(), {u, v});
    return *point_of(h);
  };
  const Rational part = ratio(1 + static_cast<std::int64_t>(random.below(7)), 16);
  return {at(part, ratio(3, 7)),
          at(ratio(1, 2), part),
          at(part, 0),
          at(0, part),
          at(0, 0),
          at(1, 0),
          at(0, 1)};
}

// A and the same solid from other patches.
// PROVES POINT-8
TEST(CurvedWalls, OfOneSurfaceFromOtherPatches) {
  Random random(20261127);
  const Patches models[] = {patch_shapes::sphere(),         patch_shapes::octant_sphere(),
                            patch_shapes::torus(3, 1),      patch_shapes::one_patch_torus(3, 1),
                            patch_shapes::frustum(1, 2, 2), patch_shapes::teapot(),
                            patch_shapes::pn_torus(12, 8)};
  for (std::size_t m = 0; m < std::size(models); ++m) {
    const Patches& model = models[m];
    const std::shared_ptr<const Operand> first = solid(model);
    for (int way = 0; way < 3; ++way) {
      const Patches other = way == 0   ? patch_shapes::quartered(model)
                            : way == 1 ? patch_shapes::elevated(model)
                                       : patch_shapes::turned(model);
      const Solids solids = {first, solid(other)};
      for (int i = 0; i < scaled(4); ++i)
        for (const ExactPoint& p : points_on(model[random.below(model.size())], random))
          EXPECT_EQ(words(solids, p), "on on out out")
              << "model " << m << " way " << way << " at " << p[0].to_string() << ","
              << p[1].to_string() << "," << p[2].to_string();
    }
  }
}

}  // namespace
}  // namespace veritope
