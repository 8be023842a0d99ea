// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/bspline_degree.h: B-splines with higher degrees.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "splines/bspline.h"
#include "splines/knot_insertion.h"
#include "splines/lines.h"
#include "splines/periodic.h"

namespace veritope {
namespace internal {

/// The knots, with one more copy of each.
template <typename Knot>
std::vector<Knot> doubled(const std::vector<Knot>& knots) {
  std::vector<Knot> out;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (i == 0 || knots[i - 1] < knots[i]) out.push_back(knots[i]);
    out.push_back(knots[i]);
  }
  return out;
}

/// The axis with additional knots and control points before and after it, so that every old knot lies in the domain:
/// those of the other periods, or arbitrary ones.
template <typename Knot>
KnotAxis<Knot> padded_axis(const KnotAxis<Knot>& axis) {
  if (axis.is_periodic) return extended_axis(axis);
  const auto p = static_cast<std::size_t>(axis.degree);
  const Knot length = axis.knots.back() - axis.knots.front();
  KnotAxis<Knot> padded{axis.degree, {}, false};
  padded.knots.assign(p, axis.knots.front() - length);
  padded.knots.insert(padded.knots.end(), axis.knots.begin(), axis.knots.end());
  padded.knots.insert(padded.knots.end(), p, axis.knots.back() + length);
  return padded;
}

/// The axis of a degree raised by one: every knot has one more copy, and outside of the domain there are as many knots
/// as that degree needs. Without a period the domain begins and ends at the copies next to its inside: then the new
/// control points depend on old ones only.
template <typename Knot>
KnotAxis<Knot> raised_axis(const KnotAxis<Knot>& axis) {
  const std::size_t q = static_cast<std::size_t>(axis.degree) + 1;
  std::vector<Knot> knots = doubled(axis.is_periodic ? padded_axis(axis).knots : axis.knots);
  std::size_t first, past;
  if (axis.is_periodic) {
    const PeriodCut cut(knots, q, axis);
    first = cut.first, past = cut.past;
  } else {
    first = first_copy(knots, axis.domain_begin()) +
            static_cast<std::size_t>(multiplicity(axis, axis.domain_begin())) - q;
    past = first_copy(knots, axis.domain_end()) + q + 1;
  }
  return {axis.degree + 1,
          std::vector<Knot>(knots.begin() + static_cast<std::ptrdiff_t>(first),
                            knots.begin() + static_cast<std::ptrdiff_t>(past)),
          axis.is_periodic};
}

/// One of the degree + 1 refined nets whose mean is the net of the raised degree: the one whose knots are those of the
/// raised axis except every (degree + 1)th. Control point i of the mean takes point position[i] of this net.
template <Ring R>
class ElevationPart {
 public:
  using Knot = typename RingNumbers<R>::Knot;
  std::vector<std::size_t> position;

  ElevationPart(const KnotAxis<Knot>& axis, const KnotAxis<Knot>& raised, std::size_t residue) {
    const KnotAxis<Knot> padded = padded_axis(axis);
    std::vector<Knot> inserted;
    const std::size_t q = static_cast<std::size_t>(raised.degree);
    std::vector<Knot> kept;
    for (std::size_t l = 0; l < raised.knots.size(); ++l)
      if (l % q != residue) kept.push_back(raised.knots[l]);
    for (auto u = kept.begin(); u != kept.end();) {
      const auto next = std::upper_bound(u, kept.end(), *u);
      const auto lacks = (next - u) - std::ptrdiff_t{multiplicity(padded, *u)};
      if (lacks > 0) inserted.insert(inserted.end(), static_cast<std::size_t>(lacks), *u);
      u = next;
    }
    if (!inserted.empty()) refinement_.emplace(padded, inserted);
    const std::vector<Knot>& refined = inserted.empty() ? padded.knots : refinement_->axis().knots;
    for (std::size_t i = 0; i < raised.num_control(); ++i)
      position.push_back(find(refined, raised, i, residue));
  }

  void refine(const std::vector<R>& from, std::vector<R>& to) const {
    if (!refinement_) {
      to = from;
      return;
    }
    to.resize(refinement_->axis().num_control());
    refinement_->apply({from.data(), 1}, {to.data(), 1});
  }

