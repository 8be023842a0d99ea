// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/value3.h: the value that a solid has on a set of points, if it has one.
#pragma once
#include <cstdint>

namespace veritope {

/// 1 on a set of interior points, 0 on a set of points off the solid. Mixed: neither of both is proved. For a point
/// that is decided, mixed means that it lies on the boundary.
enum class Value3 : std::uint8_t { kZero, kOne, kMixed };

constexpr bool is_constant(Value3 v) { return v != Value3::kMixed; }
constexpr Value3 to_value(bool bit) { return bit ? Value3::kOne : Value3::kZero; }
constexpr Value3 complement_of(Value3 v) {
  return v == Value3::kMixed ? v : to_value(v == Value3::kZero);
}

}  // namespace veritope
