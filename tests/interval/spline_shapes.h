// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/interval/spline_shapes.h: exact splines for tests.
#pragma once
#include <array>
#include <vector>

#include "robust/base/random.h"
#include "splines/de_casteljau.h"
#include "splines/knot_insertion.h"

namespace veritope::shapes {

inline Rational at(long p, long q = 1) { return Rational(p) / Rational(q); }
inline std::vector<Rational> point3(const Rational& x, const Rational& y, const Rational& z) {
  return {x, y, z};
}
inline KnotAxis<Rational> bezier_axis(int degree) {
  KnotAxis<Rational> out{degree, {}, false};
  for (int i = 0; i <= degree; ++i) out.knots.push_back(at(0));
  for (int i = 0; i <= degree; ++i) out.knots.push_back(at(1));
  return out;
}

/// (x, y, x^2 + y^2), x and y from -r to r.
inline BSplineSurface<Rational> bowl(const Rational& r) {
  std::vector<Rational> x, y, z;
  const std::array<Rational, 3> line{-r, at(0), r}, square{r * r, -r * r, r * r};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      x.push_back(line[i]), y.push_back(line[j]);
      z.push_back(square[i] + square[j]);
    }
  x.insert(x.end(), y.begin(), y.end());
  x.insert(x.end(), z.begin(), z.end());
  return BSplineSurface<Rational>({bezier_axis(2), bezier_axis(2)}, 3, false, std::move(x));
}

/// Degrees 2 and 3, domain [0,3] x [0,2], smooth: near (u, v, small).
inline BSplineSurface<Rational> random_surface(Random& random, bool is_rational) {
  const KnotAxis<Rational> u{2, {at(0), at(0), at(0), at(1), at(2), at(3), at(3), at(3)}, false};
  const KnotAxis<Rational> v{
      3, {at(0), at(0), at(0), at(0), at(1), at(2), at(2), at(2), at(2)}, false};
  const std::size_t nu = u.num_control(), nv = v.num_control();
  std::vector<Rational> c(nu * nv * (is_rational ? 4 : 3));
  for (std::size_t i = 0; i < nu; ++i)
    for (std::size_t j = 0; j < nv; ++j) {
      const std::size_t k = i * nv + j, n = nu * nv;
      const Rational w = is_rational ? at(static_cast<long>(random.between(6, 14)), 10) : at(1);
      c[k] = w * (at(static_cast<long>(i), 1) + at(static_cast<long>(random.between(-2, 2)), 10));
      c[n + k] =
          w * (at(static_cast<long>(j), 1) + at(static_cast<long>(random.between(-2, 2)), 10));
      c[2 * n + k] = w * at(static_cast<long>(random.between(-8, 8)), 10);
      if (is_rational) c[3 * n + k] = w;
    }
  return BSplineSurface<Rational>({u, v}, is_rational ? 4 : 3, is_rational, std::move(c));
}

/// (x, y, z) -> (-y, -z, x).
inline void turn(BSplineSurface<Rational>& s) {
  for (std::size_t i = 0; i < s.grid().count(); ++i) {
    const Rational x = s.component(0)[i], y = s.component(1)[i], z = s.component(2)[i];
    s.component(0)[i] = -y, s.component(1)[i] = -z, s.component(2)[i] = x;
  }
}

/// x^2 + y^2 = 1 from (1, 0) to (0, 1): ((1 - t^2), 2t) / (1 + t^2).
inline BSplineCurve<Rational> quarter_circle() {
  return BSplineCurve<Rational>({bezier_axis(2)}, 3, true,
                                {at(1), at(1), at(0), at(0), at(1), at(2), at(1), at(1), at(2)});
}

/// The point with these parameters, exactly.
template <std::size_t N>
std::vector<Rational> value(const BSpline<Rational, N>& map,
                            const std::array<Rational, N>& at_point) {
  const auto pieces = bezier_pieces(map);
  std::array<std::size_t, N> cell{};
  std::array<Rational, N> local;
  for (std::size_t a = 0; a < N; ++a) {
    while (cell[a] + 2 < pieces.breaks[a].size() && pieces.breaks[a][cell[a] + 1] < at_point[a])
      ++cell[a];
    const Rational &lo = pieces.breaks[a][cell[a]], &hi = pieces.breaks[a][cell[a] + 1];
    local[a] = (at_point[a] - lo) / (hi - lo);
  }
  std::vector<Rational> out = evaluate(pieces.at(cell), local);
  if (!map.is_rational()) return out;
  const Rational w = out.back();
  out.pop_back();
  for (Rational& v : out) v /= w;
  return out;
}

}  // namespace veritope::shapes
