// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/mesh/vertex_rounding_internal.h: vertices of a mesh in the middle of the boxes that contain them, and
// how far that moves them at most. Internal to solids/micro/mesh.
#pragma once
#include <atomic>
#include <bit>
#include <cstdint>
#include <limits>

#include "interval/box.h"
#include "predicates/vec.h"

namespace veritope::internal {

/// The greatest of numbers >= 0 that several threads have.
class Greatest {
 public:
  double value() const { return std::bit_cast<double>(bits_.load(std::memory_order_relaxed)); }
  void reach(double x) {
    // Bits of numbers >= 0 are ordered as the numbers are; infinity is the greatest.
    const auto bits = std::bit_cast<std::uint64_t>(x);
    std::uint64_t seen = bits_.load(std::memory_order_relaxed);
    while (seen < bits && !bits_.compare_exchange_weak(seen, bits, std::memory_order_relaxed)) {
    }
  }

 private:
  std::atomic<std::uint64_t> bits_{0};
};

/// The middle of the box, and the greatest distance of its points from it. REQUIRES a live ScopedUpward.
inline Vec3d middle_of(const Box3& box, Greatest& rounding) {
  std::array<double, 3> at;
  Interval square;
  for (std::size_t c = 0; c < 3; ++c) {
    const MidRad m = mid_rad(box[c]);
    at[c] = m.mid + 0.0;  // no -0
    square +=
        sqr(Interval::from_bounds(0, m.rad >= 0 ? m.rad : std::numeric_limits<double>::infinity()));
  }
  rounding.reach(sqrt(square).hi());
  return {at[0], at[1], at[2]};
}

}  // namespace veritope::internal
