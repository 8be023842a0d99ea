// SPDX-License-Identifier: LGPL-3.0-or-later
// What of an arc lies in both domains, on arcs whose equations are known.
#include "interval/intersect/intersection_clip.h"

#include <gtest/gtest.h>

#include "interval/intersect/intersection_search.h"
#include "interval/upward.h"

namespace veritope {
namespace {

Rational q(std::int64_t p, std::int64_t r = 1) { return Rational(p) / Rational(r); }

/// Bernstein coefficients over one piece, whose knots are `begin` and `end`.
BSplineSurface<Rational> surface_of(int degree, const Rational& begin, const Rational& end,
                                    const std::vector<std::array<Rational, 3>>& net) {
  KnotAxis<Rational> axis{degree, {}, false};
  axis.knots.assign(static_cast<std::size_t>(degree + 1), begin);
  axis.knots.insert(axis.knots.end(), static_cast<std::size_t>(degree + 1), end);
  std::vector<Rational> c;
  for (std::size_t k = 0; k < 3; ++k)
    for (const auto& p : net) c.push_back(p[k]);
  return BSplineSurface<Rational>({axis, axis}, 3, false, std::move(c));
}
/// z = x^2 + 2 y^2 - 1/2 over [-1, 1]^2; it meets z = 0 in an ellipse.
BSplineSurface<Rational> bowl() {
  std::vector<std::array<Rational, 3>> net;
  const std::array<Rational, 3> square{q(1), q(-1), q(1)};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      net.push_back({q(static_cast<std::int64_t>(i)) - q(1), q(static_cast<std::int64_t>(j)) - q(1),
                     square[i] + q(2) * square[j] - q(1, 2)});
  return surface_of(2, q(0), q(1), net);
}
/// z = 0 over [x0, x1] x [y0, y1].
BSplineSurface<Rational> floor_over(const Rational& x0, const Rational& x1, const Rational& y0,
                                    const Rational& y1, const Rational& end = q(1)) {
  return surface_of(1, q(0), end, {{x0, y0, q(0)}, {x0, y1, q(0)}, {x1, y0, q(0)}, {x1, y1, q(0)}});
}
/// The vertical plane through a and b.
BSplineSurface<Rational> wall_through(const std::array<Rational, 2>& a,
                                      const std::array<Rational, 2>& b) {
  return surface_of(
      1, q(0), q(1),
      {{a[0], a[1], q(-1)}, {a[0], a[1], q(1)}, {b[0], b[1], q(-1)}, {b[0], b[1], q(1)}});
}

struct Clipped {
  std::vector<DomainArc> arcs;
  std::vector<Box4> unresolved;
};
Clipped clipped(const EnclosedSurface& s1, const EnclosedSurface& s2,
                const std::vector<IntersectionTube>& tubes) {
  Clipped out;
  for (const IntersectionTube& tube : tubes)
    clip_to_domains(s1, s2, tube, &out.arcs, &out.unresolved);
  return out;
}

/// x, or y, of the parameter that is w on the tube of `bowl` and `floor_over(x0, x1, -2, 2)`.
Rational coordinate(int pivot, double w, const Rational& x0, const Rational& x1) {
  const Rational t = Rational::from_double(w);
  if (pivot < 2) return q(2) * t - q(1);
  return pivot == 2 ? x0 + (x1 - x0) * t : q(4) * t - q(2);
}

// The ellipse is cut at x = x0, by the left or the right border of the plane's domain. Every end on
// the border must enclose the place of the cut: where x is x0 exactly, or where x0^2 + 2 y^2 - 1/2
// changes its sign.
TEST(IntersectionClip, EndsOnTheBorderEncloseThePlaceOfTheCut) {
  const ScopedUpward upward;
  const auto s1 = EnclosedSurface::make(bowl());
  for (const Rational& cut :
       {q(-3, 5), q(-1, 3), q(-1, 10), q(0), q(1, 7), q(1, 2), q(2, 3), q(7, 10)})
    for (const bool is_left : {true, false}) {
      SCOPED_TRACE(cut.to_string() + (is_left ? " on the left" : " on the right"));
      const Rational x0 = is_left ? cut : q(-2), x1 = is_left ? q(2) : cut;
      const auto s2 = EnclosedSurface::make(floor_over(x0, x1, q(-2), q(2)));
      const auto cover = cover_intersection(*s1, *s2, {});
      ASSERT_TRUE(cover.undecided.empty());
      const Clipped found = clipped(*s1, *s2, cover.tubes);
      EXPECT_TRUE(found.unresolved.empty());
      int num_ends = 0;
      for (const DomainArc& arc : found.arcs) {
        EXPECT_LT(arc.begin.hi(), arc.end.lo());
        for (const bool at_end : {false, true}) {
          const Interval& place = at_end ? arc.end : arc.begin;
          if (!(at_end ? arc.ends_on_border : arc.begins_on_border)) {
            EXPECT_EQ(place, Interval(at_end ? arc.tube.w_hi : arc.tube.w_lo));
            continue;
          }
          const int pivot = arc.tube.pivot;
          const auto value = [&](double w) {
            const Rational v = coordinate(pivot, w, x0, x1);
            return pivot % 2 == 0 ? v - cut : cut * cut + q(2) * v * v - q(1, 2);
          };
          EXPECT_LE((value(place.lo()) * value(place.hi())).sign(), Sign::kZero)
              << place.lo() << " " << place.hi();
          EXPECT_LE(wid(place), 0.05);
          ++num_ends;
        }
        // No point of what is kept lies beyond the border.
        for (const double t : {0.02, 0.5, 0.98}) {
          const double w = arc.begin.hi() + t * (arc.end.lo() - arc.begin.hi());
          const Interval s = locate(*s1, *s2, arc.tube, w)[2];
          EXPECT_TRUE(s.hi() > 0 && s.lo() < 1);
        }
      }
      // One branch enters and leaves; tubes that overlap there name its ends more than once.
      EXPECT_GE(num_ends, 2);
    }
}

TEST(IntersectionClip, DomainsAreThoseOfTheirOwnSurfaces) {
  const auto s1 = EnclosedSurface::make(floor_over(q(-2), q(2), q(-2), q(2), q(3)));
  const auto s2 = EnclosedSurface::make(floor_over(q(-2), q(2), q(-2), q(2), q(5)));
  for (std::size_t i = 0; i < 4; ++i) {
    const EnclosedSurface& own = i < 2 ? *s1 : *s2;
    EXPECT_EQ(parameter_domain(*s1, *s2, i),
              Interval::from_bounds(own.domain_begin(i % 2), own.domain_end(i % 2)));
  }
  EXPECT_NE(parameter_domain(*s1, *s2, 1), parameter_domain(*s1, *s2, 2));
}

/// The tube of a wall and of the floor over [-2, 2]^2, both continued: (u, v) = (x + 2, y + 2) / 4,
/// s runs from a to b. The pivot is s, from `lo` to `hi`.
IntersectionTube tube_of_line(const EnclosedSurface& floor, const EnclosedSurface& wall,
                              const std::array<double, 2>& a, const std::array<double, 2>& b,
                              double lo, double hi) {
  IntersectionTube region;
  const double middle = 0.5 * (lo + hi);
  region.pivot = 2;
  region.w_lo = lo, region.w_hi = hi;
  const double du = (b[0] - a[0]) / 4, dv = (b[1] - a[1]) / 4;
  region.slope = {du, dv, 1, 0};
  region.center = {(a[0] + 2) / 4 + du * middle, (a[1] + 2) / 4 + dv * middle, middle, 0.5};
  for (std::size_t i = 0; i < 4; ++i)
    region.offset[i] = i == 2 ? Interval(0.0) : Interval::from_bounds(-0x1p-20, 0x1p-20);
  // Columns u, v, -t: (4, 0, 0), (0, 4, 0), (0, 0, -2).
  region.inverse = {{{0.25, 0, 0}, {0, 0.25, 0}, {0, 0, -0.5}}};
  region.direction = 1;
  const auto tube = find_tube(floor, wall, region, 0);
  EXPECT_TRUE(tube.has_value());
  return *tube;
}
Clipped clipped_line(const std::array<std::int64_t, 2>& a, const std::array<std::int64_t, 2>& b,
                     std::int64_t per, double lo, double hi) {
  const auto floor = EnclosedSurface::make(floor_over(q(-2), q(2), q(-2), q(2)));
  const auto wall = EnclosedSurface::make(
      wall_through({q(a[0], per), q(a[1], per)}, {q(b[0], per), q(b[1], per)}));
  const auto at = [&](std::int64_t v) { return static_cast<double>(v) / static_cast<double>(per); };
  return clipped(*floor, *wall,
                 {tube_of_line(*floor, *wall, {at(a[0]), at(a[1])}, {at(b[0]), at(b[1])}, lo, hi)});
}

TEST(IntersectionClip, AnArcInBothDomainsIsKeptWhole) {
  const ScopedUpward upward;
  const Clipped inside = clipped_line({-1, -1}, {1, 1}, 1, 0.25, 0.75);
  EXPECT_TRUE(inside.unresolved.empty());
  ASSERT_EQ(inside.arcs.size(), 1u);
  EXPECT_EQ(inside.arcs[0].begin, Interval(0.25));
  EXPECT_EQ(inside.arcs[0].end, Interval(0.75));
  EXPECT_FALSE(inside.arcs[0].begins_on_border || inside.arcs[0].ends_on_border);
}

TEST(IntersectionClip, AnArcOutsideOfADomainIsDropped) {
  const ScopedUpward upward;
  const auto expect_none = [](const Clipped& found) {
    EXPECT_TRUE(found.arcs.empty() && found.unresolved.empty());
  };
  expect_none(clipped_line({3, -1}, {3, 1}, 1, 0.25, 0.75));    // along the border
  expect_none(clipped_line({-1, -3}, {1, -3}, 1, 0.25, 0.75));  // along another
  expect_none(clipped_line({3, -1}, {5, 1}, 1, 0.25, 0.75));
  // Past a corner: each parameter lies in its domain somewhere, both together nowhere.
  expect_none(clipped_line({1, 4}, {4, 1}, 1, 0.125, 0.875));
  expect_none(clipped_line({-4, 1}, {-1, 4}, 1, 0.125, 0.875));
}

TEST(IntersectionClip, AnArcThroughTheCornerAloneIsNotDecided) {
  const ScopedUpward upward;
  const Clipped found = clipped_line({1, 3}, {3, 1}, 1, 0.125, 0.875);
  EXPECT_TRUE(found.arcs.empty());
  EXPECT_FALSE(found.unresolved.empty());
}

// Whether an arc that ends on the border holds the border's point is not known: a neighbouring tube decides.
TEST(IntersectionClip, ATubeThatEndsOnTheBorderIsNotDecidedThere) {
  const ScopedUpward upward;
  // x = (6 s - 8) / 3 is -2 at s = 1/3, and x = (8 - 6 s) / 3 is 2 there; both as near as doubles come.
  for (const bool from_left : {true, false})
    for (const bool begins : {true, false}) {
      const std::int64_t sign = from_left ? 1 : -1;
      const double third = 1.0 / 3;
      const Clipped found = clipped_line({-8 * sign, 0}, {-2 * sign, 0}, 3, begins ? third : 0.125,
                                         begins ? 0.75 : third);
      EXPECT_TRUE(found.arcs.empty()) << from_left << begins;
      EXPECT_FALSE(found.unresolved.empty()) << from_left << begins;
    }
}

TEST(IntersectionClip, AnArcThatCrossesTwoBordersIsCutTwice) {
  const ScopedUpward upward;
  // x = 6 s - 3: inside from s = 1/6 to s = 5/6.
  for (const std::int64_t sign : {1, -1}) {
    const Clipped found = clipped_line({-3 * sign, 0}, {3 * sign, 1}, 1, 0.0625, 0.9375);
    EXPECT_TRUE(found.unresolved.empty());
    ASSERT_EQ(found.arcs.size(), 1u);
    const DomainArc& arc = found.arcs[0];
    EXPECT_TRUE(arc.begins_on_border && arc.ends_on_border);
    const auto encloses = [](const Interval& w, const Rational& x) {
      return Rational::from_double(w.lo()) <= x && x <= Rational::from_double(w.hi());
    };
    EXPECT_TRUE(encloses(arc.begin, q(1, 6)));
    EXPECT_TRUE(encloses(arc.end, q(5, 6)));
    EXPECT_LE(std::max(wid(arc.begin), wid(arc.end)), 1e-9);
  }
}

}  // namespace
}  // namespace veritope
