// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/splines/composition_draw.h: random Bezier maps and their exact texts, for the tests of composition.
#pragma once
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "robust/base/random.h"
#include "splines/de_casteljau.h"

namespace veritope {

inline Rational draw_rational(Random& random) {
  return Rational(random.between(-20, 20)) / Rational(random.between(1, 9));
}

/// Weights, if any, are positive.
template <std::size_t N>
Bezier<Rational, N> draw_map(Random& random, std::array<int, N> degrees, int dimension,
                             bool is_rational) {
  Bezier<Rational, N> map(degrees, dimension + (is_rational ? 1 : 0), is_rational);
  for (Rational& v : map.coefficients()) v = draw_rational(random);
  if (is_rational)
    for (Rational& w : map.component(dimension)) w = Rational(random.between(1, 9)) / Rational(7);
  return map;
}

template <std::size_t N>
std::array<int, N> draw_degrees(Random& random, int most) {
  std::array<int, N> degrees;
  for (int& n : degrees) n = static_cast<int>(random.between(0, most));
  return degrees;
}

/// Maps of one component or N that fit together, rational ones among them; the values are the caller's.
template <std::size_t M, std::size_t N, typename DrawOuter, typename DrawInner>
std::pair<Bezier<double, M>, Bezier<double, N>> draw_composable(Random& random, int most_outer,
                                                                int most_inner,
                                                                DrawOuter draw_outer,
                                                                DrawInner draw_inner) {
  const bool outer_is_rational = random.below(3) == 0, inner_is_rational = random.below(3) == 0;
  Bezier<double, M> outer(draw_degrees<M>(random, most_outer), 1 + outer_is_rational,
                          outer_is_rational);
  Bezier<double, N> inner(draw_degrees<N>(random, most_inner),
                          static_cast<int>(M) + inner_is_rational, inner_is_rational);
  for (double& v : outer.coefficients()) v = draw_outer();
  for (double& v : inner.coefficients()) v = draw_inner();
  return {std::move(outer), std::move(inner)};
}

inline std::string text_of(const Rational& v) { return v.to_string(); }
inline std::string text_of(double v) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%a", v);
  return buffer;
}

template <Ring R, std::size_t N>
std::string text_of(const Bezier<R, N>& map) {
  std::string text = map.is_rational() ? "rational degrees" : "degrees";
  for (const int n : map.degrees()) text += " " + std::to_string(n);
  text += ", coefficients";
  for (const R& v : map.coefficients()) text += " " + text_of(v);
  return text;
}

template <std::size_t N>
Bezier<Rational, N> exact_map(const Bezier<double, N>& map) {
  std::vector<Rational> c;
  for (const double v : map.coefficients()) c.push_back(Rational::from_double(v));
  return Bezier<Rational, N>(map.degrees(), map.num_components(), map.is_rational(), std::move(c));
}

}  // namespace veritope
