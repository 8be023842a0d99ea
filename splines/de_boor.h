// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/de_boor.h: values of B-splines, their points, and their curves and surfaces of constant parameter.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "robust/base/result.h"
#include "splines/blossom_weights.h"
#include "splines/bspline.h"
#include "splines/de_casteljau.h"
#include "splines/lines.h"

namespace veritope {
namespace internal {

/// The error of a parameter outside of the domain, NaN included.
template <typename Knot>
Status require_in_domain(const KnotAxis<Knot>& axis, std::size_t number, const Knot& u) {
  if (axis.domain_begin() <= u && u <= axis.domain_end()) return ok_status();
  return outside_domain(number, u, axis);
}

/// Converts homogeneous values to coordinates.
template <Ring R>
std::vector<R> divided_by_weight(std::vector<R> values) {
  const R weight = values.back();
  values.pop_back();
  for (R& v : values) v = v / weight;
  return values;
}

}  // namespace internal

/// The values of all components at a point of the domain, homogeneous if the map is rational. At a knot of multiplicity
/// degree + 1 inside the domain, where the map jumps, the values from the right.
/// @error kBadArgument, with the axis and the parameter, outside of the domain.
/// @cost per axis degree^2 / 2 quotients of knots, and per component the product of (degrees + 1)
template <Ring R, std::size_t N>
Result<std::vector<R>> evaluate(const BSpline<R, N>& map,
                                const std::array<typename RingNumbers<R>::Knot, N>& at) {
  std::array<std::vector<R>, N> weights;
  std::array<std::size_t, N> first{};
  Grid<N> local;
  for (std::size_t a = 0; a < N; ++a) {
    if (const Status in = internal::require_in_domain(map.axis(a), a, at[a]); !in)
      return in.error();
    const std::size_t span = internal::find_span(map.axis(a), at[a]);
    weights[a] = internal::numbers_of_knots<R>(internal::basis_values(map.axis(a), span, at[a]));
    local.size[a] = weights[a].size();
    first[a] = span + 1 - local.size[a];
  }
  const Grid<N> grid = map.grid();
  std::vector<R> values, work(local.count());
  for (int c = 0; c < map.num_components(); ++c) {
    for (std::size_t i = 0; i < work.size(); ++i) {
      auto index = local.index_of(i);
      for (std::size_t a = 0; a < N; ++a) index[a] += first[a];
      work[i] = map.component(c)[grid.at(index)];
    }
    std::size_t left = work.size();
    for (std::size_t a = N; a-- > 0;) {  // the last axis is the fastest
      const std::vector<R>& w = weights[a];
      left /= w.size();
      for (std::size_t i = 0; i < left; ++i) {
        R sum = w[0] * work[i * w.size()];
        for (std::size_t j = 1; j < w.size(); ++j)
          internal::accumulate(sum, w[j] * work[i * w.size() + j]);
        work[i] = std::move(sum);
      }
    }
    values.push_back(work.front());
  }
  return values;
}

/// The point at a parameter of the domain: its coordinates, divided by the weight. Maps that make_bspline returned have
/// positive weights at control points, and therefore everywhere. For others, REQUIRES that the weight is not 0 there.
/// @error as evaluate
template <Ring R, std::size_t N>
Result<std::vector<R>> point(const BSpline<R, N>& map,
                             const std::array<typename RingNumbers<R>::Knot, N>& at) {
  auto values = evaluate(map, at);
  if (!values || !map.is_rational()) return values;
  return internal::divided_by_weight(std::move(values).value());
}
/// The point of a Bezier map at any parameter. REQUIRES that the weight is not 0 there.
template <Ring R, std::size_t N>
std::vector<R> point(const Bezier<R, N>& map, const std::array<R, N>& at) {
  auto values = evaluate(map, at);
  return map.is_rational() ? internal::divided_by_weight(std::move(values)) : values;
}

/// The map in the other variables, with that of `axis` fixed at u. @error as evaluate
template <Ring R, std::size_t N>
requires(N > 1) Result<BSpline<R, N - 1>> isoparametric(const BSpline<R, N>& map, std::size_t axis,
                                                        const typename RingNumbers<R>::Knot& u) {
  if (const Status in = internal::require_in_domain(map.axis(axis), axis, u); !in)
    return in.error();
  const std::size_t span = internal::find_span(map.axis(axis), u);
  const std::vector<R> weights =
      internal::numbers_of_knots<R>(internal::basis_values(map.axis(axis), span, u));
  const std::size_t first = span + 1 - weights.size();
  return BSpline<R, N - 1>(internal::without_axis(map.axes(), axis), map.num_components(),
                           map.is_rational(),
                           internal::map_lines(map, axis, 1, [&](auto from, auto to) {
                             for (std::size_t j = 0; j < weights.size(); ++j)
                               internal::accumulate(to[0], weights[j] * from[first + j]);
                           }));
}

}  // namespace veritope
