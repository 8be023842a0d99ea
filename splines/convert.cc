// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/convert.h"

#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "splines/bspline_make.h"
#include "splines/knot_axis.h"

namespace veritope {
namespace {

Error named(Code code, const char* kind, std::size_t i, const std::string& value,
            const char* what) {
  return Error{code, {}, std::string(kind) + " " + std::to_string(i) + ", " + value + ", " + what};
}

Result<std::vector<double>> rounded(std::span<const Rational> values, const char* kind) {
  std::vector<double> out;
  out.reserve(values.size());
  for (const Rational& v : values) {
    out.push_back(nearest_double(v));
    if (!std::isfinite(out.back()))
      return named(Code::kNotFinite, kind, out.size() - 1, v.to_string(),
                   "is too large for a binary64 number");
  }
  return out;
}

Result<std::vector<Rational>> exact_numbers(std::span<const double> values, const char* kind) {
  std::vector<Rational> out;
  out.reserve(values.size());
  for (const double v : values) {
    if (!std::isfinite(v))
      return named(Code::kNotFinite, kind, out.size(), internal::knot_text(v), "is no number");
    out.push_back(Rational::from_double(v));
  }
  return out;
}

// The rounded coefficients of a map. Refuses a weight, these are the last ones, that becomes 0 and was not.
template <typename Map>
Result<std::vector<double>> rounded_coefficients(const Map& map) {
  auto out = rounded(map.coefficients(), "coefficient");
  if (!out || !map.is_rational()) return out;
  for (std::size_t i = map.coefficients().size() - map.grid().count(); i < out->size(); ++i)
    if ((*out)[i] == 0 && map.coefficients()[i].sign() != Sign::kZero)
      return named(Code::kLossy, "coefficient", i, map.coefficients()[i].to_string(),
                   "is a weight that would be rounded to 0");
  return out;
}

bool repeats(const KnotAxis<double>& axis) {
  const auto p = static_cast<std::size_t>(axis.degree);
  const std::size_t spans = axis.num_control() - p;
  const auto exactly = [](double u) { return Rational::from_double(u); };
  const Rational period = exactly(axis.domain_end()) - exactly(axis.domain_begin());
  for (std::size_t i = 0; i + spans < axis.knots.size(); ++i)
    if (exactly(axis.knots[i + spans]) - exactly(axis.knots[i]) != period) return false;
  return true;
}

Result<KnotAxis<double>> rounded_axis(const KnotAxis<Rational>& axis, std::size_t number) {
  auto knots = rounded(axis.knots, "knot");
  if (!knots) return internal::axis_error(knots.error().code, number, knots.error().message);
  for (std::size_t i = 1; i < knots->size(); ++i)
    if (axis.knots[i - 1] < axis.knots[i] && !((*knots)[i - 1] < (*knots)[i]))
      return internal::knots_collide(number, i, axis.knots[i], (*knots)[i]);
  KnotAxis<double> out{axis.degree, std::move(knots).value(), axis.is_periodic};
  out.is_periodic = axis.is_periodic && repeats(out);
  return out;
}

}  // namespace

template <std::size_t N>
Result<Bezier<double, N>> nearest_double(const Bezier<Rational, N>& map) {
  auto coefficients = rounded_coefficients(map);
  if (!coefficients) return coefficients.error();
  return Bezier<double, N>(map.degrees(), map.num_components(), map.is_rational(),
                           std::move(coefficients).value());
}

template <std::size_t N>
Result<BSpline<double, N>> nearest_double(const BSpline<Rational, N>& map) {
  auto coefficients = rounded_coefficients(map);
  if (!coefficients) return coefficients.error();
  std::array<KnotAxis<double>, N> axes;
  for (std::size_t a = 0; a < N; ++a) {
    auto axis = rounded_axis(map.axis(a), a);
    if (!axis) return axis.error();
    axes[a] = std::move(axis).value();
  }
  return BSpline<double, N>(std::move(axes), map.num_components(), map.is_rational(),
                            std::move(coefficients).value());
}

template <std::size_t N>
Result<Bezier<Rational, N>> exact(const Bezier<double, N>& map) {
  auto coefficients = exact_numbers(map.coefficients(), "coefficient");
  if (!coefficients) return coefficients.error();
  return Bezier<Rational, N>(map.degrees(), map.num_components(), map.is_rational(),
                             std::move(coefficients).value());
}

template <std::size_t N>
Result<BSpline<Rational, N>> exact(const BSpline<double, N>& map) {
  auto coefficients = exact_numbers(map.coefficients(), "coefficient");
  if (!coefficients) return coefficients.error();
  std::array<KnotAxis<Rational>, N> axes;
  for (std::size_t a = 0; a < N; ++a) {
    auto knots = exact_numbers(map.axis(a).knots, "knot");
    if (!knots) return internal::axis_error(knots.error().code, a, knots.error().message);
    axes[a] = {map.axis(a).degree, std::move(knots).value(), map.axis(a).is_periodic};
  }
  return make_bspline(std::move(axes), map.num_components(), map.is_rational(),
                      std::move(coefficients).value());
}

#define VT_CONVERSIONS(N)                                                          \
  template Result<Bezier<double, N>> nearest_double(const Bezier<Rational, N>&);   \
  template Result<BSpline<double, N>> nearest_double(const BSpline<Rational, N>&); \
  template Result<Bezier<Rational, N>> exact(const Bezier<double, N>&);            \
  template Result<BSpline<Rational, N>> exact(const BSpline<double, N>&);
VT_CONVERSIONS(1)
VT_CONVERSIONS(2)
VT_CONVERSIONS(3)
#undef VT_CONVERSIONS

}  // namespace veritope
