// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/ball_certificate.h"

#include <algorithm>

#include "verify/format/byte_stream.h"
#include "verify/format/sha256.h"
#include "verify/format/statement_writer.h"

namespace veritope::certificate {

std::string text_of(const BallNumber& number) {
  const std::uint64_t value = static_cast<std::uint64_t>(number.digits);
  std::string digits = std::to_string(number.digits < 0 ? 0 - value : value);
  if (digits.size() <= number.decimals) digits.insert(0, number.decimals + 1 - digits.size(), '0');
  if (number.decimals > 0) digits.insert(digits.size() - number.decimals, ".");
  return (number.digits < 0 ? "-" : "") + digits;
}

Bytes encode(const BallBody& body) {
  internal::ByteWriter w;
  w.text(body.is_solid ? kBallMagic : kBallInvalidMagic);
  for (const BallNumber& n : body.numbers) {
    const auto bits = static_cast<std::uint64_t>(n.digits);
    w.u32(static_cast<std::uint32_t>(bits));
    w.u32(static_cast<std::uint32_t>(bits >> 32));
    w.u8(n.decimals);
  }
  return w.take();
}

Bytes encode(const Subject& subject, const BallBody& body) {
  const Bytes bytes = encode(body);
  internal::StatementWriter w;
  internal::state_subject(w, subject, body.is_solid ? kBallClaim : kBallInvalidClaim);
  w.text("radius", text_of(body.numbers[3]));
  w.text("body_sha256", to_hex(sha256(bytes)));
  return internal::join(w.take(), bytes);
}

std::optional<BallBody> internal::read_ball_body(ByteReader r) {
  BallBody b;
  const auto magic = r.raw(4);
  b.is_solid = std::equal(magic.begin(), magic.end(), kBallMagic.begin(), kBallMagic.end());
  for (BallNumber& n : b.numbers) {
    const std::uint64_t low = r.u32(), high = r.u32();
    n.digits = static_cast<std::int64_t>(high << 32 | low);
    n.decimals = r.u8();
  }
  if (!r.at_end()) return std::nullopt;
  return b;
}

std::string explain(const BallBody& b, std::string_view claim, std::size_t) {
  return std::string(claim) + ": the ball with the centre (" + text_of(b.numbers[0]) + ", " +
         text_of(b.numbers[1]) + ", " + text_of(b.numbers[2]) + ") and the radius " +
         text_of(b.numbers[3]) +
         (b.is_solid ? " is a solid: its radius is positive\n"
                     : " is no solid: its radius is not positive\n");
}

}  // namespace veritope::certificate
