// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/exact_point_internal.h: products of differences of rational points, in integers.
#pragma once
#include <array>
#include <cstddef>
#include <utility>

#include "predicates/exact_point.h"

namespace veritope::internal {

// Scaled by the denominators, which are positive, b - a keeps its direction.
inline std::array<Integer, 3> scaled_difference(const ExactPoint3& b, const ExactPoint3& a) {
  std::array<Integer, 3> out;
  for (std::size_t c = 0; c < 3; ++c) {
    out[c] = b.scaled()[c] * a.scale();
    out[c].subtract_product(a.scaled()[c], b.scale());
  }
  return out;
}

inline Integer exact_minor(const std::array<Integer, 3>& p, const std::array<Integer, 3>& q,
                           int axis) {
  const auto i = static_cast<std::size_t>((axis + 1) % 3),
             j = static_cast<std::size_t>((axis + 2) % 3);
  Integer minor = p[i] * q[j];
  return std::move(minor.subtract_product(p[j], q[i]));
}

// det(p, q, r)
inline Integer exact_triple(const std::array<Integer, 3>& p, const std::array<Integer, 3>& q,
                            const std::array<Integer, 3>& r) {
  Integer sum;
  for (int axis = 0; axis < 3; ++axis)
    sum.add_product(exact_minor(p, q, axis), r[static_cast<std::size_t>(axis)]);
  return sum;
}

}  // namespace veritope::internal
