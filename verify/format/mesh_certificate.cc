// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/mesh_certificate.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "verify/format/byte_stream.h"
#include "verify/format/sha256.h"
#include "verify/format/statement_line_internal.h"
#include "verify/format/statement_writer.h"

namespace veritope::certificate {
namespace {

using internal::ByteReader;
using internal::ByteWriter;
using internal::join;
using internal::StatementWriter;

void state_mesh(StatementWriter& w, const Subject& s, std::string_view claim, const Bytes& body) {
  internal::state_subject(w, s, claim);
  w.text("reading_rule", s.reading_rule);
  w.boolean("as_indexed", s.as_indexed);
  w.text("body_sha256", to_hex(sha256(body)));
}

std::string rules_of(const InvalidBody& body) {
  std::string rules;
  int last = 0;
  for (const Witness& w : body.witnesses) {
    if (w.rule == last) continue;
    last = w.rule;
    rules += (rules.empty() ? "M" : " M") + std::to_string(last);
  }
  return rules;
}

void write(ByteWriter& w, const Natural& n) {
  w.u32(static_cast<std::uint32_t>(n.size()));
  w.raw(n);
}

void write(ByteWriter& w, const Witness& x) {
  w.u8(x.rule);
  w.u32(x.first);
  if (x.rule >= 2 && x.rule <= 5) w.u32(x.second);
  if (x.rule == 7) {
    w.u32(x.second);
    for (const Natural& n : x.weights) write(w, n);
  }
  if (x.rule >= 8) w.u8(x.axis);
}

Witness read_witness(ByteReader& r) {
  Witness x;
  x.rule = r.u8();
  if (x.rule < 1 || x.rule > 9) r.fail();
  x.first = r.u32();
  if ((x.rule >= 2 && x.rule <= 5) || x.rule == 7) x.second = r.u32();
  if (x.rule == 7)
    for (Natural& n : x.weights) {
      const auto bytes = r.raw(r.count(1));
      n.assign(bytes.begin(), bytes.end());
      if (!n.empty() && n.back() == 0) r.fail();  // not the shortest form
    }
  if (x.rule >= 8) x.axis = r.u8();
  return x;
}

// The numbers of triangles and vertices, which follow the magic.
std::uint32_t read_counts(ByteReader& r, ValidBody& b) {
  r.raw(4);
  const std::uint32_t faces = r.count(4);
  b.num_vertex_ids = r.u32();
  return faces;
}

// What follows the numbers, up to the end.
void read_proof(ByteReader& r, std::uint32_t faces, ValidBody& b) {
  if (!r.ok() || faces > r.left() / 4) return r.fail();
  for (std::uint32_t i = 0; i < faces; ++i) b.order.push_back(r.u32());
  const auto stars = r.raw(b.num_vertex_ids);
  b.stars.assign(stars.begin(), stars.end());
  for (std::uint32_t i = 0, n = r.count(12); i < n; ++i) {
    const std::int32_t x = r.i32(), y = r.i32(), z = r.i32();
    b.star_vectors.push_back({x, y, z});
  }
  std::uint64_t next = 0;
  for (std::uint32_t i = 0, n = r.count(4); i < n && r.ok(); ++i) {
    Separator s;
    s.index = next + r.varint();
    next = s.index + 1;
    for (auto& c : s.direction) {
      const std::int64_t value = r.zigzag();
      if (value < -0x7fffffff || value > 0x7fffffff) r.fail();
      c = static_cast<std::int32_t>(value);
    }
    b.separators.push_back(s);
  }
  const auto codes = r.raw(r.count(1));
  b.codes.assign(codes.begin(), codes.end());
  const auto nesting = r.raw(r.left());
  b.nesting.assign(nesting.begin(), nesting.end());
}

void write_proof(ByteWriter& w, const ValidBody& b) {
  for (std::uint32_t f : b.order) w.u32(f);
  w.raw(b.stars);
  w.u32(static_cast<std::uint32_t>(b.star_vectors.size()));
  for (const auto& d : b.star_vectors)
    for (std::int32_t c : d) w.i32(c);
  w.u32(static_cast<std::uint32_t>(b.separators.size()));
  std::uint64_t next = 0;
  for (const Separator& s : b.separators) {
    w.varint(s.index - next);
    next = s.index + 1;
    for (std::int32_t c : s.direction) w.zigzag(c);
  }
  w.u32(static_cast<std::uint32_t>(b.codes.size()));
  w.raw(b.codes);
  w.raw(b.nesting);
}

void state_quantities(StatementWriter& w, const Quantities& q) {
  w.number("vertices", q.vertices);
  w.number("edges", q.edges);
  w.number("faces", q.faces);
  w.number("shells", q.shells);
  w.number("bodies", q.bodies);
  w.number("genus", q.genus);
  w.text("volume", q.volume);
}

void write_counts(ByteWriter& w, std::string_view magic, const ValidBody& b) {
  w.reserve(64 + 4 * b.order.size() + b.order.size() / 8 + b.stars.size() +
            12 * b.separators.size() + b.codes.size());
  w.text(magic);
  w.u32(static_cast<std::uint32_t>(b.order.size()));
  w.u32(b.num_vertex_ids);
}

}  // namespace

std::optional<ValidBody> internal::read_valid(ByteReader r) {
  ValidBody b;
  const std::uint32_t faces = read_counts(r, b);
  read_proof(r, faces, b);
  if (!r.ok()) return std::nullopt;
  return b;
}

std::optional<ReversedBody> internal::read_reversed(ByteReader r) {
  ReversedBody b;
  const std::uint32_t faces = read_counts(r, b.solid);
  const auto bits = r.raw(faces / 8 + (faces % 8 != 0));
  b.reversed.assign(bits.begin(), bits.end());
  if (faces % 8 != 0 && r.ok() && b.reversed.back() >> (faces % 8) != 0) return std::nullopt;
  read_proof(r, faces, b.solid);
  if (!r.ok()) return std::nullopt;
  return b;
}

std::optional<InvalidBody> internal::read_invalid(ByteReader r) {
  InvalidBody b;
  r.raw(4);
  b.num_faces = r.u32();
  b.num_vertex_ids = r.u32();
  for (std::uint32_t i = 0, n = r.count(5); i < n && r.ok(); ++i)
    b.witnesses.push_back(read_witness(r));
  if (!r.at_end()) return std::nullopt;
  return b;
}

Bytes encode(const ValidBody& b) {
  ByteWriter w;
  write_counts(w, kValidMagic, b);
  write_proof(w, b);
  return w.take();
}

Bytes encode(const ReversedBody& b) {
  ByteWriter w;
  write_counts(w, kReversedMagic, b.solid);
  w.raw(b.reversed);
  write_proof(w, b.solid);
  return w.take();
}

Bytes encode(const InvalidBody& b) {
  ByteWriter w;
  w.text(kInvalidMagic);
  w.u32(b.num_faces);
  w.u32(b.num_vertex_ids);
  w.u32(static_cast<std::uint32_t>(b.witnesses.size()));
  for (const Witness& x : b.witnesses) write(w, x);
  return w.take();
}

Bytes encode(const Subject& subject, const Quantities& q, const ValidBody& body) {
  const Bytes bytes = encode(body);
  StatementWriter w;
  state_mesh(w, subject, kValidClaim, bytes);
  state_quantities(w, q);
  return join(w.take(), bytes);
}

Bytes encode(const Subject& subject, const Quantities& q, const ReversedBody& body,
             std::uint64_t reversed_shells) {
  const Bytes bytes = encode(body);
  std::uint64_t reversed = 0;
  for (const unsigned char byte : body.reversed)
    reversed += static_cast<unsigned>(std::popcount(byte));
  StatementWriter w;
  state_mesh(w, subject, kReversedClaim, bytes);
  state_quantities(w, q);
  w.number("reversed", reversed);
  w.number("reversed_shells", reversed_shells);
  return join(w.take(), bytes);
}

Bytes encode(const Subject& subject, const InvalidBody& body) {
  const Bytes bytes = encode(body);
  StatementWriter w;
  state_mesh(w, subject, kInvalidClaim, bytes);
  w.text("rules", rules_of(body));
  return join(w.take(), bytes);
}

std::optional<Certificate> decode(std::span<const unsigned char> bytes, std::string& why) {
  auto statement = internal::statement_line(bytes, why);
  if (!statement) return std::nullopt;
  Certificate out;
  out.statement = std::move(*statement);
  const auto body = bytes.subspan(out.statement.size() + 1);
  const auto has_magic = [&](std::string_view magic) {
    return body.size() >= 4 && std::equal(magic.begin(), magic.end(), body.begin());
  };
  if (has_magic(kValidMagic)) out.valid = internal::read_valid(ByteReader(body));
  if (has_magic(kInvalidMagic)) out.invalid = internal::read_invalid(ByteReader(body));
  if (has_magic(kReversedMagic)) out.reversed = internal::read_reversed(ByteReader(body));
  if (!out.valid && !out.invalid && !out.reversed) {
    why = has_magic(kValidMagic) || has_magic(kInvalidMagic) || has_magic(kReversedMagic)
              ? "the body ends too early, is too long, or holds a malformed number"
              : "the body starts with none of VTMV, VTMI and VTMR";
    return std::nullopt;
  }
  return out;
}

}  // namespace veritope::certificate
