// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/enclosure/interval_de_boor.h: de Boor's algorithm on control boxes and a parameter interval, in
// midpoint-radius form. Source: [SSP01] appendix, eq. 5-13. Design: docs/design/0011-enclosures.md.
#pragma once
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "interval/numeric.h"
#include "interval/relations.h"
#include "interval/ring_numbers.h"
#include "robust/base/check.h"
#include "splines/knot_insertion.h"

namespace veritope {

/// [mid - radius, mid + radius], radius >= 0. Both numbers are exact over Rational and enclosed over Interval.
template <typename R>
struct MidRadius {
  R mid, radius;
  friend bool operator==(const MidRadius&, const MidRadius&) = default;
};

/// Contains all numbers of the boxes that `a` may stand for. REQUIRES a live ScopedUpward.
inline Interval to_interval(const MidRadius<Interval>& a) {
  return a.mid + Interval::from_bounds(-sup(a.radius), sup(a.radius));
}

namespace internal {

inline Rational magnitude(const Rational& a) { return abs(a); }
inline Interval magnitude(const Interval& a) { return Interval::from_bounds(mig(a), mag(a)); }

/// Evaluates the polynomial of one span by eq. 12 and 13; d has the control values span - degree .. span. Every t is
/// admitted, but the result is an enclosure only where t +- eps lies in the span, because 0 <= alpha <= 1 only there.
template <Ring R>
MidRadius<R> de_boor_in_span(const KnotAxis<Rational>& axis, std::size_t span,
                             std::vector<MidRadius<R>> d, const Rational& t, const Rational& eps) {
  const auto p = static_cast<std::size_t>(axis.degree);
  for (std::size_t j = 1; j <= p; ++j)
    for (std::size_t i = p; i >= j; --i) {
      const std::size_t k = span - p + i;
      const Rational &begin = axis.knots[k], &end = axis.knots[k + p + 1 - j];
      const Rational exact_alpha = (t - begin) / (end - begin);
      const R alpha = RingNumbers<R>::of_knot(exact_alpha);
      const R beta = RingNumbers<R>::of_knot(Rational(1) - exact_alpha);
      const R delta = RingNumbers<R>::of_knot(eps / (end - begin));
      const MidRadius<R>&left = d[i - 1], &right = d[i];
      const R radius = beta * left.radius + alpha * right.radius +
                       (magnitude(right.mid) + magnitude(left.mid)) * delta +
                       (right.radius + left.radius) * delta;
      d[i] = {beta * left.mid + alpha * right.mid, radius};
    }
  return d[p];
}

/// The part of one line of control values that a span uses.
template <typename R>
std::vector<MidRadius<R>> values_of_span(const std::vector<MidRadius<R>>& line, int degree,
                                         std::size_t span) {
  const auto last = line.begin() + static_cast<std::ptrdiff_t>(span) + 1;
  return {last - degree - 1, last};
}

}  // namespace internal

/// The spline with control boxes `line` over [lo, hi]: contains its value for every choice of points in the boxes
/// and every t in [lo, hi]; at hi, if the map jumps there, the value from the left.
///   (1) If no knot lies inside (lo, hi): mid is exactly the value of the spline of the mids at the middle of
///       [lo, hi], and radius follows eq. 13; with fixed hi - lo, and on spans where no |D| changes sign, radius is a
///       polynomial of degree <= degree in the middle.
///   (2) A knot inside splits [lo, hi]; the widths add. With parts [t1], [t2] at the knot tau the result is
///       [P(t1)] + [P(t2)] - P(tau), which contains both, as both contain P(tau). Its middle is not P(middle): [SSP01]
///       does not say where that box lies, and a box around P(middle) with the sum of the widths may miss points of the
///       curve (tests/interval/interval_de_boor_test.cc). Where the map jumps at tau, the jump's size is added.
/// REQUIRES lo <= hi in the domain, line.size() = axis.num_control(); over Interval a live ScopedUpward.
/// @cost degree^2 / 2 products for each span
template <Ring R>
MidRadius<R> interval_de_boor(const KnotAxis<Rational>& axis, const std::vector<MidRadius<R>>& line,
                              const Rational& lo, const Rational& hi) {
  VT_CHECK(line.size() == axis.num_control(), "a control value for each basis function");
  VT_CHECK(axis.domain_begin() <= lo && lo <= hi && hi <= axis.domain_end(),
           "the parameters lie in the domain");
  const Rational half = Rational(1) / Rational(2);
  MidRadius<R> sum;
  std::size_t span = internal::find_span(axis, lo);
  for (Rational from = lo;; from = axis.knots[span]) {
    const Rational& end = axis.knots[span + 1];
    const Rational to = end < hi ? end : hi;
    const auto d = internal::values_of_span(line, axis.degree, span);
    const auto part =
        internal::de_boor_in_span(axis, span, d, half * (from + to), half * (to - from));
    if (from == lo) {
      sum = part;
    } else {
      const auto value = [&](std::size_t k) {
        return internal::de_boor_in_span(axis, k, internal::values_of_span(line, axis.degree, k),
                                         from, Rational())
            .mid;
      };
      std::size_t before = span - 1;
      while (axis.knots[before] == from) --before;
      const R right = value(span), jump = right - value(before);
      const R half_jump = RingNumbers<R>::ratio(1, 2) * jump;
      sum = {sum.mid + part.mid - right + half_jump,
             sum.radius + part.radius + internal::magnitude(half_jump)};
    }
    if (to == hi) return sum;
    do ++span;
    while (axis.knots[span + 1] == axis.knots[span]);
  }
}

/// Evaluates a map of N parameters axis by axis, the last axis first, for each component; homogeneous if the map is
/// rational. half_widths: those of the control boxes, one for each coefficient; empty for points.
template <Ring R, std::size_t N>
std::vector<MidRadius<R>> interval_de_boor(const BSpline<R, N>& map,
                                           const std::vector<R>& half_widths,
                                           const std::array<std::pair<Rational, Rational>, N>& at) {
  VT_CHECK(half_widths.empty() || half_widths.size() == map.coefficients().size(),
           "a half width for each coefficient, or none");
  const std::size_t count = map.grid().count();
  std::vector<MidRadius<R>> out;
  for (std::size_t c = 0; c < static_cast<std::size_t>(map.num_components()); ++c) {
    std::vector<MidRadius<R>> values;
    for (std::size_t i = c * count; i < (c + 1) * count; ++i)
      values.push_back({map.coefficients()[i], half_widths.empty() ? R() : half_widths[i]});
    for (std::size_t a = N; a-- > 0;) {
      const std::size_t n = map.axis(a).num_control();
      std::vector<MidRadius<R>> next;
      for (std::size_t first = 0; first < values.size(); first += n) {
        const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
        next.push_back(interval_de_boor<R>(map.axis(a),
                                           {begin, begin + static_cast<std::ptrdiff_t>(n)},
                                           at[a].first, at[a].second));
      }
      values = std::move(next);
    }
    out.push_back(values.front());
  }
  return out;
}

/// The rounded version: boxes that contain all results of the exact one. REQUIRES finite boxes in the domain and a live
/// ScopedUpward.
template <std::size_t N>
std::vector<Interval> interval_de_boor_enclosure(const BSpline<Interval, N>& map,
                                                 const std::array<Interval, N>& at) {
  std::array<std::pair<Rational, Rational>, N> exact;
  for (std::size_t a = 0; a < N; ++a)
    exact[a] = {Rational::from_double(at[a].lo()), Rational::from_double(at[a].hi())};
  BSpline<Interval, N> mids = map;
  std::vector<Interval> half_widths;
  for (Interval& v : mids.coefficients()) {
    const MidRad split = mid_rad(v);
    v = Interval(split.mid);
    half_widths.push_back(Interval(split.rad));
  }
  std::vector<Interval> out;
  for (const auto& v : interval_de_boor(mids, half_widths, exact)) out.push_back(to_interval(v));
  return out;
}

/// The tight form: eq. 5 with the four products of bounds instead of eq. 9. It lies inside the result of
/// interval_de_boor; where that result leaves the hull of the control boxes, the tight one touches the hull. A knot
/// inside (lo, hi) gives the hull of the parts. REQUIRES what interval_de_boor requires, and a live ScopedUpward.
Interval interval_de_boor_tight(const KnotAxis<Rational>& axis, const std::vector<Interval>& line,
                                const Interval& at);

}  // namespace veritope
