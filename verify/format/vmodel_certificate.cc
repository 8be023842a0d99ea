// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/vmodel_certificate.h"

#include <algorithm>
#include <utility>

#include "verify/format/byte_stream.h"
#include "verify/format/entities_of_body_internal.h"
#include "verify/format/sha256.h"
#include "verify/format/statement_writer.h"

namespace veritope::certificate {
namespace {

using internal::ByteReader;
using internal::ByteWriter;
using Kind = VModelFace::Kind;

constexpr std::uint64_t kGluedCodes = 3;  // codes below are those of other kinds
constexpr std::size_t kMostHalvings = 64;

void write_face(ByteWriter& w, const VModelFace& face, std::uint64_t number) {
  w.varint(face.kind == Kind::kGlued ? kGluedCodes + 8 * (face.other - number - 1) + face.symmetry
                                     : static_cast<std::uint64_t>(face.kind));
}
VModelFace read_face(ByteReader& r, std::uint64_t number) {
  const std::uint64_t code = r.varint();
  if (code < kGluedCodes) return {static_cast<Kind>(code)};
  return {Kind::kGlued, number + 1 + (code - kGluedCodes) / 8,
          static_cast<std::uint8_t>((code - kGluedCodes) % 8)};
}

VModelCell read_cell_breaks(ByteReader& r, VModelCell cell) {
  for (auto& axis : cell.added_breaks) {
    const std::uint64_t n = r.varint();
    if (n > r.left() / 2) r.fail();
    for (std::uint64_t k = 0; k < n && r.ok(); ++k) axis.push_back(internal::read_fraction(r));
  }
  return cell;
}

std::vector<std::uint8_t> read_tree(ByteReader& r) {
  std::vector<std::uint8_t> out;
  std::vector<std::size_t> levels = {0};
  while (!levels.empty() && r.ok()) {
    const std::size_t level = levels.back();
    levels.pop_back();
    const std::uint8_t symbol = r.u8();
    if (symbol > 3 || (symbol != 0 && level == kMostHalvings)) r.fail();
    out.push_back(symbol);
    if (symbol != 0) levels.insert(levels.end(), 2, level + 1);
  }
  return out;
}

}  // namespace

Bytes encode(const VModelBody& body) {
  ByteWriter w;
  w.text(kVModelMagic);
  w.u32(static_cast<std::uint32_t>(body.cells.size()));
  for (const VModelCell& cell : body.cells) w.u8(cell.is_reversed ? 1 : 0);
  for (const VModelCell& cell : body.cells)
    for (const auto& axis : cell.added_breaks) {
      w.varint(axis.size());
      for (const Fraction& f : axis) internal::write_fraction(w, f);
    }
  for (std::uint64_t f = 0; f < body.faces.size(); ++f) write_face(w, body.faces[f], f);
  w.varint(body.determinants.size());
  std::uint64_t next = 0;
  for (const VModelDeterminant& d : body.determinants) {
    w.varint(d.piece - next);
    w.varint(d.zeros);
    w.raw(d.tree);
    next = d.piece + 1;
  }
  w.raw(encode(body.boundary));
  return w.take();
}

Bytes encode(const Subject& subject, const VModelQuantities& q, const VModelBody& body) {
  const Bytes bytes = encode(body);
  internal::StatementWriter w;
  internal::state_subject(w, subject, kVModelClaim);
  w.text("body_sha256", to_hex(sha256(bytes)));
  w.number("cells", q.cells);
  w.number("pieces", q.pieces);
  w.number("half_v_surfaces", q.half_v_surfaces);
  w.number("v_surfaces", q.v_surfaces);
  w.number("v_curves", q.v_curves);
  w.number("v_points", q.v_points);
  w.number("euler", internal::zigzag_code(q.euler));
  w.number("reversed", q.reversed);
  w.number("singular", q.singular);
  w.number("patches", q.patches);
  w.number("shells", q.shells);
  w.number("bodies", q.bodies);
  w.number("genus", q.genus);
  w.number("boxes", body.boundary.boxes.size());
  return internal::join(w.take(), bytes);
}

std::optional<VModelBody> internal::read_vmodel(ByteReader r) {
  VModelBody out;
  r.raw(kVModelMagic.size());
  out.cells.resize(r.count(10));
  for (VModelCell& cell : out.cells) {
    const std::uint8_t flag = r.u8();
    if (flag > 1) r.fail();
    cell.is_reversed = flag == 1;
  }
  for (VModelCell& cell : out.cells) cell = read_cell_breaks(r, std::move(cell));
  for (std::uint64_t f = 0; f < 6 * out.cells.size() && r.ok(); ++f)
    out.faces.push_back(read_face(r, f));
  std::uint64_t next = 0, n = r.varint();
  if (n > r.left() / 3) r.fail();
  for (; n > 0 && r.ok(); --n) {
    VModelDeterminant d;
    const std::uint64_t skip = r.varint();
    if (skip >> 32 != 0) r.fail();
    d.piece = next + skip;
    const std::uint64_t zeros = r.varint();
    if (zeros >> 26 != 0) r.fail();
    d.zeros = static_cast<std::uint32_t>(zeros);
    d.tree = read_tree(r);
    next = d.piece + 1;
    out.determinants.push_back(std::move(d));
  }
  ByteReader magic = r;
  const auto first = magic.raw(kStarBox2Magic.size());
  if (!magic.ok() || !std::equal(first.begin(), first.end(), kStarBox2Magic.begin()))
    return std::nullopt;
  auto boundary = read_star_box_2(r);
  if (!boundary) return std::nullopt;
  out.boundary = std::move(*boundary);
  return out;
}

}  // namespace veritope::certificate
