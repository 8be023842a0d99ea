// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/star_box_certificate.h"

#include "verify/format/byte_stream.h"
#include "verify/format/preorder_internal.h"
#include "verify/format/sha256.h"
#include "verify/format/star_box_statement.h"

namespace veritope::certificate {
namespace {

using internal::ByteReader;
using internal::ByteWriter;

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

StarBoxItem read_box(ByteReader& r) {
  StarBoxItem b;
  const std::uint8_t kind = r.u8();
  if (kind > 1) r.fail();
  b.is_mesh = kind == 1;
  b.shift = r.varint();
  for (std::int64_t& v : b.low) v = r.zigzag();
  for (std::uint64_t& v : b.size) v = r.varint();
  if (b.is_mesh) return b;
  for (auto* triple : {&b.inside, &b.outside})
    for (std::uint64_t& v : *triple) v = r.varint();
  return b;
}

StarWalk read_walk(ByteReader& r) {
  StarWalk walk;
  walk.box = r.varint();
  walk.starts_outside = r.u8() != 0;
  walk.path = internal::read_path(r);
  return walk;
}

// Reads the trees of all roots of a patch; `last` is the last leaf's box.
void read_trees(ByteReader& r, std::uint64_t roots, std::int64_t& last, StarBoxBody& out) {
  const auto is_leaf = [&](int) {
    const std::uint64_t symbol = r.varint();
    if (symbol == 0) {
      out.trees.push_back(kSplit);
      return false;
    }
    const std::uint64_t code = symbol - 1;
    const std::int64_t step = (code & 1u) != 0 ? -static_cast<std::int64_t>(code >> 1) - 1
                                               : static_cast<std::int64_t>(code >> 1);
    const std::int64_t boxes = static_cast<std::int64_t>(out.boxes.size());
    if (step < -last || step >= boxes - last) {
      r.fail();
      return true;
    }
    out.trees.push_back(last += step);
    return true;
  };
  for (std::uint64_t i = 0; i < roots && r.ok(); ++i)
    if (!internal::each_node(0, is_leaf, [&] { return r.ok(); })) r.fail();
}

std::uint64_t zigzag_code(std::int64_t z) {
  return z >= 0 ? 2 * static_cast<std::uint64_t>(z) : 2 * static_cast<std::uint64_t>(-(z + 1)) + 1;
}

}  // namespace

Bytes encode(const StarBoxBody& body) {
  ByteWriter w;
  w.text(kStarBoxMagic);
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
             std::optional<std::int64_t> winding) {
  const Bytes bytes = encode(body);
  internal::StatementWriter w = internal::state_star_boxes(
      subject, winding ? kReversedShellClaim : kStarBoxClaim, q, body, bytes);
  if (winding) w.number("winding", zigzag_code(*winding));
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
  w.number("flipped", num_reversed(body.entities));
  return w;
}

WalkPath read_path(ByteReader& r) {
  WalkPath path;
  for (std::uint32_t i = 0, n = r.count(4); i < n && r.ok(); ++i) {
    WalkPoint p;
    p.shift = r.varint();
    for (std::int64_t& v : p.at) v = r.zigzag();
    path.points.push_back(p);
  }
  path.end = r.u8();
  if (path.end > 6) r.fail();
  if (path.end != 6) return path;
  path.end_box = r.varint();
  path.ends_outside = r.u8() != 0;
  return path;
}

void read(ByteReader& r, std::uint64_t patches, StarBoxBody& out) {
  if (patches > r.left() / 3) return r.fail();
  for (std::uint64_t i = 0; i < patches && r.ok(); ++i) {
    const std::uint8_t a = r.u8(), b = r.u8();
    if (a > 12 || b > 12) return r.fail();
    out.roots.push_back({a, b});
  }
  out.exponent = r.zigzag();
  for (std::uint32_t i = 0, n = r.count(8); i < n && r.ok(); ++i) out.boxes.push_back(read_box(r));
  std::int64_t last = 0;
  for (const auto& [a, b] : out.roots) read_trees(r, std::uint64_t{1} << (a + b), last, out);
  for (std::uint32_t i = 0, n = r.count(7); i < n && r.ok(); ++i) out.walks.push_back(read_walk(r));
}

std::vector<std::uint8_t> leaf_levels(const StarBoxBody& body) {
  std::vector<std::uint8_t> levels;
  std::size_t at = 0;
  while (at < body.trees.size())
    each_node(
        0,
        [&](int level) {
          const bool is_leaf = body.trees[at++] != kSplit;
          if (is_leaf) levels.push_back(static_cast<std::uint8_t>(level));
          return is_leaf;
        },
        [&] { return at < body.trees.size(); });
  return levels;
}

}  // namespace internal

}  // namespace veritope::certificate
