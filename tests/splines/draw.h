// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/splines/draw.h: random Bezier and B-spline maps over the rationals, and their texts for failures.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "robust/base/random.h"
#include "splines/bezier.h"
#include "splines/bspline.h"
#include "tests/predicates/test_scale.h"

namespace veritope {

/// Calls law(random) for `loops` seeds, until one fails, and names the seed then.
template <typename Law>
void for_loops(std::uint64_t seed, int loops, Law law) {
  for (long loop = 0; loop < scaled(loops); ++loop) {
    Random random(seed * 1'000'000 + static_cast<std::uint64_t>(loop));
    SCOPED_TRACE("seed " + std::to_string(seed) + ", loop " + std::to_string(loop));
    law(random);
    if (testing::Test::HasFailure()) return;
  }
}
/// Calls law(random, number of variables) for curves, surfaces and, a quarter as often, volumes.
template <typename Law>
void for_all_dimensions(std::uint64_t seed, int loops, Law law) {
  for_loops(seed, loops, [&](Random& r) { law(r, std::integral_constant<std::size_t, 1>()); });
  for_loops(seed + 1, loops, [&](Random& r) { law(r, std::integral_constant<std::size_t, 2>()); });
  for_loops(seed + 2, loops / 4,
            [&](Random& r) { law(r, std::integral_constant<std::size_t, 3>()); });
}

inline Rational fraction(long p, long q = 1) { return Rational(p) / Rational(q); }

inline Rational draw_rational(Random& random) {
  return fraction(random.between(-60, 60), random.between(1, 9));
}
inline Rational draw_positive(Random& random) {
  return fraction(random.between(1, 40), random.between(1, 9));
}
/// In [0, 1], both ends in one of eight.
inline Rational draw_parameter(Random& random) {
  const long q = static_cast<long>(random.between(1, 16));
  return fraction(random.between(0, q), q);
}
inline int draw_int(Random& random, int low, int high) {
  return static_cast<int>(random.between(low, high));
}

template <std::size_t N>
std::array<Rational, N> draw_point(Random& random) {
  std::array<Rational, N> at;
  for (Rational& t : at) t = draw_parameter(random);
  return at;
}

inline std::vector<Rational> draw_coefficients(Random& random, std::size_t size, int num_components,
                                               bool is_rational) {
  std::vector<Rational> out;
  for (int c = 0; c < num_components; ++c)
    for (std::size_t i = 0; i < size; ++i)
      out.push_back(is_rational && c + 1 == num_components ? draw_positive(random)
                                                           : draw_rational(random));
  return out;
}

template <std::size_t N>
Bezier<Rational, N> draw_bezier(Random& random, int max_degree, int num_components,
                                bool is_rational = false) {
  std::array<int, N> degrees;
  Grid<N> grid;
  for (std::size_t a = 0; a < N; ++a) {
    degrees[a] = draw_int(random, 0, max_degree);
    grid.size[a] = static_cast<std::size_t>(degrees[a]) + 1;
  }
  return {degrees, num_components, is_rational,
          draw_coefficients(random, grid.count(), num_components, is_rational)};
}

enum class Ends { kClamped, kUnclamped, kPeriodic };

/// 1 to 4 spans, knots of every multiplicity up to degree + 1 among them.
inline KnotAxis<Rational> draw_axis(Random& random, int degree, Ends ends) {
  const auto p = static_cast<std::size_t>(degree);
  const int spans = draw_int(random, 1, 4);
  // The knots of one period, the first of them at the begin of the domain.
  std::vector<Rational> period;
  Rational u = draw_rational(random);
  const Rational begin = u;
  for (int s = 0; s < spans; ++s) {
    const int times = random.below(2) == 0 ? 1 : draw_int(random, 1, degree + 1);
    for (int m = 0; m < times; ++m) period.push_back(u);
    u += fraction(random.between(1, 12), 5);
  }
  const Rational length = u - begin;
  KnotAxis<Rational> axis{degree, {}, ends == Ends::kPeriodic};
  const auto inner =
      std::vector<Rational>(std::upper_bound(period.begin(), period.end(), begin), period.end());
  if (ends == Ends::kClamped) {
    axis.knots.assign(p + 1, begin);
    axis.knots.insert(axis.knots.end(), inner.begin(), inner.end());
    axis.knots.insert(axis.knots.end(), p + 1, u);
    return axis;
  }
  // Knots of the line, by number: those of the period, moved by whole periods.
  const auto knot = [&](long i) {
    const long n = static_cast<long>(period.size());
    const long turn = i >= 0 ? i / n : -((n - 1 - i) / n);
    return period[static_cast<std::size_t>(i - turn * n)] + Rational(turn) * length;
  };
  if (ends == Ends::kPeriodic) {
    const long seam = random.between(0, static_cast<long>(period.size()) - 1);  // any of its copies
    for (long i = seam - degree; i <= seam + static_cast<long>(period.size()) + degree; ++i)
      axis.knots.push_back(knot(i));
    return axis;
  }
  for (int i = 0; i < degree; ++i) {  // outside of the domain anything that does not decrease
    const Rational step = random.below(3) == 0 ? Rational(0) : fraction(random.between(1, 9), 7);
    axis.knots.insert(axis.knots.begin(), i == 0 ? begin - step : axis.knots.front() - step);
  }
  axis.knots.push_back(begin);
  axis.knots.insert(axis.knots.end(), inner.begin(), inner.end());
  axis.knots.push_back(u);
  for (int i = 0; i < degree; ++i)
    axis.knots.push_back(axis.knots.back() +
                         (random.below(3) == 0 ? Rational(0) : fraction(random.between(1, 9), 7)));
  return axis;
}

/// Makes the last `degree` control points along periodic axes equal to the first.
template <std::size_t N>
void close_periodic(BSpline<Rational, N>& map) {
  for (std::size_t a = 0; a < N; ++a) {
    if (!map.axis(a).is_periodic) continue;
    const auto p = static_cast<std::size_t>(map.axis(a).degree);
    const std::size_t n = map.axis(a).num_control(), stride = map.grid().stride(a);
    for (int c = 0; c < map.num_components(); ++c)
      map.grid().for_each_line(a, [&](std::size_t first) {
        for (std::size_t i = 0; i < p; ++i)
          map.component(c)[first + (n - p + i) * stride] = map.component(c)[first + i * stride];
      });
  }
}

template <std::size_t N>
BSpline<Rational, N> draw_bspline(Random& random, int max_degree, int num_components,
                                  bool is_rational = false) {
  std::array<KnotAxis<Rational>, N> axes;
  Grid<N> grid;
  for (std::size_t a = 0; a < N; ++a) {
    axes[a] =
        draw_axis(random, draw_int(random, 1, max_degree), static_cast<Ends>(random.below(3)));
    grid.size[a] = axes[a].num_control();
  }
  BSpline<Rational, N> map(axes, num_components, is_rational,
                           draw_coefficients(random, grid.count(), num_components, is_rational));
  close_periodic(map);
  return map;
}

/// A point of the domain, often a knot or an end.
template <std::size_t N>
std::array<Rational, N> draw_point(Random& random, const BSpline<Rational, N>& map) {
  std::array<Rational, N> at;
  for (std::size_t a = 0; a < N; ++a) {
    const auto& axis = map.axis(a);
    const auto p = static_cast<std::size_t>(axis.degree);
    at[a] = random.below(3) == 0
                ? axis.knots[p + random.below(axis.num_control() - p + 1)]
                : axis.domain_begin() +
                      draw_parameter(random) * (axis.domain_end() - axis.domain_begin());
  }
  return at;
}

inline std::string text_of(std::span<const Rational> values) {
  std::string out;
  for (const Rational& v : values) out += (out.empty() ? "" : " ") + v.to_string();
  return "{" + out + "}";
}
template <std::size_t N>
std::string text_of(const Bezier<Rational, N>& map) {
  std::string out = map.is_rational() ? "rational, degrees" : "degrees";
  for (const int d : map.degrees()) out += " " + std::to_string(d);
  return out + ", coefficients " + text_of(map.coefficients());
}
template <std::size_t N>
std::string text_of(const BSpline<Rational, N>& map) {
  std::string out = map.is_rational() ? "rational" : "polynomial";
  for (const auto& axis : map.axes())
    out += ", degree " + std::to_string(axis.degree) + (axis.is_periodic ? " periodic" : "") +
           " knots " + text_of(axis.knots);
  return out + ", coefficients " + text_of(map.coefficients());
}

}  // namespace veritope
