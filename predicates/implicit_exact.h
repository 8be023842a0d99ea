// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/implicit_exact.h: the exact sign of a polynomial in coordinates, on the stack if there is room, otherwise
// in integers of any size. Only this file makes that choice.
#pragma once
#include <type_traits>

#include "predicates/implicit_homogeneous.h"
#include "robust/base/sign.h"
#include "robust/integer.h"
#include "robust/stack_integer.h"

namespace veritope::internal {

/// orient3d of four points of three planes each has degree 39 in coordinates of one limb, in_sphere of
/// five such points 105.
inline constexpr int kStackLimbs = 44, kManyStackLimbs = 112;

/// value(std::type_identity<T>()) is the polynomial over the ring T. IsLong: for in_circle and in_sphere.
template <bool IsLong, typename Value>
Sign exact_sign(Value value) {
  const Sign3 s = value(std::type_identity<StackInteger<kStackLimbs>>()).sign();
  if (is_certain(s)) return to_sign(s);
  if constexpr (IsLong) {
    const Sign3 t = value(std::type_identity<StackInteger<kManyStackLimbs>>()).sign();
    if (is_certain(t)) return to_sign(t);
  }
  return value(std::type_identity<Integer>()).sign();
}

}  // namespace veritope::internal