 private:
  // The control point of the refined knots whose blossom arguments are raised[i + 1], ..., raised[i + q] without the
  // one whose number is `residue` modulo q. These arguments follow each other in `refined`: knots between the first and
  // the last argument occur equally often in both, and the last copies of the first argument are meant. The exception:
  // all arguments are one knot u, of which `refined` may have q copies. Then the map jumps at u, and the result is the
  // point left of u if raised[i] < u, otherwise the one right of it.
  static std::size_t find(const std::vector<Knot>& refined, const KnotAxis<Knot>& raised,
                          std::size_t i, std::size_t residue) {
    const auto q = static_cast<std::size_t>(raised.degree);
    const auto window = raised.knots.begin() + static_cast<std::ptrdiff_t>(i);
    const std::size_t omitted = i + 1 + (residue + q - (i + 1) % q) % q;
    const Knot& u = window[omitted == i + 1 ? 2 : 1];
    const auto end = window + static_cast<std::ptrdiff_t>(q) + 1;
    auto copies = static_cast<std::size_t>(std::upper_bound(window + 1, end, u) - window) - 1;
    if (omitted <= i + copies) --copies;
    const auto [first, last] = std::equal_range(refined.begin(), refined.end(), u);
    const auto at_left = static_cast<std::size_t>(first - refined.begin()),
               at_right = static_cast<std::size_t>(last - refined.begin()) - copies;
    return (copies + 1 == q && *window < u ? at_left : at_right) - 1;
  }

  std::optional<Refinement<R>> refinement_;
};

template <Ring R, std::size_t N>
BSpline<R, N> elevate_once(const BSpline<R, N>& map, std::size_t axis) {
  const auto& old_axis = map.axis(axis);
  auto axes = map.axes();
  const auto& raised = axes[axis] = raised_axis(old_axis);
  const auto p = static_cast<std::size_t>(old_axis.degree);
  std::vector<ElevationPart<R>> parts;
  for (std::size_t residue = 0; residue <= p; ++residue)
    parts.emplace_back(old_axis, raised, residue);
  const std::size_t n = old_axis.num_control(), new_n = raised.num_control();
  const R share = RingNumbers<R>::ratio(1, raised.degree);
  std::vector<R> padded(n + 2 * p), refined;
  auto net = map_lines(map, axis, new_n, [&](Line<const R> from, Line<R> to) {
    if (raised.is_periodic) {
      extend_line(from, n, p, padded);
    } else {
      for (std::size_t i = 0; i < n; ++i) padded[p + i] = from[i];
    }
    for (const ElevationPart<R>& part : parts) {
      part.refine(padded, refined);
      for (std::size_t i = 0; i < new_n; ++i) accumulate(to[i], refined[part.position[i]]);
    }
    for (std::size_t i = 0; i < new_n; ++i) to[i] = share * to[i];
    if (raised.is_periodic) close_period(to, new_n, p + 1);
  });
  return BSpline<R, N>(std::move(axes), map.num_components(), map.is_rational(), std::move(net));
}

}  // namespace internal

/// Raises the degree along `axis` by `by`; the map stays the same. Every knot of the domain occurs `by` times more, so
/// that the map is as smooth there as before; outside of the domain only the knots that the degree needs are left. A
/// clamped axis stays clamped, a periodic one periodic. Each new control point is a convex combination of old ones.
/// REQUIRES degree >= 1, by >= 0.
/// @cost for each line, `by` times: degree + 1 refinements, each with at most one knot for every different knot
/// @source [Pra84], here for knots of any multiplicity and ends of any kind
template <Ring R, std::size_t N>
BSpline<R, N> elevate(BSpline<R, N> map, std::size_t axis, int by) {
  VT_CHECK(by >= 0, "a degree can only be raised");
  VT_CHECK(by == 0 || map.axis(axis).degree > 0, "elevation of a piecewise constant map");
  for (; by > 0; --by) map = internal::elevate_once(map, axis);
  return map;
}

}  // namespace veritope
