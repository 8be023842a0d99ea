// SPDX-License-Identifier: Apache-2.0 OR MIT
// The certificates of balls as plain data, their encoding and a text dump. The page: docs/certificates/ball.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "verify/format/mesh_certificate.h"

namespace veritope::certificate {

inline constexpr std::string_view kBallClaim = "ball-1", kBallInvalidClaim = "ball-invalid-1";
inline constexpr std::string_view kBallMagic = "VTBL", kBallInvalidMagic = "VTBN";

/// digits / 10^decimals.
struct BallNumber {
  std::int64_t digits = 0;
  std::uint8_t decimals = 0;
};
/// "-0.5"
std::string text_of(const BallNumber& number);

struct BallBody {
  bool is_solid = false;              ///< which of the two claims
  std::array<BallNumber, 4> numbers;  ///< of the file: the centre, then the radius
};

Bytes encode(const BallBody& body);
Bytes encode(const Subject& subject, const BallBody& body);
std::string explain(const BallBody& body, std::string_view claim, std::size_t max_items);

namespace internal {
std::optional<BallBody> read_ball_body(ByteReader body);
}  // namespace internal

}  // namespace veritope::certificate
