// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/claims.h: the table of claims, and certificates of any of them. Each checker has the same table,
// written apart. The pages: docs/certificates. A new claim is one row here (docs/how-to/add-a-certificate.md).
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "verify/format/collar_certificate.h"
#include "verify/format/dms_certificate.h"
#include "verify/format/dms_invalid_certificate.h"
#include "verify/format/mesh_certificate.h"
#include "verify/format/micro_certificate.h"
#include "verify/format/micro_inside_certificate.h"
#include "verify/format/patch_invalid_certificate.h"
#include "verify/format/patch_meeting_certificate.h"
#include "verify/format/points_certificate.h"
#include "verify/format/vmodel_certificate.h"
#include "verify/format/vmodel_invalid_certificate.h"
#include "verify/format/volume_folded_certificate.h"

namespace veritope::certificate {

/// The body of a certificate as plain data.
using AnyBody =
    std::variant<ValidBody, InvalidBody, ReversedBody, StarBoxBody, CollarBody, PatchInvalidBody,
                 PatchMeetingBody, PointsBody, VolumeFoldedBody, VModelBody, VModelInvalidBody,
                 MicroBody, MicroInsideBody, DmsBody, DmsPairsBody, DmsInvalidBody>;

/// Which entities of the model are surfaces; the others are triangles. Bodies of version 1 about patches do not say so
/// themselves.
struct ModelKinds {
  std::vector<bool> is_surface;
};

struct Claim {
  std::string_view name, magic;  ///< magic: the body's first bytes
  std::string_view page;         ///< in docs/certificates
  std::string_view formats;      ///< the model's, separated by commas
  /// The statement's keys by the kind of their values, separated by blanks, without kCommonTextKeys and
  /// kCommonNumberKeys, which every claim has.
  std::string_view text_keys, number_keys, flag_keys;
  /// REQUIRES a body of this claim's type.
  Bytes (*encode)(const AnyBody& body);
  /// Decodes the layout only; no condition is tested. Counts are compared with the bytes left before anything is
  /// allocated; memory is linear in the bytes.
  /// @param statement, model  needed for version 1 of the claims about patches: the number of patches, and the
  /// kinds of the model's entities. Without a model the kinds are guessed: the decoder then knows only the number of
  /// surfaces, and assumes that they are the first entities.
  /// @return nothing, and a sentence in `why`, if the bytes are no body of this claim.
  std::optional<AnyBody> (*decode)(std::span<const unsigned char> body, std::string_view statement,
                                   const ModelKinds* model, std::string& why);
  /// A text for people; lists longer than `max_items` are cut, and say so. REQUIRES a body of this claim's type.
  std::string (*explain)(const AnyBody& body, std::string_view name, std::size_t max_items);
};

inline constexpr std::string_view kCommonTextKeys =
    "body_sha256 certificate claim subject_format subject_sha256 tool";
inline constexpr std::string_view kCommonNumberKeys = "subject_bytes";

std::span<const Claim> all_claims();
/// Null if no claim has that name.
const Claim* find_claim(std::string_view name);
/// One line for each claim: name, magic, formats, keys with the kinds of their values. Both checkers print these lines
/// for --claims.
std::string claims_as_text();

struct DecodedCertificate {
  const Claim* claim = nullptr;
  std::string statement;  ///< the line of JSON
  AnyBody body;
};
/// The claim is the one that the statement names; if the table does not have it, the first one with the body's magic.
/// @return nothing, and a sentence in `why`, if the bytes are no certificate
std::optional<DecodedCertificate> decode_certificate(std::span<const unsigned char> bytes,
                                                     std::string& why,
                                                     const ModelKinds* model = nullptr);
/// The file of which a certificate speaks.
struct StatedSubject {
  std::string sha256;  ///< as the statement has it
  std::uint64_t bytes = 0;
};
/// What the statement says; the body is not looked at, and may be missing.
/// @return nothing if the bytes do not begin as those of a certificate do
std::optional<StatedSubject> stated_subject(std::span<const unsigned char> bytes);
/// A text that a person can read: the statement, key by key, then the body.
std::optional<std::string> explain_certificate(std::span<const unsigned char> bytes,
                                               std::size_t max_items, std::string& why,
                                               const ModelKinds* model = nullptr);

}  // namespace veritope::certificate
