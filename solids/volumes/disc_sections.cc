// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/volumes/disc_sections.h"

#include <array>
#include <utility>

#include "splines/bezier_components.h"
#include "splines/bezier_degree.h"
#include "splines/bezier_product.h"
#include "splines/bspline_pieces.h"

namespace veritope::internal {
namespace {

using Polynomial = BezierSurface<Rational>;  // with one component

Polynomial constant(const Rational& value) { return {{0, 0}, 1, false, {value}}; }
Polynomial linear(std::size_t axis, const Rational& at_0, const Rational& at_1) {
  return {axis == 0 ? std::array{1, 0} : std::array{0, 1}, 1, false, {at_0, at_1}};
}
Polynomial operator*(const Polynomial& a, const Polynomial& b) { return multiplied(a, b); }
Polynomial operator+(const Polynomial& a, const Polynomial& b) { return sum(a, b); }
Polynomial operator-(const Polynomial& a, const Polynomial& b) { return difference(a, b); }

CellSurface surface_of(const Polynomial& x, const Polynomial& y, const Polynomial& z,
                       const Polynomial& w) {
  const auto map = quotient(joined(joined(x, y), z), w);
  return to_bspline(elevate_to(map, {4, 4}));
}

// (x, y) turned by so many right angles.
std::array<Rational, 2> turned(Rational x, Rational y, int quarter) {
  for (; quarter > 0; --quarter) x = std::exchange(y, x), x = -x;
  return {std::move(x), std::move(y)};
}

CellSurface square_in_the_middle() {
  const Rational h(Integer(1), Integer(2)), z;
  return CellSurface({unit_axis(1), unit_axis(1)}, 3, false,
                     {h, z, z, -h, z, -h, h, z, z, z, z, z});
}

// Row 0: the side of the square, raised to degree 2, with weights 1. Row 1: the arc.
CellSurface quarter_of_disc(int quarter) {
  const Rational half(Integer(1), Integer(2)), fourth(Integer(1), Integer(4)), zero, one(1), two(2);
  const std::array<std::array<Rational, 3>, 6> points =
      quarter % 2 == 0 ? std::array<std::array<Rational, 3>, 6>{{{half, zero, one},
                                                                 {fourth, fourth, one},
                                                                 {zero, half, one},
                                                                 {one, zero, one},
                                                                 {one, one, one},
                                                                 {zero, two, two}}}
                       : std::array<std::array<Rational, 3>, 6>{{{half, zero, one},
                                                                 {fourth, fourth, one},
                                                                 {zero, half, one},
                                                                 {two, zero, two},
                                                                 {one, one, one},
                                                                 {zero, one, one}}};
  std::vector<Rational> all(24);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto [x, y] = turned(points[i][0], points[i][1], quarter);
    all[i] = x, all[6 + i] = y, all[18 + i] = points[i][2];
  }
  return CellSurface({unit_axis(1), unit_axis(2)}, 4, true, std::move(all));
}

CellSurface cube_face(const std::array<std::array<int, 3>, 4>& corners) {
  std::vector<Rational> all;
  for (std::size_t k = 0; k < 3; ++k)
    for (const auto& corner : corners) all.emplace_back(corner[k]);
  return CellSurface({unit_axis(1), unit_axis(1)}, 3, false, std::move(all));
}

}  // namespace

std::vector<CellSurface> disc_sections() {
  std::vector<CellSurface> out{square_in_the_middle()};
  for (int quarter = 0; quarter < 4; ++quarter) out.push_back(quarter_of_disc(quarter));
  return out;
}

// The points (2 Re(p conj q), 2 Im(p conj q), |p|^2 - |q|^2) / (|p|^2 + |q|^2) of complex polynomials p, q are the
// projections of p / q from the north pole; -1 <= s, t <= 1, a = 3/8:
//   z-  p / q = a (s + i t), with x and y exchanged, so that normals point out
//   z+  q / p = a (s - i t), times 1 + i s t
//   x+  p / q = (1 + i t) ((1 - r) a + r) / ((1 - r) + r a (1 + t^2)), 0 <= r <= 1, and this turned by right angles:
//       the argument depends on t alone, |p / q| rises with r since a^2 (1 + t^2) < 1. At r = 0 it is a (1 + i t), at
//       r = 1 the side s = 1 of z+ with its factor.
std::vector<SphereSide> sphere_sides() {
  const Rational a_value(Integer(3), Integer(8));
  const Polynomial a = constant(a_value), one = constant(Rational(1)), two = constant(Rational(2));
  const Polynomial s = linear(0, Rational(-1), Rational(1)),
                   t = linear(1, Rational(-1), Rational(1));
  const Polynomial square = a * a * (s * s + t * t), factor = one + s * s * (t * t);
  std::vector<SphereSide> out;
  out.push_back({cube_face({{{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}}}),
                 surface_of(two * a * t, two * a * s, square - one, square + one)});
  out.push_back({cube_face({{{-1, -1, 1}, {-1, 1, 1}, {1, -1, 1}, {1, 1, 1}}}),
                 surface_of(two * a * s * factor, two * a * t * factor, (one - square) * factor,
                            (one + square) * factor)});
  const Polynomial r = linear(1, Rational(0), Rational(1));
  const Polynomial spread = one + s * s, p = a + r * (one - a), q = one - r + r * a * spread;
  const Polynomial across = two * p * q, along = two * s * p * q, up = spread * p * p - q * q,
                   weight = spread * p * p + q * q;
  const Polynomial zero = constant(Rational(0));
  for (int quarter = 0; quarter < 4; ++quarter) {
    std::array<std::array<int, 3>, 4> corners{};
    for (std::size_t i = 0; i < 4; ++i) {
      int x = 1, y = i < 2 ? -1 : 1;
      for (int k = 0; k < quarter; ++k) x = std::exchange(y, x), x = -x;
      corners[i] = {x, y, i % 2 == 0 ? -1 : 1};
    }
    Polynomial x = across, y = along;
    for (int k = 0; k < quarter; ++k) x = std::exchange(y, x), x = zero - x;
    out.push_back({cube_face(corners), surface_of(x, y, up, weight)});
  }
  return out;
}

CellSurface half_disc() {
  const Rational zero, one(1), half(Integer(1), Integer(2));
  KnotAxis<Rational> up{2, {}, false};
  for (const int u : {0, 0, 0, 1, 1, 2, 2, 2}) up.knots.emplace_back(u);
  std::vector<Rational> all;
  const std::array<std::array<int, 3>, 5> arc = {
      {{0, -1, 1}, {1, -1, 1}, {2, 0, 2}, {1, 1, 1}, {0, 1, 1}}};
  const std::array<Rational, 5> along = {-one, -half, zero, half, one};
  for (std::size_t i = 0; i < 5; ++i) all.insert(all.end(), {zero, Rational(arc[i][0])});
  all.insert(all.end(), 10, zero);
  for (std::size_t i = 0; i < 5; ++i) all.insert(all.end(), {along[i], Rational(arc[i][1])});
  for (std::size_t i = 0; i < 5; ++i) all.insert(all.end(), {one, Rational(arc[i][2])});
  return CellSurface({std::move(up), unit_axis(1)}, 4, true, std::move(all));
}

}  // namespace veritope::internal
