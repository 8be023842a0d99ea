// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/direction.h: exact vectors whose length does not matter.
#pragma once
#include <array>
#include <cstddef>

#include "predicates/vec.h"
#include "robust/dyadic.h"

namespace veritope {

/// A vector and its positive multiples are one direction; zero does not occur.
using Direction = std::array<Dyadic, 3>;

inline Direction difference(const Vec3d& a, const Vec3d& b) {
  Direction out;
  for (std::size_t k = 0; k < 3; ++k) {
    const int i = static_cast<int>(k);
    out[k] = Dyadic::from_double(a[i]) - Dyadic::from_double(b[i]);
  }
  return out;
}
inline Direction axis_direction(std::size_t axis, int sign) {
  Direction out;
  out[axis] = Dyadic(sign);
  return out;
}
inline Direction operator+(const Direction& a, const Direction& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Direction operator-(const Direction& a) { return {-a[0], -a[1], -a[2]}; }
inline Direction operator*(const Dyadic& s, const Direction& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
inline Dyadic dot(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Direction cross(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline bool is_zero(const Direction& a) {
  return a[0].sign() == 0 && a[1].sign() == 0 && a[2].sign() == 0;
}
/// Positive if the angle between them is acute, zero if it is right.
inline Sign side(const Direction& a, const Direction& b) { return dot(a, b).sign(); }
/// Positive if the turn from a to b, by less than a half turn, is counter-clockwise around n. REQUIRES a and b in the
/// plane with the normal n.
inline Sign turn(const Direction& n, const Direction& a, const Direction& b) {
  return dot(n, cross(a, b)).sign();
}

}  // namespace veritope
