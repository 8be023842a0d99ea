// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/unit_space_internal.h: function spaces of clamped axes that are brought to [0,1], and maps in a larger
// space.
#pragma once
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include "splines/bspline.h"
#include "splines/bspline_degree.h"
#include "splines/knot_insertion.h"

namespace veritope::internal {

/// The splines of a degree on [0,1] with these inner knots, each as often as it occurs, ascending.
struct UnitSpace {
  int degree = 1;
  std::vector<Rational> inner;

  std::size_t num_control() const { return static_cast<std::size_t>(degree) + 1 + inner.size(); }
  friend bool operator==(const UnitSpace&, const UnitSpace&) = default;
};

/// REQUIRES a clamped axis.
UnitSpace unit_space(const KnotAxis<Rational>& axis);
/// The space of t -> f(1 - t).
UnitSpace reversed_space(UnitSpace space);
/// The least space that holds both.
UnitSpace common_space(const UnitSpace& a, const UnitSpace& b);

/// Raises degrees and inserts knots; the map stays the same. REQUIRES a clamped axis whose space lies in `to`.
template <std::size_t N>
BSpline<Rational, N> raised(BSpline<Rational, N> map, std::size_t axis, const UnitSpace& to) {
  map = elevate(std::move(map), axis, to.degree - map.axis(axis).degree);
  const KnotAxis<Rational>& own = map.axis(axis);
  const Rational begin = own.domain_begin(), length = own.domain_end() - begin;
  std::vector<Rational> wanted, missing;
  for (const Rational& t : to.inner) wanted.push_back(begin + t * length);
  std::set_difference(wanted.begin(), wanted.end(), own.knots.begin(), own.knots.end(),
                      std::back_inserter(missing));
  return missing.empty() ? map : refine(map, axis, missing);
}

}  // namespace veritope::internal
