// SPDX-License-Identifier: LGPL-3.0-or-later
#include <cmath>

#include "solids/classify/ray_point.h"

namespace veritope {

// Dividing a double by a power of two is exact, or loses less than 2^-1074.
RayPoint::RayPoint(const Vec3d& p, int scale) : given_(p) {
  constexpr double kLost = 0x1p-1074;
  for (std::size_t k = 0; k < 3; ++k) {
    const double c = p[static_cast<int>(k)];
    rounded_[k] = std::ldexp(c, -scale);
    const double lost = std::ldexp(rounded_[k], scale) == c ? 0 : kLost;
    box_.lo[k] = rounded_[k] - lost;
    box_.hi[k] = rounded_[k] + lost;
  }
}

RayPoint::RayPoint(const ExactPoint& p, int scale) : has_exact_(true), exact_(p) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational x = p[k] * Rational::power_of_two(-scale);
    rounded_[k] = nearest_double(x);
    box_.lo[k] = round_down(x);
    box_.hi[k] = round_up(x);
  }
}

const ExactPoint& RayPoint::exact() const {
  if (!has_exact_) {
    for (std::size_t k = 0; k < 3; ++k)
      exact_[k] = Rational::from_double(given_[static_cast<int>(k)]);
    has_exact_ = true;
  }
  return exact_;
}

RayPoint::Fractions RayPoint::fractions() const {
  Fractions out;
  for (const Rational& x : exact()) out.denominator = lcm(out.denominator, x.denominator());
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational& x = exact()[k];
    out.numerators[k] = x.numerator() * divide_exactly(out.denominator, x.denominator());
  }
  return out;
}

}  // namespace veritope
