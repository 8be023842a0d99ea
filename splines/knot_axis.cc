// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/knot_axis.h"

#include <iomanip>
#include <locale>
#include <sstream>
#include <string>
#include <utility>

namespace veritope {
namespace {

std::string named(std::size_t i, const Rational& knot) {
  return "knot " + std::to_string(i) + ", " + knot.to_string() + ",";
}

}  // namespace

std::string internal::knot_text(const Rational& u) { return u.to_string(); }
std::string internal::knot_text(double u) {
  std::ostringstream out;
  out.imbue(std::locale::classic());  // whatever the program's is
  out << std::setprecision(17) << u;
  return out.str();
}
Error internal::axis_error(Code code, std::size_t number, const std::string& sentence) {
  return Error{code, {}, "axis " + std::to_string(number) + ": " + sentence};
}

Result<KnotAxis<Rational>> make_knot_axis(int degree, std::vector<Rational> knots,
                                          bool is_periodic) {
  if (degree < 1) return bad_argument("the degree " + std::to_string(degree) + " is less than 1");
  if (degree > kMaxSplineDegree)
    return Error{Code::kOverLimit,
                 {},
                 "the degree " + std::to_string(degree) + " is over the limit " +
                     std::to_string(kMaxSplineDegree)};
  const auto p = static_cast<std::size_t>(degree);
  if (knots.size() < 2 * (p + 1))
    return bad_argument(std::to_string(knots.size()) + " knots are too few for the degree " +
                        std::to_string(degree) + ": it needs at least " +
                        std::to_string(2 * (p + 1)));
  std::size_t first_equal = 0;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    if (knots[i] < knots[i - 1])
      return bad_argument(named(i, knots[i]) + " is less than the one before it, " +
                          knots[i - 1].to_string());
    if (knots[first_equal] < knots[i]) first_equal = i;
    if (i - first_equal > p)
      return bad_argument(named(i, knots[i]) + " occurs more than " + std::to_string(p + 1) +
                          " times, one more than the degree");
  }
  KnotAxis<Rational> axis{degree, std::move(knots), is_periodic};
  if (!(axis.domain_begin() < axis.domain_end()))
    return bad_argument("the domain from " + named(p, axis.domain_begin()) + " to itself is empty");
  if (is_periodic) {
    const std::size_t spans = axis.num_control() - p;
    const Rational period = axis.domain_end() - axis.domain_begin();
    for (std::size_t i = 0; i + spans < axis.knots.size(); ++i)
      if (axis.knots[i + spans] - axis.knots[i] != period)
        return bad_argument(named(i + spans, axis.knots[i + spans]) + " does not repeat knot " +
                            std::to_string(i) + " by the period " + period.to_string());
  }
  return axis;
}

}  // namespace veritope
