// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/restriction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "splines/bezier_domain.h"
#include "tests/splines/draw.h"

namespace veritope {
namespace {

using internal::AffineBlend;
using internal::CutPlaces;
using internal::OrderOfCuts;
using internal::PartCuts;

std::vector<Rational> on_part(std::vector<Rational> line, const Rational& a, const Rational& b,
                              const OrderOfCuts& order) {
  const CutPlaces<Rational> places(a, b, Rational(1), order.end_first);
  const PartCuts<AffineBlend<Rational>> cuts{order, internal::cut_at(places.begin),
                                             internal::cut_at(places.end)};
  cuts.apply(line.data(), 1, static_cast<int>(line.size()) - 1);
  return line;
}
std::vector<Rational> on_part(const std::vector<Rational>& line, const Rational& a,
                              const Rational& b) {
  return on_part(line, a, b, internal::order_of_cuts(a, b));
}
std::vector<Rational> draw_line(Random& random) {
  return draw_coefficients(random, static_cast<std::size_t>(draw_int(random, 1, 7)), 1, false);
}
// a <= b, inside of [0, 1] or not.
std::array<Rational, 2> draw_part(Random& random, bool is_inside) {
  Rational a = is_inside ? draw_parameter(random) : draw_rational(random) / Rational(10);
  Rational b = is_inside ? draw_parameter(random) : draw_rational(random) / Rational(10);
  if (b < a) std::swap(a, b);
  return {a, b};
}

TEST(Restriction, TheFirstCutLeavesAHalfOrMore) {
  for_loops(910, 200, [](Random& random) {
    const auto [a, b] = draw_part(random, random.below(2) == 0);
    const OrderOfCuts order = internal::order_of_cuts(a, b);
    EXPECT_GE(order.end_first ? b : Rational(1) - a, fraction(1, 2));
    EXPECT_EQ(order.cuts_begin, a != Rational(0));
    EXPECT_EQ(order.cuts_end, b != Rational(1));
  });
  // At 1/2 itself the end is first: a / b is then exact in binary numbers.
  EXPECT_TRUE(internal::cuts_end_first(0.5));
  EXPECT_FALSE(internal::cuts_end_first(0x1.fffffffffffffp-2));
}

TEST(Restriction, BothOrdersAndCutsOfNothingGiveTheSameNumbers) {
  for_loops(911, 60, [](Random& random) {
    const auto line = draw_line(random);
    const auto [a, b] = draw_part(random, true);
    const auto expected = on_part(line, a, b);
    // Each order where it does not divide by zero.
    if (b != Rational(0)) {
      EXPECT_EQ(on_part(line, a, b, {true, true, true}), expected);
    }
    if (a != Rational(1)) {
      EXPECT_EQ(on_part(line, a, b, {false, true, true}), expected);
    }
  });
}

TEST(Restriction, Composes) {
  for_loops(912, 60, [](Random& random) {
    const auto line = draw_line(random);
    const auto [a, b] = draw_part(random, false);
    const auto [c, d] = draw_part(random, false);
    const Rational length = b - a;
    EXPECT_EQ(on_part(on_part(line, a, b), c, d), on_part(line, a + c * length, a + d * length))
        << a.to_string() << " " << b.to_string() << " " << c.to_string() << " " << d.to_string();
  });
}

TEST(Restriction, OfAPointIsConstant) {
  for_loops(913, 60, [](Random& random) {
    const auto line = draw_line(random);
    const Rational t = draw_parameter(random);
    const auto part = on_part(line, t, t);
    const BezierCurve<Rational> curve({static_cast<int>(line.size()) - 1}, 1, false, line);
    for (const Rational& v : part) EXPECT_EQ(v, evaluate(curve, {t})[0]) << t.to_string();
  });
}

TEST(Restriction, OfAMapIsThatOfItsLines) {
  for_loops(914, 40, [](Random& random) {
    const auto map = draw_bezier<2>(random, 4, 2);
    auto [a, b] = draw_part(random, random.below(2) == 0);
    if (a == b) b += fraction(1, 3);
    const std::size_t axis = random.below(2);
    const auto part = restricted(map, axis, a, b);
    const Grid<2> grid = map.grid();
    for (int c = 0; c < 2; ++c)
      grid.for_each_line(axis, [&, a = a, b = b](std::size_t first) {
        std::vector<Rational> line, got;
        for (std::size_t i = 0; i < grid.size[axis]; ++i) {
          line.push_back(map.component(c)[first + i * grid.stride(axis)]);
          got.push_back(part.component(c)[first + i * grid.stride(axis)]);
        }
        EXPECT_EQ(got, on_part(line, a, b));
      });
  });
}

}  // namespace
}  // namespace veritope
