// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/enclosure/interval_de_boor.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "interval/upward.h"
#include "tests/splines/exact_map.h"

namespace veritope {
namespace {

using exact_map::ExactMap;
using exact_map::random_bspline;

Rational ratio(long p, long q) { return Rational(p) / Rational(q); }

std::vector<MidRadius<Rational>> line_of(Random& random, std::size_t n, bool positive,
                                         bool points) {
  std::vector<MidRadius<Rational>> line;
  for (std::size_t i = 0; i < n; ++i)
    line.push_back({ratio(random.between(positive ? 40 : -90, 90), 7),
                    points ? Rational() : ratio(random.between(0, 9), 11)});
  return line;
}
std::vector<Rational> mids(const std::vector<MidRadius<Rational>>& line) {
  std::vector<Rational> out;
  for (const auto& v : line) out.push_back(v.mid);
  return out;
}

// The example of the issue: centre to centre only in this form.
TEST(IntervalDeBoor, ProductOfIntervalsIsAroundTheProductOfMiddles) {
  // P = t D1 on [0, 1] with D1 = [-1, 3], t = [0, 2] is not a legal parameter, so on [0, 4]: alpha = [0, 1/2].
  const auto axis = make_knot_axis(1, {0, 0, 4, 4}).value();
  const auto box = interval_de_boor<Rational>(axis, {{0, 0}, {1, 2}}, 0, 2);
  EXPECT_EQ(box.mid, ratio(1, 4));  // 1/4 * 1
  EXPECT_EQ(
      box.radius,
      ratio(5,
            4));  // 1/4 * 2 + 1 * 1/4 + 2 * 1/4: [-1, 3/2], where [0, 1/2] * [-1, 3] = [-1/2, 3/2]
}

TEST(IntervalDeBoor, MiddleIsTheExactValueAndTheBoxHoldsTheCurve) {
  Random random(1);
  for (int loop = 0; loop < 100; ++loop) {
    const int p = 1 + static_cast<int>(random.below(5));
    const auto map = random_bspline<1>(random, {{p}, {1 + random.below(4)}, 1, false}, 7, 9);
    const auto& axis = map.axis(0);
    const auto line = line_of(random, axis.num_control(), false, random.below(2) == 0);
    const ExactMap<1> exact(BSplineCurve<Rational>(map.axes(), 1, false, mids(line)));
    const auto span = internal::find_span(
        axis, axis.domain_begin() + ratio(static_cast<long>(random.below(100)), 100) *
                                        (axis.domain_end() - axis.domain_begin()));
    const Rational begin = axis.knots[span], length = axis.knots[span + 1] - begin;
    const auto a = random.between(0, 20), b = random.between(a, 20);
    const Rational lo = begin + ratio(a, 20) * length, hi = begin + ratio(b, 20) * length;
    const auto box = interval_de_boor<Rational>(axis, line, lo, hi);
    const auto value = [&](const Rational& t) {  // of this span's polynomial
      return internal::de_boor_in_span(axis, span, internal::values_of_span(line, p, span), t,
                                       Rational());
    };
    EXPECT_EQ(box.mid, value((lo + hi) / Rational(2)).mid);
    if (hi < axis.knots[span + 1]) {
      EXPECT_EQ(box.mid, exact.at({(lo + hi) / Rational(2)}).value[0]);
    }
    for (int k = 0; k <= 8; ++k) {
      const auto at =
          value(lo + ratio(k, 8) * (hi - lo));  // all choices of points in the boxes: mid +- radius
      EXPECT_LE(abs(at.mid - box.mid) + at.radius, box.radius) << "loop " << loop;
    }
  }
}

// Newton's form of the interpolant through points 0 .. n, at x.
Rational interpolated(const std::vector<Rational>& x, std::vector<Rational> y, const Rational& at) {
  const std::size_t n = x.size();
  for (std::size_t k = 1; k < n; ++k)
    for (std::size_t i = n; i-- > k;) y[i] = (y[i] - y[i - 1]) / (x[i] - x[i - k]);
  Rational out = y[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) out = out * (at - x[i]) + y[i];
  return out;
}

TEST(IntervalDeBoor, RadiusIsAPolynomialOfTheDegreeWhereNoSignChanges) {
  Random random(2);
  for (int loop = 0; loop < 40; ++loop) {
    const int p = 1 + static_cast<int>(random.below(5));
    const auto map = random_bspline<1>(random, {{p}, {3}, 1, false}, 7, 9);
    const auto& axis = map.axis(0);
    const auto line = line_of(random, axis.num_control(), true, false);  // D > 0 on all levels
    const auto span = internal::find_span(axis, axis.domain_begin());
    const Rational begin = axis.knots[span], length = axis.knots[span + 1] - begin,
                   eps = length / Rational(50);
    const auto radius = [&](const Rational& t) {
      return interval_de_boor<Rational>(axis, line, t - eps, t + eps).radius;
    };
    std::vector<Rational> x, y;
    for (int k = 0; k <= p; ++k)
      x.push_back(begin + eps + ratio(k, 10) * length), y.push_back(radius(x.back()));
    for (int k = 0; k < 6; ++k) {
      const Rational t = begin + ratio(7 + 13 * k, 100) * length;
      EXPECT_EQ(radius(t), interpolated(x, y, t)) << "loop " << loop;
    }
    // The degree is p indeed, and not less, for eps > 0 and these data: one point fewer does not determine it.
    x.pop_back(), y.pop_back();
    if (p > 1) {
      EXPECT_NE(radius(begin + ratio(9, 10) * length),
                interpolated(x, y, begin + ratio(9, 10) * length));
    }
  }
}

TEST(IntervalDeBoor, RadiusIsNoPolynomialWhereASignChanges) {
  const auto axis = make_knot_axis(2, {0, 0, 0, 1, 1, 1}).value();
  const std::vector<MidRadius<Rational>> line{{-1, 0}, {1, 0}, {1, 0}};
  const auto radius = [&](const Rational& t) {
    return interval_de_boor<Rational>(axis, line, t - ratio(1, 100), t + ratio(1, 100)).radius;
  };
  std::vector<Rational> x, y;
  for (int k = 1; k <= 3; ++k) x.push_back(ratio(k, 10)), y.push_back(radius(x.back()));
  EXPECT_EQ(radius(ratio(2, 5)), interpolated(x, y, ratio(2, 5)));
  EXPECT_NE(radius(ratio(9, 10)), interpolated(x, y, ratio(9, 10)));
}

TEST(IntervalDeBoor, WidthsAddAtKnotsAndTheBoxHoldsBothParts) {
  Random random(3);
  for (int loop = 0; loop < 60; ++loop) {
    const int p = 1 + static_cast<int>(random.below(4));
    const auto map = random_bspline<1>(random, {{p}, {4}, 1, false}, 7, 9);
    const auto& axis = map.axis(0);
    const auto line = line_of(random, axis.num_control(), false, false);
    const Rational length = axis.domain_end() - axis.domain_begin();
    const auto a = random.between(0, 10), b = random.between(a, 20);
    const Rational lo = axis.domain_begin() + ratio(a, 20) * length,
                   hi = axis.domain_begin() + ratio(b, 20) * length;
    const auto box = interval_de_boor<Rational>(axis, line, lo, hi);
    std::vector<Rational> cuts{lo};
    for (const Rational& k : axis.knots)
      if (cuts.back() < k && k < hi) cuts.push_back(k);
    cuts.push_back(hi);
    Rational sum;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const auto part = interval_de_boor<Rational>(axis, line, cuts[i], cuts[i + 1]);
      sum += part.radius;
      EXPECT_LE(abs(part.mid - box.mid) + part.radius, box.radius) << "loop " << loop;
    }
    EXPECT_EQ(box.radius, sum) << "loop " << loop;  // multiplicities are at most p: no jump
  }
}

TEST(IntervalDeBoor, AJumpIsInsideTheBox) {
  const auto axis = make_knot_axis(1, {0, 0, 1, 1, 2, 2}).value();
  const auto box =
      interval_de_boor<Rational>(axis, {{0, 0}, {0, 0}, {7, 0}, {7, 0}}, ratio(1, 2), ratio(3, 2));
  EXPECT_LE(abs(box.mid), box.radius);
  EXPECT_LE(abs(Rational(7) - box.mid), box.radius);
}

// Why the box at a knot is not put around P(middle).
TEST(IntervalDeBoor, TheSumOfWidthsAroundTheMiddleWouldMissTheCurve) {
  const auto axis = make_knot_axis(1, {0, 0, 1, 2, 2}).value();
  const std::vector<MidRadius<Rational>> line{{-1, 0}, {0, 0}, {0, 0}};  // P = t - 1, then 0
  const Rational lo = ratio(2, 5), hi = ratio(11, 10);
  const auto box = interval_de_boor<Rational>(axis, line, lo, hi);
  const auto middle = interval_de_boor<Rational>(axis, line, ratio(3, 4), ratio(3, 4)).mid;
  const auto first = interval_de_boor<Rational>(axis, line, lo, lo).mid;
  EXPECT_LT(box.radius, abs(first - middle));
  EXPECT_LE(abs(first - box.mid), box.radius);
}

// Eq. 5 with exact products of intervals, as the tight form's oracle.
struct Range {
  Rational lo, hi;
  friend Range operator*(const Range& a, const Range& b) {
    const auto all = {a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi};
    return {std::min(all), std::max(all)};
  }
  friend Range operator+(const Range& a, const Range& b) { return {a.lo + b.lo, a.hi + b.hi}; }
};
Range tight(const KnotAxis<Rational>& axis, std::size_t span, std::vector<Range> d,
            const Rational& lo, const Rational& hi) {
  const auto p = static_cast<std::size_t>(axis.degree);
  for (std::size_t j = 1; j <= p; ++j)
    for (std::size_t i = p; i >= j; --i) {
      const Rational begin = axis.knots[span - p + i],
                     length = axis.knots[span + 1 + i - j] - begin;
      const Range alpha{(lo - begin) / length, (hi - begin) / length};
      d[i] = Range{Rational(1) - alpha.hi, Rational(1) - alpha.lo} * d[i - 1] + alpha * d[i];
    }
  return d[p];
}

TEST(IntervalDeBoor, TightFormLiesInsideAndBothRoundOutward) {
  Random random(4);
  const ScopedUpward upward;
  for (int loop = 0; loop < 100; ++loop) {
    const int p = 1 + static_cast<int>(random.below(4));
    const auto map = random_bspline<1>(random, {{p}, {3}, 1, false}, 8, 9);
    const auto& axis = map.axis(0);
    // Dyadic data, so that the intervals are the exact boxes.
    std::vector<MidRadius<Rational>> line;
    std::vector<Interval> boxes;
    for (std::size_t i = 0; i < axis.num_control(); ++i) {
      const auto m = random.between(-64, 64), r = random.between(0, 16);
      line.push_back({ratio(m, 16), ratio(r, 16)});
      boxes.push_back(
          Interval::from_bounds(static_cast<double>(m - r) / 16, static_cast<double>(m + r) / 16));
    }
    const auto span = internal::find_span(axis, axis.domain_begin());
    const Rational begin = axis.knots[span], length = axis.knots[span + 1] - begin;
    const auto a = random.between(0, 16), b = random.between(a, 16);
    const Rational lo = begin + ratio(a, 16) * length, hi = begin + ratio(b, 16) * length;
    const auto wide = interval_de_boor<Rational>(axis, line, lo, hi);
    std::vector<Range> ranges;
    for (std::size_t i = span - static_cast<std::size_t>(p); i <= span; ++i)
      ranges.push_back({line[i].mid - line[i].radius, line[i].mid + line[i].radius});
    const Range exact = tight(axis, span, ranges, lo, hi);
    EXPECT_LE(wide.mid - wide.radius, exact.lo) << "loop " << loop;
    EXPECT_LE(exact.hi, wide.mid + wide.radius) << "loop " << loop;
    const Interval at =
        Interval::from_bounds(nearest_double(lo), nearest_double(hi));  // exact: dyadic
    const Interval rounded = interval_de_boor_tight(axis, boxes, at);
    EXPECT_TRUE(contains(rounded, exact.lo) && contains(rounded, exact.hi));
    const Interval outer =
        interval_de_boor_enclosure<1>(BSplineCurve<Interval>(map.axes(), 1, false, boxes), {at})[0];
    EXPECT_TRUE(contains(outer, wide.mid - wide.radius) && contains(outer, wide.mid + wide.radius));
    EXPECT_LE(wid(outer), nearest_double(Rational(2) * wide.radius) + 1e-12);
  }
}

TEST(IntervalDeBoor, SurfacesAndVolumesGoAxisByAxis) {
  Random random(5);
  const ScopedUpward upward;
  for (int loop = 0; loop < 10; ++loop) {
    const auto map = random_bspline<3>(random, {{2, 1, 2}, {2, 1, 2}, 2, false}, 8, 16);
    const ExactMap<3> exact(map);
    std::array<std::pair<Rational, Rational>, 3> at;
    std::array<Interval, 3> rounded;
    for (std::size_t a = 0; a < 3; ++a) {
      const Rational begin = map.axis(a).domain_begin(), length = map.axis(a).domain_end() - begin;
      const auto i = random.between(0, 16), j = random.between(i, 16);
      at[a] = {begin + ratio(i, 16) * length, begin + ratio(j, 16) * length};
      rounded[a] = Interval::from_bounds(round_up(at[a].first), round_down(at[a].second));
    }
    const auto boxes = interval_de_boor<Rational, 3>(map, {}, at);
    std::vector<Interval> points;
    for (const Rational& v : map.coefficients()) points.push_back(enclose(v));
    const auto outer = interval_de_boor_enclosure<3>(
        BSplineVolume<Interval>(map.axes(), 2, false, points), rounded);
    for (int k = 0; k < 27; ++k) {
      const std::array<int, 3> corner{k % 3, k / 3 % 3, k / 9};
      std::array<Rational, 3> u;
      for (std::size_t a = 0; a < 3; ++a)
        u[a] = at[a].first + ratio(corner[a], 2) * (at[a].second - at[a].first);
      const auto value = exact.at(u).value;
      for (std::size_t c = 0; c < 2; ++c) {
        EXPECT_LE(abs(value[c] - boxes[c].mid), boxes[c].radius);
        EXPECT_TRUE(contains(outer[c], value[c]));
      }
    }
  }
}

TEST(IntervalDeBoor, MiddleOfASurfaceBoxIsThePointWithinACell) {
  Random random(6);
  const auto map = random_bspline<2>(random, {{3, 2}, {1, 1}, 3, false}, 7, 9);
  const ExactMap<2> exact(map);
  std::array<std::pair<Rational, Rational>, 2> at;
  std::array<Rational, 2> middle;
  for (std::size_t a = 0; a < 2; ++a) {
    const Rational begin = map.axis(a).domain_begin(), length = map.axis(a).domain_end() - begin;
    at[a] = {begin + ratio(1, 5) * length, begin + ratio(2, 5) * length},
    middle[a] = begin + ratio(3, 10) * length;
  }
  const auto boxes = interval_de_boor<Rational, 2>(map, {}, at);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(boxes[c].mid, exact.at(middle).value[c]);
}

TEST(IntervalDeBoor, RefusesParametersOutsideTheDomain) {
  const auto axis = make_knot_axis(1, {0, 0, 1, 1}).value();
  EXPECT_THROW(interval_de_boor<Rational>(axis, {{0, 0}, {1, 0}}, 0, 2), InternalError);
  EXPECT_THROW(interval_de_boor<Rational>(axis, {{0, 0}, {1, 0}}, 1, 0), InternalError);
  EXPECT_THROW(interval_de_boor<Rational>(axis, {{0, 0}}, 0, 1), InternalError);
}

}  // namespace
}  // namespace veritope
