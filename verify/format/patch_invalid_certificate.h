// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/patch_invalid_certificate.h: the certificate of an invalid patch model, version 1, as plain data, and
// its encoding. The page: docs/certificates/patch-invalid.md. Integers and bytes only; nothing here decides anything.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include "verify/format/patch_entities.h"

namespace veritope::certificate {

inline constexpr std::string_view kPatchInvalidClaim = "patch-invalid-1";
inline constexpr std::string_view kPatchInvalidMagic = "VTPI";

/// [low / 2^bits, high / 2^bits].
struct UnitInterval {
  std::uint64_t bits = 0, low = 0, high = 0;
};
struct RestrictedPatch {
  std::uint64_t patch = 0;
  std::array<UnitInterval, 2> at;
};
/// A crossing: section 3 of the page.
struct CrossingFinding {
  std::array<RestrictedPatch, 2> sheets;
  std::array<std::array<std::int64_t, 3>, 3> rows{};
};

struct PatchArc {
  std::uint64_t patch = 0;
  std::uint8_t side = 0;
  UnitInterval at;
};
/// Sides: section 4 of the page.
struct SideFinding {
  std::vector<PatchArc> arcs;
  std::uint8_t axis = 0;
  std::uint64_t point_bits = 0, point = 0;
  std::uint64_t same = 0, opposite = 0;  ///< as in the statement
};

struct PatchInvalidBody {
  std::vector<PatchEntity> entities;
  std::variant<CrossingFinding, SideFinding> finding;
};

Bytes encode(const PatchInvalidBody& body);
/// The whole certificate of a model with this many patches. `subject.reading_rule` and `as_indexed` are not used.
Bytes encode(const Subject& subject, std::uint64_t patches, const PatchInvalidBody& body);

namespace internal {
/// Reads what follows the entities; same and opposite are the statement's.
void read(ByteReader& r, std::uint64_t patches, PatchInvalidBody& out);
}  // namespace internal

}  // namespace veritope::certificate
