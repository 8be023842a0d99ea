// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/piece_bound_subjects.h: the part of each bound of solids/pieces/piece_bounds.h that the true rounding
// error uses, for given inputs. The code's own lines run in a given rounding mode, and the result is compared with
// exact rationals. 1 means all of the bound.
#pragma once
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "interval/upward.h"
#include "robust/rational.h"
#include "solids/pieces/piece_net_internal.h"

namespace veritope::piece_bounds {

enum class Rounding { kNearest, kUpward };
using Numbers = std::vector<double>;

/// f(in) as this thread computes it in the given mode.
template <typename Function>
Numbers computed(Rounding mode, Numbers in, Function f) {
  if (mode == Rounding::kNearest) {
    for (double& v : in) v = fenced(v);
    return f(in);
  }
  const ScopedUpward upward;
  for (double& v : in) v = fenced(v);
  Numbers out = f(in);
  for (double& v : out) v = fenced(v);
  return out;
}
inline std::vector<Rational> exactly(const Numbers& in) {
  std::vector<Rational> out;
  for (const double v : in) out.push_back(Rational::from_double(v));
  return out;
}
inline double share(const Rational& error, double bound) {
  return nearest_double(abs(error) / Rational::from_double(bound));
}

/// One component of a net, quartered: the worst coefficient of the four children.
double share_of_quarters(const FormShape& shape, const Numbers& net, Rounding mode);
/// The input has ten numbers: g0 .. g3, c, origin.
double share_of_side(const Numbers& in, Rounding mode);
/// x, error, origin: the lower end of a hull, and the error that the slack had to cover. Over 1: the computed end lies
/// inside.
double share_of_hull(const Numbers& in, Rounding mode);
/// The input is x, error, w, w_error, origin.
double share_of_rational_hull(const Numbers& in, Rounding mode);
/// m (three axes), w, the inner centre, the outer centre, the origin: 13 numbers; the projection is along the last
/// axis. 0 unless |d| is greatest there and w > 0. Both coordinates are tested.
double share_of_crossing(const Numbers& in, const std::array<double, 2>& turn, Rounding mode);

/// One input of one subject. what: side, hull, rational_hull, projected, turned, tensor, triangle; p, q:
/// degrees of the last two.
struct BoundCase {
  std::string what;
  int p, q;
  Rounding mode;
  Numbers in;
};
double share_of(const BoundCase& c);

}  // namespace veritope::piece_bounds
