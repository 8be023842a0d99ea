// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/periodic.h: periodic axes beyond the knots and control points that they store.
#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "splines/knot_axis.h"
#include "splines/lines.h"

namespace veritope::internal {

/// A periodic axis with `degree` additional knots, and as many additional control points, at both ends. It is no longer
/// marked as periodic.
template <typename Knot>
KnotAxis<Knot> extended_axis(const KnotAxis<Knot>& axis) {
  const auto p = static_cast<std::size_t>(axis.degree);
  const std::size_t spans = axis.num_control() - p;
  const Knot period = axis.domain_end() - axis.domain_begin();
  std::vector<Knot> knots(axis.knots.size() + 2 * p);
  std::copy(axis.knots.begin(), axis.knots.end(), knots.begin() + axis.degree);
  for (std::size_t i = p; i-- > 0;) knots[i] = knots[i + spans] - period;
  for (std::size_t i = axis.knots.size() + p; i < knots.size(); ++i)
    knots[i] = knots[i - spans] + period;
  return {axis.degree, std::move(knots), false};
}
/// The n points of a line along a periodic axis of degree p, with p additional points at both ends.
template <typename R>
void extend_line(Line<const R> from, std::size_t n, std::size_t p, std::vector<R>& to) {
  const std::size_t spans = n - p;
  to.resize(n + 2 * p);
  for (std::size_t i = 0; i < n; ++i) to[p + i] = from[i];
  for (std::size_t i = p; i-- > 0;) to[i] = to[i + spans];
  for (std::size_t i = n + p; i < to.size(); ++i) to[i] = to[i - spans];
}

/// Makes the last p of n points equal to the first p, which they are along a periodic axis up to rounding.
template <typename R>
void close_period(Line<R> line, std::size_t n, std::size_t p) {
  for (std::size_t i = 0; i < p; ++i) line[n - p + i] = line[i];
}

template <typename Knot>
std::size_t first_copy(const std::vector<Knot>& knots, const Knot& u) {
  return static_cast<std::size_t>(std::lower_bound(knots.begin(), knots.end(), u) - knots.begin());
}

/// Where a periodic axis of this degree, modelled on `like`, begins in a knot list that reaches far enough beyond both
/// ends of the domain; and one past its last knot. The domain begins and ends at the same copy of its knot as in
/// `like`, or at the last copy if that one is gone.
struct PeriodCut {
  std::size_t first, past;

  template <typename Knot>
  PeriodCut(const std::vector<Knot>& knots, std::size_t degree, const KnotAxis<Knot>& like) {
    const Knot &a = like.domain_begin(), &b = like.domain_end();
    const std::size_t at_a = first_copy(knots, a), at_b = first_copy(knots, b);
    const auto copies =
        static_cast<std::size_t>(std::upper_bound(knots.begin(), knots.end(), a) - knots.begin()) -
        at_a;
    const std::size_t copy =
        std::min(static_cast<std::size_t>(like.degree) - first_copy(like.knots, a), copies - 1);
    first = at_a + copy - degree;
    past = at_b + copy + degree + 1;
  }
};

}  // namespace veritope::internal
