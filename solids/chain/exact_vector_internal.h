// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/exact_vector_internal.h: vectors of rationals. Internal to solids/chain.
#pragma once
#include "solids/classify/point_answer.h"

namespace veritope::internal {

inline ExactPoint minus(const ExactPoint& a, const ExactPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline ExactPoint plus(const ExactPoint& a, const ExactPoint& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline ExactPoint times(const Rational& s, const ExactPoint& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
inline Rational dot(const ExactPoint& a, const ExactPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline ExactPoint cross(const ExactPoint& a, const ExactPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline bool is_zero(const ExactPoint& a) {
  return a[0].sign() == 0 && a[1].sign() == 0 && a[2].sign() == 0;
}

}  // namespace veritope::internal
