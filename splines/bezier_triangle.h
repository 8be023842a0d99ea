// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/bezier_triangle.h: maps in triangular Bernstein form: evaluation, blossom, derivative, subdivision,
// restriction. Their algebra (sum, product, elevation, conversions): bezier_triangle_algebra.h.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "robust/base/result.h"
#include "splines/bezier.h"
#include "splines/knot_axis.h"
#include "splines/ring.h"

namespace veritope {

/// Barycentric coordinates, of a point of the parameter triangle if their sum is 1, of a direction if it is 0.
template <Ring R>
using Barycentric = std::array<R, 3>;

/// (n + 1)(n + 2) / 2 for degree n.
inline std::size_t num_triangle_coefficients(int degree) {
  const auto n = static_cast<std::size_t>(degree);
  return (n + 1) * (n + 2) / 2;
}
/// The place of the coefficient of u^i v^j w^k, i + j + k = n, whatever n is: rows of constant i follow each other from
/// corner 0 on, and within a row k rises.
inline std::size_t triangle_index(int j, int k) {
  return static_cast<std::size_t>((j + k) * (j + k + 1) / 2 + k);
}
/// visit(i, j, k) for all i + j + k = degree, in the order of triangle_index.
template <typename Visit>
void for_each_triangle_index(int degree, Visit visit) {
  for (int row = 0; row <= degree; ++row)
    for (int k = 0; k <= row; ++k) visit(degree - row, row - k, k);
}

/// sum over i + j + k = n of n! / (i! j! k!) u^i v^j w^k b_ijk, with num_components() coordinates. Rational maps are
/// homogeneous: the last component is the weight w, the others are w times the coordinates. Coefficients lie component
/// by component.
template <Ring R>
class BezierTriangle {
 public:
  /// REQUIRES degree >= 0 and num_triangle_coefficients(degree) coefficients per component; data that were read go
  /// through make_bezier_triangle.
  BezierTriangle(int degree, int num_components, bool is_rational, std::vector<R> coefficients)
      : degree_(degree),
        num_components_(num_components),
        is_rational_(is_rational),
        coefficients_(std::move(coefficients)) {
    VT_CHECK(coefficients_.size() == count() * static_cast<std::size_t>(num_components_),
             "a triangle needs a coefficient for every component and index");
  }
  /// All coefficients zero.
  BezierTriangle(int degree, int num_components, bool is_rational)
      : BezierTriangle(degree, num_components, is_rational,
                       std::vector<R>(num_triangle_coefficients(degree) *
                                      static_cast<std::size_t>(num_components))) {}

  int degree() const { return degree_; }
  /// Includes the weight.
  int num_components() const { return num_components_; }
  bool is_rational() const { return is_rational_; }
  int dimension() const { return num_components_ - (is_rational_ ? 1 : 0); }
  /// Coefficients of a component.
  std::size_t count() const { return num_triangle_coefficients(degree_); }

  std::span<const R> coefficients() const { return coefficients_; }
  std::span<R> coefficients() { return coefficients_; }
  std::span<const R> component(int c) const {
    return coefficients().subspan(static_cast<std::size_t>(c) * count(), count());
  }
  std::span<R> component(int c) {
    return coefficients().subspan(static_cast<std::size_t>(c) * count(), count());
  }
  friend bool operator==(const BezierTriangle&, const BezierTriangle&) = default;

