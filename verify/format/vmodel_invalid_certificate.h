// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/vmodel_invalid_certificate.h: the certificate of an invalid V-model as plain data, and its encoding.
// The page: docs/certificates/vmodel-invalid.md. Integers and bytes only; nothing here decides anything.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "verify/format/patch_invalid_certificate.h"
#include "verify/format/volume_folded_certificate.h"

namespace veritope::certificate {

inline constexpr std::string_view kVModelInvalidClaim = "vmodel-invalid-1";
inline constexpr std::string_view kVModelInvalidMagic = "VTVI";

struct CellPoint {
  std::uint64_t cell = 0;
  std::array<PieceFraction, 3> at;
};
/// A part of a knot span of an axis.
struct SpanInterval {
  std::uint64_t piece = 0;
  UnitInterval at;
};
struct CellBox {
  std::uint64_t cell = 0;
  std::array<SpanInterval, 3> at;
};

/// The determinant vanishes on a box of knots.
struct FlatCell {
  std::uint64_t cell = 0;
  std::array<std::uint64_t, 3> pieces{};
};
struct LeftHandedCell {
  CellPoint at;
};
struct SingularPoint {
  CellPoint at;
};
/// Two points of the cells with one image; the second is known, or is somewhere in a box.
struct CellOverlap {
  struct Somewhere {
    CellBox box;
    std::array<std::array<std::int64_t, 3>, 3> rows{};
  };
  CellPoint inside;
  std::variant<CellPoint, Somewhere> other;
};
/// A part of a side of a face of a cell.
struct FaceArc {
  std::uint64_t cell = 0;
  std::uint8_t face = 0, side = 0;
  SpanInterval at;
};
struct CrowdedCurve {
  std::array<FaceArc, 3> arcs;
};
struct PinchedPoint {
  std::uint64_t cell = 0;
  std::uint8_t corner = 0;
};

/// In the order of the page's kinds.
using VModelInvalidFinding =
    std::variant<FlatCell, LeftHandedCell, SingularPoint, CellOverlap, CrowdedCurve, PinchedPoint>;
struct VModelInvalidBody {
  std::uint32_t cells = 0;  ///< entities of the file
  VModelInvalidFinding finding;
};
/// "flat", "left-handed", ...: what the statement calls the finding.
std::string_view name_of(const VModelInvalidFinding& finding);

Bytes encode(const VModelInvalidBody& body);
/// The whole certificate. `subject.reading_rule` and `as_indexed` are not used.
Bytes encode(const Subject& subject, const VModelInvalidBody& body);

namespace internal {
std::optional<VModelInvalidBody> read_vmodel_invalid(ByteReader r);
}  // namespace internal

}  // namespace veritope::certificate
