// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/volume_folded_certificate.h: the certificate of a volume that folds, as plain data, and its encoding.
// The page: docs/certificates/volume-folded.md. Integers and bytes only; nothing here decides anything.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "verify/format/byte_stream.h"
#include "verify/format/mesh_certificate.h"
#include "verify/format/patch_meeting_certificate.h"

namespace veritope::certificate {

inline constexpr std::string_view kVolumeFoldedClaim = "volume-folded-1";
inline constexpr std::string_view kVolumeFoldedMagic = "VTVF";

/// A parameter of an axis: the number of its piece, and how far in it.
struct PieceFraction {
  std::uint64_t piece = 0;
  UnitFraction at;
};
struct VolumeFoldedBody {
  std::uint32_t volumes = 0;  ///< entities of the file
  std::uint64_t entity = 0;
  /// The Jacobian determinant is positive at the first and negative at the second.
  std::array<std::array<PieceFraction, 3>, 2> points;
};

Bytes encode(const VolumeFoldedBody& body);
/// The whole certificate. `subject.reading_rule` and `as_indexed` are not used.
Bytes encode(const Subject& subject, const VolumeFoldedBody& body);

namespace internal {
std::optional<VolumeFoldedBody> read_volume_folded(ByteReader r);
}  // namespace internal

}  // namespace veritope::certificate
