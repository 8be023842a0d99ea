// SPDX-License-Identifier: Apache-2.0 OR MIT
#include <algorithm>
#include <utility>

#include "verify/format/dms_planes_internal.h"
#include "verify/format/dms_trees_internal.h"
#include "verify/format/micro_certificate.h"
#include "verify/format/patch_certificate_text_internal.h"
#include "verify/format/sha256.h"
#include "verify/format/statement_writer.h"
#include "verify/format/text_parts.h"

namespace veritope::certificate::internal {
namespace {

constexpr std::size_t kMaxLevels = 64;
// Symbols of trees: edges cut at the middle, edges cut elsewhere, leaves.
constexpr std::uint8_t kNumEdges = 6, kLeafH = 12, kLeafP = 13;

void write_node(ByteWriter& w, const DmsCutProof& cut) {
  w.u8(static_cast<std::uint8_t>(cut.edge + (cut.at ? kNumEdges : 0)));
  if (cut.at) write_fraction(w, *cut.at);
}
void write_node(ByteWriter& w, const DmsLeafProof& leaf) {
  w.u8(leaf.is_polynomial ? kLeafP : kLeafH);
  for (const Fraction& x : leaf.matrix) write_fraction(w, x);
  write_planes(w, leaf.planes);
}
DmsTreeProof read_dms_tree(ByteReader& r) {
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
      for (Fraction& x : leaf.matrix) x = read_fraction(r);
      leaf.planes = read_planes(r);
      out.emplace_back(std::move(leaf));
      continue;
    }
    if (level == kMaxLevels) r.fail();
    DmsCutProof cut;
    cut.edge = symbol % kNumEdges;
    if (symbol >= kNumEdges) cut.at = read_fraction(r);
    out.emplace_back(std::move(cut));
    levels.insert(levels.end(), 2, level + 1);
  }
  return out;
}

}  // namespace

void write_dms_trees(ByteWriter& w, const std::vector<DmsTreeProof>& trees) {
  for (const DmsTreeProof& tree : trees)
    for (const auto& node : tree) std::visit([&](const auto& n) { write_node(w, n); }, node);
}
std::vector<DmsTreeProof> read_dms_trees(ByteReader& r, std::size_t count) {
  std::vector<DmsTreeProof> out;
  while (out.size() < count && r.ok()) out.push_back(read_dms_tree(r));
  return out;
}

void write_dms_part(ByteWriter& w, const StarBoxBody& boxes) {
  const Bytes bytes = encode(boxes);
  w.u32(static_cast<std::uint32_t>(bytes.size()));
  w.raw(bytes);
}
std::optional<StarBoxBody> read_dms_part(ByteReader& r) {
  const std::uint32_t length = r.u32();
  const auto part = r.raw(length);
  ByteReader magic(part);
  const auto first = magic.raw(kStarBox2Magic.size());
  if (!r.ok() || !magic.ok() || !std::equal(first.begin(), first.end(), kStarBox2Magic.begin()))
    return std::nullopt;
  return read_star_box_2(ByteReader(part));
}

void append_dms_trees(std::string& out, const std::vector<DmsTreeProof>& trees,
                      std::size_t max_items) {
  append_list(out, "tetrahedra", trees.size(), max_items, [&](std::size_t i) {
    std::size_t leaves = 0, polynomial = 0;
    const DmsLeafProof* first = nullptr;
    for (const auto& node : trees[i])
      if (const auto* const leaf = std::get_if<DmsLeafProof>(&node)) {
        if (first == nullptr) first = leaf;
        ++leaves;
        polynomial += leaf->is_polynomial;
      }
    std::string text = std::to_string(leaves) + (leaves == 1 ? " leaf, " : " leaves, ") +
                       std::to_string(polynomial) + " of one polynomial; the first by the matrix (";
    for (std::size_t c = 0; first != nullptr && c < first->matrix.size(); ++c)
      text += (c == 0 ? "" : c % 3 == 0 ? "; " : ", ") + short_text(first->matrix[c]);
    return text + ")";
  });
}

Bytes dms_certificate(const Subject& subject, std::string_view claim, const DmsQuantities& q,
                      const char* patches, const Bytes& body) {
  StatementWriter w;
  state_subject(w, subject, claim);
  w.text("body_sha256", to_hex(sha256(body)));
  w.number("tetrahedra", q.tetrahedra);
  w.number("control_points", q.control_points);
  w.number("leaves", q.leaves);
  w.number(patches, q.patches);
  w.number("shells", q.shells);
  w.number("bodies", q.bodies);
  w.number("genus", q.genus);
  return join(w.take(), body);
}

}  // namespace veritope::certificate::internal
