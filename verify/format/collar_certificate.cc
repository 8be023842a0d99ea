// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/collar_certificate.h"

#include <bit>

#include "verify/format/byte_stream.h"
#include "verify/format/entities_of_body_internal.h"
#include "verify/format/preorder_internal.h"
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
  const std::string_view claim = body.star.version == 2 ? kCollar2Claim : kCollarClaim;
  internal::StatementWriter w = internal::state_star_boxes(subject, claim, q, body.star, bytes);
  w.number("cells", body.cells.size());
  return internal::join(w.take(), bytes);
}

void internal::read(ByteReader& r, std::uint64_t patches, CollarBody& out) {
  read(r, patches, out.star);
  out.shift = r.varint();
  for (std::int64_t& v : out.corner) v = r.zigzag();
  const std::uint32_t cells = r.count(2);
  std::uint64_t code = 0;
  for (std::uint32_t i = 0; i < cells && r.ok(); ++i) {
    code += r.varint();
    if (code == 0 || std::countr_zero(code) > 62) return r.fail();  // level not in [0, 20]
    out.cells.push_back(code);
  }
  const auto sides = r.raw(r.count(1));
  out.sides.assign(sides.begin(), sides.end());
  std::int64_t face = 0;
  for (std::uint32_t i = 0; i < cells && r.ok(); ++i) {
    const std::int64_t step = r.zigzag();
    if (step < -face || step > std::int64_t{0xffffffff} - face) return r.fail();
    out.collapses.push_back(static_cast<std::uint32_t>(face += step));
  }
  const auto is_leaf = [&](int) {
    out.leaves.push_back(r.u8());
    return out.leaves.back() != 0;
  };
  for (const std::uint8_t level : leaf_levels(out.star))
    if (!r.ok() || !each_node(level, is_leaf, [&] { return r.ok(); })) return r.fail();
  for (std::size_t i = 0; i < out.sides.size() && r.ok(); ++i) out.shores.push_back(read_path(r));
}

std::optional<CollarBody> internal::read_collar_2(ByteReader r) {
  CollarBody out;
  out.star.version = 2;
  r.raw(kStarBox2Magic.size());
  if (!read_with_kinds(r, out.star.entities)) return std::nullopt;
  read(r, num_patches(out.star.entities), out);
  return r.at_end() ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace veritope::certificate
