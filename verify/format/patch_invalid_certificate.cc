// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/patch_invalid_certificate.h"

#include "verify/format/byte_stream.h"
#include "verify/format/sha256.h"
#include "verify/format/statement_writer.h"

namespace veritope::certificate {
namespace {

using internal::ByteReader;
using internal::ByteWriter;

void write(ByteWriter& w, const UnitInterval& t) {
  w.varint(t.bits);
  w.varint(t.low);
  w.varint(t.high);
}

void write(ByteWriter& w, const CrossingFinding& finding) {
  w.u8(0);
  for (const RestrictedPatch& sheet : finding.sheets) {
    w.varint(sheet.patch);
    for (const UnitInterval& t : sheet.at) write(w, t);
  }
  for (const auto& row : finding.rows)
    for (const std::int64_t v : row) w.zigzag(v);
}

void write(ByteWriter& w, const SideFinding& finding) {
  w.u8(1);
  w.u32(static_cast<std::uint32_t>(finding.arcs.size()));
  for (const PatchArc& arc : finding.arcs) {
    w.varint(arc.patch);
    w.u8(arc.side);
    write(w, arc.at);
  }
  w.u8(finding.axis);
  w.varint(finding.point_bits);
  w.varint(finding.point);
}

UnitInterval read_interval(ByteReader& r) {
  const std::uint64_t bits = r.varint(), low = r.varint();
  return {bits, low, r.varint()};
}

CrossingFinding read_crossing(ByteReader& r) {
  CrossingFinding finding;
  for (RestrictedPatch& sheet : finding.sheets) {
    sheet.patch = r.varint();
    for (UnitInterval& t : sheet.at) t = read_interval(r);
  }
  for (auto& row : finding.rows)
    for (std::int64_t& v : row) v = r.zigzag();
  return finding;
}

SideFinding read_sides(ByteReader& r) {
  SideFinding finding;
  for (std::uint32_t i = 0, n = r.count(5); i < n && r.ok(); ++i) {
    const std::uint64_t patch = r.varint();
    const std::uint8_t side = r.u8();
    finding.arcs.push_back({patch, side, read_interval(r)});
  }
  finding.axis = r.u8();
  finding.point_bits = r.varint();
  finding.point = r.varint();
  return finding;
}

}  // namespace

Bytes encode(const PatchInvalidBody& body) {
  ByteWriter w;
  w.text(kPatchInvalidMagic);
  internal::write(w, body.entities);
  std::visit([&](const auto& finding) { write(w, finding); }, body.finding);
  return w.take();
}

Bytes encode(const Subject& subject, std::uint64_t patches, const PatchInvalidBody& body) {
  const Bytes bytes = encode(body);
  const auto* const sides = std::get_if<SideFinding>(&body.finding);
  internal::StatementWriter w;
  internal::state_subject(w, subject, kPatchInvalidClaim);
  w.text("body_sha256", to_hex(sha256(bytes)));
  w.text("finding", sides != nullptr ? "side" : "crossing");
  w.number("patches", patches);
  w.number("flipped", num_reversed(body.entities));
  w.number("same", sides != nullptr ? sides->same : 0);
  w.number("opposite", sides != nullptr ? sides->opposite : 0);
  return internal::join(w.take(), bytes);
}

void internal::read(ByteReader& r, std::uint64_t, PatchInvalidBody& out) {
  const std::uint8_t kind = r.u8();
  if (kind > 1) return r.fail();
  if (kind == 0)
    out.finding = read_crossing(r);
  else
    out.finding = read_sides(r);
}

}  // namespace veritope::certificate
