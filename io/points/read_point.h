// SPDX-License-Identifier: LGPL-3.0-or-later
// io/points/read_point.h: points from lines of text: three coordinates a line, or two; and segments, six of them.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "io/base/decimal.h"
#include "io/base/read_limits.h"
#include "predicates/vec.h"
#include "robust/base/result.h"
#include "solids/classify/point_answer.h"

namespace veritope {

/// What a decimal coordinate means.
enum class Decimals { kNearest, kExact };

struct ReadPoint {
  std::array<std::string_view, 3> tokens;  ///< of the line; the third one is empty in the plane
  /// Vec3d if binary64 has all three coordinates.
  std::variant<Vec3d, ExactPoint> point;
};

/// Why a line is refused: the column, counted from 1, and what is wrong.
struct PointFault {
  std::size_t column = 0;
  std::string message;
};

/// The limits of a coordinate that docs/certificates/points.md has, whatever the limits of the reader are.
inline constexpr std::size_t kMostTokenBytes = 4096;
inline constexpr std::uint32_t kMostPointExponent = 4096;

/// Reads the lines of one file. Coordinates are decimals, hexadecimal numbers or fractions p/q, as section 2 of
/// docs/certificates/points.md says, separated by blanks, tabs, or one comma or semicolon. Fractions and hexadecimal
/// numbers are exact.
class PointLines {
 public:
  /// @param dimension  how many numbers a line has: 3, 2 for points with z = 0, or 6 for segments
  PointLines(Decimals decimals, const ReadLimits& limits, std::size_t dimension = 3);

  /// Nothing for a line without a point: empty, a comment after #, or a first line that consists of words. REQUIRES 8
  /// readable bytes after the line.
  /// @error the fault, in `fault`; then the result is empty, too
  std::optional<ReadPoint> read(std::string_view line, std::optional<PointFault>& fault);
  /// The two ends of a segment, exactly, from six numbers. REQUIRES dimension 6.
  std::optional<std::array<ExactPoint, 2>> read_segment(std::string_view line,
                                                        std::optional<PointFault>& fault);

 private:
  static constexpr std::size_t kMostNumbers = 6;
  using Number = std::variant<double, Rational>;
  struct Numbers {
    std::array<std::string_view, kMostNumbers> tokens;
    std::array<Number, kMostNumbers> values;
  };
  std::optional<Numbers> read_numbers(std::string_view line, std::optional<PointFault>& fault);
  bool read_token(std::string_view token, Number& value, std::string& why) const;

  Decimals decimals_;
  std::size_t dimension_;
  ReadLimits limits_;
  ReadLimits exact_limits_;  ///< of decimals that are exact, hexadecimal numbers and fractions
  DecimalReader reader_;
  bool is_first_ = true;
};

}  // namespace veritope
