// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/interval.h"

#include <cstdio>

#include "robust/binary64.h"

namespace veritope {

bool contains(const Interval& a, const Rational& x) {
  if (a.is_empty()) return false;
  return (!is_finite(a.lo()) || Rational::from_double(a.lo()) <= x) &&
         (!is_finite(a.hi()) || x <= Rational::from_double(a.hi()));
}

Interval enclose(const Rational& x) { return Interval::from_bounds(round_down(x), round_up(x)); }

std::string to_string(const Interval& a) {
  if (a.is_empty()) return "[empty]";
  char text[64];
  std::snprintf(text, sizeof text, "[%.17g, %.17g]", a.lo(), a.hi());
  return text;
}

}  // namespace veritope
