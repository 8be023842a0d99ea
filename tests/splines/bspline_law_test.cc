// SPDX-License-Identifier: LGPL-3.0-or-later
// Laws of the algebra of B-splines, in rationals, for clamped, unclamped and periodic axes with knots of every multiplicity.
#include <gtest/gtest.h>

#include "splines/affine_map.h"
#include "splines/bspline_common.h"
#include "splines/bspline_degree.h"
#include "splines/bspline_derivative.h"
#include "splines/bspline_domain.h"
#include "splines/bspline_make.h"
#include "splines/bspline_pieces.h"
#include "splines/de_boor.h"
#include "tests/splines/draw.h"

namespace veritope {
namespace {

using Values = std::vector<Rational>;

// The recursion of Cox and de Boor, as it is written in textbooks; at the end of the domain the limit from the left.
Rational basis(const KnotAxis<Rational>& axis, std::size_t i, std::size_t p, const Rational& x) {
  const auto& t = axis.knots;
  if (p == 0) {
    if (x == axis.domain_end()) return Rational(t[i] < x && x == t[i + 1] ? 1 : 0);
    return Rational(t[i] <= x && x < t[i + 1] ? 1 : 0);
  }
  Rational sum;
  if (t[i] < t[i + p]) sum += (x - t[i]) / (t[i + p] - t[i]) * basis(axis, i, p - 1, x);
  if (t[i + 1] < t[i + p + 1])
    sum += (t[i + p + 1] - x) / (t[i + p + 1] - t[i + 1]) * basis(axis, i + 1, p - 1, x);
  return sum;
}

// What make_bspline demands.
template <std::size_t N>
void expect_valid(const BSpline<Rational, N>& map) {
  const auto again = make_bspline(map.axes(), map.num_components(), map.is_rational(),
                                  Values(map.coefficients().begin(), map.coefficients().end()));
  EXPECT_TRUE(again) << again.error().message << " in " << text_of(map);
}

// Are they one map? Decided by all their pieces, in common degrees, on the cells that the knots of both make.
template <std::size_t N>
void expect_same_map(BSpline<Rational, N> a, BSpline<Rational, N> b) {
  for (std::size_t axis = 0; axis < N; ++axis) {
    const Values of_a = internal::breaks_of(a.axis(axis)), of_b = internal::breaks_of(b.axis(axis));
    ASSERT_EQ(of_a.front(), of_b.front());
    ASSERT_EQ(of_a.back(), of_b.back());
    for (const Rational& u : of_a)
      if (!std::binary_search(of_b.begin(), of_b.end(), u)) b = insert_knot(b, axis, u);
    for (const Rational& u : of_b)
      if (!std::binary_search(of_a.begin(), of_a.end(), u)) a = insert_knot(a, axis, u);
  }
  const auto x = bezier_pieces(a), y = bezier_pieces(b);
  ASSERT_EQ(x.breaks, y.breaks);
  for (std::size_t i = 0; i < x.pieces.size(); ++i) {
    const auto [v, w] = to_common_degrees(x.pieces[i], y.pieces[i]);
    EXPECT_EQ(v, w) << "piece " << i << " of " << text_of(a) << " and " << text_of(b);
  }
}

// Knots of the domain, ends included, some of them twice and more, none more than degree + 1 times in all.
Values draw_knots(Random& random, const KnotAxis<Rational>& axis) {
  Values knots;
  for (int i = draw_int(random, 0, 6); i > 0; --i) {
    const Rational u = random.below(2) == 0
                           ? axis.knots[static_cast<std::size_t>(axis.degree) + random.below(2)]
                           : axis.domain_begin() +
                                 draw_parameter(random) * (axis.domain_end() - axis.domain_begin());
    const auto already = std::count(knots.begin(), knots.end(), u);
    if (u <= axis.domain_end() && multiplicity(axis, u) + already <= axis.degree)
      knots.push_back(u);
  }
  std::sort(knots.begin(), knots.end());
  return knots;
}

TEST(BSplineLaw, RandomMapsAreValid) {
  int periodic = 0, full = 0;
  for_all_dimensions(200, 60, [&](Random& random, auto n) {
    const auto map = draw_bspline<n>(random, 4, 2, true);
    expect_valid(map);
    const auto& axis = map.axis(0);
    periodic += axis.is_periodic;
    for (const Rational& u : internal::breaks_of(axis))
      full += axis.domain_begin() < u && u < axis.domain_end() &&
              multiplicity(axis, u) == axis.degree + 1;
  });
  EXPECT_GT(periodic, 20);
  EXPECT_GT(full, 10);
}

TEST(BSplineLaw, ValuesAreTheSumsOfTheTextbooksBasisAndTheBasisSumsToOne) {
  for_all_dimensions(210, 40, [](Random& random, auto n) {
    const auto map = draw_bspline<n>(random, 3, 2);
    SCOPED_TRACE(text_of(map));
    const auto at = draw_point(random, map);
    Values sums(2);
    Rational total;
    for (std::size_t i = 0; i < map.grid().count(); ++i) {
      const auto index = map.grid().index_of(i);
      Rational product(1);
      for (std::size_t a = 0; a < n && product.sign() != Sign::kZero; ++a)
        product *=
            basis(map.axis(a), index[a], static_cast<std::size_t>(map.axis(a).degree), at[a]);
      total += product;
      for (int c = 0; c < 2; ++c)
        sums[static_cast<std::size_t>(c)] += product * map.component(c)[i];
    }
    const auto values = evaluate(map, at);
    ASSERT_TRUE(values);
    EXPECT_EQ(values.value(), sums);
    EXPECT_EQ(total, Rational(1));
  });
}

TEST(BSplineLaw, InsertionOfManyKnotsIsThatOfOneAfterTheOther) {
  for_all_dimensions(220, 60, [](Random& random, auto n) {
    const auto map = draw_bspline<n>(random, 4, 2);
    SCOPED_TRACE(text_of(map));
    const std::size_t axis = random.below(n);
    const Values knots = draw_knots(random, map.axis(axis));
    SCOPED_TRACE(text_of(knots));
    const auto refined = refine(map, axis, knots);
    expect_valid(refined);
    auto one_by_one = map;
    for (const Rational& u : knots) one_by_one = insert_knot(one_by_one, axis, u);
    if (!knots.empty()) {
      EXPECT_EQ(refined, one_by_one);
      EXPECT_FALSE(refined.axis(axis).is_periodic);
    }
    for (int i = 0; i < 4; ++i) {
      const auto at = draw_point(random, map);
      EXPECT_EQ(evaluate(refined, at).value(), evaluate(map, at).value());
    }
  });
}

TEST(BSplineLaw, PiecesAreTheMapOnTheirCells) {
  for_all_dimensions(230, 40, [](Random& random, auto n) {
    const auto map = draw_bspline<n>(random, 3, 2);
    SCOPED_TRACE(text_of(map));
    const auto pieces = bezier_pieces(map);
    for (std::size_t i = 0; i < pieces.pieces.size(); ++i) {
      const auto cell = pieces.grid().index_of(i);
      std::array<Rational, n> local = draw_point<n>(random), at;
      for (std::size_t a = 0; a < n; ++a) {
        const Rational &low = pieces.breaks[a][cell[a]], &high = pieces.breaks[a][cell[a] + 1];
        local[a] = local[a] * fraction(1, 2);  // not the upper end, where the map may jump
        at[a] = low + local[a] * (high - low);
      }
      EXPECT_EQ(evaluate(pieces.pieces[i], local), evaluate(map, at).value());
    }
    expect_same_map(joined(pieces), map);
    expect_valid(joined(pieces));
  });
}

TEST(BSplineLaw, ElevationLeavesTheMapItsSmoothnessAndItsEndsUnchanged) {
  for_all_dimensions(240, 80, [](Random& random, auto n) {
    const auto map = draw_bspline<n>(random, 4, 2, true);
    SCOPED_TRACE(text_of(map));
    const std::size_t a = random.below(n);
    const int by = draw_int(random, 1, 3);
    const auto raised = elevate(map, a, by);
    expect_valid(raised);
    expect_same_map(raised, map);
    const auto &old_axis = map.axis(a), &axis = raised.axis(a);
    EXPECT_EQ(axis.degree, old_axis.degree + by);
    EXPECT_EQ(axis.is_periodic, old_axis.is_periodic);
    for (const Rational& u : internal::breaks_of(old_axis))
      if (old_axis.domain_begin() < u && u < old_axis.domain_end()) {
        EXPECT_EQ(multiplicity(axis, u), multiplicity(old_axis, u) + by);
      }
    if (multiplicity(old_axis, old_axis.domain_begin()) == old_axis.degree + 1) {
      EXPECT_EQ(multiplicity(axis, axis.domain_begin()), axis.degree + 1);
    }
  });
}

TEST(BSplineLaw, ElevationOfABezierMapIsThatOfItsCoefficients) {
  for_loops(250, 20, [](Random& random) {
    auto map = draw_bezier<2>(random, 4, 2);
    map = elevate(elevate(map, 0, 1), 1, 1);
    EXPECT_EQ(elevate(to_bspline(map), 1, 3), to_bspline(elevate(map, 1, 3))) << text_of(map);
  });
}

TEST(BSplineLaw, RestrictedAndClampedMapsAreTheMap) {
  for_all_dimensions(260, 40, [](Random& random, auto n) {
    const auto map = draw_bspline<n>(random, 3, 2);
    SCOPED_TRACE(text_of(map));
    auto low = draw_point(random, map), high = draw_point(random, map);
    for (std::size_t a = 0; a < n; ++a) {
      if (high[a] < low[a]) std::swap(low[a], high[a]);
      if (low[a] == high[a])
        low[a] = map.axis(a).domain_begin(), high[a] = map.axis(a).domain_end();
    }
    const auto part = restricted(map, low, high);
    ASSERT_TRUE(part);
    expect_valid(part.value());
    for (std::size_t a = 0; a < n; ++a) {
      EXPECT_EQ(part.value().axis(a).domain_begin(), low[a]);
      EXPECT_EQ(multiplicity(part.value().axis(a), high[a]), map.axis(a).degree + 1);
    }
    for (int i = 0; i < 4; ++i) {
      auto at = draw_point(random, part.value());
      for (std::size_t a = 0; a < n; ++a)  // from the left the map may have another value
        if (at[a] == high[a]) at[a] = (low[a] + high[a]) * fraction(1, 2);
      EXPECT_EQ(evaluate(part.value(), at).value(), evaluate(map, at).value());
    }
    auto all = map;
    for (std::size_t a = 0; a < n; ++a) all = clamped(all, a);
    expect_valid(all);
    expect_same_map(all, map);
  });
}

TEST(BSplineLaw, MirroredReversedMovedAndPermutedMapsTakeTheValuesOfTheMap) {
  for_all_dimensions(270, 40, [](Random& random, auto n) {
    auto map = draw_bspline<n>(random, 3, 2);
    SCOPED_TRACE(text_of(map));
    const std::size_t a = random.below(n), b = random.below(n);
    const Rational begin = map.axis(a).domain_begin(), end = map.axis(a).domain_end();
    const auto back = reversed(map, a), mirror = mirrored(map, a);
    expect_valid(back), expect_valid(mirror);
    EXPECT_EQ(reversed(back, a), map);
    EXPECT_EQ(mirrored(mirror, a), map);
    EXPECT_EQ(with_domain(mirror, a, begin, end).value(), back);
    const Rational low = draw_rational(random), high = low + draw_positive(random);
    const auto moved = with_domain(map, a, low, high).value();
    expect_valid(moved);
    EXPECT_EQ(with_domain(moved, a, begin, end).value(), map);
    auto at = draw_point(random, map), to = at;
    to[a] = low + (at[a] - begin) / (end - begin) * (high - low);
    EXPECT_EQ(evaluate(moved, to).value(), evaluate(map, at).value());
    to = at, std::swap(to[a], to[b]);
    EXPECT_EQ(evaluate(swapped(map, a, b), to).value(), evaluate(map, at).value());
    // Where the map does not jump: not at a knot, where limits from the right and from the left are exchanged.
    at[a] = begin + fraction(random.between(1, 996), 997) * (end - begin);
    to = at, to[a] = begin + end - at[a];
    EXPECT_EQ(evaluate(back, to).value(), evaluate(map, at).value());
  });
}

TEST(BSplineLaw, IsoparametricMapsFixOneVariable) {
  for_loops(280, 30, [](Random& random) {
    const auto volume = draw_bspline<3>(random, 3, 3, true);
    SCOPED_TRACE(text_of(volume));
    const auto at = draw_point(random, volume);
    const auto expected = evaluate(volume, at).value();
    const auto x = isoparametric(volume, 0, at[0]).value(),
               y = isoparametric(volume, 1, at[1]).value(),
               z = isoparametric(volume, 2, at[2]).value();
    expect_valid(x), expect_valid(y), expect_valid(z);
    EXPECT_EQ(evaluate(x, {at[1], at[2]}).value(), expected);
    EXPECT_EQ(evaluate(y, {at[0], at[2]}).value(), expected);
    EXPECT_EQ(evaluate(isoparametric(z, 1, at[1]).value(), {at[0]}).value(), expected);
  });
}

// The pieces of the derivative are the derivatives of the pieces, over the lengths of their cells.
template <std::size_t N>
void expect_derivative(const BSpline<Rational, N>& map, std::size_t axis,
                       const BSpline<Rational, N>& derived) {
  const auto x = bezier_pieces(map), y = bezier_pieces(derived);
  ASSERT_EQ(x.breaks, y.breaks);
  for (std::size_t i = 0; i < x.pieces.size(); ++i) {
    const std::size_t cell = x.grid().index_of(i)[axis];
    auto expected = derivative(x.pieces[i], axis);
    for (int c = 0; c < expected.dimension(); ++c)
      for (Rational& v : expected.component(c))
        v /= x.breaks[axis][cell + 1] - x.breaks[axis][cell];
    const auto [v, w] = to_common_degrees(y.pieces[i], expected);
    EXPECT_EQ(v, w) << "piece " << i << " of " << text_of(map);
  }
}

TEST(BSplineLaw, DerivativeIsThatOfThePieces) {
  for_all_dimensions(290, 60, [](Random& random, auto n) {
    const auto map = draw_bspline<n>(random, 4, 2);
    SCOPED_TRACE(text_of(map));
    const std::size_t a = random.below(n);
    const auto derived = derivative(map, a);
    if (derived.axis(a).degree > 0) expect_valid(derived);
    EXPECT_EQ(derived.axis(a).is_periodic, map.axis(a).is_periodic);
    expect_derivative(map, a, derived);
  });
}

TEST(BSplineLaw, DerivativeOfARationalMapIsThatOfThePiecesWithKnotsAsItsSmoothnessNeeds) {
  for_all_dimensions(300, 24, [](Random& random, auto n) {
    const auto map = draw_bspline<n>(random, n == 3 ? 2 : 3, 3, true);
    SCOPED_TRACE(text_of(map));
    const std::size_t a = random.below(n);
    const auto derived = derivative(map, a);
    expect_valid(derived);  // weights too: they are means of products of positive ones
    expect_derivative(map, a, derived);
    for (std::size_t b = 0; b < n; ++b)
      for (const Rational& u : internal::breaks_of(map.axis(b)))
        if (map.axis(b).domain_begin() < u && u < map.axis(b).domain_end()) {
          EXPECT_EQ(multiplicity(derived.axis(b), u),
                    std::min(map.axis(b).degree + multiplicity(map.axis(b), u) + (a == b ? 1 : 0),
                             derived.axis(b).degree + 1));
        }
  });
}

TEST(BSplineLaw, KnotsThatWereInsertedCanBeRemovedAndNoOthers) {
  for_all_dimensions(310, 30, [](Random& random, auto n) {
    auto map = draw_bspline<n>(random, 3, 2);
    const std::size_t a = random.below(n);
    map = clamped(map, a);
    SCOPED_TRACE(text_of(map));
    Values knots;
    for (const Rational& u : draw_knots(random, map.axis(a)))
      if (map.axis(a).domain_begin() < u && u < map.axis(a).domain_end()) knots.push_back(u);
    const auto back = without_knots(refine(map, a, knots), a, knots);
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(back.value(), map);
    for (const Rational& u : internal::breaks_of(map.axis(a)))
      if (map.axis(a).domain_begin() < u && u < map.axis(a).domain_end()) {
        const auto refused = without_knots(map, a, {u});
        ASSERT_FALSE(refused);  // random control points: no map with fewer knots
        EXPECT_EQ(refused.error().code, Code::kLossy);
        EXPECT_NE(refused.error().message.find(u.to_string()), std::string::npos);
      }
  });
}

TEST(BSplineLaw, EqualMapsHaveEqualCoefficientsOnCommonAxes) {
  for_all_dimensions(315, 24, [](Random& random, auto n) {
    const auto map = draw_bspline<n>(random, 3, 2);
    SCOPED_TRACE(text_of(map));
    auto a = map, b = map;
    for (std::size_t axis = 0; axis < n; ++axis) {
      a = elevate(refine(a, axis, draw_knots(random, a.axis(axis))), axis, draw_int(random, 0, 2));
      b = refine(elevate(b, axis, draw_int(random, 0, 2)), axis, draw_knots(random, b.axis(axis)));
    }
    const auto common = to_common_axes(a, b);
    ASSERT_TRUE(common);
    expect_valid(common->first);
    EXPECT_EQ(common->first, common->second);
    auto other = clamped(b, 0);
    other.coefficients()[random.below(other.coefficients().size())] += Rational(1);
    if constexpr (n == 1) {  // clamped: every control point counts
      const auto apart = to_common_axes(a, other);
      ASSERT_TRUE(apart);
      EXPECT_NE(apart->first, apart->second);
    }
  });
}

TEST(BSplineLaw, MapsOnDifferentDomainsHaveNoCommonAxes) {
  const auto line = to_bspline(Bezier<Rational, 1>({1}, 1, false));
  const auto longer = with_domain(line, 0, fraction(0), fraction(3, 2)).value();
  const auto common = to_common_axes(line, longer);
  ASSERT_FALSE(common);
  EXPECT_EQ(common.error().code, Code::kBadArgument);
  EXPECT_EQ(common.error().message,
            "axis 0: the domain of one map ends at 1, that of the other at 3/2");
}

TEST(BSplineLaw, AffineMapsActOnPoints) {
  for_loops(320, 20, [](Random& random) {
    const auto map = draw_bspline<2>(random, 3, 3, true);
    AffineMap affine{1, 2, {draw_rational(random), draw_rational(random)}, {draw_rational(random)}};
    const auto at = draw_point(random, map);
    const Values x = point(map, at).value(), y = point(transformed(map, affine), at).value();
    EXPECT_EQ(y,
              (Values{affine.linear[0] * x[0] + affine.linear[1] * x[1] + affine.translation[0]}))
        << text_of(map);
  });
}

// Knots that are small fractions: numbers of many digits would make it a test of GMP.
TEST(BSplineLaw, DegreeSixtyThreeWorks) {
  Random random(330);
  const int p = kMaxSplineDegree;
  for (const Ends ends : {Ends::kClamped, Ends::kUnclamped, Ends::kPeriodic}) {
    // Three spans; unclamped: two different knots outside of them on either side; periodic: knots of multiplicity 31 to 33.
    KnotAxis<Rational> axis{p, {}, ends == Ends::kPeriodic};
    const auto add = [&axis](int knot, int times) {
      axis.knots.insert(axis.knots.end(), static_cast<std::size_t>(times), Rational(knot));
    };
    if (ends == Ends::kClamped) add(0, p + 1), add(1, 1), add(2, p + 1), add(3, p + 1);
    if (ends == Ends::kUnclamped)
      add(-2, 32), add(-1, 31), add(0, 1), add(1, 30), add(2, 1), add(3, 1), add(4, 32), add(5, 31);
    if (ends == Ends::kPeriodic)
      add(-2, 32), add(-1, 31), add(0, 33), add(1, 32), add(2, 31), add(3, 33), add(4, 31);
    BSpline<Rational, 1> map({axis}, 1, false,
                             draw_coefficients(random, axis.num_control(), 1, false));
    close_periodic(map);
    SCOPED_TRACE(text_of(map));
    expect_valid(map);
    const auto at = draw_point(random, map);
    const Values expected = evaluate(map, at).value();
    EXPECT_EQ(evaluate(clamped(map, 0), at).value(), expected);
    EXPECT_EQ(evaluate(elevate(map, 0, 1), at).value(), expected);
    expect_derivative(map, 0, derivative(map, 0));
  }
}

TEST(BSplineLaw, ElevationOfUnclampedMapsOfHigherDegreesLeavesTheMapUnchanged) {
  Random random(340);
  for (const int degree : {8, 15, 24}) {
    const auto axis = draw_axis(random, degree, Ends::kUnclamped);
    const BSpline<Rational, 1> map({axis}, 1, false,
                                   draw_coefficients(random, axis.num_control(), 1, false));
    const auto raised = elevate(map, 0, 1);
    expect_valid(raised);
    expect_same_map(raised, map);
  }
}

}  // namespace
}  // namespace veritope
