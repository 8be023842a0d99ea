// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/normal_chain.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "solids/classify/patch_classifier.h"
#include "solids/classify/patch_rays.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

constexpr std::uint64_t kSeed = 20261127;

Rational ratio(std::int64_t p, std::int64_t q = 1) { return Rational(p) / Rational(q); }

ExactPoint some_point(Random& random, double reach) {
  ExactPoint out;
  for (Rational& x : out) x = Rational::from_double((2 * random.unit() - 1) * reach);
  return out;
}

// Origins on vertices, in planes of bases, far away, inside and outside.
std::vector<ExactPoint> origins(const PatchComplex& complex, std::size_t count, Random& random) {
  std::vector<ExactPoint> out{{0, 0, 0}, {ratio(1, 3), ratio(-1, 7), ratio(1, 5)}};
  while (out.size() < count) {
    const Patch& patch =
        complex.patch(static_cast<std::uint32_t>(random.below(complex.patches().size())));
    const BaseTriangle base = base_triangles(patch)[0];
    switch (out.size() % 4) {
      case 0: out.push_back(base[random.below(3)]); break;
      case 1: {  // in the plane of a base
        ExactPoint p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = base[0][k] + base[1][k] - base[2][k];
        out.push_back(p);
        break;
      }
      case 2: out.push_back(some_point(random, 1000)); break;
      default: out.push_back(some_point(random, 2)); break;
    }
  }
  return out;
}

// PROVES CHAIN-1
TEST(NormalChain, IsTheWindingNumberForEveryOrigin) {
  Random random(kSeed);
  const std::vector<std::pair<Patches, double>> models = {
      {patch_shapes::octant_sphere(), 1.25},       {patch_shapes::sphere(), 1.25},
      {patch_shapes::one_patch_torus(3, 1), 4.25}, {patch_shapes::frustum(1, 0, 2), 2.25},
      {patch_shapes::pn_torus(12, 8), 4.25},       {patch_shapes::plate(1), 4}};
  std::size_t known = 0, inside = 0;
  for (const auto& [patches, reach] : models) {
    const PatchComplex complex = complex_of(patches);
    const NormalChain chain(complex);
    const PatchClassifier service = PatchClassifier::make(complex, false);
    for (const ExactPoint& origin : origins(complex, 10, random))
      for (int i = 0; i < 20; ++i) {
        const ExactPoint q = some_point(random, reach);
        const auto value = chain.value(q, origin);
        if (!value) continue;  // on a strip: none of these
        ++known;
        const PointAnswer a = service.classify(q);
        inside += a.winding != 0 ? 1 : 0;
        EXPECT_EQ(*value, a.winding) << "seed " << kSeed << " model of " << patches.size();
      }
  }
  EXPECT_EQ(known, models.size() * 10 * 20);
  EXPECT_GT(inside, 100u);
}

// PROVES CHAIN-1
TEST(NormalChain, HasValuesOnFlatWallsAndNoneOnThePatches) {
  const PatchComplex complex = complex_of(patch_shapes::octant_sphere());
  const NormalChain chain(complex);
  const ExactPoint origin{0, 0, 0};
  EXPECT_EQ(chain.value({ratio(1, 3), ratio(1, 3), ratio(1, 3)}, origin), 1);  // on a base
  EXPECT_EQ(chain.value({0, 0, ratio(1, 2)}, origin), 1);  // on an edge of four simplices
  EXPECT_EQ(chain.value(origin, origin), 1);
  EXPECT_EQ(chain.value({ratio(3, 5), 0, ratio(4, 5)}, origin), std::nullopt);
  EXPECT_EQ(chain.value({0, 0, 1}, origin), std::nullopt);
  EXPECT_EQ(chain.value({2, 0, 0}, {2, 0, 0}), 0);  // the origin is a wall of all simplices
}

