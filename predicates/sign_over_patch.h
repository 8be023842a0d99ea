// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/sign_over_patch.h: which signs does a polynomial in Bernstein form take on its box or triangle? Exact or
// undecided.
// Design: docs/design/0011-enclosures.md.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "robust/base/sign.h"
#include "splines/bezier.h"
#include "splines/bezier_triangle.h"

namespace veritope {

enum class PatchSign {
  kPositive,   ///< at every point of the closed set
  kNegative,   ///< at every point
  kZero,       ///< identically
  kMixed,      ///< two points have different signs, of which one may be zero
  kUndecided,  ///< the budget was spent
};

/// A point and the exact sign there.
template <std::size_t N>
struct SignWitness {
  std::array<Rational, N> at{};
  Sign sign = Sign::kZero;
};

/// How many pieces may be examined, and how often one may be halved.
struct SignBudget {
  std::size_t max_pieces = 20000;
  int max_depth = 200;
};

/// NumCorners: 2 for the least and the greatest corner of a box, 3 for a triangle's.
template <std::size_t N, std::size_t NumCorners>
struct SignReport {
  PatchSign answer = PatchSign::kUndecided;
  std::array<SignWitness<N>, 2> witnesses{};  ///< for kMixed: their signs differ
  std::array<std::array<Rational, N>, NumCorners>
      place{};               ///< for kUndecided: a piece that is left
  std::size_t num_left = 0;  ///< for kUndecided: how many pieces are left
  std::size_t num_pieces = 0,
              num_exact = 0;  ///< spent: pieces examined, and how many of them in rationals
  int depth = 0;              ///< of the deepest piece
};
template <std::size_t N>
using BoxSign = SignReport<N, 2>;
/// Points by their barycentric coordinates.
using TriangleSign = SignReport<3, 3>;

/// The signs of one component on [0,1]^N. Halves the box until the coefficients of every piece have one sign, or
/// corners, which are values, have two. Uses intervals first, and rationals where those are too wide. Zeros that no
/// corner of a dyadic piece meets (f >= 0 that touches 0 at 1/3) end undecided.
/// REQUIRES 0 <= component < num_components, max_pieces >= 1.
/// @cost a de Casteljau step and a scan for each piece, in intervals
template <std::size_t N>
BoxSign<N> sign_over_box(const Bezier<Rational, N>& map, int component = 0,
                         const SignBudget& budget = {});

/// The signs of sum n! / (i! j! k!) u^i v^j w^k b_ijk on the triangle u + v + w = 1, u, v, w >= 0. b_ijk is coefficient
/// (j + k)(j + k + 1) / 2 + k: rows of falling i, within which k rises.
/// REQUIRES (degree + 1)(degree + 2) / 2 coefficients, degree >= 0.
TriangleSign sign_over_triangle(int degree, const std::vector<Rational>& coefficients,
                                const SignBudget& budget = {});

/// The signs of one component. REQUIRES 0 <= component < num_components.
inline TriangleSign sign_over_triangle(const BezierTriangle<Rational>& map, int component = 0,
                                       const SignBudget& budget = {}) {
  VT_CHECK(component >= 0 && component < map.num_components(), "the component exists");
  const auto values = map.component(component);
  return sign_over_triangle(map.degree(), {values.begin(), values.end()}, budget);
}

extern template BoxSign<1> sign_over_box(const Bezier<Rational, 1>&, int, const SignBudget&);
extern template BoxSign<2> sign_over_box(const Bezier<Rational, 2>&, int, const SignBudget&);
extern template BoxSign<3> sign_over_box(const Bezier<Rational, 3>&, int, const SignBudget&);

}  // namespace veritope
