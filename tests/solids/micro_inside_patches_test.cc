// SPDX-License-Identifier: LGPL-3.0-or-later
// Microstructures inside of solids of patches.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "models/patch_shapes.h"
#include "models/round_parts.h"
#include "solids/classify/patch_classifier.h"
#include "tests/solids/patch_support.h"
#include "tests/support/micro_cells.h"
#include "tests/support/micro_inside.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

using micro_cells::box_tile;
using micro_cells::full;
using micro_inside::answer;
using micro_inside::Answer;
using micro_inside::condition_of;
using v_cells::cube;

Rational over(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

MicroTile straight_jack() {
  JackShape shape;
  shape.degree = 1;
  return jack_tile(shape).value();
}
Patches ball(const Rational& radius, const PatchPoint& middle) {
  return patch_shapes::placed(patch_shapes::sphere(), radius, middle);
}
Patches polar_ball(const Rational& radius, const PatchPoint& middle) {
  return patch_shapes::placed(patch_shapes::octant_sphere(), radius, middle);
}
Patches with_hole(const Patches& outer, const Patches& hole) {
  return patch_shapes::joined({outer, patch_shapes::reversed(hole)});
}
std::string condition(const Microstructure& micro, const Patches& patches) {
  return condition_of(answer(micro, complex_of(patches)));
}
const PatchPoint kMiddle = {over(1, 2), over(1, 2), over(1, 2)};

// PROVES MICRO-2, MICRO-2.I1
TEST(MicroInsidePatches, ABoxWhoseCornersTouchABallIsNotInside) {
  // Half of the edges, in sixty-fourths, are 8, 12 and 24; the corners are 28 off the middle.
  const Microstructure micro =
      full({cube(0, 0, 0)}, {1, 1, 1}, box_tile({24, 20, 8}, {40, 44, 56}));
  for (const auto& make : {ball, polar_ball}) {
    EXPECT_EQ(condition(micro, make(over(28, 64) + over(1, 1 << 20), kMiddle)), "");
    EXPECT_EQ(condition(micro, make(over(28, 64), kMiddle)), "I1");
    EXPECT_EQ(condition(micro, make(over(28, 64) - over(1, 1 << 20), kMiddle)), "I1");
    EXPECT_EQ(condition(micro, make(over(30, 64), kMiddle)), "");
  }
  const Answer crossing = answer(micro, complex_of(ball(over(26, 64), kMiddle)));
  ASSERT_EQ(condition_of(crossing), "I1");
  const auto& defect = std::get<InsideDefect>(crossing);
  ASSERT_TRUE(defect.patch.has_value() && defect.source.has_value());
  EXPECT_LT(*defect.source, 6u);
  EXPECT_NE(defect.message.find(" is not proved to miss patch "), std::string::npos)
      << defect.message;
}

// PROVES MICRO-2.I1
TEST(MicroInsidePatches, ACylinderHoldsWhatItsEquationSays) {
  // The cylinder x^2 + y^2 <= 1, 0 <= z <= 2, and a box with the corners (+-3/5, +-s, 1 +- h).
  const Patches cylinder = patch_shapes::disc_cylinder(Rational(2));
  const auto asked = [&](const Rational& s, const Rational& h) {
    const VVolume cage =
        v_cells::polynomial({1, 1, 1}, [&](std::size_t i, std::size_t j, std::size_t k) {
          const auto side = [](std::size_t n) { return Rational(n == 0 ? -2 : 2); };
          return v_cells::Point{side(i) * over(3, 5), side(j) * s, Rational(1) + side(k) * h};
        });
    return condition(full({cage}, {1, 1, 1}, box_tile({16, 16, 16}, {48, 48, 48})), cylinder);
  };
  const Rational bit = over(1, 1 << 16);
  EXPECT_EQ(asked(over(4, 5) - bit, over(1, 2)), "");
  EXPECT_EQ(asked(over(4, 5), over(1, 2)), "I1");
  EXPECT_EQ(asked(over(4, 5) + bit, over(1, 2)), "I1");
  EXPECT_EQ(asked(over(1, 2), Rational(1) - bit), "");
  EXPECT_EQ(asked(over(1, 2), Rational(1)), "I1");
  EXPECT_EQ(asked(over(1, 2), Rational(1) + bit), "I1");
}

// PROVES MICRO-2.I2
TEST(MicroInsidePatches, EachPieceMustBeInTheSolid) {
  Microstructure micro = full({cube(0, 0, 0)}, {3, 1, 1}, straight_jack());
  micro.grids[0].tiles[1] = 0;
  const Patches whole = ball(Rational(4), kMiddle);
  EXPECT_EQ(condition(micro, whole), "");
  EXPECT_EQ(condition(micro, ball(Rational(1), {Rational(9), Rational(0), Rational(0)})), "I2");
  // One piece is in a void; then there is a solid in the void around that piece.
  const PatchPoint low = {over(1, 2), over(-1, 2), over(-1, 2)},
                   high = {over(3, 2), over(3, 2), over(3, 2)};
  const Patches hollow = with_hole(whole, patch_shapes::box(low, high));
  const Answer in_void = answer(micro, complex_of(hollow));
  ASSERT_EQ(condition_of(in_void), "I2");
  EXPECT_EQ(std::get<InsideDefect>(in_void).patch->cell, 2u);
  const Patches inner = patch_shapes::box({over(5, 8), over(-1, 4), over(-1, 4)},
                                          {over(5, 4), over(5, 4), over(5, 4)});
  EXPECT_EQ(condition(micro, patch_shapes::joined({hollow, inner})), "");
}

// PROVES MICRO-2.I3
TEST(MicroInsidePatches, BehindEachVoidAPointIsOffTheTiles) {
  Microstructure micro = full({cube(0, 0, 0)}, {2, 2, 2}, straight_jack());
  micro.grids[0].tiles[7] = 0;
  const Patches whole = patch_shapes::box({-4, -4, -4}, {5, 5, 5});
  struct Case {
    PatchPoint middle;
    Rational radius;
    const char* condition;
  };
  const auto all = [](const Rational& x) { return PatchPoint{x, x, x}; };
  for (const Case& c : {Case{all(over(1, 4)), over(1, 20), "I3"},  // in the node of a jack
                        Case{all(over(1, 4)), over(1, 5), "I1"},   // across its surface
                        Case{all(over(3, 4)), over(1, 20), ""},    // in the empty cell
                        Case{all(over(1, 16)), over(1, 20), ""},   // near a corner of a cell
                        Case{all(over(1, 2)), over(1, 10), ""},    // around such a corner
                        Case{{over(1, 16), over(7, 16), over(7, 16)}, over(1, 1000), ""},
                        Case{all(Rational(3)), over(1, 2), "I3"}}) {  // off the cage
    for (const auto& make : {ball, polar_ball}) {
      const Answer got = answer(micro, complex_of(with_hole(whole, make(c.radius, c.middle))));
      EXPECT_EQ(condition_of(got), c.condition) << c.middle[0].to_string();
      if (condition_of(got) != "") continue;
      // The cage is the identity.
      const auto& voids = std::get<InsideProof>(got).voids;
      ASSERT_EQ(voids.size(), 1u);
      Rational sum;
      for (std::size_t a = 0; a < 3; ++a) {
        const Rational off = voids[0].x[a] - c.middle[a];
        sum += off * off;
      }
      EXPECT_LT(sum, c.radius * c.radius);
    }
  }
}

TEST(MicroInsidePatches, VoidsAreListedByTheirShells) {
  const Microstructure micro = full({cube(0, 0, 0)}, {2, 2, 2}, straight_jack());
  const std::vector<PatchPoint> middles = {{over(1, 2), over(1, 2), over(1, 2)},
                                           {over(1, 16), over(1, 16), over(1, 16)},
                                           {over(1, 2), over(1, 2), over(15, 16)}};
  Patches model = patch_shapes::box({-4, -4, -4}, {5, 5, 5});
  for (const PatchPoint& m : middles) model = with_hole(model, polar_ball(over(1, 32), m));
  model = patch_shapes::joined({model, ball(Rational(1), {9, 9, 9})});
  const Answer got = answer(micro, complex_of(model));
  ASSERT_EQ(condition_of(got), "");
  const auto& voids = std::get<InsideProof>(got).voids;
  ASSERT_EQ(voids.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t a = 0; a < 3; ++a) {
      const Rational off = voids[i].x[a] - middles[i][a];
      EXPECT_LT(off * off, over(1, 1024));
    }
}

// A cube of 2 x 1 x 1 cells, the second one empty, with a bridge from the cap between them to x = end.
Microstructure bridged(const Rational& end) {
  Microstructure micro = full({cube(0, 0, 0)}, {2, 1, 1}, box_tile({0, 16, 16}, {64, 48, 48}));
  micro.grids[0].tiles[1] = 0;
  MicroBridge b;
  b.cap = {0, 0, 1};
  b.points.resize(b.num_points());
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 3; ++k)
        b.points[b.at(i, j, k)] = {over(1, 2) + (end - over(1, 2)) * over(k, 2), over(1 + 2 * i, 4),
                                   over(1 + 2 * j, 4)};
  micro.bridges.push_back(std::move(b));
  return micro;
}

