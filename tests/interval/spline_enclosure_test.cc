// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/enclosure/spline_enclosure.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

#include "interval/enclosure/bernstein_box.h"
#include "interval/enclosure/range_enclosure.h"
#include "interval/enclosure/surface_enclosure.h"
#include "tests/interval/exact_jets.h"

namespace veritope {
namespace {

using exact_jets::Bracket;
using exact_jets::holds;
using exact_jets::PieceJets;
using exact_map::random_bspline;
using exact_map::Shape;

constexpr EnclosureForm kForms[] = {EnclosureForm::kHull, EnclosureForm::kMeanValue,
                                    EnclosureForm::kBoth};

template <std::size_t N>
Box<N> draw_box(Random& random, const Box<N>& domain) {
  Box<N> out;
  for (std::size_t a = 0; a < N; ++a) {
    const double lo = domain[a].lo(), size = domain[a].hi() - lo;
    const double width =
        random.below(6) == 0 ? 0 : size * std::pow(2.0, -static_cast<double>(random.below(12)));
    const double begin = lo + (size - width) * random.unit();
    out[a] = Interval::from_bounds(begin, std::min(begin + width, domain[a].hi()));
  }
  return out;
}
// A member, a corner now and then.
template <std::size_t N>
std::array<double, N> draw_member(Random& random, const Box<N>& box) {
  std::array<double, N> out;
  for (std::size_t a = 0; a < N; ++a) {
    const double t = random.unit(), lo = box[a].lo(), hi = box[a].hi();
    const auto kind = random.below(4);
    out[a] = kind == 0 ? lo : kind == 1 ? hi : std::min(std::max(lo + t * (hi - lo), lo), hi);
  }
  return out;
}

template <std::size_t N>
struct Located {
  PieceJets<N> jets;
  std::array<Rational, N> local;
};
template <std::size_t N>
Located<N> locate(const BezierPieces<Rational, N>& pieces, const std::array<double, N>& at,
                  int order) {
  std::array<std::size_t, N> cell;
  std::array<Rational, N> length, local;
  for (std::size_t a = 0; a < N; ++a) {
    const auto& b = pieces.breaks[a];
    const Rational u = Rational::from_double(at[a]);
    cell[a] = 0;
    while (cell[a] + 2 < b.size() && b[cell[a] + 1] <= u) ++cell[a];
    length[a] = b[cell[a] + 1] - b[cell[a]];
    local[a] = (u - b[cell[a]]) / length[a];
  }
  return {PieceJets<N>(pieces.at(cell), length, order), local};
}

template <std::size_t N>
void try_values(std::uint64_t seed, int loops, int max_degree) {
  Random random(seed);
  for (int loop = 0; loop < loops; ++loop) {
    Shape<N> shape;
    for (std::size_t a = 0; a < N; ++a) {
      shape.degrees[a] = 1 + static_cast<int>(random.below(static_cast<std::uint64_t>(max_degree)));
      shape.spans[a] = 1 + random.below(3);
    }
    shape.is_rational = random.below(2) == 0;
    shape.num_components = 2 + (shape.is_rational ? 1 : 0);
    const auto map = random_bspline<N>(random, shape, 7, 30);
    const auto pieces = bezier_pieces(map);
    const auto enclosure = SplineEnclosure<N>::prepare(map, 3).value();
    for (int k = 0; k < 4; ++k) {
      const Box<N> box = draw_box(random, enclosure.domain());
      for (int point = 0; point < 3; ++point) {
        const auto located = locate(pieces, draw_member(random, box), 2);
        for (const auto& [order, values] : located.jets.at(located.local))
          for (const EnclosureForm form : kForms) {
            int total = 0;
            for (const int o : order) total += o;
            if (total > 2) continue;
            const auto enclosed = enclosure.derivative(order, box, form).value();
            for (std::size_t c = 0; c < values.size(); ++c)
              ASSERT_TRUE(holds(enclosed[c], Bracket(values[c])))
                  << "seed " << seed << " loop " << loop << " form " << static_cast<int>(form)
                  << " order " << order[0] << ": " << to_string(enclosed[c]) << " misses "
                  << values[c].to_string();
          }
      }
    }
  }
}
TEST(SplineEnclosure, HoldsValuesAndDerivativesOfCurves) { try_values<1>(1, 40, 5); }
TEST(SplineEnclosure, HoldsValuesAndDerivativesOfSurfaces) { try_values<2>(2, 12, 3); }
TEST(SplineEnclosure, HoldsValuesAndDerivativesOfVolumes) { try_values<3>(3, 4, 2); }

TEST(SplineEnclosure, HoldsEverySelectionOfControlBoxes) {
  Random random(4);
  for (int loop = 0; loop < 20; ++loop) {
    const bool is_rational = loop % 2 == 1;
    const auto map =
        random_bspline<2>(random, {{2, 3}, {2, 2}, 2 + is_rational, is_rational}, 8, 16);
    std::vector<Interval> boxes;
    BSpline<Rational, 2> chosen = map;
    for (Rational& v : chosen.coefficients()) {
      const auto low = random.below(3), high = random.below(3), here = random.below(low + high + 1);
      const double x = nearest_double(v);  // exact: sixteenths
      boxes.push_back(Interval::from_bounds(x - 0.125 * static_cast<double>(low),
                                            x + 0.125 * static_cast<double>(high)));
      v += (Rational(here) - Rational(low)) / Rational(8);
    }
    const std::size_t count = map.grid().count();
    if (is_rational)  // weights in [1/2, 4] stay positive only without their boxes
      for (std::size_t i = 2 * count; i < 3 * count; ++i)
        boxes[i] = enclose(chosen.coefficients()[i] = map.coefficients()[i]);
    const auto enclosure =
        SplineEnclosure<2>::prepare(
            BSpline<Interval, 2>(map.axes(), map.num_components(), is_rational, boxes), 2)
            .value();
    const auto pieces = bezier_pieces(chosen);
    for (int k = 0; k < 5; ++k) {
      const Box2 box = draw_box(random, enclosure.domain());
      const auto located = locate(pieces, draw_member(random, box), 1);
      for (const auto& [order, values] : located.jets.at(located.local))
        for (const EnclosureForm form : kForms) {
          const auto enclosed = enclosure.derivative(order, box, form).value();
          for (std::size_t c = 0; c < values.size(); ++c)
            ASSERT_TRUE(holds(enclosed[c], Bracket(values[c]))) << "loop " << loop;
        }
    }
  }
}

TEST(SurfaceEnclosure, HoldsNormalsConesAndCurvatures) {
  Random random(5);
  int bounded = 0, cones = 0;
  for (int loop = 0; loop < 30; ++loop) {
    const bool is_rational = loop % 3 == 2;
    auto map =
        random_bspline<2>(random, {{2 + loop % 2, 3}, {2, 1}, 3 + is_rational, is_rational}, 8, 16);
    // Near a graph, so that normals exist: x and y by their columns.
    const Grid<2> grid = map.grid();
    for (std::size_t i = 0; i < grid.count(); ++i) {
      const Rational w = is_rational ? map.component(3)[i] : Rational(1);
      map.component(0)[i] = w * Rational(4 * (i / grid.size[1])),
      map.component(1)[i] = w * Rational(4 * (i % grid.size[1]));
    }
    const auto surface = SplineEnclosure<2>::prepare(map, 3).value();
    const auto pieces = bezier_pieces(map);
    for (int k = 0; k < 6; ++k) {
      const Box2 box = draw_box(random, surface.domain());
      const auto cone = enclose_normal_cone(surface, box).value();
      cones += cone.has_value();
      for (int point = 0; point < 4; ++point) {
        const auto located = locate(pieces, draw_member(random, box), 2);
        const auto shape = exact_jets::shape_of(located.jets.at(located.local));
        for (const EnclosureForm form : kForms) {
          const auto normal = enclose_normal(surface, box, form).value();
          for (std::size_t c = 0; c < 3; ++c)
            ASSERT_TRUE(holds(normal[c], Bracket(shape.normal[c]))) << loop;
          const auto curvature = enclose_curvatures(surface, box, form).value();
          bounded += is_common(curvature.gauss);
          ASSERT_TRUE(holds(curvature.gauss, Bracket(shape.gauss))) << loop;
          const auto range = [](const auto& p) { return Bracket(p.first, p.second); };
          ASSERT_TRUE(holds(curvature.mean, range(shape.mean), false)) << loop;
          ASSERT_TRUE(holds(curvature.principal_min, range(shape.principal_min), false)) << loop;
          ASSERT_TRUE(holds(curvature.principal_max, range(shape.principal_max), false)) << loop;
        }
        if (!cone) continue;
        exact_jets::Vector axis;
        for (std::size_t c = 0; c < 3; ++c) axis[c] = Rational::from_double(cone->axis[c]);
        const Rational along = exact_jets::dot(shape.normal, axis),
                       limit = Rational::from_double(cone->tangent) * along;
        const auto across = exact_jets::cross(shape.normal, axis);
        ASSERT_GE(along, Rational());
        ASSERT_LE(exact_jets::dot(across, across), limit * limit);
      }
    }
  }
  EXPECT_GT(bounded, 500);
  EXPECT_GT(cones, 60);  // it is no test of [-inf, inf]
}

// PROVES ENCLOSE-2, ENCLOSE-2.CURVATURE
TEST(SurfaceEnclosure, ConesOfACylinderSpanItsAngle) {
  // A quarter of a cylinder, rational: normals turn by 90 degrees; from the bisector 45.
  const auto u = make_knot_axis(2, {0, 0, 0, 1, 1, 1}).value(),
             v = make_knot_axis(1, {0, 0, 1, 1}).value();
  // (1 - t^2, 2t) / (1 + t^2), weights 1, 1, 2; the second axis is z.
  const BSplineSurface<Rational> map(
      {u, v}, 4, true, {1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 2, 2, 0, 1, 0, 1, 0, 2, 1, 1, 1, 1, 2, 2});
  const auto surface = SplineEnclosure<2>::prepare(map, 3).value();
  const auto whole = enclose_normal_cone(surface, surface.domain()).value();
  ASSERT_TRUE(whole);
  EXPECT_GT(whole->tangent, 0.99);
  EXPECT_LT(whole->tangent, 3.0);
  const Box2 small(Interval::from_bounds(0.5, 0.5009765625), Interval::from_bounds(0, 1));
  const auto k = enclose_curvatures(surface, small).value();
  EXPECT_TRUE(contains(k.gauss, Rational()));
  EXPECT_LT(mag(k.gauss), 1e-2);
  EXPECT_LT(std::abs(std::abs(mid(k.mean)) - 0.5), 1e-2);
  const ScopedUpward upward;
  EXPECT_TRUE(are_within_right_angle(enclose_normal_cone(surface, small).value().value(),
                                     enclose_normal_cone(surface, small).value().value()));
  EXPECT_FALSE(are_within_right_angle({{1, 0, 0}, 0.5}, {{0, 1, 0}, 0.0}));
  EXPECT_FALSE(are_within_right_angle({{1, 0, 0}, 1.0}, {{1, 0, 0}, 1.0}));
  EXPECT_TRUE(are_within_right_angle({{1, 0, 0}, 0.99}, {{1, 0, 0}, 0.99}));
}

TEST(SurfaceEnclosure, ASingularPointInTheMiddleLeavesCurvaturesUnbounded) {
  // (u^2, v^2, u v), a cone, with its tip at the middle of the box: regular all around it.
  const auto u = make_knot_axis(2, {-1, -1, -1, 1, 1, 1}).value();
  const BSplineSurface<Rational> map(
      {u, u}, 3, false,
      {1, 1, 1, -1, -1, -1, 1, 1, 1, 1, -1, 1, 1, -1, 1, 1, -1, 1, 1, 0, -1, 0, 0, 0, -1, 0, 1});
  const auto surface = SplineEnclosure<2>::prepare(map, 3).value();
  const Box2 box(Interval::from_bounds(-0.25, 0.25), Interval::from_bounds(-0.25, 0.25));
  for (const auto form : {EnclosureForm::kHull, EnclosureForm::kMeanValue, EnclosureForm::kBoth}) {
    const auto k = enclose_curvatures(surface, box, form).value();
    EXPECT_TRUE(contains(k.gauss, Rational()));
    EXPECT_FALSE(k.mean.is_empty());
  }
}

TEST(SurfaceEnclosure, NoConeWhereThereIsNoNormal) {
  const auto u = make_knot_axis(1, {0, 0, 1, 1}).value();
  // A collapsed edge is legal: v = 0 is one point.
  const BSplineSurface<Rational> map({u, u}, 3, false, {0, 0, 0, 1, 0, 1, 0, 0, 0, 1, 0, 2});
  const auto surface = SplineEnclosure<2>::prepare(map, 3).value();
  EXPECT_TRUE(enclose_normal_cone(surface, surface.domain())
                  .value());  // flat: zero coefficients are in every cone
  EXPECT_FALSE(is_common(enclose_curvatures(surface, surface.domain()).value().mean));
  const BSplineSurface<Rational> folded({u, u}, 3, false, {0, 1, 1, 0, 0, 1, 0, 1, 0, 0, 0, 0});
  EXPECT_FALSE(enclose_normal_cone(SplineEnclosure<2>::prepare(folded, 1).value(), surface.domain())
                   .value());
}

// Excess over the exact range of t^2 - t on boxes around its turning point, where the range is known: [-1/4, ...].
// PROVES ENCLOSE-1, ENCLOSE-1.HULL, ENCLOSE-1.MEAN
TEST(SplineEnclosure, HullAndMeanValueConvergeQuadratically) {
  const auto axis = make_knot_axis(2, {0, 0, 0, 1, 1, 1}).value();
  const BSplineCurve<Rational> map({axis}, 1, false, {0, Rational(-1) / Rational(2), 0});
  const auto enclosure = SplineEnclosure<1>::prepare(map, 3).value();
  for (const EnclosureForm form : {EnclosureForm::kHull, EnclosureForm::kMeanValue}) {
    double before = 0;
    for (int k = 3; k < 10; ++k) {
      const double d = std::ldexp(1.0, -k), lo = 0.5 - d, hi = 0.5 + 2 * d;
      const auto box = enclosure.value(Box<1>(Interval::from_bounds(lo, hi)), form).value()[0];
      const double excess = wid(box) - 4 * d * d;  // range [-1/4, -1/4 + 4 d^2]
      EXPECT_LE(box.lo(), -0.25) << "the turning point lies between the ends of the box";
      EXPECT_GE(box.hi(), -0.25 + 4 * d * d);
      if (k > 3) {
        EXPECT_NEAR(std::log2(before / excess), 2, 0.1);
      }
      before = excess;
    }
  }
}

// t / (1 + t): the derivatives rise or fall over [0, 1], so their ranges are those between the values at the ends.
// PROVES ENCLOSE-1.RATIONAL
TEST(SplineEnclosure, HoldsTheRangesOfARationalCurve) {
  const auto axis = make_knot_axis(1, {0, 0, 1, 1}).value();
  const BSplineCurve<Rational> map({axis}, 2, true, {0, 1, 1, 2});
  const auto enclosure = SplineEnclosure<1>::prepare(map, 3).value();
  const std::array<Interval, 3> exact{Interval::from_bounds(0, 0.5), Interval::from_bounds(0.25, 1),
                                      Interval::from_bounds(-2, -0.25)};
  for (const EnclosureForm form : {EnclosureForm::kHull, EnclosureForm::kMeanValue})
    for (int order = 0; order < 3; ++order) {
      const auto found = enclosure.derivative({order}, enclosure.domain(), form).value()[0];
      EXPECT_TRUE(is_subset(exact[static_cast<std::size_t>(order)], found))
          << "order " << order << ": " << to_string(found);
      EXPECT_LT(mag(found), 100);
    }
}

TEST(RangeEnclosure, ReachesTheWantedExcess) {
  Random random(6);
  const auto map = random_bspline<2>(random, {{3, 3}, {2, 2}, 3, false}, 8, 16);
  const auto enclosure = SplineEnclosure<2>::prepare(map, 3).value();
  const auto values = [&](const Box2& b) { return enclosure.value(b, EnclosureForm::kHull); };
  const auto range = narrowed_range<2>(enclosure.domain(), 1e-4, 5000, values).value();
  ASSERT_TRUE(range.is_reached);
  EXPECT_LE(range.excess, 1e-4);
  std::array<Interval, 3> sampled;
  sampled.fill(Interval::empty());
  const Box2 d = enclosure.domain();
  for (int i = 0; i <= 200; ++i)
    for (int j = 0; j <= 200; ++j) {
      const auto at = [](const Interval& side, int k) {
        return Interval(std::min(side.hi(), side.lo() + (side.hi() - side.lo()) * k / 200));
      };
      const auto v = values(Box2(at(d[0], i), at(d[1], j))).value();
      for (std::size_t c = 0; c < 3; ++c) sampled[c] = hull(sampled[c], v[c]);
    }
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_TRUE(is_subset(sampled[c], Interval::from_bounds(range.outer[c].lo() - 1e-13,
                                                            range.outer[c].hi() + 1e-13)));
    EXPECT_LT(wid(range.outer[c]) - wid(sampled[c]), 0.1);  // the grid is coarse
  }
  const auto few = narrowed_range<2>(enclosure.domain(), 1e-12, 20, values).value();
  EXPECT_FALSE(few.is_reached);
  EXPECT_EQ(few.boxes, 20u);
  EXPECT_EQ(narrowed_range<2>(enclosure.domain(), 0, 20, values).error().code, Code::kBadArgument);
  EXPECT_EQ(narrowed_range<2>(Box2::empty(), 1, 20, values).error().code, Code::kBadArgument);
}

TEST(SplineEnclosure, RefusesBadBoxesOrdersAndWeights) {
  const auto axis = make_knot_axis(1, {0, 0, 1, 1}).value();
  const BSplineCurve<Rational> map({axis}, 1, false, {0, 1});
  const auto enclosure = SplineEnclosure<1>::prepare(map, 1).value();
  const auto code = [](const auto& result) {
    return result.has_value() ? Code::kEmpty : result.error().code;
  };
  EXPECT_EQ(code(enclosure.value(Box<1>(Interval::from_bounds(0, 1)))), Code::kEmpty);  // no error
  EXPECT_EQ(code(enclosure.value(Box<1>(Interval::from_bounds(0, 1.5)))), Code::kBadArgument);
  EXPECT_EQ(code(enclosure.value(Box<1>::empty())), Code::kBadArgument);
  EXPECT_EQ(code(enclosure.value(Box<1>::entire())), Code::kBadArgument);
  EXPECT_EQ(code(enclosure.derivative({1}, enclosure.domain(), EnclosureForm::kMeanValue)),
            Code::kBadArgument);
  EXPECT_EQ(code(enclosure.derivative({1}, enclosure.domain(), EnclosureForm::kHull)),
            Code::kEmpty);
  EXPECT_EQ(code(enclosure.derivative({-1}, enclosure.domain())), Code::kBadArgument);
  EXPECT_EQ(code(SplineEnclosure<1>::prepare(map, 4)), Code::kBadArgument);
  EXPECT_EQ(
      code(SplineEnclosure<1>::prepare(BSplineCurve<Rational>({axis}, 2, true, {0, 1, 1, 0}), 1)),
      Code::kBadArgument);
  const Interval mixed = Interval::from_bounds(-1, 1), one(1.0);
  EXPECT_EQ(code(SplineEnclosure<1>::prepare(
                BSplineCurve<Interval>({axis}, 2, true, {one, one, one, mixed}), 1)),
            Code::kBadArgument);
  const auto flat =
      SplineEnclosure<2>::prepare(BSplineSurface<Rational>({axis, axis}, 1, false, {0, 1, 2, 3}), 3)
          .value();
  EXPECT_EQ(code(enclose_normal(flat, flat.domain())), Code::kBadArgument);
  EXPECT_EQ(code(enclose_curvatures(flat, flat.domain())), Code::kBadArgument);
  EXPECT_EQ(code(enclose_normal_cone(flat, flat.domain())), Code::kBadArgument);
}

// Both sides of a corner are inside, and the rounding mode of the caller does not matter.
// PROVES ENCLOSE-1.KNOTS
TEST(SplineEnclosure, HoldsBothSlopesAtACorner) {
  const auto axis = make_knot_axis(1, {0, 0, 1, 2, 2}).value();
  const BSplineCurve<Rational> map({axis}, 1, false, {0, 1, 0});
  const auto enclosure = SplineEnclosure<1>::prepare(map, 2).value();
  std::fesetround(FE_DOWNWARD);
  const auto slope = enclosure.derivative({1}, Box<1>(Interval(1.0))).value()[0];
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(slope, Interval::from_bounds(-1, 1));
  EXPECT_EQ(enclosure.derivative({2}, enclosure.domain(), EnclosureForm::kHull).value()[0],
            Interval());
}

// PROVES ENCLOSE-1.KNOTS
TEST(SplineEnclosure, HoldsBothSidesOfAJump) {
  const auto axis = make_knot_axis(1, {0, 0, 1, 1, 2, 2}).value();
  const auto enclosure =
      SplineEnclosure<1>::prepare(BSplineCurve<Rational>({axis}, 1, false, {0, 1, 5, 7}), 1)
          .value();
  EXPECT_EQ(enclosure.value(Box<1>(Interval(1.0))).value()[0], Interval::from_bounds(1, 5));
  EXPECT_EQ(enclosure.value(enclosure.domain()).value()[0], Interval::from_bounds(0, 7));
}

TEST(BernsteinBox, RestrictionHoldsTheRestrictedCoefficients) {
  Random random(8);
  const ScopedUpward upward;
  for (int loop = 0; loop < 200; ++loop) {
    Bezier<Rational, 1> exact({1 + static_cast<int>(random.below(8))}, 1, false);
    std::vector<Interval> rounded;
    for (Rational& v : exact.coefficients())
      v = Rational(random.between(-99, 99)) / Rational(7), rounded.push_back(enclose(v));
    double a = random.unit(), b = random.unit();
    if (loop % 5 == 0) a = 0;
    if (loop % 7 == 0) b = 1;
    if (loop % 11 == 0) b = a;
    const double lo = std::min(a, b), hi = std::max(a, b);
    const auto cut =
        on_box<1>({exact.degrees(), 1, false, rounded}, Box<1>(Interval::from_bounds(lo, hi)));
    // The right part first, which no order of the subject's can match bit for bit.
    auto truth = right_part(exact, 0, Rational::from_double(lo));
    if (lo < 1)
      truth = left_part(truth, 0,
                        (Rational::from_double(hi) - Rational::from_double(lo)) /
                            (Rational(1) - Rational::from_double(lo)));
    for (std::size_t i = 0; i < truth.coefficients().size(); ++i) {
      EXPECT_TRUE(contains(cut.coefficients()[i], truth.coefficients()[i])) << "loop " << loop;
      EXPECT_LT(wid(cut.coefficients()[i]), 1e-12);
    }
  }
}

}  // namespace
}  // namespace veritope
