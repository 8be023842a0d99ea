// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/micro_inside_certificate.h"

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

constexpr std::size_t kLeastBytesOfVoid = 11;

// A body in the body, with its magic.
template <auto Read>
auto read_inner(std::span<const unsigned char> bytes, std::string_view magic)
    -> decltype(Read(ByteReader(bytes))) {
  if (bytes.size() < magic.size() || !std::equal(magic.begin(), magic.end(), bytes.begin()))
    return std::nullopt;
  return Read(ByteReader(bytes));
}

}  // namespace

Bytes encode(const MicroInsideBody& body) {
  const Bytes structure = encode(body.structure),
              solid = std::visit([](const auto&b) { return encode(b); }, body.solid);
  internal::ByteWriter w;
  w.text(kMicroInsideMagic);
  w.u32(static_cast<std::uint32_t>(structure.size()));
  w.u32(static_cast<std::uint32_t>(solid.size()));
  w.raw(structure);
  w.raw(solid);
  w.u32(static_cast<std::uint32_t>(body.voids.size()));
  for (const VoidEntry& v : body.voids) {
    w.u32(v.volume);
    for (const Fraction& x : v.x) internal::write_fraction(w, x);
    w.u8(v.corner);
  }
  return w.take();
}

Bytes encode(const Subject& subject, const MicroQuantities& quantities,
             const InsideStatement& model, const MicroInsideBody& body) {
  const Bytes bytes = encode(body);
  internal::StatementWriter w;
  internal::state_subject(w, subject, kMicroInsideClaim);
  w.text("body_sha256", to_hex(sha256(bytes)));
  internal::state_quantities(w, quantities);
  w.text("model_sha256", model.sha256);
  w.number("model_bytes", model.bytes);
  w.text("model_format", model.format);
  w.text("reading_rule", model.reading_rule);
  w.boolean("as_indexed", model.as_indexed);
  w.text("skin", model.skin);
  return internal::join(w.take(), bytes);
}

std::optional<MicroInsideBody> internal::read_micro_inside(ByteReader r) {
  r.raw(kMicroInsideMagic.size());
  const std::uint32_t structure_size = r.u32(), solid_size = r.u32();
  const auto structure = r.raw(structure_size), solid = r.raw(solid_size);
  if (!r.ok()) return std::nullopt;
  auto structure_body = read_inner<internal::read_micro>(structure, kMicroMagic);
  if (!structure_body) return std::nullopt;
  MicroInsideBody out{std::move(*structure_body), {}, {}};
  if (auto mesh = read_inner<internal::read_valid>(solid, kValidMagic))
    out.solid = std::move(*mesh);
  else if (auto patches = read_inner<internal::read_star_box_2>(solid, kStarBox2Magic))
    out.solid = std::move(*patches);
  else
    return std::nullopt;
  for (std::uint32_t i = 0, n = r.count(kLeastBytesOfVoid); i < n && r.ok(); ++i) {
    VoidEntry& v = out.voids.emplace_back();
    v.volume = r.u32();
    for (Fraction& x : v.x) x = read_fraction(r);
    v.corner = r.u8();
  }
  if (!r.at_end()) return std::nullopt;
  return out;
}

std::string explain(const MicroInsideBody& body, std::string_view claim, std::size_t max_items) {
  std::string out = "body: " + std::string(claim) + "\n";
  internal::append_list(out, "voids", body.voids.size(), max_items, [&](std::size_t i) {
    const VoidEntry& v = body.voids[i];
    std::string text = "a point of the void at (";
    for (std::size_t c = 0; c < 3; ++c) text += (c == 0 ? "" : ", ") + internal::short_text(v.x[c]);
    text += ") of volume " + std::to_string(v.volume);
    return text + (v.corner == 8
                       ? ", in a cell without tile"
                       : ", joined to corner " + std::to_string(v.corner) + " of its cell");
  });
  out += "the microstructure as a " + explain(body.structure, kMicroClaim, max_items);
  const auto* const mesh = std::get_if<ValidBody>(&body.solid);
  return out + "the model as a " +
         (mesh != nullptr ? explain(*mesh, kValidClaim, max_items)
                          : explain(std::get<StarBoxBody>(body.solid), kStarBox2Claim, max_items));
}

}  // namespace veritope::certificate
