// SPDX-License-Identifier: LGPL-3.0-or-later
// De Casteljau's scheme, restriction and products of splines/ over Interval and MpInterval: results contain those
// over the rationals.
#include <gtest/gtest.h>

#include "interval/enclosure/bernstein_box.h"
#include "interval/enclosure/bernstein_product_internal.h"
#include "interval/enclosure/net_internal.h"
#include "interval/solvers/exact_bernstein.h"
#include "interval/solvers/mp_restriction_internal.h"
#include "interval/upward.h"
#include "splines/bezier_domain.h"
#include "splines/bezier_product.h"
#include "tests/splines/draw.h"

namespace veritope {
namespace {

using Line = std::vector<Rational>;

Line draw_line(Random& random) {
  return draw_coefficients(random, static_cast<std::size_t>(draw_int(random, 1, 7)), 1, false);
}
std::vector<Interval> enclosed(const Line& line) {
  std::vector<Interval> out;
  for (const Rational& v : line) out.push_back(enclose(v));
  return out;
}
void expect_tight(const std::vector<Interval>& in, const Line& exact, double most) {
  ASSERT_EQ(in.size(), exact.size());
  for (std::size_t i = 0; i < in.size(); ++i) {
    EXPECT_TRUE(contains(in[i], exact[i])) << i << ": " << exact[i].to_string();
    EXPECT_LE(wid(in[i]), most) << i;
  }
}
int degree_of(const Line& line) { return static_cast<int>(line.size()) - 1; }

TEST(DeCasteljauOverInterval, EveryBlendContainsTheExactParts) {
  const ScopedUpward upward;
  for_loops(930, 60, [](Random& random) {
    const Line line = draw_line(random);
    const int n = degree_of(line);
    const Rational t = draw_parameter(random);
    Line left = line, right = line;
    internal::keep_left(left.data(), 1, n, internal::cut_at(t));
    internal::keep_right(right.data(), 1, n, internal::cut_at(t));
    const Interval at = enclose(t), rest = Interval(1.0) - at;
    const auto check = [&](const auto& blend) {
      auto in = enclosed(line), other = enclosed(line);
      internal::keep_left(in.data(), 1, n, blend);
      expect_tight(in, left, 0x1p-40);
      in = enclosed(line);
      internal::split_keeping_right(in.data(), 1, n, other.data(), 1, blend);
      expect_tight(in, right, 0x1p-40);
      expect_tight(other, left, 0x1p-40);
    };
    check(internal::AffineBlend<Interval>{rest, at});
    const Interval unit = Interval::from_bounds(0, 1);
    check(internal::InsideBlend{intersection(rest, unit), intersection(at, unit)});
    if (t == fraction(1, 2)) check(internal::HalfBlend<Interval>{Interval(0.5)});
  });
}

// A dyadic part of a line, of which a double knows both ends.
struct DyadicPart {
  explicit DyadicPart(Random& random) {
    const long bits = 1L << random.between(1, 8);
    lo = fraction(random.between(0, bits - 1), bits);
    hi = lo +
         fraction(random.between(1, bits - static_cast<long>(nearest_double(lo * Rational(bits)))),
                  bits);
  }
  Rational lo, hi;
};

TEST(RestrictionOverInterval, EveryWayContainsTheExactPart) {
  const ScopedUpward upward;
  for_loops(931, 80, [](Random& random) {
    const Line line = draw_line(random);
    const int n = degree_of(line);
    const DyadicPart part(random);
    const BezierCurve<Rational> map({n}, 1, false, line);
    const auto exact = restricted(map, 0, part.lo, part.hi);
    const Line expected(exact.coefficients().begin(), exact.coefficients().end());
    const double lo = nearest_double(part.lo), hi = nearest_double(part.hi);
    SCOPED_TRACE(part.lo.to_string() + " to " + part.hi.to_string());

    const auto box =
        on_box<1>({{n}, 1, false, enclosed(line)}, Box<1>(Interval::from_bounds(lo, hi)));
    expect_tight({box.coefficients().begin(), box.coefficients().end()}, expected, 0x1p-38);

    auto net = enclosed(line);
    internal::Cut(Interval(lo), Interval(hi)).apply(net.data(), 1, net.size());
    expect_tight(net, expected, 0x1p-38);

    const auto wide = enclosed_on(map, ExactBox<1>{{ExactInterval{part.lo, part.hi}}}, 200);
    expect_tight({wide.coefficients().begin(), wide.coefficients().end()}, expected, 0x1p-45);
  });
}

TEST(RestrictionOverInterval, CutsOutsideOfTheLineExtrapolate) {
  const ScopedUpward upward;
  for_loops(932, 40, [](Random& random) {
    const Line line = draw_line(random);
    const Rational lo = fraction(random.between(-8, 8), 4),
                   hi = lo + fraction(random.between(1, 8), 4);
    const BezierCurve<Rational> map({degree_of(line)}, 1, false, line);
    const auto exact = restricted(map, 0, lo, hi);
    auto net = enclosed(line);
    internal::Cut(enclose(lo), enclose(hi)).apply(net.data(), 1, net.size());
    expect_tight(net, {exact.coefficients().begin(), exact.coefficients().end()}, 0x1p-20);
  });
}

TEST(ScaledProductOverInterval, ContainsTheExactCoefficientsAndDifferences) {
  const ScopedUpward upward;
  for_loops(933, 30, [](Random& random) {
    const auto x = draw_bezier<2>(random, 3, 1), y = draw_bezier<2>(random, 3, 1),
               z = draw_bezier<2>(random, 3, 1);
    const auto scaled = [](const Bezier<Rational, 2>& map) {
      const auto values = enclosed({map.coefficients().begin(), map.coefficients().end()});
      return internal::ScaledBernstein2({map.degrees(), 1, false, values}, 0);
    };
    const auto got = scaled(x) * scaled(y) - scaled(z);
    const auto exact = to_scaled(difference(multiplied(x, y), z));
    ASSERT_EQ(got.size(), exact.coefficients().size());
    for (std::size_t i = 0; i < got.size(); ++i) {
      EXPECT_TRUE(contains(got.scaled(i), exact.coefficients()[i]));
      EXPECT_LE(wid(got.scaled(i)), 0x1p-25);
    }
  });
}

}  // namespace
}  // namespace veritope
