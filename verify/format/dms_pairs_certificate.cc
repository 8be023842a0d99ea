// SPDX-License-Identifier: Apache-2.0 OR MIT
// The second version of the certificate of a simplex-spline solid.
#include <utility>

#include "verify/format/dms_planes_internal.h"
#include "verify/format/dms_trees_internal.h"
#include "verify/format/micro_certificate.h"
#include "verify/format/patch_certificate_text_internal.h"
#include "verify/format/text_parts.h"

namespace veritope::certificate {
namespace {

using internal::ByteReader;
using internal::ByteWriter;
using PairKind = DmsPairProof::Kind;

constexpr std::size_t kLeastBytesOfList = 1, kLeastBytesOfBlock = 21, kLeastBytesOfPair = 9,
                      kLeastBytesOfEdge = 2;

void write_face_pair(ByteWriter& w, const DmsPairProof& pair) {
  w.varint(pair.first);
  w.varint(pair.second);
  w.u8(static_cast<std::uint8_t>(pair.kind));
  if (pair.kind == PairKind::kChain) {
    w.varint(pair.tetrahedra.size());
    for (const std::uint64_t v : pair.chain) w.varint(v);
    for (const std::uint64_t t : pair.tetrahedra) w.varint(t);
  }
  if (pair.kind == PairKind::kAtEdge)
    for (const Fraction& x : pair.feet) internal::write_fraction(w, x);
  for (const auto& direction : pair.directions)
    for (const Fraction& x : direction) internal::write_fraction(w, x);
}
DmsPairProof read_face_pair(ByteReader& r) {
  DmsPairProof out;
  out.first = r.varint();
  out.second = r.varint();
  const std::uint8_t kind = r.u8();
  if (kind > static_cast<std::uint8_t>(PairKind::kAtEdge)) r.fail();
  out.kind = static_cast<PairKind>(kind);
  if (out.kind == PairKind::kChain) {
    out.tetrahedra.resize(internal::read_count(r, kLeastBytesOfEdge));
    out.chain.resize(out.tetrahedra.size() + 1);
    for (std::uint64_t& v : out.chain) v = r.varint();
    for (std::uint64_t& t : out.tetrahedra) t = r.varint();
  }
  if (out.kind == PairKind::kAtEdge)
    for (Fraction& x : out.feet) x = internal::read_fraction(r);
  out.directions.resize(out.kind == PairKind::kAtEdge ? 2 : 1);
  for (auto& direction : out.directions)
    for (Fraction& x : direction) x = internal::read_fraction(r);
  return out;
}

}  // namespace

Bytes encode(const DmsPairsBody& body) {
  ByteWriter w;
  w.text(kDms2Magic);
  w.u32(static_cast<std::uint32_t>(body.trees.size()));
  w.u32(static_cast<std::uint32_t>(body.planes.size()));
  w.u32(static_cast<std::uint32_t>(body.blocks.size()));
  w.u32(static_cast<std::uint32_t>(body.pairs.size()));
  internal::write_dms_trees(w, body.trees);
  for (const auto& planes : body.planes) internal::write_planes(w, planes);
  for (const DmsBlockProof& block : body.blocks) {
    w.varint(block.tetrahedra.size());
    for (const std::uint64_t t : block.tetrahedra) w.varint(t);
    for (const Fraction& x : block.matrix) internal::write_fraction(w, x);
    internal::write_planes(w, block.planes);
  }
  for (const DmsPairProof& pair : body.pairs) write_face_pair(w, pair);
  internal::write_dms_part(w, body.domain);
  return w.take();
}

Bytes encode(const Subject& subject, const DmsQuantities& q, const DmsPairsBody& body) {
  return internal::dms_certificate(subject, kDms2Claim, q, "faces", encode(body));
}

std::optional<DmsPairsBody> internal::read_dms_pairs_body(ByteReader r) {
  DmsPairsBody out;
  r.raw(kDms2Magic.size());
  const std::size_t trees = r.count(kLeastBytesOfTree), faces = r.count(kLeastBytesOfList),
                    blocks = r.count(kLeastBytesOfBlock), pairs = r.count(kLeastBytesOfPair);
  out.trees = read_dms_trees(r, trees);
  while (out.planes.size() < faces && r.ok()) out.planes.push_back(read_planes(r));
  while (out.blocks.size() < blocks && r.ok()) {
    DmsBlockProof& block = out.blocks.emplace_back();
    block.tetrahedra.resize(read_count(r, 1));
    for (std::uint64_t& t : block.tetrahedra) t = r.varint();
    for (Fraction& x : block.matrix) x = read_fraction(r);
    block.planes = read_planes(r);
  }
  while (out.pairs.size() < pairs && r.ok()) out.pairs.push_back(read_face_pair(r));
  auto domain = read_dms_part(r);
  if (!domain || !r.at_end()) return std::nullopt;
  out.domain = std::move(*domain);
  return out;
}

std::string explain(const DmsPairsBody& body, std::string_view claim, std::size_t max_items) {
  std::string out = "body: " + std::string(claim) + "\n";
  internal::append_dms_trees(out, body.trees, max_items);
  internal::append_list(out, "blocks", body.blocks.size(), max_items, [&](std::size_t i) {
    std::string text = "the hull of tetrahedra";
    for (const std::uint64_t t : body.blocks[i].tetrahedra) text += " " + std::to_string(t);
    text += " by the matrix (";
    for (std::size_t c = 0; c < 9; ++c)
      text += (c == 0       ? ""
               : c % 3 == 0 ? "; "
                            : ", ") +
              internal::short_text(body.blocks[i].matrix[c]);
    return text + ")";
  });
  internal::append_list(out, "pairs of faces", body.pairs.size(), max_items, [&](std::size_t i) {
    const DmsPairProof& pair = body.pairs[i];
    std::string text = std::to_string(pair.first) + " and " + std::to_string(pair.second);
    text += pair.kind == PairKind::kApart   ? ": apart across"
            : pair.kind == PairKind::kChain ? ": by a chain through"
                                            : ": at an edge along";
    for (const std::uint64_t v : pair.chain) text += " " + std::to_string(v);
    if (pair.kind == PairKind::kChain) text += " along";
    for (const auto& direction : pair.directions) {
      text += " (";
      for (std::size_t c = 0; c < 3; ++c)
        text += (c == 0 ? "" : ", ") + internal::short_text(direction[c]);
      text += ")";
    }
    return text;
  });
  return out + "the domain as a " + explain(body.domain, kStarBox2Claim, max_items);
}

}  // namespace veritope::certificate
