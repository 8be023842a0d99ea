// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/enclosure/interval_de_boor.h"

#include <algorithm>

namespace veritope {

Interval interval_de_boor_tight(const KnotAxis<Rational>& axis, const std::vector<Interval>& line,
                                const Interval& at) {
  VT_CHECK(line.size() == axis.num_control(), "a control value for each basis function");
  const Rational lo = Rational::from_double(at.lo()), hi = Rational::from_double(at.hi());
  VT_CHECK(axis.domain_begin() <= lo && hi <= axis.domain_end(),
           "the parameters lie in the domain");
  const auto p = static_cast<std::size_t>(axis.degree);
  Interval out = Interval::empty();
  for (std::size_t span = internal::find_span(axis, lo);; ++span) {
    if (axis.knots[span] == axis.knots[span + 1]) continue;
    const Rational &from = std::max(lo, axis.knots[span]), &to = std::min(hi, axis.knots[span + 1]);
    std::vector<Interval> d(line.begin() + static_cast<std::ptrdiff_t>(span - p),
                            line.begin() + static_cast<std::ptrdiff_t>(span) + 1);
    for (std::size_t j = 1; j <= p; ++j)
      for (std::size_t i = p; i >= j; --i) {
        const Rational& begin = axis.knots[span - p + i];
        const Rational length = axis.knots[span + 1 + i - j] - begin;
        const auto alpha = [&](const Rational& a, const Rational& b) {
          return hull(enclose(a / length), enclose(b / length));
        };
        d[i] = alpha(length - (to - begin), length - (from - begin)) * d[i - 1] +
               alpha(from - begin, to - begin) * d[i];
      }
    out = hull(out, d[p]);
    if (hi <= axis.knots[span + 1]) return out;
  }
}

}  // namespace veritope
