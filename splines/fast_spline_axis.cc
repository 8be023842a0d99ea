// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/fast_spline_axis.cc: cells, their buckets, and the error of the parameter in a cell.
#include <algorithm>

#include "robust/base/fp_guard.h"
#include "splines/fast_spline_tables_internal.h"

namespace veritope::internal {
namespace {

// docs/bounds/fast_spline.md, 3.
Rational parameter_error(const Rational& begin, const Rational& length, double origin,
                         double rate) {
  const Rational one(1), u = Rational::power_of_two(-53);
  const Rational e = abs(begin - Rational::from_double(origin)) / length;
  const Rational rho = abs(Rational::from_double(rate) * length - one);
  const Rational error =
      (one + e) * (one + u) * (one + u) * (one + rho) - one + Rational::power_of_two(-1074);
  return Rational::from_double(round_up(error));  // few digits: it is multiplied often
}

std::size_t bucket_of(const FastAxisStorage& axis, double u) {
  const auto bucket = static_cast<std::size_t>((u - axis.breaks[0]) * axis.per_bucket);
  return std::min(bucket, axis.buckets);
}

// first[b]: the last cell whose break lies in a bucket below b, so that a parameter in bucket b is in one of the cells
// first[b] .. first[b + 1].
void fill_buckets(FastAxisStorage& axis) {
  const std::size_t cells = axis.breaks.size() - 1;
  axis.buckets = std::min<std::size_t>(4 * cells, 1u << 16);
  axis.per_bucket = static_cast<double>(axis.buckets) / (axis.breaks.back() - axis.breaks[0]);
  axis.first.assign(axis.buckets + 2, 0);
  std::vector<std::uint32_t> last(axis.buckets + 1,
                                  0);  // the last cell that starts in the bucket, or 0
  for (std::size_t i = 0; i < cells; ++i)
    last[bucket_of(axis, axis.breaks[i])] = static_cast<std::uint32_t>(i);
  for (std::size_t b = 0; b <= axis.buckets; ++b)
    axis.first[b + 1] = std::max(axis.first[b], last[b]);
}

}  // namespace

Result<FastAxisStorage> make_fast_axis(int degree, const std::vector<Rational>& breaks) {
  FastAxisStorage axis;
  axis.degree = degree;
  const auto refused = [](const std::string& what) {
    return Error{Code::kOverLimit,
                 {},
                 what + ": fast evaluation needs knots up to 2^200, and spans from 2^-200"};
  };
  const Rational limit = Rational::from_double(kFastLimit);
  for (const Rational& knot : breaks)
    if (abs(knot) > limit) return refused("knot " + knot.to_string());
  // u >= a iff u >= round_up(a), for the binary64 numbers u.
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) axis.breaks.push_back(round_up(breaks[i]));
  axis.breaks.push_back(round_down(breaks.back()));
  if (!(axis.breaks[0] < axis.breaks.back()))
    return refused("no two binary64 numbers lie between " + breaks[0].to_string() + " and " +
                   breaks.back().to_string());
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const Rational length = breaks[i + 1] - breaks[i], exact_scale = Rational(degree) / length;
    if (exact_scale > limit) return refused("span " + length.to_string());
    axis.origin.push_back(round_down(breaks[i]));  // not above any parameter of the cell
    axis.rate.push_back(nearest_double(Rational(1) / length));
    axis.slope_scale.push_back(nearest_double(exact_scale));
    axis.scale_error.push_back(
        round_up(abs(Rational::from_double(axis.slope_scale.back()) - exact_scale)));
    axis.error.push_back(parameter_error(breaks[i], length, axis.origin.back(), axis.rate.back()));
  }
  const ScopedDefaultFp nearest;  // as the kernels will compute
  fill_buckets(axis);
  return axis;
}

}  // namespace veritope::internal
