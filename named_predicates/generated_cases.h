// SPDX-License-Identifier: LGPL-3.0-or-later
// named_predicates/generated_cases.h: the generated predicates, and those based on them, on operands in one row.
#pragma once
#include <array>
#include <cstddef>

#include "named_predicates/named_predicate.h"
#include "predicates/generated/compare_distance2d.h"
#include "predicates/generated/compare_distance3d.h"
#include "predicates/generated/compare_lengths2d.h"
#include "predicates/generated/compare_lengths3d.h"
#include "predicates/generated/order_along_line2d.h"
#include "predicates/generated/order_along_line3d.h"
#include "predicates/generated/power_circle.h"
#include "predicates/generated/power_edge2d.h"
#include "predicates/generated/power_edge3d.h"
#include "predicates/generated/power_sphere.h"
#include "predicates/order_on_circle.h"
#include "predicates/side_of_bisector.h"
#include "robust/rational.h"

namespace veritope {

template <std::size_t Dim>
auto point_at(const Operands& v, std::size_t i) {
  if constexpr (Dim == 2) {
    return Vec2d{v[i], v[i + 1]};
  } else {
    return Vec3d{v[i], v[i + 1], v[i + 2]};
  }
}

/// A predicate on points only.
template <std::size_t Dim, auto Predicate>
Sign decide_three(const Operands& v, TierCounts* tally) {
  return Predicate(point_at<Dim>(v, 0), point_at<Dim>(v, Dim), point_at<Dim>(v, 2 * Dim), tally);
}
template <std::size_t Dim, auto Predicate>
Sign decide_four(const Operands& v, TierCounts* tally) {
  return Predicate(point_at<Dim>(v, 0), point_at<Dim>(v, Dim), point_at<Dim>(v, 2 * Dim),
                   point_at<Dim>(v, 3 * Dim), tally);
}

/// A predicate on points, each followed by its weight.
template <std::size_t Dim, auto Predicate>
Sign decide_edge(const Operands& v, TierCounts* tally) {
  return Predicate(point_at<Dim>(v, 0), v[Dim], point_at<Dim>(v, Dim + 1), v[2 * Dim + 1],
                   point_at<Dim>(v, 2 * Dim + 2), v[3 * Dim + 2], tally);
}
inline Sign decide_power_circle(const Operands& v, TierCounts* tally) {
  return power_circle(point_at<2>(v, 0), v[2], point_at<2>(v, 3), v[5], point_at<2>(v, 6), v[8],
                      point_at<2>(v, 9), v[11], tally);
}
inline Sign decide_power_sphere(const Operands& v, TierCounts* tally) {
  return power_sphere(point_at<3>(v, 0), v[3], point_at<3>(v, 4), v[7], point_at<3>(v, 8), v[11],
                      point_at<3>(v, 12), v[15], point_at<3>(v, 16), v[19], tally);
}

/// The generated formula over rationals.
template <std::size_t N, auto Of>
Sign by_generated_formula(const Operands& v) {
  std::array<Rational, N> w;
  for (std::size_t i = 0; i < N; ++i) w[i] = Rational::from_double(v[i]);
  return Of(w).sign();
}

/// side_of_bisector over rationals: by the distances of p from b and a.
template <std::size_t Dim>
Sign side_of_bisector_by_formula(const Operands& v) {
  Rational sum;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const Rational p = Rational::from_double(v[2 * Dim + axis]);
    const Rational to_a = Rational::from_double(v[axis]) - p,
                   to_b = Rational::from_double(v[Dim + axis]) - p;
    sum += to_b * to_b - to_a * to_a;
  }
  return sum.sign();
}

/// order_on_circle over rationals: by the sums of the turns from p to q and from p to r.
inline Sign order_on_circle_by_formula(const Operands& v) {
  const auto at = [&](std::size_t i, std::size_t axis) {
    return Rational::from_double(v[2 * i + axis]) - Rational::from_double(v[axis]);
  };
  const auto cross = [&](std::size_t i, std::size_t j) {
    return (at(i, 0) * at(j, 1) - at(i, 1) * at(j, 0)).sign();
  };
  const auto dot = [&](std::size_t i, std::size_t j) {
    return (at(i, 0) * at(j, 0) + at(i, 1) * at(j, 1)).sign();
  };
  for (std::size_t i = 1; i <= 3; ++i) {
    if (dot(i, i) == Sign::kZero) return Sign::kZero;
  }
  // The turn from p in eighths; 2 means any value in (0, 4), and 6 any in (4, 8).
  const auto eighths = [&](std::size_t i) {
    const int side = to_int(cross(1, i));
    return side == 0 ? 2 - 2 * to_int(dot(1, i)) : 4 - 2 * side;
  };
  const int q = eighths(2), r = eighths(3);
  return q != r ? sign_of(r - q) : (q % 4 == 0 ? Sign::kZero : cross(2, 3));
}

}  // namespace veritope
