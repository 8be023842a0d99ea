// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/dms_certificate.h"

#include <algorithm>
#include <utility>

#include "verify/format/byte_stream.h"
#include "verify/format/dms_planes_internal.h"
#include "verify/format/micro_certificate.h"
#include "verify/format/patch_certificate_text_internal.h"
#include "verify/format/sha256.h"
#include "verify/format/statement_writer.h"
#include "verify/format/text_parts.h"

namespace veritope::certificate {
namespace {

using internal::ByteReader;
using internal::ByteWriter;
using internal::read_count;
using internal::read_planes;
using internal::write_planes;

constexpr std::size_t kLeastBytesOfTree = 20, kLeastBytesOfFace = 2, kLeastBytesOfPoint = 6,
                      kLeastBytesOfDmsTile = 4;
constexpr std::size_t kMaxLevels = 64;
// Symbols of trees: edges cut at the middle, edges cut elsewhere, leaves.
constexpr std::uint8_t kNumEdges = 6, kLeafH = 12, kLeafP = 13;

void write_node(ByteWriter& w, const DmsCutProof& cut) {
  w.u8(static_cast<std::uint8_t>(cut.edge + (cut.at ? kNumEdges : 0)));
  if (cut.at) internal::write_fraction(w, *cut.at);
}
void write_node(ByteWriter& w, const DmsLeafProof& leaf) {
  w.u8(leaf.is_polynomial ? kLeafP : kLeafH);
  for (const Fraction& x : leaf.matrix) internal::write_fraction(w, x);
  write_planes(w, leaf.planes);
}
void write_part(ByteWriter& w, const StarBoxBody& boxes) {
  const Bytes bytes = encode(boxes);
  w.u32(static_cast<std::uint32_t>(bytes.size()));
  w.raw(bytes);
}

DmsTreeProof read_tree(ByteReader& r) {
  DmsTreeProof out;
  std::vector<std::size_t> levels{0};
  while (!levels.empty() && r.ok()) {
    const std::size_t level = levels.back();
    levels.pop_back();
    const std::uint8_t symbol = r.u8();
    if (symbol >= kLeafH) {
      DmsLeafProof leaf;
      leaf.is_polynomial = symbol == kLeafP;
      if (symbol > kLeafP) r.fail();
      for (Fraction& x : leaf.matrix) x = internal::read_fraction(r);
      leaf.planes = read_planes(r);
      out.emplace_back(std::move(leaf));
      continue;
    }
    if (level == kMaxLevels) r.fail();
    DmsCutProof cut;
    cut.edge = symbol % kNumEdges;
    if (symbol >= kNumEdges) cut.at = internal::read_fraction(r);
    out.emplace_back(std::move(cut));
    levels.insert(levels.end(), 2, level + 1);
  }
  return out;
}
std::optional<StarBoxBody> read_part(ByteReader& r) {
  const std::uint32_t length = r.u32();
  const auto part = r.raw(length);
  ByteReader magic(part);
  const auto first = magic.raw(kStarBox2Magic.size());
  if (!r.ok() || !magic.ok() || !std::equal(first.begin(), first.end(), kStarBox2Magic.begin()))
    return std::nullopt;
  return internal::read_star_box_2(ByteReader(part));
}

}  // namespace

Bytes encode(const DmsBody& body) {
  ByteWriter w;
  w.text(kDmsMagic);
  w.u32(static_cast<std::uint32_t>(body.trees.size()));
  w.u32(static_cast<std::uint32_t>(body.planes.size()));
  w.u32(static_cast<std::uint32_t>(body.points.size()));
  for (const auto& point : body.points)
    for (const Fraction& x : point) internal::write_fraction(w, x);
  for (const DmsTreeProof& tree : body.trees)
    for (const auto& node : tree) std::visit([&](const auto& n) { write_node(w, n); }, node);
  for (const auto& planes : body.planes) write_planes(w, planes);
  for (const auto& tiles : body.tiles) {
    w.varint(tiles.size());
    for (const DmsTileProof& tile : tiles) {
      for (const std::uint64_t p : tile.points) w.varint(p);
      write_planes(w, tile.planes);
    }
  }
  write_part(w, body.domain);
  write_part(w, body.surface);
  return w.take();
}

Bytes encode(const Subject& subject, const DmsQuantities& q, const DmsBody& body) {
  const Bytes bytes = encode(body);
  internal::StatementWriter w;
  internal::state_subject(w, subject, kDmsClaim);
  w.text("body_sha256", to_hex(sha256(bytes)));
  w.number("tetrahedra", q.tetrahedra);
  w.number("control_points", q.control_points);
  w.number("leaves", q.leaves);
  w.number("patches", q.patches);
  w.number("shells", q.shells);
  w.number("bodies", q.bodies);
  w.number("genus", q.genus);
  return internal::join(w.take(), bytes);
}

std::optional<DmsBody> internal::read_dms_body(ByteReader r) {
  DmsBody out;
  r.raw(kDmsMagic.size());
  const std::size_t trees = r.count(kLeastBytesOfTree), faces = r.count(kLeastBytesOfFace);
  out.points.resize(r.count(kLeastBytesOfPoint));
  for (auto& point : out.points)
    for (Fraction& x : point) x = read_fraction(r);
  for (std::size_t t = 0; t < trees && r.ok(); ++t) out.trees.push_back(read_tree(r));
  for (std::size_t f = 0; f < faces && r.ok(); ++f) out.planes.push_back(read_planes(r));
  for (std::size_t f = 0; f < faces && r.ok(); ++f) {
    auto& tiles = out.tiles.emplace_back(read_count(r, kLeastBytesOfDmsTile));
    for (DmsTileProof& tile : tiles) {
      for (std::uint64_t& p : tile.points) p = r.varint();
      tile.planes = read_planes(r);
    }
  }
  auto domain = read_part(r);
  if (!domain) return std::nullopt;
  auto surface = read_part(r);
  if (!surface || !r.at_end()) return std::nullopt;
  out.domain = std::move(*domain);
  out.surface = std::move(*surface);
  return out;
}

std::string explain(const DmsBody& body, std::string_view claim, std::size_t max_items) {
  std::string out = "body: " + std::string(claim) + "\n";
  internal::append_list(out, "tetrahedra", body.trees.size(), max_items, [&](std::size_t i) {
    std::size_t leaves = 0, polynomial = 0;
    const DmsLeafProof* first = nullptr;
    for (const auto& node : body.trees[i])
      if (const auto* const leaf = std::get_if<DmsLeafProof>(&node)) {
        if (first == nullptr) first = leaf;
        ++leaves;
        polynomial += leaf->is_polynomial;
      }
    std::string text = std::to_string(leaves) + (leaves == 1 ? " leaf, " : " leaves, ") +
                       std::to_string(polynomial) + " of one polynomial; the first by the matrix (";
    for (std::size_t c = 0; first != nullptr && c < first->matrix.size(); ++c)
      text += (c == 0 ? "" : c % 3 == 0 ? "; " : ", ") + internal::short_text(first->matrix[c]);
    return text + ")";
  });
  internal::append_list(out, "faces of the boundary", body.tiles.size(), max_items,
                        [&](std::size_t i) {
                          const std::size_t n = std::max<std::size_t>(1, body.tiles[i].size());
                          return std::to_string(n) + (n == 1 ? " tile" : " tiles");
                        });
  out += "the domain as a " + explain(body.domain, kStarBox2Claim, max_items);
  return out + "the surface as a " + explain(body.surface, kStarBox2Claim, max_items);
}

}  // namespace veritope::certificate
