// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/random_surfaces.h: pairs of surfaces for experiments on intersection, from a seed.
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "robust/base/random.h"
#include "splines/bspline.h"

namespace veritope::bench {

inline double unit(Random& random) { return static_cast<double>(random.next() >> 11) * 0x1p-53; }

/// Degree 3, n control points, equal spans over [0, 1], clamped.
inline KnotAxis<Rational> cubic_axis(int n) {
  KnotAxis<Rational> axis{3, {}, false};
  for (int i = 0; i < n + 4; ++i) {
    const int span = i < 4 ? 0 : (i > n ? n - 3 : i - 3);
    axis.knots.push_back(Rational(span) / Rational(n - 3));
  }
  return axis;
}

/// The graph of a random bicubic over the unit square: n x n control points, heights uniform in [-1, 1], the others on
/// the Greville abscissae, rounded to binary64.
inline BSplineSurface<Rational> random_graph(int n, Random& random) {
  const auto axis = cubic_axis(n);
  const auto greville = [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    return Rational::from_double(
        nearest_double((axis.knots[k + 1] + axis.knots[k + 2] + axis.knots[k + 3]) / Rational(3)));
  };
  const auto count = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  std::vector<Rational> c(3 * count);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const auto k = static_cast<std::size_t>(i * n + j);
      c[k] = greville(i), c[count + k] = greville(j);
      c[2 * count + k] = Rational::from_double(2 * unit(random) - 1);
    }
  return BSplineSurface<Rational>({axis, axis}, 3, false, std::move(c));
}

/// A bump over the unit square, tilted, with its top, of height 0, at a random place, and a plane that it pierces by h:
/// the intersection is one small loop.
inline std::pair<BSplineSurface<Rational>, BSplineSurface<Rational>> bump_and_plane(
    double h, Random& random) {
  const Rational x0 = Rational::from_double(0.4 + 0.2 * unit(random)),
                 y0 = Rational::from_double(0.4 + 0.2 * unit(random));
  const Rational a = Rational::from_double(1 + unit(random)),
                 c = Rational::from_double(1 + unit(random));
  const Rational b = Rational::from_double(0.8 * unit(random) - 0.4);
  const Rational tilt_x = Rational::from_double(unit(random) - 0.5),
                 tilt_y = Rational::from_double(unit(random) - 0.5);
  // -(a dx^2 + b dx dy + c dy^2) in Bernstein form of degree 2: the products of linear factors, polarised.
  const auto corner = [](int i, int degree) { return Rational(i) / Rational(degree); };
  const auto tilt = [&](const Rational& x, const Rational& y) { return tilt_x * x + tilt_y * y; };
  const auto square = [](const Rational& at, int i) {  // (t - at)^2
    const Rational low = -at, high = Rational(1) - at;
    return i == 0 ? low * low : (i == 1 ? low * high : high * high);
  };
  std::vector<Rational> bump(27), plane(12);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const auto k = static_cast<std::size_t>(3 * i + j);
      const Rational x = corner(i, 2), y = corner(j, 2);
      bump[k] = x, bump[9 + k] = y;
      bump[18 + k] = tilt(x, y) - (a * square(x0, i) + b * (x - x0) * (y - y0) + c * square(y0, j));
    }
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      const auto k = static_cast<std::size_t>(2 * i + j);
      const Rational x = Rational(3 * i - 1), y = Rational(3 * j - 1);
      plane[k] = x, plane[4 + k] = y, plane[8 + k] = tilt(x, y) - Rational::from_double(h);
    }
  const auto bezier_axis = [](int degree) {
    KnotAxis<Rational> axis{degree, {}, false};
    for (int i = 0; i < 2 * (degree + 1); ++i) axis.knots.push_back(Rational(i > degree ? 1 : 0));
    return axis;
  };
  return {BSplineSurface<Rational>({bezier_axis(2), bezier_axis(2)}, 3, false, std::move(bump)),
          BSplineSurface<Rational>({bezier_axis(1), bezier_axis(1)}, 3, false, std::move(plane))};
}

}  // namespace veritope::bench