// PROVES MICRO-2.I4
TEST(MicroInsidePatches, TheSkinIsNearlyTheGreatestDistanceOfAnEnd) {
  const Microstructure micro = bridged(over(7, 8));
  for (const Rational& gap : {over(1, 8), over(3, 4)}) {
    const Answer got = answer(
        micro, complex_of(patch_shapes::box({-4, -4, -4}, {over(7, 8) + gap, Rational(12), 4})));
    ASSERT_EQ(condition_of(got), "") << gap.to_string();
    const Rational skin = *std::get<InsideProof>(got).skin;
    EXPECT_GT(skin, gap);
    EXPECT_LT(skin, gap * over(21, 20));
    EXPECT_LE(skin.numerator().bit_length(), 20u);
  }
  // A ball: the corners of the end are 3 off its middle, its own middle 2 sqrt 2. It ends at 3.
  const Answer round =
      answer(bridged(over(7, 8)),
             complex_of(ball(Rational(4), {over(7, 8) - Rational(2), over(1, 2), over(1, 2)})));
  ASSERT_EQ(condition_of(round), "");
  // The middle of the end is farthest from the surface: 2.
  EXPECT_GT(*std::get<InsideProof>(round).skin, Rational(2));
  EXPECT_LT(*std::get<InsideProof>(round).skin, over(21, 10));
  EXPECT_FALSE(std::get<InsideProof>(answer(full({cube(0, 0, 0)}, {1, 1, 1}, straight_jack()),
                                            complex_of(ball(Rational(4), kMiddle))))
                   .skin.has_value());
}

