// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/star_box_certificate.h"

#include "verify/format/byte_stream.h"
#include "verify/format/sha256.h"
#include "verify/format/star_box_statement.h"

namespace veritope::certificate {
namespace {

using internal::ByteWriter;

constexpr unsigned char kMagic[] = {'V', 'T', 'S', 'B'};

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
  internal::write(w, walk.path);
}

std::uint64_t zigzag_code(std::int64_t z) {
  return z >= 0 ? 2 * static_cast<std::uint64_t>(z) : 2 * static_cast<std::uint64_t>(-(z + 1)) + 1;
}

}  // namespace

Bytes encode(const StarBoxBody& body) {
  ByteWriter w;
  for (const unsigned char c : kMagic) w.u8(c);
  internal::write(w, body.entities);
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

Bytes encode(const Subject& subject, const StarBoxQuantities& q, const StarBoxBody& body,
             std::optional<std::int64_t> turned) {
  const Bytes bytes = encode(body);
  internal::StatementWriter w =
      internal::state_star_boxes(subject, turned ? kTurnedShellClaim : kStarBoxClaim, q, body, bytes);
  if (turned) w.number("winding", zigzag_code(*turned));
  return internal::join(w.take(), bytes);
}

namespace internal {

void write(ByteWriter& w, const WalkPath& path) {
  w.u32(static_cast<std::uint32_t>(path.points.size()));
  for (const WalkPoint& p : path.points) {
    w.varint(p.shift);
    for (const std::int64_t v : p.at) w.zigzag(v);
  }
  w.u8(path.end);
  if (path.end != 6) return;
  w.varint(path.end_box);
  w.u8(path.ends_outside ? 1 : 0);
}

StatementWriter state_star_boxes(const Subject& subject, std::string_view claim,
                                 const StarBoxQuantities& q, const StarBoxBody& body,
                                 const Bytes& bytes) {
  StatementWriter w;
  state_subject(w, subject, claim);
  w.text("body_sha256", to_hex(sha256(bytes)));
  w.number("patches", q.patches);
  w.number("edges", q.edges);
  w.number("vertices", q.vertices);
  w.number("shells", q.shells);
  w.number("bodies", q.bodies);
  w.number("genus", q.genus);
  w.number("boxes", body.boxes.size());
  w.number("flipped", num_flipped(body.entities));
  return w;
}

}  // namespace internal

}  // namespace veritope::certificate
