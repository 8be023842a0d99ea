// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/patch_meeting_certificate.h: the certificate of an invalid patch model, version 2, as plain data, and
// its encoding: two points of the surface have one image. The page: docs/certificates/patch-invalid-2.md. Integers and
// bytes only; nothing here decides anything.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "verify/format/patch_entities.h"

namespace veritope::certificate {

inline constexpr std::string_view kPatchInvalid2Claim = "patch-invalid-2";
inline constexpr std::string_view kPatchInvalid2Magic = "VTI2";

/// numerator / denominator, from 0 to 1.
struct UnitFraction {
  std::uint64_t numerator = 0, denominator = 1;
};
/// A point of a patch: (u, v), or (s, t) of a triangle.
struct MeetingPlace {
  std::uint64_t patch = 0;
  std::array<UnitFraction, 2> at;
};

struct PatchMeetingBody {
  std::vector<PatchEntity> entities;
  std::array<MeetingPlace, 2> places;
};

Bytes encode(const PatchMeetingBody& body);
/// The whole certificate of a model with this many patches. `subject.reading_rule` and `as_indexed` are not used.
Bytes encode(const Subject& subject, std::uint64_t patches, const PatchMeetingBody& body);

namespace internal {
std::optional<PatchMeetingBody> read_patch_meeting(ByteReader r);
}  // namespace internal

}  // namespace veritope::certificate