// A gap far below the smallest nodes of patches: the skin is greater, but there is one.
TEST(MicroInsidePatches, ASkinBelowTheSmallestNodesIsRaised) {
  const Answer got =
      answer(bridged(over(7, 8)),
             complex_of(patch_shapes::box({-4, -4, -4}, {over(7, 8) + over(1, 1 << 30), 5, 5})));
  ASSERT_EQ(condition_of(got), "");
  EXPECT_GT(*std::get<InsideProof>(got).skin, over(1, 1 << 30));
  EXPECT_LT(*std::get<InsideProof>(got).skin, over(1, 4));
}

// PROVES MICRO-2, MICRO-2.I1
TEST(MicroInsidePatches, ABridgeThatTouchesOrCrossesTheSurfaceIsNotInside) {
  const Microstructure micro = bridged(over(7, 8));
  for (const Rational& x : {over(7, 8), over(4, 5), over(3, 5)}) {
    const Answer got = answer(micro, complex_of(patch_shapes::box({-4, -4, -4}, {x, 4, 4})));
    ASSERT_EQ(condition_of(got), "I1") << x.to_string();
    EXPECT_EQ(std::get<InsideDefect>(got).bridge, 0u);
    EXPECT_EQ(std::get<InsideDefect>(got).message.substr(0, 36),
              "bridge 0 is not proved to miss patch");
  }
  // A void within the bridge.
  EXPECT_EQ(condition(micro, with_hole(patch_shapes::box({-4, -4, -4}, {5, 5, 5}),
                                       ball(over(1, 16), {over(3, 4), over(1, 2), over(1, 2)}))),
            "I1");
}

