// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/knot_axis.h: the degree and the knots of one axis of a B-spline.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "robust/base/result.h"
#include "robust/rational.h"

namespace veritope {

/// The greatest degree that the constructors accept.
inline constexpr int kMaxSplineDegree = 63;

/// The knots of one axis, clamped or unclamped. For n control points of degree p there are n + p + 1 knots, not
/// decreasing; the domain [knots[p], knots[n]] is not empty, and no knot occurs more than p + 1 times. On a periodic
/// axis also knots[n + i] - knots[p + i] = knots[n] - knots[p] wherever both exist, and the first p control points
/// along the axis equal the last p. They are stored in full, so that only the flag tells a periodic axis from an
/// unclamped one.
template <typename Knot>
struct KnotAxis {
  int degree = 0;
  std::vector<Knot> knots;
  bool is_periodic = false;

  std::size_t num_control() const { return knots.size() - static_cast<std::size_t>(degree) - 1; }
  const Knot& domain_begin() const { return knots[static_cast<std::size_t>(degree)]; }
  const Knot& domain_end() const { return knots[num_control()]; }
  friend bool operator==(const KnotAxis&, const KnotAxis&) = default;
};

/// The axis, if it is one: a degree from 1 to kMaxSplineDegree, and knots as KnotAxis says.
/// @error kBadArgument, with the offending knot and its number, from 0; kOverLimit for the degree.
Result<KnotAxis<Rational>> make_knot_axis(int degree, std::vector<Rational> knots,
                                          bool is_periodic = false);

namespace internal {

/// Enough digits to read the same number back.
std::string knot_text(const Rational& u);
std::string knot_text(double u);
/// "axis 1: <sentence>"
Error axis_error(Code code, std::size_t number, const std::string& sentence);

/// The error of a parameter of axis `number` that is not in its domain.
template <typename Knot>
Error outside_domain(std::size_t number, const Knot& u, const KnotAxis<Knot>& axis) {
  return axis_error(Code::kBadArgument, number,
                    "the parameter " + knot_text(u) + " is not in the domain from " +
                        knot_text(axis.domain_begin()) + " to " + knot_text(axis.domain_end()));
}
template <typename Knot>
Error empty_domain(std::size_t number, const Knot& begin, const Knot& end) {
  return axis_error(
      Code::kBadArgument, number,
      "a domain from " + knot_text(begin) + " to " + knot_text(end) + " would be empty");
}
/// The error that knot i, which was u, would become `rounded` and no longer be as far from the others as the map needs.
template <typename Knot, typename Rounded>
Error knots_collide(std::size_t number, std::size_t i, const Knot& u, const Rounded& rounded) {
  return axis_error(Code::kLossy, number,
                    "knot " + std::to_string(i) + ", " + knot_text(u) + ", would be rounded to " +
                        knot_text(rounded) + ", which is no number between its neighbours");
}

}  // namespace internal

}  // namespace veritope
