// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/blossom_weights.h: B-spline values and blossoms as linear functionals of the control points, in exact knots.
#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "splines/knot_axis.h"
#include "splines/ring.h"

namespace veritope::internal {

/// The span k with knots[k] <= u < knots[k + 1]; for u = domain_end() the last one that is not empty.
/// REQUIRES u in the domain.
template <typename Knot>
std::size_t find_span(const KnotAxis<Knot>& axis, const Knot& u) {
  const auto begin = axis.knots.begin();
  const auto first = begin + axis.degree,
             last = begin + static_cast<std::ptrdiff_t>(axis.num_control());
  auto above = std::upper_bound(first, last, u);  // in (domain_begin, domain_end)
  if (above == last && !(u < *last)) above = std::lower_bound(first, last, *last);
  return static_cast<std::size_t>(above - begin) - 1;
}

/// The factors of control points span - degree, ..., span in the blossom, at the given arguments, of the polynomial on
/// a span that is not empty. If all arguments equal a u in the span, they are the values of the basis functions at u,
/// none negative, computed without a difference of nearly equal terms. REQUIRES `degree` arguments, in any order.
/// @cost degree^2 / 2 quotients.  @source [Ram89], [PT97] A2.2
template <typename Knot>
std::vector<Knot> blossom_weights(const KnotAxis<Knot>& axis, std::size_t span,
                                  std::span<const Knot> arguments) {
  const auto p = static_cast<std::size_t>(axis.degree);
  std::vector<Knot> weights(p + 1, Knot(0));
  weights[p] = Knot(1);
  for (std::size_t level = p; level > 0; --level) {
    const Knot& u = arguments[level - 1];
    for (std::size_t m = level; m <= p; ++m) {
      const Knot &low = axis.knots[span - p + m], &high = axis.knots[span + m + 1 - level];
      const Knot share = weights[m] / (high - low);
      weights[m - 1] += (high - u) * share;
      weights[m] = (u - low) * share;
    }
  }
  return weights;
}

/// The factors of the value at u.
template <typename Knot>
std::vector<Knot> basis_values(const KnotAxis<Knot>& axis, std::size_t span, const Knot& u) {
  return blossom_weights<Knot>(axis, span,
                               std::vector<Knot>(static_cast<std::size_t>(axis.degree), u));
}

template <Ring R>
std::vector<R> numbers_of_knots(const std::vector<typename RingNumbers<R>::Knot>& knots) {
  std::vector<R> numbers;
  numbers.reserve(knots.size());
  for (const auto& k : knots) numbers.push_back(RingNumbers<R>::of_knot(k));
  return numbers;
}

}  // namespace veritope::internal
