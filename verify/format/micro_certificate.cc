// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/micro_certificate.h"

#include <algorithm>
#include <utility>

#include "verify/format/byte_stream.h"
#include "verify/format/patch_certificate_text_internal.h"
#include "verify/format/sha256.h"
#include "verify/format/statement_writer.h"
#include "verify/format/text_parts.h"

namespace veritope::certificate {
namespace {

using internal::ByteReader;

constexpr std::size_t kLeastBytesOfTile = 5, kLeastBytesOfBridge = 19, kLeastBytesOfSweep = 22;
enum : std::uint8_t { kStar = 0, kBoxes = 1 };  // how a tile is proved

// In decimals if it is below 2^64.
std::string number_text(const Natural& n) {
  if (n.size() > sizeof(std::uint64_t))
    return "(a number of " + std::to_string(n.size()) + " bytes)";
  std::uint64_t value = 0;
  for (std::size_t i = n.size(); i-- > 0;) value = value << 8 | n[i];
  return std::to_string(value);
}
void write_tile(internal::ByteWriter& w, const MicroTileProof& tile) {
  w.u8(static_cast<std::uint8_t>(tile.index()));
  if (const auto* const star = std::get_if<StarTileProof>(&tile)) {
    for (const Fraction& x : star->centre) internal::write_fraction(w, x);
    w.varint(star->exit);
    return;
  }
  const Bytes boxes = encode(std::get<StarBoxBody>(tile));
  w.u32(static_cast<std::uint32_t>(boxes.size()));
  w.raw(boxes);
}

// Nothing if the bytes are no proof; then r has failed, or the bytes of the star boxes are malformed.
std::optional<MicroTileProof> read_tile(ByteReader& r) {
  const std::uint8_t kind = r.u8();
  if (kind == kStar) {
    StarTileProof star;
    for (Fraction& x : star.centre) x = internal::read_fraction(r);
    star.exit = r.varint();
    return star;
  }
  if (kind != kBoxes) return std::nullopt;
  const std::uint32_t length = r.u32();
  const auto part = r.raw(length);
  ByteReader magic(part);
  const auto first = magic.raw(kStarBox2Magic.size());
  if (!r.ok() || !magic.ok() || !std::equal(first.begin(), first.end(), kStarBox2Magic.begin()))
    return std::nullopt;
  auto boxes = internal::read_star_box_2(ByteReader(part));
  if (!boxes) return std::nullopt;
  return MicroTileProof(std::move(*boxes));
}

BridgeProof read_bridge(ByteReader& r) {
  BridgeProof out;
  for (Fraction& x : out.matrix) x = internal::read_fraction(r);
  const std::uint8_t slices = r.u8();
  if (slices == 0) r.fail();
  for (unsigned j = 1; j < slices && r.ok(); ++j) out.cuts.push_back(internal::read_fraction(r));
  return out;
}

SweepProof read_sweep(ByteReader& r) {
  SweepProof out;
  for (Fraction& x : out.matrix) x = internal::read_fraction(r);
  out.depth = internal::read_fraction(r);
  out.speed = internal::read_fraction(r);
  return out;
}

// The whole body; `read` reads a bridge or a sweep of at least so many bytes.
template <typename Proof, typename Read>
std::optional<MicroBody> read_body(ByteReader r, std::size_t least_bytes, Read read) {
  MicroBody out;
  r.raw(kMicroMagic.size());
  const std::size_t tiles = r.count(kLeastBytesOfTile), bridges = r.count(least_bytes);
  for (std::size_t k = 0; k < tiles && r.ok(); ++k) {
    auto tile = read_tile(r);
    if (!tile) return std::nullopt;
    out.tiles.push_back(std::move(*tile));
  }
  std::vector<Proof> proofs;
  for (std::size_t b = 0; b < bridges && r.ok(); ++b) proofs.push_back(read(r));
  out.bridges = std::move(proofs);
  ByteReader magic = r;
  const auto first = magic.raw(kVModelMagic.size());
  if (!magic.ok() || !std::equal(first.begin(), first.end(), kVModelMagic.begin()))
    return std::nullopt;
  auto cage = internal::read_vmodel(r);
  if (!cage) return std::nullopt;
  out.cage = std::move(*cage);
  return out;
}

void write_matrix(internal::ByteWriter& w, const std::array<Fraction, 9>& matrix) {
  for (const Fraction& x : matrix) internal::write_fraction(w, x);
}
void write_bridge(internal::ByteWriter& w, const BridgeProof& bridge) {
  write_matrix(w, bridge.matrix);
  w.u8(static_cast<std::uint8_t>(bridge.cuts.size() + 1));
  for (const Fraction& x : bridge.cuts) internal::write_fraction(w, x);
}
void write_bridge(internal::ByteWriter& w, const SweepProof& sweep) {
  write_matrix(w, sweep.matrix);
  internal::write_fraction(w, sweep.depth);
  internal::write_fraction(w, sweep.speed);
}

std::string matrix_text(const std::array<Fraction, 9>& matrix) {
  std::string text = "one to one by the matrix (";
  for (std::size_t c = 0; c < matrix.size(); ++c)
    text += (c == 0 ? "" : c % 3 == 0 ? "; " : ", ") + internal::short_text(matrix[c]);
  return text + ")";
}
std::string text_of_proof(const BridgeProof& bridge) {
  return matrix_text(bridge.matrix) + ", " + std::to_string(bridge.cuts.size() + 1) + " slices";
}
std::string text_of_proof(const SweepProof& sweep) {
  return matrix_text(sweep.matrix) + ", depth " + internal::short_text(sweep.depth) + ", speed " +
         internal::short_text(sweep.speed);
}

}  // namespace

std::string internal::short_text(const Fraction& x) {
  return (x.is_negative ? "-" : "") + number_text(x.numerator) + "/" + number_text(x.denominator);
}

void internal::state_quantities(StatementWriter& w, const MicroQuantities& q) {
  w.number("cells", q.cells);
  w.number("tiles", q.tiles);
  w.number("bridges", q.bridges);
  w.number("glued_caps", q.glued_caps);
  w.number("components", q.components);
  w.number("shells", q.shells);
  w.number("genus", q.genus);
}

Bytes encode(const MicroBody& body) {
  internal::ByteWriter w;
  w.text(kMicroMagic);
  w.u32(static_cast<std::uint32_t>(body.tiles.size()));
  std::visit([&](const auto& all) { w.u32(static_cast<std::uint32_t>(all.size())); }, body.bridges);
  for (const MicroTileProof& tile : body.tiles) write_tile(w, tile);
  std::visit(
      [&](const auto& all) {
        for (const auto& bridge : all) write_bridge(w, bridge);
      },
      body.bridges);
  w.raw(encode(body.cage));
  return w.take();
}

Bytes encode(const Subject& subject, const MicroQuantities& q, const MicroBody& body) {
  const Bytes bytes = encode(body);
  internal::StatementWriter w;
  internal::state_subject(w, subject, kMicroClaim);
  w.text("body_sha256", to_hex(sha256(bytes)));
  internal::state_quantities(w, q);
  return internal::join(w.take(), bytes);
}

// Only the file tells bridges from sweeps: the body is what reads to its end.
std::optional<MicroBody> internal::read_micro(ByteReader r) {
  auto out = read_body<BridgeProof>(r, kLeastBytesOfBridge, read_bridge);
  return out ? std::move(out) : read_body<SweepProof>(r, kLeastBytesOfSweep, read_sweep);
}

std::string explain(const MicroBody& body, std::string_view claim, std::size_t max_items) {
  std::string out = "body: " + std::string(claim) + "\n";
  internal::append_list(out, "tiles", body.tiles.size(), max_items, [&](std::size_t i) {
    const auto* const star = std::get_if<StarTileProof>(&body.tiles[i]);
    if (star == nullptr)
      return std::to_string(std::get<StarBoxBody>(body.tiles[i]).boxes.size()) + " star boxes";
    std::string text = "star-shaped about (";
    for (std::size_t c = 0; c < 3; ++c)
      text += (c == 0 ? "" : ", ") + internal::short_text(star->centre[c]);
    return text + "), left through patch " + std::to_string(star->exit);
  });
  const bool has_sweeps = std::holds_alternative<std::vector<SweepProof>>(body.bridges);
  std::visit(
      [&](const auto& all) {
        internal::append_list(out, has_sweeps ? "sweeps" : "bridges", all.size(), max_items,
                              [&](std::size_t i) { return text_of_proof(all[i]); });
      },
      body.bridges);
  return out + "the cage as a " + explain(body.cage, kVModelClaim, max_items);
}

}  // namespace veritope::certificate