TEST(MicroInsidePatches, TheWorkIsBounded) {
  const Microstructure micro = full({cube(0, 0, 0)}, {2, 2, 2}, straight_jack());
  const PatchComplex near =
      complex_of(with_hole(patch_shapes::box({-4, -4, -4}, {5, 5, 5}),
                           ball(over(3, 40), {over(1, 16), over(1, 16), over(1, 16)})));
  EXPECT_EQ(condition_of(answer(micro, near)), "");
  InsideLimits few;
  few.nodes = few.nodes_of_part = 0;
  Answer got = answer(micro, near, 1, few);
  ASSERT_EQ(condition_of(got), "I1");
  EXPECT_FALSE(std::get<InsideDefect>(got).patch.has_value());
  few = {};
  few.pairs = 1;
  got = answer(micro, near, 1, few);
  ASSERT_EQ(condition_of(got), "I1");
  EXPECT_NE(std::get<InsideDefect>(got).message.find("comparisons with patches of the model"),
            std::string::npos);
}

// x -> A x + b for the points of patches, A with columns a; all weights stay.
Patches mapped(const Patches& patches, const std::array<PatchPoint, 3>& a, const PatchPoint& b) {
  Patches out;
  for (const Patch& patch : patches) {
    Patch::Tensor map = patch.tensor();
    for (std::size_t i = 0; i < map.grid().count(); ++i) {
      PatchPoint x, y;
      const Rational w = map.is_rational() ? map.component(3)[i] : Rational(1);
      for (std::size_t c = 0; c < 3; ++c) x[c] = map.component(static_cast<int>(c))[i];
      for (std::size_t c = 0; c < 3; ++c)
        y[c] = a[0][c] * x[0] + a[1][c] * x[1] + a[2][c] * x[2] + b[c] * w;
      for (std::size_t c = 0; c < 3; ++c) map.component(static_cast<int>(c))[i] = y[c];
    }
    out.push_back(make_patch(std::move(map), patch.origin()).value());
  }
  return out;
}

