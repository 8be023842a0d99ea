// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/solvers/function_roots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "interval/functions.h"

namespace veritope {
namespace {

ExactBox<2> square(long r) {
  const ExactInterval side{Rational(-r), Rational(r)};
  return ExactBox<2>{{side, side}};
}

// The circle x^2 + y^2 = 1 and y = sin(3 x): by the symmetry in (0, 0) an even number; six.
// PROVES ROOT-2
TEST(FunctionRoots, FindWhereASineMeetsACircle) {
  const auto f = [](const Box<2>& b) {
    const Interval three(3);
    return ValuesAndDerivatives<2>{
        {sqr(b[0]) + sqr(b[1]) - Interval(1), b[1] - sin(three * b[0])},
        {{{Interval(2) * b[0], Interval(2) * b[1]}, {-three * cos(three * b[0]), Interval(1)}}}};
  };
  const auto report = function_roots<2>(square(2), f);
  EXPECT_TRUE(report.is_complete());
  // Signs of x^2 + sin(3 x)^2 - 1 on a fine grid of x.
  int changes = 0;
  double last = 1;
  for (int i = -2000; i <= 2000; ++i) {
    const double x = i / 1000.0 + 1e-4, v = x * x + std::sin(3 * x) * std::sin(3 * x) - 1;
    changes += v * last < 0;
    last = v;
  }
  EXPECT_EQ(static_cast<int>(report.roots.size()), changes);
  for (const auto& root : report.roots) EXPECT_LE(root.box.width(), Rational::power_of_two(-39));
}

// exp(x) = 1 + x touches in 0; y = x.
// PROVES ROOT-2.OPEN
TEST(FunctionRoots, KeepATouchInACluster) {
  const auto f = [](const Box<2>& b) {
    return ValuesAndDerivatives<2>{
        {exp(b[0]) - Interval(1) - b[0], b[1] - b[0]},
        {{{exp(b[0]) - Interval(1), Interval(0)}, {Interval(-1), Interval(1)}}}};
  };
  SolverOptions options;
  options.max_boxes = 4000;
  const auto report = function_roots<2>(square(1), f, options);
  EXPECT_TRUE(report.roots.empty());
  EXPECT_TRUE(std::any_of(report.clusters.begin(), report.clusters.end(), [](const auto& c) {
    return c.box.contains({Rational(0), Rational(0)});
  }));
}

// PROVES ROOT-2.SAME
TEST(FunctionRoots, FindARootOnACutAndOnTheBoundaryOnce) {
  const auto f = [](const Box<1>& b) {
    return ValuesAndDerivatives<1>{{sin(Interval(4) * b[0])},
                                   {{{Interval(4) * cos(Interval(4) * b[0])}}}};
  };
  const ExactBox<1> domain{{ExactInterval{Rational(0), Rational(1)}}};  // roots 0 and pi / 4
  const auto report = function_roots<1>(domain, f);
  EXPECT_TRUE(report.is_complete());
  ASSERT_EQ(report.roots.size(), 2u);
  EXPECT_EQ(std::count_if(report.roots.begin(), report.roots.end(),
                          [](const auto& r) { return r.place == RootPlace::kAtBoundary; }),
            1);
}

// (x - 1/4) (19/20 - x) over [0, 1]: the half [0, 1/2] has one root, proved in a box that reaches over 1/2. The other
// half touches that box, is not inside of it, and holds the second root.
// PROVES ROOT-2.COVERED
TEST(FunctionRoots, APartThatOnlyTouchesABoxOfUniquenessIsSearched) {
  const auto f = [](const Box<1>& b) {
    const Interval x = b[0], last = Interval(19) / Interval(20);
    return ValuesAndDerivatives<1>{{(x - Interval(0.25)) * (last - x)},
                                   {{{last + Interval(0.25) - Interval(2) * x}}}};
  };
  const ExactBox<1> domain{{ExactInterval{Rational(0), Rational(1)}}};
  const auto report = function_roots<1>(domain, f);
  EXPECT_TRUE(report.is_complete());
  ASSERT_EQ(report.roots.size(), 2u);
  std::array<const IsolatedRoot<1>*, 2> root{&report.roots[0], &report.roots[1]};
  if (root[1]->box[0].lo < root[0]->box[0].lo) std::swap(root[0], root[1]);
  EXPECT_TRUE(root[0]->box.contains({Rational(1) / Rational(4)}));
  EXPECT_TRUE(root[1]->box.contains({Rational(19) / Rational(20)}));
  // As the comment says; else the test would pass without the condition.
  const Rational half = Rational(1) / Rational(2);
  EXPECT_LT(half, root[0]->unique_in[0].hi);
  EXPECT_LT(root[0]->unique_in[0].hi, root[1]->box[0].lo);
}

}  // namespace
}  // namespace veritope