 private:
  int degree_;
  int num_components_;
  bool is_rational_;
  std::vector<R> coefficients_;
};

/// @error kOverLimit for a degree over kMaxSplineDegree; kBadArgument for one below 0, no component, or the wrong
/// number of coefficients.
template <Ring R>
Result<BezierTriangle<R>> make_bezier_triangle(int degree, int num_components, bool is_rational,
                                               std::vector<R> coefficients) {
  if (degree > kMaxSplineDegree)
    return Error{Code::kOverLimit, {}, "degree " + std::to_string(degree) + " of a triangle"};
  if (degree < 0 || num_components < (is_rational ? 2 : 1))
    return Error{Code::kBadArgument,
                 {},
                 "a triangle of degree " + std::to_string(degree) + " with " +
                     std::to_string(num_components) + " components"};
  const std::size_t needed = num_triangle_coefficients(degree);
  if (coefficients.size() % needed != 0 ||
      coefficients.size() / needed != static_cast<std::size_t>(num_components))
    return Error{Code::kBadArgument,
                 {},
                 std::to_string(coefficients.size()) + " coefficients instead of " +
                     std::to_string(num_components) + " times " + std::to_string(needed)};
  return BezierTriangle<R>(degree, num_components, is_rational, std::move(coefficients));
}

namespace internal {

/// One step of de Casteljau in place: the first coefficients become those of the form of degree - 1 with one argument
/// of the blossom set.
template <Ring R>
void set_argument(R* b, int degree, const Barycentric<R>& at) {
  for_each_triangle_index(degree - 1, [&](int, int j, int k) {
    R& v = b[triangle_index(j, k)];
    v = at[0] * v + at[1] * b[triangle_index(j + 1, k)] + at[2] * b[triangle_index(j, k + 1)];
  });
}

}  // namespace internal

/// The blossom of each component: symmetric, affine in every argument, the map itself where all arguments are equal.
/// REQUIRES degree() arguments.
template <Ring R>
std::vector<R> blossom(const BezierTriangle<R>& map, std::span<const Barycentric<R>> arguments) {
  VT_CHECK(arguments.size() == static_cast<std::size_t>(map.degree()),
           "a blossom has as many arguments as the degree");
  std::vector<R> values, work;
  for (int c = 0; c < map.num_components(); ++c) {
    work.assign(map.component(c).begin(), map.component(c).end());
    for (int left = map.degree(); left > 0; --left)
      internal::set_argument(work.data(), left, arguments[static_cast<std::size_t>(left) - 1]);
    values.push_back(work.front());
  }
  return values;
}

/// All components at a point, inside the triangle or not; homogeneous if the map is rational.
template <Ring R>
std::vector<R> evaluate(const BezierTriangle<R>& map, const Barycentric<R>& at) {
  const std::vector<Barycentric<R>> arguments(static_cast<std::size_t>(map.degree()), at);
  return blossom<R>(map, arguments);
}

/// The derivative of each component along a direction, its degree lower by one (degree 0 for a constant). For a
/// rational map: the derivatives of the homogeneous components, not of the quotients.
template <Ring R>
BezierTriangle<R> directional_derivative(const BezierTriangle<R>& map,
                                         const Barycentric<R>& direction) {
  if (map.degree() == 0) return BezierTriangle<R>(0, map.num_components(), map.is_rational());
  BezierTriangle<R> out(map.degree() - 1, map.num_components(), map.is_rational());
  const R n = RingNumbers<R>::ratio(map.degree(), 1);
  std::vector<R> work;
  for (int c = 0; c < map.num_components(); ++c) {
    work.assign(map.component(c).begin(), map.component(c).end());
    internal::set_argument(work.data(), map.degree(), direction);
    for (std::size_t i = 0; i < out.count(); ++i) out.component(c)[i] = n * work[i];
  }
  return out;
}

/// The three triangles into which a point p cuts the map: the one at index e has p in place of corner e. @cost one
/// evaluation
template <Ring R>
std::array<BezierTriangle<R>, 3> split_at(const BezierTriangle<R>& map, const Barycentric<R>& p) {
  std::array<BezierTriangle<R>, 3> parts{map, map, map};
  std::vector<R> work;
  for (int c = 0; c < map.num_components(); ++c) {
    work.assign(map.component(c).begin(), map.component(c).end());
    for (int level = 1; level <= map.degree(); ++level) {
      const int n = map.degree() - level;
      internal::set_argument(work.data(), n + 1, p);
      for (int k = 0; k <= n; ++k) {  // what this level leaves of the three edges
        parts[0].component(c)[triangle_index(n - k, k)] = work[triangle_index(n - k, k)];
        parts[1].component(c)[triangle_index(level, k)] = work[triangle_index(0, k)];
        parts[2].component(c)[triangle_index(k, level)] = work[triangle_index(k, 0)];
      }
    }
  }
  return parts;
}

/// The map on the triangle with these corners, as a map of the whole parameter triangle: its composition with an affine
/// map of the parameters. The corners may lie anywhere; equal ones give a map that is constant along lines.
/// @cost O(degree^5) products per component
template <Ring R>
BezierTriangle<R> restricted(const BezierTriangle<R>& map,
                             const std::array<Barycentric<R>, 3>& corners) {
  BezierTriangle<R> out(map.degree(), map.num_components(), map.is_rational());
  const int n = map.degree();
  for (int c = 0; c < map.num_components(); ++c) {
    std::vector<R> after_i(map.component(c).begin(), map.component(c).end());
    for (int i = 0; i <= n; ++i) {
      std::vector<R> after_j = after_i;
      for (int j = 0; i + j <= n; ++j) {
        std::vector<R> work = after_j;
        for (int left = n - i - j; left > 0; --left)
          internal::set_argument(work.data(), left, corners[2]);
        out.component(c)[triangle_index(j, n - i - j)] = work.front();
        if (i + j < n) internal::set_argument(after_j.data(), n - i - j, corners[1]);
      }
      if (i < n) internal::set_argument(after_i.data(), n - i, corners[0]);
    }
  }
  return out;
}

/// The four triangles between the corners and the midpoints of the edges: number e < 3 keeps corner e in its place;
/// number 3 is the middle one, with the midpoint of the edge opposite to corner e in place of corner e. All keep the
/// orientation.
template <Ring R>
std::array<BezierTriangle<R>, 4> split_in_four(const BezierTriangle<R>& map) {
  const R h = RingNumbers<R>::ratio(1, 2), o = one<R>(), z = R();
  const Barycentric<R> c0{o, z, z}, c1{z, o, z}, c2{z, z, o};
  const Barycentric<R> m0{z, h, h}, m1{h, z, h}, m2{h, h, z};
  return {restricted<R>(map, {c0, m2, m1}), restricted<R>(map, {m2, c1, m0}),
          restricted<R>(map, {m1, m0, c2}), restricted<R>(map, {m0, m1, m2})};
}

/// The boundary opposite to corner `edge`, from corner edge + 1 to corner edge + 2 (modulo 3).
template <Ring R>
BezierCurve<R> boundary_curve(const BezierTriangle<R>& map, int edge) {
  BezierCurve<R> curve({map.degree()}, map.num_components(), map.is_rational());
  const int n = map.degree();
  for (int c = 0; c < map.num_components(); ++c)
    for (int t = 0; t <= n; ++t) {
      const std::size_t at = edge == 0   ? triangle_index(n - t, t)
                             : edge == 1 ? triangle_index(0, n - t)
                                         : triangle_index(t, 0);
      curve.component(c)[static_cast<std::size_t>(t)] = map.component(c)[at];
    }
  return curve;
}

}  // namespace veritope
