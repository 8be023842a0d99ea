// SPDX-License-Identifier: LGPL-3.0-or-later
// io/points/read_point.h: points from lines of text: three coordinates a line, or two.
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
  /// @param dimension  the number of coordinates of a point: 3, or 2 with z = 0
  PointLines(Decimals decimals, const ReadLimits& limits, std::size_t dimension = 3);

  /// Nothing for a line without a point: empty, a comment after #, or a first line that consists of words. REQUIRES 8
  /// readable bytes after the line.
  /// @error the fault, in `fault`; then the result is empty, too
  std::optional<ReadPoint> read(std::string_view line, std::optional<PointFault>& fault);

 private:
  bool read_token(std::string_view token, std::variant<double, Rational>& value,
                  std::string& why) const;

  Decimals decimals_;
  std::size_t dimension_;
  ReadLimits limits_;
  ReadLimits exact_limits_;  ///< of decimals that are exact, hexadecimal numbers and fractions
  DecimalReader reader_;
  bool is_first_ = true;
};

}  // namespace veritope
