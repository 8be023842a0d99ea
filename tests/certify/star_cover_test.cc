// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/star_cover.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "robust/rational.h"
#include "splines/bezier_calculus.h"
#include "splines/de_casteljau.h"
#include "verify/certify/star_walks.h"

namespace veritope {
namespace {

using patch_shapes::Patches;

Rational ratio(int p, int q = 1) { return Rational(p) / Rational(q); }
patch_shapes::Point origin() { return {ratio(0), ratio(0), ratio(0)}; }

PatchComplex complex_of(Patches patches) {
  PatchInput input;
  input.patches = std::move(patches);
  return make_patch_complex(std::move(input)).value();
}

struct Model {
  explicit Model(Patches patches, int max_level = StarCoverOptions().max_level)
      : complex(complex_of(std::move(patches))), forest(PieceForest::make(complex).value()) {
    StarCoverOptions options;
    options.max_level = max_level;
    cover = find_star_cover(forest, options);
  }
  PatchComplex complex;
  PieceForest forest;
  StarCover cover;
};

// Each leaf's hull lies in its box, each root has leaves below it, each box a leaf.
void expect_leaves(Model& m) {
  ASSERT_TRUE(m.cover.is_complete());
  std::vector<bool> named(m.cover.boxes.size());
  const auto visit = [&](auto& self, PieceForest::Id id) -> void {
    const std::uint32_t box = m.cover.box_of_node[id];
    if (box == StarCover::kNone) {
      ASSERT_NE(m.forest.node(id).first_child, PieceForest::kNone);
      for (PieceForest::Id k = 0; k < 4; ++k) self(self, m.forest.node(id).first_child + k);
      return;
    }
    named[box] = true;
    EXPECT_TRUE(is_inside(m.forest.node(id).hull, m.cover.boxes[box].star.box));
  };
  for (std::uint32_t r = 0; r < m.forest.num_roots(); ++r) visit(visit, m.forest.root(r));
  EXPECT_TRUE(std::all_of(named.begin(), named.end(), [](bool b) { return b; }));
}

TEST(StarCover, TheShareThatIsCoveredOnlyGrowsUpToTheWhole) {
  for (const Patches& patches : {patch_shapes::sphere(), patch_shapes::torus(ratio(3), ratio(1))}) {
    const PatchComplex complex = complex_of(patches);
    PieceForest forest = PieceForest::make(complex).value();
    WorkShare work;
    StarCoverOptions options;
    options.work = &work;
    double last = 0;
    std::size_t num_views = 0;
    options.stops_at = [&](PieceForest::Id, std::size_t) {
      const WorkShare::View view = work.view();
      EXPECT_EQ(view.step, 1u);
      EXPECT_EQ(view.whole, static_cast<double>(forest.num_roots()));
      EXPECT_GE(view.done, last);
      EXPECT_LT(view.done, view.whole) << "a piece is not covered yet";
      last = view.done, ++num_views;
      return false;
    };
    const StarCover cover = find_star_cover(forest, options);
    ASSERT_TRUE(cover.is_complete());
    EXPECT_GT(num_views, 0u);
    EXPECT_EQ(work.view().percent(), std::nullopt) << "the step has ended";
    EXPECT_EQ(work.view().done, work.view().whole);
  }
}

// PROVES STAR-1
// PROVES STAR-1.S1
TEST(StarCover, CoversSoundModelsAndFindsTheirSides) {
  const std::vector<std::pair<const char*, Patches>> models = {
      {"box", patch_shapes::box(origin(), {ratio(1), ratio(2), ratio(3)})},
      {"sphere", patch_shapes::sphere()},
      {"octants", patch_shapes::octant_sphere()},
      {"torus", patch_shapes::torus(ratio(3), ratio(1))},
      {"one patch", patch_shapes::one_patch_torus(ratio(3), ratio(1))},
  };
  for (const auto& [name, patches] : models) {
    SCOPED_TRACE(name);
    Model m(patches);
    expect_leaves(m);
    const ShellWalks walks = find_shell_walks(m.forest, m.cover);
    ASSERT_TRUE(walks.missing.empty());
    ASSERT_EQ(walks.walks.size(), 1u);
    EXPECT_EQ(walks.walks[0].winding_inside, 1);
    EXPECT_EQ(walks.num_bodies(), 1u);
  }
}

TEST(StarCover, DoesNotDependOnSize) {
  for (const int exponent : {-900, 0, 900}) {
    const Rational f = Rational::power_of_two(exponent);
    const Model m(patch_shapes::placed(patch_shapes::torus(ratio(3), ratio(1)), f,
                                       {f * ratio(5), f, ratio(0)}));
    EXPECT_TRUE(m.cover.is_complete()) << "2^" << exponent;
    EXPECT_LT(m.cover.boxes.size(), 2000u);
  }
}

// The weights of a box's corners differ by 2^200: flat faces all the same. What doubles cannot tell from weights <= 0 is not covered, but the search ends.
TEST(StarCover, EndsForExtremeWeights) {
  const auto zero = [](const Rational& v) { return v.sign() == Sign::kZero; };
  for (const int exponent : {-2, -200}) {
    Patches patches = patch_shapes::box(origin(), {ratio(1), ratio(1), ratio(1)});
    const Rational light = Rational::power_of_two(exponent);
    for (Patch& patch : patches) {
      const std::size_t n = patch.num_control();
      std::vector<Rational> c;
      for (int k = 0; k < 4; ++k)
        for (std::size_t i = 0; i < n; ++i) {
          const bool is_origin = zero(patch.component(0)[i]) && zero(patch.component(1)[i]) &&
                                 zero(patch.component(2)[i]);
          const Rational w = is_origin ? light : Rational(1);
          c.push_back(k == 3 ? w : w * patch.component(k)[i]);
        }
      patch =
          make_patch(BezierSurface<Rational>(patch.tensor().degrees(), 4, true, c), patch.origin())
              .value();
    }
    const Model m(patches);
    EXPECT_TRUE(exponent != -2 || m.cover.is_complete());
    EXPECT_LT(m.cover.tried, 20000u);
  }
}

TEST(StarCover, NeverCoversWhatTouchesOrCrossesItself) {
  const Patches ball = patch_shapes::sphere();
  const std::vector<std::pair<const char*, Patches>> models = {
      {"torus that touches itself in a point", patch_shapes::torus(ratio(1), ratio(1))},
      {"torus that crosses itself", patch_shapes::torus(ratio(1), ratio(5, 4))},
      {"balls that cross",
       patch_shapes::joined(
           {ball, patch_shapes::placed(ball, ratio(1), {ratio(1), ratio(0), ratio(0)})})},
      {"balls that touch",
       patch_shapes::joined(
           {ball, patch_shapes::placed(ball, ratio(1), {ratio(2), ratio(0), ratio(0)})})},
      {"ball that touches its cavity",
       patch_shapes::joined({ball, patch_shapes::reversed(patch_shapes::placed(
                                       ball, ratio(1, 2), {ratio(1, 2), ratio(0), ratio(0)}))})},
  };
  for (const auto& [name, patches] : models) {
    const Model m(patches, 9);  // contacts are approached for ever
    EXPECT_FALSE(m.cover.is_complete()) << name;
  }
}

// PROVES STAR-2
TEST(ShellWalks, CountBodiesByDepthAndSeeReversedShells) {
  const auto ball = [](int radius) {
    return patch_shapes::placed(patch_shapes::sphere(), ratio(radius), origin());
  };
  Model nested(patch_shapes::joined({patch_shapes::reversed(ball(2)), ball(3), ball(1)}));
  const ShellWalks walks = find_shell_walks(nested.forest, nested.cover);
  ASSERT_TRUE(walks.missing.empty());
  EXPECT_EQ(walks.num_bodies(), 2u);
  for (const ShellWalk& w : walks.walks) EXPECT_EQ(w.winding_inside, 1) << "shell " << w.shell;

  Model reversed(patch_shapes::reversed(ball(1)));
  EXPECT_EQ(find_shell_walks(reversed.forest, reversed.cover).walks.at(0).winding_inside, 0);
  Model twice(patch_shapes::joined({ball(2), ball(1)}));
  const ShellWalks both = find_shell_walks(twice.forest, twice.cover);
  ASSERT_EQ(both.walks.size(), 2u);
  EXPECT_EQ(both.walks[0].winding_inside, 1);
  EXPECT_EQ(both.walks[1].winding_inside, 2);
}

// Two blocks whose tops z = x/10 and z = 1/50 - x/10 cross: seen from the centres every sheet is a graph, and there are two.
// PROVES STAR-1.S2
TEST(CrossingNumber, CountsSheetsJointly) {
  const auto wedge = [](const Rational& slope, const Rational& height) {
    Patches block =
        patch_shapes::box({ratio(-1), ratio(-1), ratio(-2)}, {ratio(1), ratio(1), ratio(0)});
    for (Patch& p : block) {
      std::vector<Rational> c(p.coefficients().begin(), p.coefficients().end());
      const std::size_t n = p.num_control();
      for (std::size_t i = 0; i < n; ++i) c[2 * n + i] = c[2 * n + i] + slope * c[i] + height;
      p = make_patch(BezierSurface<Rational>(p.tensor().degrees(), 3, false, c), p.origin())
              .value();
    }
    return block;
  };
  const StarBox star{
      {{-0.125, -0.125, -0.125}, {0.125, 0.125, 0.125}}, {0, 0, -0.1015625}, {0, 0, 0.1015625}};
  for (const bool both : {false, true}) {
    Patches patches = wedge(ratio(1, 10), ratio(0));
    if (both) patches = patch_shapes::joined({patches, wedge(ratio(-1, 10), ratio(1, 50))});
    const PatchComplex complex = complex_of(patches);
    PieceForest forest = PieceForest::make(complex).value();
    ASSERT_EQ(forest.scale(), -2);  // coordinates up to 2.1
    StarBox scaled = star;
    for (Point3d* p : {&scaled.box.lo, &scaled.box.hi, &scaled.inside, &scaled.outside})
      for (double& x : *p) x *= 0.25;
    std::vector<PieceForest::Id> tested, held;
    ASSERT_TRUE(find_pieces(forest, scaled.box, 0.02, 4096, &tested, &held));
    ASSERT_TRUE(has_star_signs(forest, tested, scaled));
    EXPECT_EQ(crossing_number(forest, tested, scaled), both ? 2 : 1);
  }
}

// Hulls hold exact points, and signs never contradict exact ones.
TEST(PieceForest, HullsHoldTheirPointsAndSignsAreExact) {
  const Model m(patch_shapes::torus(ratio(3), ratio(1)));
  PieceForest forest = PieceForest::make(m.complex).value();
  Random random(7);
  const Rational unit = Rational::power_of_two(forest.scale());
  std::size_t decided = 0;
  for (int trial = 0; trial < 300; ++trial) {
    PieceForest::Id id = forest.root(static_cast<std::uint32_t>(random.below(forest.num_roots())));
    const int depth = static_cast<int>(random.below(6));
    for (int level = 0; level < depth; ++level)
      id = forest.children(id) + static_cast<PieceForest::Id>(random.below(4));
    const PieceForest::Node node = forest.node(id);
    const PieceForest::Form& form = forest.form(node.patch);
    const auto place = [&](std::uint64_t k, int bits) {
      return (Rational(static_cast<std::int64_t>(k)) + Rational::from_double(random.unit())) *
             Rational::power_of_two(-bits);
    };
    const Rational u = place(node.i, form.root_bits[0] + node.level),
                   v = place(node.j, form.root_bits[1] + node.level);
    const auto& map = m.complex.patch(node.patch).tensor();
    const auto p = evaluate(map, {u, v});
    std::array<Rational, 3> point;
    for (std::size_t k = 0; k < 3; ++k) {
      point[k] = unit * p[k] / p[3];
      EXPECT_TRUE(Rational::from_double(node.hull.lo[k]) <= point[k] &&
                  point[k] <= Rational::from_double(node.hull.hi[k]))
          << "trial " << trial;
    }
    // A centre near the point: at 0 to 3 extents.
    Point3d c;
    for (std::size_t k = 0; k < 3; ++k)
      c[k] = nearest_double(point[k]) + 3 * extent(node.hull) * (random.unit() - 0.5);
    const Sign3 side = forest.side_of(id, c);
    if (side == Sign3::kUncertain) continue;
    ++decided;
    const auto derivative_at = [&](std::size_t axis) {
      std::array<Rational, 3> out;
      const auto d = derivative(map, axis);
      const auto value = evaluate(d, {u, v});
      for (std::size_t k = 0; k < 3; ++k) out[k] = value[k] / value[3];
      return out;
    };
    const auto su = derivative_at(0), sv = derivative_at(1);
    Rational dot(0);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      dot = dot + (su[i] * sv[j] - su[j] * sv[i]) * (point[k] - Rational::from_double(c[k]));
    }
    EXPECT_EQ(dot.sign(), side == Sign3::kPositive ? Sign::kPositive : Sign::kNegative)
        << "trial " << trial;
  }
  EXPECT_GT(decided, 50u);
}

}  // namespace
}  // namespace veritope