TEST(NormalChain, CountsItsCells) {
  const PatchComplex complex = complex_of(patch_shapes::octant_sphere());
  const NormalChain chain(complex);
  // Each octant has a degenerate second base, at its collapsed side.
  EXPECT_EQ(chain.simplices({0, 0, 0}).plus, 8u);
  EXPECT_EQ(chain.simplices({0, 0, 0}).zero, 8u);
  EXPECT_EQ(chain.simplices({5, 0, 0}).minus, 4u);
  EXPECT_EQ(chain.free_form_cells().plus, 8u);
  const NormalChain block(complex_of(unit_box()));
  EXPECT_EQ(block.free_form_cells().zero, 6u);
}

// The unit cube, whose top is pulled up to z = 3 and 5 by control points with weights 2^unit times as great as others.
Patches pulled_cube(std::int64_t unit) {
  Patches out;
  for (const Patch& face : unit_box()) {
    const Patch::Tensor flat = elevate(elevate(face.tensor(), 0, 3), 1, 3);
    Patch::Tensor map({4, 4}, 4, true);
    const auto z = flat.component(2);
    const bool is_top =
        std::all_of(z.begin(), z.end(), [](const Rational& x) { return x == Rational(1); });
    for (std::size_t i = 0; i < 25; ++i) {
      const std::size_t row = i / 5, column = i % 5;
      const bool is_pulled = is_top && row % 4 != 0 && column % 4 != 0, is_middle = i == 12;
      const Rational w = Rational::power_of_two(!is_pulled ? -4 * unit : is_middle ? 0 : -unit);
      for (int c = 0; c < 3; ++c) map.component(c)[i] = w * flat.component(c)[i];
      if (is_pulled) map.component(2)[i] = w * Rational(is_middle ? 3 : 5);
      map.component(3)[i] = w;
    }
    out.push_back(make_patch(std::move(map)).value());
  }
  return out;
}

// Rounded weights may be 0: no cell is left out for that.
TEST(NormalChain, SeesCellsWhoseWeightsBinary64DoesNotHave) {
  const ExactPoint q{ratio(28, 100), ratio(1, 2), 4}, origin{ratio(1, 3), ratio(2, 7), ratio(5, 2)};
  for (const int unit : {20, 1500}) {
    const PatchComplex complex = complex_of(pulled_cube(unit));
    const auto f = NormalChain(complex).value(q, origin);
    EXPECT_EQ(PatchClassifier::make(complex, false, 3).classify(q).winding, 1) << unit;
    if (unit == 20) {
      EXPECT_EQ(f, 1);
    }
    EXPECT_NE(f, 0) << unit;
  }
}

// A cell is closed: all rays have the same winding, which is 0 off the hull.
TEST(FreeFormCell, IsAClosedChain) {
  Random random(kSeed);
  for (const Patches& patches :
       {patch_shapes::octant_sphere(), patch_shapes::sphere(), patch_shapes::pn_torus(12, 8),
        patch_shapes::one_patch_torus(3, 1)}) {
    const PatchComplex complex = complex_of(patches);
    const int scale = scale_of(complex);
    std::size_t inside = 0;
    for (int i = 0; i < 30; ++i) {
      const auto number = static_cast<std::uint32_t>(random.below(patches.size()));
      const PatchRays rays(free_form_cell(complex.patch(number), scale, 0, 0), scale);
      for (int k = 0; k < 5; ++k) {
        Vec3d p{};
        double* const to[3] = {&p.x, &p.y, &p.z};
        for (std::size_t c = 0; c < 3; ++c)
          *to[c] = std::ldexp(
              rays.hull().lo[c] + random.unit() * (rays.hull().hi[c] - rays.hull().lo[c]), scale);
        const RayPoint q(p, scale);
        std::optional<ShellWindings> first;
        for (std::size_t axis = 0; axis < 3; ++axis)
          for (const bool is_upward : {false, true}) {
            const RayCount count = rays.count_rounded(q, {axis, is_upward});
            ASSERT_EQ(count.state, RayCount::State::kCounted) << "seed " << kSeed;
            if (!first) first = count.windings;
            EXPECT_EQ(*first, count.windings) << "seed " << kSeed;
          }
        inside += first->empty() ? 0 : 1;
      }
    }
    EXPECT_GT(inside, 5u);
  }
}

}  // namespace
}  // namespace veritope
