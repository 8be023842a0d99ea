// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/collar_certificate.h"

#include "verify/format/byte_stream.h"
#include "verify/format/star_box_statement.h"

namespace veritope::certificate {

Bytes encode(const CollarBody& body) {
  internal::ByteWriter w;
  w.raw(encode(body.star));
  w.varint(body.shift);
  for (const std::int64_t v : body.corner) w.zigzag(v);
  w.u32(static_cast<std::uint32_t>(body.cells.size()));
  std::uint64_t last_code = 0;
  for (const std::uint64_t code : body.cells) w.varint(code - last_code), last_code = code;
  w.u32(static_cast<std::uint32_t>(body.sides.size()));
  w.raw(body.sides);
  std::int64_t last_face = 0;
  for (const std::uint32_t face : body.collapses)
    w.zigzag(std::int64_t{face} - last_face), last_face = face;
  w.raw(body.leaves);
  for (const WalkPath& shore : body.shores) internal::write(w, shore);
  return w.take();
}

Bytes encode(const Subject& subject, const StarBoxQuantities& q, const CollarBody& body) {
  const Bytes bytes = encode(body);
  internal::StatementWriter w =
      internal::state_star_boxes(subject, kCollarClaim, q, body.star, bytes);
  w.number("cells", body.cells.size());
  return internal::join(w.take(), bytes);
}

}  // namespace veritope::certificate
