// SPDX-License-Identifier: LGPL-3.0-or-later
// V-models that look sound and are not, or look broken and are sound: what certify says of each, and that the C++
// checker accepts each certificate.
#include <gtest/gtest.h>

#include "tests/support/v_cells.h"
#include "tests/support/v_model_judge.h"

namespace veritope {
namespace {

using random_v_models::Judged;
using v_cells::cube;
using v_cells::Point;

Rational q(std::int64_t p, std::int64_t d) { return Rational(p) / Rational(d); }

Judged judged(const std::vector<VVolume>& cells) {
  Judged out = random_v_models::judged(cells, PatchOrientation::kKeep);
  EXPECT_EQ(out.problem, "");
  return out;
}
// Several claims refute such models: the code is one of these words.
void expect_invalid(const std::vector<VVolume>& cells, const std::string& codes) {
  const Judged j = judged(cells);
  ASSERT_EQ(j.verdict(), Verdict::kInvalid) << j.certified.findings.front().message;
  EXPECT_NE((" " + codes + " ").find(" " + j.code + " "), std::string::npos) << j.code;
}
// Nothing refutes the model, unless the cells themselves are refuted, with one of these codes.
void expect_undecided(const std::vector<VVolume>& cells, const std::string& words,
                      const std::string& codes = "none") {
  const Judged j = judged(cells);
  if (j.verdict() == Verdict::kInvalid) return expect_invalid(cells, codes);
  ASSERT_EQ(j.verdict(), Verdict::kUndecided);
  EXPECT_EQ(j.code, "not-certified");
  EXPECT_NE(j.certified.findings.front().message.find(words), std::string::npos)
      << j.certified.findings.front().message;
}
// Genus of the only shell, and the number of places where N is 0.
void expect_valid(const std::vector<VVolume>& cells, std::int64_t genus, std::size_t singular) {
  const Judged j = judged(cells);
  ASSERT_EQ(j.verdict(), Verdict::kValid) << j.certified.findings.front().message;
  EXPECT_EQ(j.certified.claim, "vmodel-1");
  ASSERT_EQ(j.facts().shell_facts.size(), 1u);
  EXPECT_EQ(j.facts().shell_facts[0].genus, genus);
  EXPECT_EQ(j.facts().vmodel->singular.size(), singular);
}
const char* const kRepeated = "side-overused overlap curve-nonmanifold";

KnotAxis<Rational> linear_axis() {
  return {1, {Rational(0), Rational(0), Rational(1), Rational(1)}, false};
}

TEST(VModelTraps, TwoCubesOnOneEdgeAreInvalid) {
  expect_invalid({cube(0, 0, 0), cube(1, 1, 0)}, "side-overused curve-nonmanifold");
}
TEST(VModelTraps, TwoCubesOnOneVertexAreInvalid) {
  expect_invalid({cube(0, 0, 0), cube(1, 1, 1)}, "patches-touching point-nonmanifold");
}
TEST(VModelTraps, ACellAndItsCopyAreInvalid) {
  expect_invalid({cube(0, 0, 0), cube(0, 0, 0)}, kRepeated);
  // With its axes named in another way, or reversed, so that 8 symmetries without orientations would glue the two.
  expect_invalid({cube(0, 0, 0), v_cells::turned(cube(0, 0, 0), 8 * 3)}, kRepeated);
  expect_invalid({cube(0, 0, 0), v_cells::turned(cube(0, 0, 0), 3)}, kRepeated);
}
TEST(VModelTraps, ACellInsideOfAnotherIsInvalid) {
  const VVolume inner = v_cells::box({q(1, 4), q(1, 4), q(1, 4)}, {q(1, 2), q(1, 2), q(1, 2)});
  expect_invalid({cube(0, 0, 0), inner}, "shell-turned overlap");
}

// u c(v), w; c turns by `quarters` times 90 degrees. The face u = 0 is the axis.
VVolume sector(int quarters) {
  const std::array<std::array<int, 2>, 4> ends{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  std::vector<std::array<Rational, 2>> c;
  KnotAxis<Rational> around{2, {Rational(0)}, false};
  for (int i = 0; i <= quarters; ++i) {
    const auto& a = ends[static_cast<std::size_t>(i) % 4];
    const auto& b = ends[static_cast<std::size_t>(i + 1) % 4];
    c.push_back({Rational(a[0]), Rational(a[1])});
    if (i < quarters) c.push_back({Rational(a[0] + b[0]), Rational(a[1] + b[1])});
    around.knots.insert(around.knots.end(), 2, Rational(i));
  }
  around.knots.emplace_back(quarters);
  std::vector<Rational> values;
  for (std::size_t k = 0; k < 3; ++k)
    for (int u = 0; u < 2; ++u)
      for (const auto& at : c)
        for (int w = 0; w < 2; ++w) values.push_back(k == 2 ? Rational(w) : Rational(u) * at[k]);
  return {{linear_axis(), around, linear_axis()}, 3, false, values};
}
TEST(VModelTraps, ASectorOfThreePiAroundItsAxisIsInvalid) {
  expect_invalid({sector(6)}, kRepeated);
  // As several cells, which are glued around the axis, it is no better.
  const VVolume half = restricted(sector(6), 1, Rational(0), Rational(3)).value(),
                rest = restricted(sector(6), 1, Rational(3), Rational(6)).value();
  expect_invalid({half, rest}, kRepeated);
  expect_valid({sector(3)}, 0, 1);
}

// A wedge whose face w = 1 has the points of a line, with these weights at the end of u.
VVolume weighted_wedge(std::array<int, 3> weights) {
  return v_cells::rational(
      {1, 2, 1},
      [](std::size_t i, std::size_t j, std::size_t k) {
        return k == 1 ? Point{Rational(0), Rational(j), Rational(1)}
                      : Point{Rational(i), Rational(j), Rational(0)};
      },
      [=](std::size_t i, std::size_t j, std::size_t k) {
        return k == 1 && i == 1 ? Rational(weights[j]) : Rational(1);
      });
}
TEST(VModelTraps, EqualPointsWithOtherWeightsAreNoEdge) {
  // The face is a curve that no certificate of cells speaks of; it touches another one.
  const Judged open = judged({weighted_wedge({1, 4, 1})});
  EXPECT_EQ(open.verdict(), Verdict::kUndecided);
  EXPECT_EQ(open.code, "contact");
  expect_valid({weighted_wedge({1, 1, 1})}, 0, 1);
}

// The planes w = 0 of (u w, v w, w), -1 <= u, v, w <= 1, are points: N = w^2. Axis a is the third one.
VVolume double_pyramid(std::size_t a) {
  return v_cells::polynomial({1, 1, 1}, [=](std::size_t i, std::size_t j, std::size_t k) {
    const auto sign = [](std::size_t n) { return Rational(n == 0 ? -1 : 1); };
    Point p;
    p[(a + 1) % 3] = sign(i) * sign(k);
    p[(a + 2) % 3] = sign(j) * sign(k);
    p[a] = sign(k);
    return p;
  });
}
std::vector<VVolume> pyramids_of(std::size_t a) {
  const VVolume cell = double_pyramid(a);
  return {restricted(cell, 2, Rational(0), q(1, 2)).value(),
          restricted(cell, 2, q(1, 2), Rational(1)).value()};
}
TEST(VModelTraps, ADoublePyramidIsPinchedInItsMiddle) {
  expect_invalid({double_pyramid(2)}, "singular-line overlap");
  // A knot there does not help: the cell is one cell still.
  expect_undecided({insert_knot(double_pyramid(2), 2, q(1, 2))},
                   "a line inside of the cell is collapsed", "overlap");
  // Two pyramids share a point.
  expect_invalid(pyramids_of(2), "patches-touching point-nonmanifold");
}
TEST(VModelTraps, ThreeDoublePyramidsThatFillACubeAreNoVModel) {
  std::vector<VVolume> cells, halves;
  for (std::size_t a = 0; a < 3; ++a) {
    cells.push_back(double_pyramid(a));
    for (const VVolume& half : pyramids_of(a)) halves.push_back(half);
  }
  EXPECT_EQ(make_v_model(cells, VOrientation::kKeep).value().counts().internal, 6u);
  expect_undecided(cells, "the Jacobian determinant is zero", "overlap");
  // Six pyramids with one apex are one.
  expect_valid(halves, 0, 6);
}

// A wedge with an inner knot on u, where the face w = 1 is a line along v for u <= 1/2 only.
VVolume half_a_wedge() {
  KnotAxis<Rational> u{1, {Rational(0), Rational(0), q(1, 2), Rational(1), Rational(1)}, false};
  std::vector<Rational> values;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 2; ++j)
        for (int k = 0; k < 2; ++k)
          values.push_back(c == 0   ? Rational(i)
                           : c == 1 ? (k == 1 && i < 2 ? q(1, 2) : Rational(j))
                                    : Rational(k));
  return {{u, linear_axis(), linear_axis()}, 3, false, values};
}
TEST(VModelTraps, AFaceThatCollapsesOnOneOfTwoSpansMustBeSplit) {
  const VVolume cell = half_a_wedge();
  expect_undecided({cell}, "a part of a face is collapsed; split it at u = 1/2");
  expect_valid({restricted(cell, 0, Rational(0), q(1, 2)).value(),
                restricted(cell, 0, q(1, 2), Rational(1)).value()},
               0, 2);
}

// Quarters `first` and so on of a square ring, in counterclockwise order.
VVolume ring_part(int first, int quarters) {
  const std::array<std::array<int, 2>, 4> around{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
  KnotAxis<Rational> v{1, {Rational(0)}, false};
  for (int i = 0; i <= quarters; ++i) v.knots.emplace_back(i);
  v.knots.emplace_back(quarters);
  std::vector<Rational> values;
  for (std::size_t c = 0; c < 3; ++c)
    for (int r = 1; r <= 2; ++r)
      for (int i = 0; i <= quarters; ++i)
        for (int z = 0; z < 2; ++z)
          values.push_back(
              c == 2 ? Rational(z)
                     : Rational(r * around[static_cast<std::size_t>((first + i) % 4)][c]));
  return {{linear_axis(), v, linear_axis()}, 3, false, values};
}
TEST(VModelTraps, RingsOfOneAndOfTwoCellsAreValid) {
  expect_valid({ring_part(0, 4)}, 1, 0);
  expect_valid({ring_part(0, 2), ring_part(2, 2)}, 1, 0);
  expect_valid({ring_part(0, 1), ring_part(1, 3)}, 1, 0);
}
TEST(VModelTraps, ARingOfOneAndAHalfTurnsIsInvalid) {
  expect_invalid({ring_part(0, 6)}, kRepeated);
}

// A square with four quadratic sides that meet smoothly: N = 0 on its four edges along w.
Point squircle_point(std::size_t i, std::size_t j) {
  const std::array<std::array<std::array<int, 2>, 3>, 3> p{
      {{{{-1, 0}, {-1, 1}, {0, 1}}}, {{{-1, -1}, {0, 0}, {1, 1}}}, {{{0, -1}, {1, -1}, {1, 0}}}}};
  return {Rational(p[i][j][0]), Rational(p[i][j][1]), Rational(0)};
}
TEST(VModelTraps, ASquircleAmongOtherCellsIsValidAndNotRegular) {
  std::vector<VVolume> cells{
      v_cells::polynomial({2, 2, 1}, [](std::size_t i, std::size_t j, std::size_t k) {
        Point p = squircle_point(i, j);
        p[2] = Rational(k);
        return p;
      })};
  if (make_v_model(cells, VOrientation::kKeep).value().hand(0) == Sign::kNegative)
    cells[0] = reversed(cells[0], 2);
  // One quadratic side each, around it, ruled to the side three times as large.
  for (std::size_t side = 0; side < 4; ++side) {
    VVolume cell = v_cells::polynomial({2, 1, 1}, [&](std::size_t i, std::size_t j, std::size_t k) {
      const std::size_t u = side < 2 ? 2 * side : i, v = side < 2 ? i : 2 * (side - 2);
      Point p = squircle_point(u, v);
      const Rational scale(j == 0 ? 1 : 3);
      return Point{p[0] * scale, p[1] * scale, Rational(k)};
    });
    if (make_v_model({cell}, VOrientation::kKeep).value().hand(0) == Sign::kNegative)
      cell = reversed(cell, 0);
    cells.push_back(std::move(cell));
  }
  expect_valid(cells, 0, 4);
  // In it, no more than an edge may vanish: its edges are inner ones here, and border ones when it stands alone.
  expect_valid({cells[0]}, 0, 4);
}

}  // namespace
}  // namespace veritope
