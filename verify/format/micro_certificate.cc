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

constexpr std::size_t kLeastBytesOfTile = 7;

// In decimals if it is below 2^64.
std::string number_text(const Natural& n) {
  if (n.size() > sizeof(std::uint64_t))
    return "(a number of " + std::to_string(n.size()) + " bytes)";
  std::uint64_t value = 0;
  for (std::size_t i = n.size(); i-- > 0;) value = value << 8 | n[i];
  return std::to_string(value);
}
std::string centre_text(const Fraction& x) {
  return (x.is_negative ? "-" : "") + number_text(x.numerator) + "/" + number_text(x.denominator);
}

}  // namespace

Bytes encode(const MicroBody& body) {
  internal::ByteWriter w;
  w.text(kMicroMagic);
  w.u32(static_cast<std::uint32_t>(body.tiles.size()));
  for (const MicroTileProof& tile : body.tiles) {
    for (const Fraction& x : tile.centre) internal::write_fraction(w, x);
    w.varint(tile.exit);
  }
  w.raw(encode(body.cage));
  return w.take();
}

Bytes encode(const Subject& subject, const MicroQuantities& q, const MicroBody& body) {
  const Bytes bytes = encode(body);
  internal::StatementWriter w;
  internal::state_subject(w, subject, kMicroClaim);
  w.text("body_sha256", to_hex(sha256(bytes)));
  w.number("cells", q.cells);
  w.number("tiles", q.tiles);
  w.number("glued_caps", q.glued_caps);
  w.number("components", q.components);
  w.number("shells", q.shells);
  w.number("genus", q.genus);
  return internal::join(w.take(), bytes);
}

std::optional<MicroBody> internal::read_micro(ByteReader r) {
  MicroBody out;
  r.raw(kMicroMagic.size());
  out.tiles.resize(r.count(kLeastBytesOfTile));
  for (MicroTileProof& tile : out.tiles) {
    for (Fraction& x : tile.centre) x = internal::read_fraction(r);
    tile.exit = r.varint();
  }
  ByteReader magic = r;
  const auto first = magic.raw(kVModelMagic.size());
  if (!magic.ok() || !std::equal(first.begin(), first.end(), kVModelMagic.begin()))
    return std::nullopt;
  auto cage = read_vmodel(r);
  if (!cage) return std::nullopt;
  out.cage = std::move(*cage);
  return out;
}

std::string explain(const MicroBody& body, std::string_view claim, std::size_t max_items) {
  std::string out = "body: " + std::string(claim) + "\n";
  internal::append_list(out, "tiles", body.tiles.size(), max_items, [&](std::size_t i) {
    const MicroTileProof& tile = body.tiles[i];
    std::string text = "star-shaped about (";
    for (std::size_t c = 0; c < 3; ++c) text += (c == 0 ? "" : ", ") + centre_text(tile.centre[c]);
    return text + "), left through patch " + std::to_string(tile.exit);
  });
  return out + "the cage as a " + explain(body.cage, kVModelClaim, max_items);
}

}  // namespace veritope::certificate
