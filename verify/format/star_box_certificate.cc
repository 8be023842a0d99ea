// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/star_box_certificate.h"

#include "verify/format/byte_stream.h"
#include "verify/format/entities_of_body_internal.h"
#include "verify/format/preorder_internal.h"
#include "verify/format/sha256.h"
#include "verify/format/star_box_statement.h"

namespace veritope::certificate {
namespace {

using internal::ByteReader;
using internal::ByteWriter;

using Point = std::array<std::int64_t, 3>;

// Differences and sums modulo 2^64: what is read is written again, whatever the numbers are.
std::int64_t minus(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b));
}
std::int64_t plus(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
}

void write_bounds(ByteWriter& w, const StarBoxItem& b) {
  w.varint(b.shift);
  for (const std::int64_t v : b.low) w.zigzag(v);
  for (const std::uint64_t v : b.size) w.varint(v);
}

void write_1(ByteWriter& w, const StarBoxItem& b) {
  w.u8(b.is_mesh ? 1 : 0);
  write_bounds(w, b);
  if (b.is_mesh) return;
  for (const Point* c : {&b.sheets[0].inside, &b.sheets[0].outside})
    for (std::size_t k = 0; k < 3; ++k)
      w.varint(static_cast<std::uint64_t>(minus((*c)[k], b.low[k])));
}

void write_2(ByteWriter& w, const StarBoxItem& b) {
  w.u8(b.is_mesh ? 1 : 0);
  w.varint(b.frame);
  write_bounds(w, b);
  if (b.is_mesh) return;
  w.u8(static_cast<std::uint8_t>(b.sheets.size()));
  w.u8(static_cast<std::uint8_t>(b.separators.size()));
  w.varint(b.point_shift);
  Point first{};
  for (const StarSheet& sheet : b.sheets)
    for (const Point* c : {&sheet.inside, &sheet.outside}) {
      for (std::size_t k = 0; k < 3; ++k) w.zigzag(minus((*c)[k], first[k]));
      first = b.sheets[0].inside;
    }
  for (const StarSeparator& q : b.separators) {
    w.u8(q.degree);
    w.zigzag(q.shift);
    for (const std::int64_t v : q.coefficients) w.zigzag(v);
  }
  for (const StarSheet& sheet : b.sheets)
    for (const std::uint8_t sign : sheet.signs) w.u8(sign);
}

void write(ByteWriter& w, const StarWalk& walk) {
  w.varint(walk.box);
  w.u8(walk.starts_outside ? 1 : 0);
  internal::write(w, walk.path);
}

bool read_kind(ByteReader& r) {  // is_mesh
  const std::uint8_t kind = r.u8();
  if (kind > 1) r.fail();
  return kind == 1;
}
void read_bounds(ByteReader& r, StarBoxItem& b) {
  b.shift = r.varint();
  for (std::int64_t& v : b.low) v = r.zigzag();
  for (std::uint64_t& v : b.size) v = r.varint();
}

StarBoxItem read_box_1(ByteReader& r) {
  StarBoxItem b;
  b.is_mesh = read_kind(r);
  read_bounds(r, b);
  if (b.is_mesh) return b;
  b.point_shift = b.shift;
  b.sheets.resize(1);
  for (Point* c : {&b.sheets[0].inside, &b.sheets[0].outside})
    for (std::size_t k = 0; k < 3; ++k)
      (*c)[k] = plus(b.low[k], static_cast<std::int64_t>(r.varint()));
  return b;
}

