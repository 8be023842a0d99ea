// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/patch_meeting_certificate.h"

#include <utility>

#include "verify/format/byte_stream.h"
#include "verify/format/sha256.h"
#include "verify/format/statement_writer.h"

namespace veritope::certificate {

using internal::ByteReader;
using internal::ByteWriter;

Bytes encode(const PatchMeetingBody& body) {
  ByteWriter w;
  w.text(kPatchInvalid2Magic);
  internal::write_with_kinds(w, body.entities);
  for (const MeetingPlace& place : body.places) {
    w.varint(place.patch);
    for (const UnitFraction& t : place.at) {
      w.varint(t.numerator);
      w.varint(t.denominator);
    }
  }
  return w.take();
}

Bytes encode(const Subject& subject, std::uint64_t patches, const PatchMeetingBody& body) {
  const Bytes bytes = encode(body);
  internal::StatementWriter w;
  internal::state_subject(w, subject, kPatchInvalid2Claim);
  w.text("body_sha256", to_hex(sha256(bytes)));
  w.text("finding", "meeting");
  w.number("patches", patches);
  w.number("flipped", num_reversed(body.entities));
  return internal::join(w.take(), bytes);
}

std::optional<PatchMeetingBody> internal::read_patch_meeting(ByteReader r) {
  PatchMeetingBody out;
  r.raw(kPatchInvalid2Magic.size());
  if (!read_with_kinds(r, out.entities)) return std::nullopt;
  for (MeetingPlace& place : out.places) {
    place.patch = r.varint();
    for (UnitFraction& t : place.at) {
      t.numerator = r.varint();
      t.denominator = r.varint();
    }
  }
  return r.at_end() ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace veritope::certificate
