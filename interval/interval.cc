// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/interval.h"

#include <cstdio>
#include <cstring>

#include "robust/binary64.h"

namespace veritope {

bool contains(const Interval& a, const Rational& x) {
  if (a.is_empty()) return false;
  return (!is_finite(a.lo()) || Rational::from_double(a.lo()) <= x) &&
         (!is_finite(a.hi()) || x <= Rational::from_double(a.hi()));
}

Interval enclose(const Rational& x) { return Interval::from_bounds(round_down(x), round_up(x)); }

std::string internal::number_text(const char* format, double v) {
  char text[40];
  std::snprintf(text, sizeof text, format, v);
  std::string plain;
  for (const char* c = text; *c != 0; ++c) {
    const bool is_point = std::strchr("0123456789abcdefinxp+-", *c) == nullptr;
    if (!is_point) {
      plain += *c;
    } else if (plain.empty() || plain.back() != '.') {
      plain += '.';
    }
  }
  return plain;
}

std::string to_string(const Interval& a) {
  if (a.is_empty()) return "[empty]";
  return "[" + internal::number_text("%.17g", a.lo()) + ", " +
         internal::number_text("%.17g", a.hi()) + "]";
}

}  // namespace veritope
