// SPDX-License-Identifier: LGPL-3.0-or-later
// Files of one ball: three lines of text, docs/certificates/ball.md.
#pragma once
#include <cstdint>
#include <string>

#include "io/base/read_limits.h"
#include "io/base/source.h"
#include "solids/ball/ball.h"

namespace veritope {

enum class BallFormat { kBall };

struct BallFile {
  static constexpr const char* kTitle = "a ball";
  static constexpr std::uint64_t kCentreLine = 2, kRadiusLine = 3;

  Ball ball;
  BallFormat format = BallFormat::kBall;
  std::uint64_t bytes = 0;
  std::string sha256;  ///< of the bytes that were read, 64 lower-case hex digits
  double seconds_read = 0, seconds_parse = 0, seconds_hash = 0;
};

/// The first line is "ball".
bool looks_like_ball(const Source& source);

/// Leaves sha256 and the seconds open. @error kSyntax, kOverLimit for more than 18 digits, with the line
Result<BallFile> read_ball(BallFormat format, const Source& source, const ReadLimits& limits);

}  // namespace veritope
