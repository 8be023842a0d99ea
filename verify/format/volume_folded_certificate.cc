// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/volume_folded_certificate.h"

#include "verify/format/sha256.h"
#include "verify/format/statement_writer.h"

namespace veritope::certificate {

using internal::ByteReader;
using internal::ByteWriter;

Bytes encode(const VolumeFoldedBody& body) {
  ByteWriter w;
  w.text(kVolumeFoldedMagic);
  w.u32(body.volumes);
  w.varint(body.entity);
  for (const auto& point : body.points)
    for (const PieceFraction& t : point) {
      w.varint(t.piece);
      w.varint(t.at.numerator);
      w.varint(t.at.denominator);
    }
  return w.take();
}

Bytes encode(const Subject& subject, const VolumeFoldedBody& body) {
  const Bytes bytes = encode(body);
  internal::StatementWriter w;
  internal::state_subject(w, subject, kVolumeFoldedClaim);
  w.text("body_sha256", to_hex(sha256(bytes)));
  w.number("volumes", body.volumes);
  w.number("entity", body.entity);
  return internal::join(w.take(), bytes);
}

std::optional<VolumeFoldedBody> internal::read_volume_folded(ByteReader r) {
  VolumeFoldedBody out;
  r.raw(kVolumeFoldedMagic.size());
  out.volumes = r.u32();
  out.entity = r.varint();
  for (auto& point : out.points)
    for (PieceFraction& t : point) {
      t.piece = r.varint();
      t.at.numerator = r.varint();
      t.at.denominator = r.varint();
    }
  return r.at_end() ? std::optional(out) : std::nullopt;
}

}  // namespace veritope::certificate
