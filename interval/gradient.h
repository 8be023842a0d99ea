// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/gradient.h: a number with its first derivatives, in intervals (forward differentiation), so that the same
// formula gives a value at a point and its slopes over a box.
#pragma once
#include <array>
#include <cstddef>

#include "interval/interval.h"

namespace veritope {

/// Encloses f and its partial derivatives with respect to N parameters, at every point of a set. Operations REQUIRE a
/// live ScopedUpward. Slopes are unbounded where a divisor or the argument of a root may be 0.
template <std::size_t N>
struct Gradient {
  Interval value;
  std::array<Interval, N> slope{};

  friend Gradient operator-(const Gradient& a) {
    Gradient out{-a.value, {}};
    for (std::size_t i = 0; i < N; ++i) out.slope[i] = -a.slope[i];
    return out;
  }
  friend Gradient operator+(const Gradient& a, const Gradient& b) {
    Gradient out{a.value + b.value, {}};
    for (std::size_t i = 0; i < N; ++i) out.slope[i] = a.slope[i] + b.slope[i];
    return out;
  }
  friend Gradient operator-(const Gradient& a, const Gradient& b) {
    Gradient out{a.value - b.value, {}};
    for (std::size_t i = 0; i < N; ++i) out.slope[i] = a.slope[i] - b.slope[i];
    return out;
  }
  friend Gradient operator*(const Gradient& a, const Gradient& b) {
    Gradient out{a.value * b.value, {}};
    for (std::size_t i = 0; i < N; ++i) out.slope[i] = a.value * b.slope[i] + b.value * a.slope[i];
    return out;
  }
  friend Gradient operator/(const Gradient& a, const Gradient& b) {
    Gradient out{a.value / b.value, {}};
    for (std::size_t i = 0; i < N; ++i)
      out.slope[i] = (a.slope[i] - out.value * b.slope[i]) / b.value;
    return out;
  }
  friend Gradient operator*(const Interval& k, const Gradient& a) {
    Gradient out{k * a.value, {}};
    for (std::size_t i = 0; i < N; ++i) out.slope[i] = k * a.slope[i];
    return out;
  }
  friend Gradient sqr(const Gradient& a) {
    Gradient out{sqr(a.value), {}};
    const Interval twice = a.value + a.value;
    for (std::size_t i = 0; i < N; ++i) out.slope[i] = twice * a.slope[i];
    return out;
  }
  friend Gradient sqrt(const Gradient& a) {
    Gradient out{sqrt(a.value), {}};
    const Interval twice = out.value + out.value;
    for (std::size_t i = 0; i < N; ++i) out.slope[i] = a.slope[i] / twice;
    return out;
  }
};

}  // namespace veritope
