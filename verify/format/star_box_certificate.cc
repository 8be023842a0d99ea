// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/star_box_certificate.h"

#include "verify/format/byte_stream.h"
#include "verify/format/sha256.h"
#include "verify/format/statement_writer.h"

namespace veritope::certificate {
namespace {

using internal::ByteWriter;

constexpr unsigned char kMagic[] = {'V', 'T', 'S', 'B'};

// Nothing if it does not fit 63 bits.
std::optional<std::uint64_t> small(const Natural& n) {
  if (n.size() > 8 || (n.size() == 8 && n.back() >= 128)) return std::nullopt;
  std::uint64_t v = 0;
  for (std::size_t i = n.size(); i-- > 0;) v = v << 8 | n[i];
  return v;
}

void write(ByteWriter& w, const Fraction& f) {
  const auto p = small(f.numerator), q = small(f.denominator);
  if (p && q) {
    w.zigzag(f.is_negative ? -static_cast<std::int64_t>(*p) : static_cast<std::int64_t>(*p));
    w.varint(*q);
    return;
  }
  w.zigzag(0);
  w.varint(0);
  w.varint(f.numerator.size() + 1);
  w.u8(f.is_negative ? 1 : 0);
  w.raw(f.numerator);
  w.varint(f.denominator.size());
  w.raw(f.denominator);
}

void write(ByteWriter& w, const StarBoxItem& b) {
  w.u8(b.is_mesh ? 1 : 0);
  w.varint(b.shift);
  for (const std::int64_t v : b.low) w.zigzag(v);
  for (const std::uint64_t v : b.size) w.varint(v);
  if (b.is_mesh) return;
  for (const auto* triple : {&b.inside, &b.outside})
    for (const std::uint64_t v : *triple) w.varint(v);
}

void write(ByteWriter& w, const StarWalk& walk) {
  w.varint(walk.box);
  w.u8(walk.starts_outside ? 1 : 0);
  w.u32(static_cast<std::uint32_t>(walk.points.size()));
  for (const WalkPoint& p : walk.points) {
    w.varint(p.shift);
    for (const std::int64_t v : p.at) w.zigzag(v);
  }
  w.u8(walk.end);
  if (walk.end != 6) return;
  w.varint(walk.end_box);
  w.u8(walk.ends_outside ? 1 : 0);
}

std::uint64_t zigzag_code(std::int64_t z) {
  return z >= 0 ? 2 * static_cast<std::uint64_t>(z) : 2 * static_cast<std::uint64_t>(-(z + 1)) + 1;
}

}  // namespace

Bytes encode(const StarBoxBody& body) {
  ByteWriter w;
  w.raw(kMagic);
  w.u32(static_cast<std::uint32_t>(body.entities.size()));
  for (const PatchEntity& e : body.entities) w.u8(e.is_reversed ? 1 : 0);
  for (const PatchEntity& e : body.entities) {
    if (!e.is_surface) continue;
    for (const auto& axis : e.breaks) {
      w.u32(static_cast<std::uint32_t>(axis.size()));
      for (const Fraction& f : axis) write(w, f);
    }
  }
  for (const auto& ab : body.roots) w.raw(ab);
  w.zigzag(body.exponent);
  w.u32(static_cast<std::uint32_t>(body.boxes.size()));
  for (const StarBoxItem& b : body.boxes) write(w, b);
  std::int64_t last = 0;
  for (const std::int64_t symbol : body.trees) {
    if (symbol == kSplit) {
      w.varint(0);
      continue;
    }
    w.varint(1 + zigzag_code(symbol - last));
    last = symbol;
  }
  w.u32(static_cast<std::uint32_t>(body.walks.size()));
  for (const StarWalk& walk : body.walks) write(w, walk);
  return w.take();
}

Bytes encode(const Subject& subject, const StarBoxQuantities& q, const StarBoxBody& body) {
  const Bytes bytes = encode(body);
  std::uint64_t flipped = 0;
  for (const PatchEntity& e : body.entities) flipped += e.is_reversed ? 1 : 0;
  internal::StatementWriter w;
  internal::state_subject(w, subject, kStarBoxClaim);
  w.text("body_sha256", to_hex(sha256(bytes)));
  w.number("patches", q.patches);
  w.number("edges", q.edges);
  w.number("vertices", q.vertices);
  w.number("shells", q.shells);
  w.number("bodies", q.bodies);
  w.number("genus", q.genus);
  w.number("boxes", body.boxes.size());
  w.number("flipped", flipped);
  return internal::join(w.take(), bytes);
}

}  // namespace veritope::certificate
