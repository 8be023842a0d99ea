// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include "robust/base/random.h"
#include "splines/de_casteljau.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

Rational at(long p, long q = 1) { return Rational(p) / Rational(q); }

// The recursion of Cox and de Boor, as it is written in textbooks.
Rational basis(const std::vector<Rational>& t, std::size_t i, int p, const Rational& x) {
  if (p == 0) return t[i] <= x && x < t[i + 1] ? at(1) : at(0);
  Rational sum;
  const auto k = static_cast<std::size_t>(p);
  if (t[i] < t[i + k]) sum += (x - t[i]) / (t[i + k] - t[i]) * basis(t, i, p - 1, x);
  if (t[i + 1] < t[i + k + 1])
    sum += (t[i + k + 1] - x) / (t[i + k + 1] - t[i + 1]) * basis(t, i + 1, p - 1, x);
  return sum;
}

TEST(BezierPieces, AreTheBSplineOnEverySpan) {
  Random random(1);
  for (int loop = 0; loop < 60; ++loop) {
    const int p = 1 + static_cast<int>(random.below(4));
    KnotAxis<Rational> axis{p, {}, false};
    const std::size_t n = static_cast<std::size_t>(p) + 1 + random.below(6);
    Rational knot = at(-3);
    int times = 0;
    while (axis.knots.size() < n + static_cast<std::size_t>(p) + 1) {
      const bool again = times <= p && times > 0 && random.below(2) == 0;
      if (!again) knot += at(static_cast<long>(1 + random.below(5)), 7), times = 0;
      axis.knots.push_back(knot), ++times;
    }
    if (!(axis.domain_begin() < axis.domain_end())) continue;
    std::vector<Rational> control;
    for (std::size_t i = 0; i < n; ++i)
      control.push_back(at(static_cast<long>(random.below(100)), 9));
    const BSplineCurve<Rational> curve({axis}, 1, false, control);
    const auto pieces = bezier_pieces(curve);
    ASSERT_EQ(pieces.pieces.size() + 1, pieces.breaks[0].size());
    for (std::size_t piece = 0; piece < pieces.pieces.size(); ++piece) {
      const Rational a = pieces.breaks[0][piece], b = pieces.breaks[0][piece + 1];
      for (int k = 0; k < 5; ++k) {
        const Rational local = at(k, 5), x = a + local * (b - a);
        Rational expected;
        for (std::size_t i = 0; i < n; ++i) expected += control[i] * basis(axis.knots, i, p, x);
        EXPECT_EQ(evaluate(pieces.pieces[piece], {local})[0], expected) << "loop " << loop;
      }
    }
  }
}

TEST(Bezier, PartsAreTheSameMap) {
  Random random(2);
  Bezier<Rational, 3> map({2, 3, 1}, 2, false);
  for (Rational& v : map.coefficients()) v = at(static_cast<long>(random.below(50)), 3);
  const std::array<Rational, 3> point{at(1, 3), at(2, 5), at(1, 7)};
  const auto expected = evaluate(map, point);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Rational cut = at(3, 4);
    const auto [left, right] = split(map, axis, cut);
    auto in_left = point, in_right = point;
    in_left[axis] = point[axis] / cut;
    in_right[axis] = (point[axis] - cut) / (at(1) - cut);
    EXPECT_EQ(evaluate(left, in_left), expected);
    EXPECT_EQ(evaluate(right, in_right), expected);
  }
}

}  // namespace
}  // namespace veritope
