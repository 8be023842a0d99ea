// SPDX-License-Identifier: LGPL-3.0-or-later
// render/sample_rows_internal.h: the samples of some rows of a picture. A pixel has kSamples x kSamples of them, at the
// centres of equal squares; its colour is their mean.
#pragma once
#include <cstddef>
#include <cstdint>

#include "render/scene_camera_internal.h"

namespace veritope::internal {

inline constexpr std::size_t kSamples = 3;

/// Rows [first, first + count) of samples, each of `width` samples.
struct SampleRows {
  std::size_t width = 0, first = 0, count = 0;

  std::size_t size() const { return width * count; }
  std::size_t end() const { return first + count; }
  /// REQUIRES a row and a column of these.
  std::size_t index(std::size_t column, std::size_t row) const {
    return (row - first) * width + column;
  }
};

/// Orders what covers a sample, the nearest first: by the depth, rounded, then by `order`. The lowest bit is a tag that
/// does not matter, since no two things have the same order. REQUIRES 0 <= depth <= kDeepest.
inline std::uint64_t depth_key(double depth, std::uint32_t order, bool tag) {
  return static_cast<std::uint64_t>(depth + 0.5) << 33 | std::uint64_t{order} << 1 | (tag ? 1 : 0);
}
/// Larger than the key of any depth, with a tag that is set.
inline constexpr std::uint64_t kNoKey = ~std::uint64_t{0};
inline std::uint64_t depth_of(std::uint64_t key) { return key >> 33; }
inline std::uint32_t order_of(std::uint64_t key) { return static_cast<std::uint32_t>(key >> 1); }
inline bool tag_of(std::uint64_t key) { return (key & 1) != 0; }

}  // namespace veritope::internal
