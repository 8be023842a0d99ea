// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_similarity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace veritope {
namespace {

constexpr std::int64_t kModerate = 32;  // the exponent of lengths that are left as they are
const Rational kNear(2);                // lengths of the box from the origin, likewise

template <typename Map>
void map_places(DmsModel& model, Map map) {
  for (DmsCloud& cloud : model.clouds)
    for (DmsPoint& knot : cloud) knot = map(std::move(knot));
  const std::size_t components = model.num_components();
  for (std::size_t i = 0; i < model.control.values.size(); i += components) {
    Rational* const value = &model.control.values[i];
    DmsPoint image = map({value[0], value[1], value[2]});
    for (std::size_t c = 0; c < 3; ++c) value[c] = std::move(image[c]);
  }
}

}  // namespace

std::int64_t exponent_of(const Rational& x) {
  return static_cast<std::int64_t>(x.numerator().bit_length()) -
         static_cast<std::int64_t>(x.denominator().bit_length()) - 1;
}

DmsPoint DmsSimilarity::to_unit(DmsPoint x) const {
  const Rational factor = Rational::power_of_two(-exponent);
  for (std::size_t c = 0; c < 3; ++c) x[c] = factor * (x[c] - centre[c]);
  return x;
}

DmsPoint DmsSimilarity::from_unit(DmsPoint u) const {
  const Rational factor = Rational::power_of_two(exponent);
  for (std::size_t c = 0; c < 3; ++c) u[c] = centre[c] + factor * u[c];
  return u;
}

DmsPlane DmsSimilarity::to_unit(const DmsPlane& plane) const {
  Rational number = plane.number;
  for (std::size_t c = 0; c < 3; ++c) number -= plane.vector[c] * centre[c];
  return {plane.vector, Rational::power_of_two(-exponent) * number};
}

DmsModel DmsSimilarity::to_unit(DmsModel model) const {
  map_places(model, [this](DmsPoint p) { return to_unit(std::move(p)); });
  return model;
}

DmsModel DmsSimilarity::from_unit(DmsModel model) const {
  map_places(model, [this](DmsPoint p) { return from_unit(std::move(p)); });
  return model;
}

DmsSimilarity similarity_of(std::span<const DmsPoint> points) {
  DmsPoint low = points[0], high = points[0];
  for (const DmsPoint& p : points)
    for (std::size_t c = 0; c < 3; ++c) {
      low[c] = std::min(low[c], p[c]);
      high[c] = std::max(high[c], p[c]);
    }
  Rational length, farthest;
  for (std::size_t c = 0; c < 3; ++c) {
    length = std::max(length, high[c] - low[c]);
    farthest = std::max({farthest, abs(low[c]), abs(high[c])});
  }
  DmsSimilarity out;
  if (length.sign() == Sign::kZero) return out;
  const std::int64_t exponent = exponent_of(length);
  const bool is_moderate = -kModerate < exponent && exponent < kModerate;
  if (is_moderate && farthest <= kNear * length) return out;
  out.exponent = exponent;
  // A multiple of 2^exponent near the middle, so that coordinates do not become longer.
  const Rational unit = Rational::power_of_two(exponent);
  for (std::size_t c = 0; c < 3; ++c) {
    const Rational steps = (low[c] + high[c]) / (Rational(2) * unit);
    out.centre[c] = unit * Rational(floor_divide(steps.numerator(), steps.denominator()));
  }
  return out;
}

double scaled_up(double x, std::int64_t exponent) {
  constexpr std::int64_t kMost = 4000;  // beyond the exponents of all doubles
  const auto steps = static_cast<int>(std::clamp(exponent, -kMost, kMost));
  const double scaled = std::ldexp(x, steps);
  const bool is_exact = std::ldexp(scaled, -steps) == x;
  return is_exact || !std::isfinite(scaled)
             ? scaled
             : std::nextafter(scaled, std::numeric_limits<double>::infinity());
}

}  // namespace veritope