StarSeparator read_separator(ByteReader& r) {
  StarSeparator q;
  q.degree = r.u8();
  if (q.degree < 1 || q.degree > 3) r.fail();
  q.shift = r.zigzag();
  const std::size_t d = q.degree;
  for (std::size_t n = (d + 1) * (d + 2) * (d + 3) / 6; n > 0 && r.ok(); --n)
    q.coefficients.push_back(r.zigzag());
  return q;
}
void read_sheets(ByteReader& r, StarBoxItem& b) {
  const std::uint8_t sheets = r.u8(), separators = r.u8();
  b.point_shift = r.varint();
  Point first{};
  for (std::uint8_t i = 0; i < sheets && r.ok(); ++i) {
    StarSheet sheet;
    for (Point* c : {&sheet.inside, &sheet.outside}) {
      for (std::size_t k = 0; k < 3; ++k) (*c)[k] = plus(first[k], r.zigzag());
      if (i == 0) first = sheet.inside;
    }
    b.sheets.push_back(sheet);
  }
  for (std::uint8_t i = 0; i < separators && r.ok(); ++i) b.separators.push_back(read_separator(r));
  for (StarSheet& sheet : b.sheets)
    for (std::uint8_t i = 0; i < separators && r.ok(); ++i) sheet.signs.push_back(r.u8());
}
StarBoxItem read_box_2(ByteReader& r) {
  StarBoxItem b;
  b.is_mesh = read_kind(r);
  b.frame = r.varint();
  read_bounds(r, b);
  if (!b.is_mesh) read_sheets(r, b);
  return b;
}
StarFrame read_frame(ByteReader& r) {
  StarFrame f;
  for (auto& row : f.rows)
    for (std::int64_t& v : row) v = r.zigzag();
  return f;
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

}  // namespace

Bytes encode(const StarBoxBody& body) {
  const bool is_1 = body.version == 1;
  ByteWriter w;
  w.text(is_1 ? kStarBoxMagic : kStarBox2Magic);
  if (is_1) internal::write(w, body.entities);
  if (!is_1) internal::write_with_kinds(w, body.entities);
  for (const auto& ab : body.roots) w.raw(ab);
  w.zigzag(body.exponent);
  if (!is_1) {
    w.u32(static_cast<std::uint32_t>(body.frames.size()));
    for (const StarFrame& f : body.frames)
      for (const auto& row : f.rows)
        for (const std::int64_t v : row) w.zigzag(v);
  }
  w.u32(static_cast<std::uint32_t>(body.boxes.size()));
  for (const StarBoxItem& b : body.boxes) (is_1 ? write_1 : write_2)(w, b);
  std::int64_t last = 0;
  for (const std::int64_t symbol : body.trees) {
    if (symbol == kSplit) {
      w.varint(0);
      continue;
    }
    w.varint(1 + internal::zigzag_code(symbol - last));
    last = symbol;
  }
  w.u32(static_cast<std::uint32_t>(body.walks.size()));
  for (const StarWalk& walk : body.walks) write(w, walk);
  return w.take();
}

Bytes encode(const Subject& subject, const StarBoxQuantities& q, const StarBoxBody& body,
             std::optional<std::int64_t> winding) {
  const Bytes bytes = encode(body);
  const std::string_view claim = body.version == 1
                                     ? (winding ? kReversedShellClaim : kStarBoxClaim)
                                     : (winding ? kReversedShell2Claim : kStarBox2Claim);
  internal::StatementWriter w = internal::state_star_boxes(subject, claim, q, body, bytes);
  if (winding) w.number("winding", internal::zigzag_code(*winding));
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
  const bool is_1 = out.version == 1;
  for (std::uint32_t i = 0, n = is_1 ? 0 : r.count(9); i < n && r.ok(); ++i)
    out.frames.push_back(read_frame(r));
  for (std::uint32_t i = 0, n = r.count(is_1 ? 8 : 9); i < n && r.ok(); ++i)
    out.boxes.push_back((is_1 ? read_box_1 : read_box_2)(r));
  std::int64_t last = 0;
  for (const auto& [a, b] : out.roots) read_trees(r, std::uint64_t{1} << (a + b), last, out);
  for (std::uint32_t i = 0, n = r.count(7); i < n && r.ok(); ++i) out.walks.push_back(read_walk(r));
}

std::optional<StarBoxBody> read_star_box_2(ByteReader r) {
  StarBoxBody out;
  out.version = 2;
  r.raw(kStarBox2Magic.size());
  if (!read_with_kinds(r, out.entities)) return std::nullopt;
  read(r, num_patches(out.entities), out);
  return r.at_end() ? std::optional(std::move(out)) : std::nullopt;
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