// PROVES MICRO-2
// Random boxes in random affine cells, against balls, with the parameters of the patches turned, before and after an
// affine map of all: a box is inside if all its corners are, by the equation of the ball.
TEST(MicroInsidePatches, BoxesAreInsideOfBallsAsTheirCornersSay) {
  Random random(1189);
  int num_inside = 0, num_outside = 0;
  for (int round = 0; round < 30; ++round) {
    const auto number = [&](int lo, int hi, int q) { return over(random.between(lo, hi), q); };
    std::array<PatchPoint, 3> edges;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t c = 0; c < 3; ++c)
        edges[a][c] = a == c ? number(8, 16, 16) : number(-3, 3, 16);
    PatchPoint corner;
    for (Rational& x : corner) x = number(-24, 8, 16);
    const auto image = [&](const PatchPoint& u) {
      PatchPoint out = corner;
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t a = 0; a < 3; ++a) out[c] += u[a] * edges[a][c];
      return out;
    };
    std::array<int, 3> lo{}, hi{};
    for (std::size_t a = 0; a < 3; ++a) {
      lo[a] = static_cast<int>(random.between(1, 30));
      hi[a] = static_cast<int>(random.between(34, 63));
    }
    const Rational radius = number(12, 24, 16);
    bool all_in = true;
    for (unsigned k = 0; k < 8; ++k) {
      PatchPoint u;
      for (std::size_t a = 0; a < 3; ++a) u[a] = over((k >> a & 1) != 0 ? hi[a] : lo[a], 64);
      const PatchPoint p = image(u);
      all_in = all_in && p[0] * p[0] + p[1] * p[1] + p[2] * p[2] < radius * radius;
    }
    Patches model = random.below(2) == 0 ? ball(radius, {}) : polar_ball(radius, {});
    for (Patch& patch : model) patch = turned(patch, random.below(4));
    // An affine map with a positive determinant.
    std::array<PatchPoint, 3> columns;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t c = 0; c < 3; ++c)
        columns[a][c] = a == c ? number(6, 12, 8) : number(-2, 2, 8);
    const PatchPoint shift = {number(-64, 64, 8), number(-64, 64, 8), number(-64, 64, 8)};
    for (const bool is_mapped : {false, true}) {
      const VVolume cage =
          v_cells::polynomial({1, 1, 1}, [&](std::size_t i, std::size_t j, std::size_t k) {
            const PatchPoint p = image({Rational(i), Rational(j), Rational(k)});
            if (!is_mapped) return v_cells::Point{p[0], p[1], p[2]};
            v_cells::Point q{shift[0], shift[1], shift[2]};
            for (std::size_t c = 0; c < 3; ++c)
              for (std::size_t a = 0; a < 3; ++a) q[c] += columns[a][c] * p[a];
            return q;
          });
      const std::string got = condition(full({cage}, {1, 1, 1}, box_tile(lo, hi)),
                                        is_mapped ? mapped(model, columns, shift) : model);
      EXPECT_EQ(got.empty(), all_in) << "round " << round << ", mapped " << is_mapped << got;
    }
    ++(all_in ? num_inside : num_outside);
  }
  EXPECT_GT(num_inside, 4);
  EXPECT_GT(num_outside, 4);
}

TEST(MicroInsidePatches, TheAnswerIsTheSameForEveryNumberOfJobs) {
  Microstructure micro = full({cube(0, 0, 0)}, {6, 6, 6}, straight_jack());
  for (const Rational& radius : {over(9, 10), over(4, 5)}) {
    const PatchComplex model = complex_of(ball(radius, kMiddle));
    const Answer one = answer(micro, model), four = answer(micro, model, 4);
    EXPECT_EQ(condition_of(one), condition_of(four));
    if (const auto* const defect = std::get_if<InsideDefect>(&one)) {
      EXPECT_EQ(std::get<InsideDefect>(four).message, defect->message);
    }
  }
}

// The answer for a mesh is that for its triangles, as patches.
TEST(MicroInsidePatches, TrianglesAndPatchesOfOneSurfaceAgree) {
  const Microstructure micro = full({cube(0, 0, 0)}, {2, 2, 2}, straight_jack());
  for (const double lo : {-0.125, -0x1p-30, 0.0, 0.125}) {
    const TriangleMesh mesh = shapes::box({lo, lo, lo}, {1 - lo, 1 - lo, 1 - lo});
    Patches triangles;
    for (const auto& face : mesh.faces) {
      std::array<PatchPoint, 3> p;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d& q = mesh.positions[face[k]];
        p[k] = {Rational::from_double(q.x), Rational::from_double(q.y), Rational::from_double(q.z)};
      }
      triangles.push_back(flat(p[0], p[1], p[2]));
    }
    EXPECT_EQ(condition(micro, triangles), condition_of(answer(micro, mesh))) << lo;
  }
}

}  // namespace
}  // namespace veritope
