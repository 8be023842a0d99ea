// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/direction.h: exact vectors whose length does not matter.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "predicates/vec.h"
#include "robust/dyadic.h"

namespace veritope {

/// A vector, which stands for all its positive multiples. With integers beside it that decide most signs.
class Direction {
 public:
  Direction() = default;  ///< zero, which is no direction
  explicit Direction(std::array<Dyadic, 3> vector);

  const Dyadic& operator[](std::size_t k) const { return vector_[k]; }
  bool is_zero() const {
    return vector_[0].sign() == 0 && vector_[1].sign() == 0 && vector_[2].sign() == 0;
  }

  /// For some integer s the components times 2^s differ from these integers by less than 1, and both are at most
  /// kMostApprox in absolute value.
  const std::array<std::int64_t, 3>& approx() const { return approx_; }
  static constexpr int kApproxBits = 38;
  static constexpr std::int64_t kMostApprox = std::int64_t{1} << kApproxBits;

 private:
  std::array<Dyadic, 3> vector_;
  std::array<std::int64_t, 3> approx_{};
};

Direction difference(const Vec3d& a, const Vec3d& b);
Direction axis_direction(std::size_t axis, int sign);
Direction operator+(const Direction& a, const Direction& b);
Direction operator-(const Direction& a);
Direction operator*(const Dyadic& s, const Direction& a);
Direction cross(const Direction& a, const Direction& b);
Dyadic dot(const Direction& a, const Direction& b);

/// The sign of dot(a, b): positive if the angle between them is acute, zero if it is right.
Sign side(const Direction& a, const Direction& b);
/// The sign of the determinant of n, a, b. For a and b in the plane with the normal n: positive if the turn from a to
/// b, by less than a half turn, is counter-clockwise around n.
Sign turn(const Direction& n, const Direction& a, const Direction& b);
/// Whether two normals have one plane: one is a multiple of the other, positive or negative.
bool is_parallel(const Direction& a, const Direction& b);

}  // namespace veritope
