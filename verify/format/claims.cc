// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/claims.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "verify/format/entities_of_body_internal.h"
#include "verify/format/patch_certificate_text_internal.h"
#include "verify/format/statement_line_internal.h"
#include "verify/format/text_parts.h"

namespace veritope::certificate {
namespace {

using internal::ByteReader;

constexpr std::string_view kMeshes = "stl,obj,ply,off";
constexpr std::string_view kSplines = "vjson,itd,g2,mfem,vjson-faces,itd-faces,g2-faces,mfem-faces";
constexpr std::string_view kAllFormats =
    "stl,obj,ply,off,vjson,itd,g2,mfem,vjson-faces,itd-faces,g2-faces,mfem-faces,chain";
constexpr std::string_view kVolumes = "vjson,itd,g2,mfem";
constexpr std::string_view kStarNumbers =
    "bodies boxes edges flipped genus patches shells vertices";

// The text after "key":, up to a quotation mark, comma or brace.
std::string_view value_of(std::string_view statement, std::string_view key) {
  const std::size_t at = statement.find("\"" + std::string(key) + "\":");
  if (at == statement.npos) return {};
  statement.remove_prefix(at + key.size() + 3);
  if (statement.starts_with('"')) statement.remove_prefix(1);
  return statement.substr(0, statement.find_first_of("\",}"));
}

std::uint64_t number_of(std::string_view statement, std::string_view key) {
  std::uint64_t n = 0;
  for (const char c : value_of(statement, key))
    if (c >= '0' && c <= '9' && n < std::uint64_t{1} << 40)
      n = 10 * n + static_cast<std::uint64_t>(c - '0');
  return n;
}

bool begins_with(std::span<const unsigned char> body, std::string_view magic) {
  return body.size() >= magic.size() && std::equal(magic.begin(), magic.end(), body.begin());
}

template <class BodyOfClaim>
Bytes encode_as(const AnyBody& body) {
  return encode(std::get<BodyOfClaim>(body));
}
template <class BodyOfClaim>
std::string explain_as(const AnyBody& body, std::string_view name, std::size_t max_items) {
  return explain(std::get<BodyOfClaim>(body), name, max_items);
}

// Bodies that can be read without their statement and their model.
template <auto Read>
std::optional<AnyBody> decode_whole(std::span<const unsigned char> body, std::string_view,
                                    const ModelKinds*, std::string& why) {
  why = "the body ends too early, is too long, or holds a malformed number";
  if (auto read = Read(ByteReader(body))) return AnyBody(std::move(*read));
  return std::nullopt;
}

StarBoxBody& star_of(StarBoxBody& body) { return body; }
StarBoxBody& star_of(CollarBody& body) { return body.star; }
PatchInvalidBody& star_of(PatchInvalidBody& body) { return body; }

template <class BodyOfClaim>
std::optional<AnyBody> decode_patches(std::span<const unsigned char> body,
                                      std::string_view statement, const ModelKinds* model,
                                      std::string& why) {
  why = "the body is not complete";
  ByteReader r(body);
  r.raw(4);
  BodyOfClaim out;
  auto entities = internal::read_after_entities(r, number_of(statement, "patches"), model,
                                                [&](ByteReader& rest, std::uint64_t patches) {
                                                  out = BodyOfClaim();
                                                  internal::read(rest, patches, out);
                                                });
  if (!entities) return std::nullopt;
  star_of(out).entities = std::move(*entities);
  return AnyBody(std::move(out));
}

constexpr auto kClaims = std::to_array<Claim>({
    {kValidClaim, kValidMagic, "mesh.md", kMeshes, "reading_rule volume",
     "bodies edges faces genus shells vertices", "as_indexed", encode_as<ValidBody>,
     decode_whole<internal::read_valid>, explain_as<ValidBody>},
    {kInvalidClaim, kInvalidMagic, "mesh.md", kMeshes, "reading_rule rules", "", "as_indexed",
     encode_as<InvalidBody>, decode_whole<internal::read_invalid>, explain_as<InvalidBody>},
    {kReversedClaim, kReversedMagic, "mesh-reversed.md", kMeshes, "reading_rule volume",
     "bodies edges faces genus reversed reversed_shells shells vertices", "as_indexed",
     encode_as<ReversedBody>, decode_whole<internal::read_reversed>, explain_as<ReversedBody>},
    {kPointsClaim, kPointsMagic, "points.md", kAllFormats, "answers_sha256 decimals reading_rule",
     "answers_bytes on points undecided", "as_indexed winding", encode_as<PointsBody>,
     decode_whole<internal::read_points>, explain_as<PointsBody>},
    {kStarBoxClaim, kStarBoxMagic, "star-box.md", kSplines, "", kStarNumbers, "",
     encode_as<StarBoxBody>, decode_patches<StarBoxBody>, explain_as<StarBoxBody>},
    {kReversedShellClaim, kStarBoxMagic, "star-box.md", kSplines, "",
     "bodies boxes edges flipped genus patches shells vertices winding", "", encode_as<StarBoxBody>,
     decode_patches<StarBoxBody>, explain_as<StarBoxBody>},
    {kStarBox2Claim, kStarBox2Magic, "star-box-2.md", kSplines, "", kStarNumbers, "",
     encode_as<StarBoxBody>, decode_whole<internal::read_star_box_2>, explain_as<StarBoxBody>},
    {kReversedShell2Claim, kStarBox2Magic, "star-box-2.md", kSplines, "",
     "bodies boxes edges flipped genus patches shells vertices winding", "", encode_as<StarBoxBody>,
     decode_whole<internal::read_star_box_2>, explain_as<StarBoxBody>},
    {kPatchInvalidClaim, kPatchInvalidMagic, "patch-invalid.md", kSplines, "finding",
     "flipped opposite patches same", "", encode_as<PatchInvalidBody>,
     decode_patches<PatchInvalidBody>, explain_as<PatchInvalidBody>},
    {kPatchInvalid2Claim, kPatchInvalid2Magic, "patch-invalid-2.md", kSplines, "finding",
     "flipped patches", "", encode_as<PatchMeetingBody>, decode_whole<internal::read_patch_meeting>,
     explain_as<PatchMeetingBody>},
    {kVolumeFoldedClaim, kVolumeFoldedMagic, "volume-folded.md", kVolumes, "", "entity volumes", "",
     encode_as<VolumeFoldedBody>, decode_whole<internal::read_volume_folded>,
     explain_as<VolumeFoldedBody>},
    {kCollarClaim, kStarBoxMagic, "collar.md", kSplines, "",
     "bodies boxes cells edges flipped genus patches shells vertices", "", encode_as<CollarBody>,
     decode_patches<CollarBody>, explain_as<CollarBody>},
    {kCollar2Claim, kStarBox2Magic, "collar-2.md", kSplines, "",
     "bodies boxes cells edges flipped genus patches shells vertices", "", encode_as<CollarBody>,
     decode_whole<internal::read_collar_2>, explain_as<CollarBody>},
    {kVModelClaim, kVModelMagic, "vmodel.md", kVolumes, "",
     "bodies boxes cells euler genus half_v_surfaces patches pieces reversed shells singular "
     "v_curves "
     "v_points v_surfaces",
     "", encode_as<VModelBody>, decode_whole<internal::read_vmodel>, explain_as<VModelBody>},
    {kVModelInvalidClaim, kVModelInvalidMagic, "vmodel-invalid.md", kVolumes, "finding", "cells",
     "", encode_as<VModelInvalidBody>, decode_whole<internal::read_vmodel_invalid>,
     explain_as<VModelInvalidBody>},
    {kMicroClaim, kMicroMagic, "microstructure.md", "vmicro", "",
     "bridges cells components genus glued_caps shells tiles", "", encode_as<MicroBody>,
     decode_whole<internal::read_micro>, explain_as<MicroBody>},
    {kDmsClaim, kDmsMagic, "dms-solid.md", "vdms", "",
     "bodies control_points genus leaves patches shells tetrahedra", "", encode_as<DmsBody>,
     decode_whole<internal::read_dms_body>, explain_as<DmsBody>},
    {kDms2Claim, kDms2Magic, "dms-solid-2.md", "vdms", "",
     "bodies control_points faces genus leaves shells tetrahedra", "", encode_as<DmsPairsBody>,
     decode_whole<internal::read_dms_pairs_body>, explain_as<DmsPairsBody>},
    {kDmsInvalidClaim, kDmsInvalidMagic, "dms-invalid.md", "vdms", "finding", "tetrahedra", "",
     encode_as<DmsInvalidBody>, decode_whole<internal::read_dms_invalid>,
     explain_as<DmsInvalidBody>},
    {kMicroInsideClaim, kMicroInsideMagic, "micro-inside.md", "vmicro",
     "model_format model_sha256 reading_rule skin",
     "bridges cells components genus glued_caps model_bytes shells tiles", "as_indexed",
     encode_as<MicroInsideBody>, decode_whole<internal::read_micro_inside>,
     explain_as<MicroInsideBody>},
});

void add_keys(std::string_view names, const char* kind, std::map<std::string, std::string>& keys) {
  while (!names.empty()) {
    const std::size_t end = std::min(names.find(' '), names.size());
    keys[std::string(names.substr(0, end))] = kind;
    names.remove_prefix(std::min(end + 1, names.size()));
  }
}

}  // namespace

std::span<const Claim> all_claims() { return kClaims; }

const Claim* find_claim(std::string_view name) {
  const auto at =
      std::find_if(kClaims.begin(), kClaims.end(), [&](const Claim& c) { return c.name == name; });
  return at == kClaims.end() ? nullptr : &*at;
}

std::string claims_as_text() {
  std::string out;
  for (const Claim& c : kClaims) {
    std::map<std::string, std::string> keys;
    for (const std::string_view names : {kCommonTextKeys, c.text_keys})
      add_keys(names, "text", keys);
    for (const std::string_view names : {kCommonNumberKeys, c.number_keys})
      add_keys(names, "number", keys);
    add_keys(c.flag_keys, "flag", keys);
    out += std::string(c.name) + " " + std::string(c.magic) + " " + std::string(c.formats);
    char before = ' ';
    for (const auto& [key, kind] : keys) {
      out += before + key + "=" + kind;
      before = ',';
    }
    out += '\n';
  }
  return out;
}

std::optional<DecodedCertificate> decode_certificate(std::span<const unsigned char> bytes,
                                                     std::string& why, const ModelKinds* model) {
  auto statement = internal::statement_line(bytes, why);
  if (!statement) return std::nullopt;
  DecodedCertificate out;
  out.statement = std::move(*statement);
  const auto body = bytes.subspan(out.statement.size() + 1);
  out.claim = find_claim(value_of(out.statement, "claim"));
  if (out.claim == nullptr) {
    const auto fits = [&](const Claim& c) { return begins_with(body, c.magic); };
    const auto at = std::find_if(kClaims.begin(), kClaims.end(), fits);
    why = "neither its claim nor the first bytes of its body are known";
    if (at == kClaims.end()) return std::nullopt;
    out.claim = &*at;
  }
  why = "the body does not begin with " + std::string(out.claim->magic);
  if (!begins_with(body, out.claim->magic)) return std::nullopt;
  auto decoded = out.claim->decode(body, out.statement, model, why);
  if (!decoded) return std::nullopt;
  out.body = std::move(*decoded);
  return out;
}

std::optional<StatedSubject> stated_subject(std::span<const unsigned char> bytes) {
  std::string why;
  const auto statement = internal::statement_line(bytes, why);
  if (!statement || value_of(*statement, "certificate") != kFormatName) return std::nullopt;
  return StatedSubject{std::string(value_of(*statement, "subject_sha256")),
                       number_of(*statement, "subject_bytes")};
}

std::optional<std::string> explain_certificate(std::span<const unsigned char> bytes,
                                               std::size_t max_items, std::string& why,
                                               const ModelKinds* model) {
  const auto c = decode_certificate(bytes, why, model);
  if (!c) return std::nullopt;
  return internal::statement_text(c->statement) + "\n" +
         c->claim->explain(c->body, c->claim->name, max_items);
}

}  // namespace veritope::certificate
