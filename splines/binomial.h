// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/binomial.h: binomial coefficients of any size, as integers and as numbers that a ring can be divided by.
#pragma once
#include <concepts>
#include <vector>

#include "robust/integer.h"
#include "robust/rational.h"
#include "splines/ring.h"

namespace veritope {

/// C(n, 0), ..., C(n, n). REQUIRES n >= 0.
inline std::vector<Integer> binomial_row(int n) {
  std::vector<Integer> row{Integer(1)};
  for (int i = 0; i < n; ++i)
    row.push_back(divide_exactly(row.back() * Integer(n - i), Integer(i + 1)));
  return row;
}

namespace internal {
/// The integer as a knot: exact, or the double next to it.
template <typename Knot>
Knot knot_of(const Integer& n) {
  if constexpr (std::same_as<Knot, double>) {
    return nearest_double(Rational(n));
  } else {
    return Knot(Rational(n));
  }
}
template <Ring R>
R divided(const R& value, const typename RingNumbers<R>::Knot& by) {
  return RingNumbers<R>::fraction(value, knot_of<typename RingNumbers<R>::Knot>(Integer(0)), by);
}
}  // namespace internal

}  // namespace veritope
