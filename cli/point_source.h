// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/point_source.h: the points of a file, some at a time, in constant memory.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/points/read_point.h"

namespace veritope::cli {

/// Points in the order of the file.
struct PointBatch {
  std::vector<Vec3d> points;  ///< rounded, where binary64 does not have a coordinate
  /// The points with such coordinates, by their number in the batch.
  std::vector<std::pair<std::size_t, ExactPoint>> exact;

  /// The coordinates as given, one blank between them; of .npy files as hexadecimal numbers.
  std::string_view text(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
    return std::string_view(text_).substr(begin, ends_[i] - begin);
  }
  std::size_t size() const { return points.size(); }
  void clear();
  /// @param tokens  the third one is empty for a point of the plane
  void add(const std::array<std::string_view, 3>& tokens, const Vec3d& point);

 private:
  std::string text_;
  std::vector<std::size_t> ends_;
};

class PointSource {
 public:
  static constexpr std::size_t kBatch = std::size_t{1} << 16;

  virtual ~PointSource() = default;
  /// Replaces the batch by the next points; it is empty after the last one.
  /// @error with FILE:LINE as the file and the column in the message; or the row of an .npy file
  virtual Status next(PointBatch& batch) = 0;
};

/// Opens a text or an .npy file; "-" is standard input.
/// @param dimension  the number of coordinates of a point: 3, or 2 with z = 0
/// @error kCannotOpen, and as read_npy_header
Result<std::unique_ptr<PointSource>> open_points(const std::string& path, Decimals decimals,
                                                 const ReadLimits& limits,
                                                 std::size_t dimension = 3);

}  // namespace veritope::cli
