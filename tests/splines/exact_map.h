// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/splines/exact_map.h: random splines, and their values and derivatives in rationals.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "robust/base/random.h"
#include "splines/de_casteljau.h"
#include "splines/knot_insertion.h"

namespace veritope::exact_map {

template <std::size_t N>
struct Shape {
  std::array<int, N> degrees;
  std::array<std::size_t, N> spans;  // non-empty ones
  int num_components;
  bool is_rational;
};

/// Knots are multiples of 1 / knot_denominator, coefficients of 1 / denominator in [-4, 4]; weights in [1/2, 4].
template <std::size_t N>
BSpline<Rational, N> random_bspline(Random& random, const Shape<N>& shape, long knot_denominator,
                                    long denominator) {
  std::array<KnotAxis<Rational>, N> axes;
  std::size_t count = 1;
  for (std::size_t a = 0; a < N; ++a) {
    const int p = shape.degrees[a];
    std::vector<Rational> knots;
    const bool is_clamped = random.below(2) == 0;
    Rational at = Rational(static_cast<long>(random.between(-5, 5)));
    const auto step = [&] { at += Rational(random.between(1, 9)) / Rational(knot_denominator); };
    for (int i = 0; i <= p; ++i) {
      if (!is_clamped && i > 0) step();
      knots.push_back(at);
    }
    for (std::size_t k = 0; k < shape.spans[a]; ++k) {
      step();
      const auto times =
          k + 1 < shape.spans[a] ? 1 + random.below(static_cast<std::uint64_t>(p)) : 1;
      for (std::uint64_t m = 0; m < times; ++m) knots.push_back(at);
    }
    for (int i = 0; i < p; ++i) {
      if (!is_clamped) step();
      knots.push_back(at);
    }
    axes[a] = make_knot_axis(p, std::move(knots)).value();
    count *= axes[a].num_control();
  }
  std::vector<Rational> coefficients;
  for (int c = 0; c < shape.num_components; ++c)
    for (std::size_t i = 0; i < count; ++i) {
      const bool is_weight = shape.is_rational && c + 1 == shape.num_components;
      coefficients.push_back(Rational(is_weight
                                          ? random.between(denominator / 2, 4 * denominator)
                                          : random.between(-4 * denominator, 4 * denominator)) /
                             Rational(denominator));
    }
  return BSpline<Rational, N>(std::move(axes), shape.num_components, shape.is_rational,
                              std::move(coefficients));
}

/// d/d axis of the homogeneous map of a cell of length h.
template <std::size_t N>
Bezier<Rational, N> differentiated(const Bezier<Rational, N>& map, std::size_t axis,
                                   const Rational& h) {
  auto degrees = map.degrees();
  const int n = degrees[axis];
  if (n == 0) return Bezier<Rational, N>(degrees, map.num_components(), map.is_rational());
  --degrees[axis];
  Bezier<Rational, N> out(degrees, map.num_components(), map.is_rational());
  const Grid<N> from = map.grid(), to = out.grid();
  for (int c = 0; c < map.num_components(); ++c) {
    std::vector<std::size_t> first;
    to.for_each_line(axis, [&](std::size_t i) { first.push_back(i); });
    std::size_t line = 0;
    from.for_each_line(axis, [&](std::size_t i) {
      for (std::size_t k = 0; k < to.size[axis]; ++k)
        out.component(c)[first[line] + k * to.stride(axis)] =
            Rational(n) / h *
            (map.component(c)[i + (k + 1) * from.stride(axis)] -
             map.component(c)[i + k * from.stride(axis)]);
      ++line;
    });
  }
  return out;
}

/// Value and first derivatives of the points of a map.
template <std::size_t N>
class ExactMap {
 public:
  explicit ExactMap(const BSpline<Rational, N>& map) : pieces_(bezier_pieces(map)) {}
  struct Point {
    std::vector<Rational> value;
    std::array<std::vector<Rational>, N> partial;
  };
  Point at(const std::array<Rational, N>& u) const {
    std::array<std::size_t, N> cell;
    std::array<Rational, N> local, length;
    for (std::size_t a = 0; a < N; ++a) {
      const auto& breaks = pieces_.breaks[a];
      std::size_t i = 0;
      while (i + 2 < breaks.size() && breaks[i + 1] <= u[a]) ++i;
      cell[a] = i, length[a] = breaks[i + 1] - breaks[i];
      local[a] = (u[a] - breaks[i]) / length[a];
    }
    const auto& piece = pieces_.at(cell);
    Point out;
    const auto x = evaluate(piece, local);
    const auto dimension = static_cast<std::size_t>(piece.dimension());
    const Rational w = piece.is_rational() ? x.back() : Rational(1);
    for (std::size_t c = 0; c < dimension; ++c) out.value.push_back(x[c] / w);
    for (std::size_t a = 0; a < N; ++a) {
      const auto d = evaluate(differentiated(piece, a, length[a]), local);
      for (std::size_t c = 0; c < dimension; ++c)
        out.partial[a].push_back(
            (d[c] - (piece.is_rational() ? out.value[c] * d.back() : Rational())) / w);
    }
    return out;
  }
  const BezierPieces<Rational, N>& pieces() const { return pieces_; }

 private:
  BezierPieces<Rational, N> pieces_;
};

}  // namespace veritope::exact_map
