// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/dms_invalid_certificate.h: the certificate of an invalid simplex-spline solid as plain data, and its
// encoding. The page: docs/certificates/dms-invalid.md. Integers and bytes only; nothing here decides anything.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "verify/format/dms_certificate.h"
#include "verify/format/patch_invalid_certificate.h"

namespace veritope::certificate {

inline constexpr std::string_view kDmsInvalidClaim = "dms-invalid-1";
inline constexpr std::string_view kDmsInvalidMagic = "VTDI";

using DmsPointProof = std::array<Fraction, 3>;
struct DmsFaceName {
  std::uint64_t tetrahedron = 0;
  std::uint8_t number = 0;
};
using DmsIndexName = std::array<std::uint8_t, 4>;

struct DmsReversedTetrahedron {
  std::uint64_t tetrahedron = 0;
};
struct DmsOverusedFace {
  std::array<DmsFaceName, 2> faces;
};
struct DmsDegenerateCloud {
  std::uint64_t tetrahedron = 0;
  DmsIndexName index{};
};
struct DmsCloudWithoutCore {
  struct Weight {
    DmsIndexName index{};
    std::uint8_t corner = 0;
    Fraction weight;
  };
  std::uint64_t tetrahedron = 0;
  std::vector<Weight> weights;  ///< one to four
};
struct DmsCloudInside {
  DmsFaceName face;
  std::array<std::uint8_t, 3> last{};
  std::uint64_t tetrahedron = 0;
  std::vector<Fraction> weights;  ///< last[0] + last[1] + last[2] + 3
};
struct DmsNegativePoint {
  DmsPointProof at;
};
/// A part of a tetrahedron on which the map is one polynomial.
struct DmsPolynomialPart {
  std::uint64_t tetrahedron = 0;
  std::array<DmsPointProof, 4> corners;
  std::vector<DmsPlaneProof> planes;
};
struct DmsFlatLeaf : DmsPolynomialPart {};
struct DmsCrowdedEdgeName {
  std::array<std::uint64_t, 2> vertices{};
};
struct DmsPinchedVertexName {
  std::uint64_t vertex = 0;
};
struct DmsImproperPoint {
  std::array<DmsFaceName, 2> faces;
  std::array<std::array<Fraction, 3>, 2> weights;
};
struct DmsOverlapPoint {
  std::array<std::uint64_t, 2> tetrahedra{};
  DmsPointProof at;
};
struct DmsMeetingPoints {
  std::array<DmsPointProof, 2> at;
};
struct DmsCrossingPieces {
  struct Piece {
    DmsFaceName face;
    std::array<DmsPointProof, 3> corners;
    std::vector<DmsPlaneProof> planes;
  };
  std::array<Piece, 2> pieces;
  std::array<std::array<UnitInterval, 2>, 2> at;
  std::array<std::array<std::int64_t, 3>, 3> rows{};
};

struct DmsCoveringLeaf : DmsPolynomialPart {
  DmsPointProof other;
};

/// In the order of the page's kinds.
using DmsInvalidFinding =
    std::variant<DmsReversedTetrahedron, DmsOverusedFace, DmsDegenerateCloud, DmsCloudWithoutCore,
                 DmsCloudInside, DmsNegativePoint, DmsFlatLeaf, DmsCrowdedEdgeName,
                 DmsPinchedVertexName, DmsImproperPoint, DmsOverlapPoint, DmsMeetingPoints,
                 DmsCrossingPieces, DmsCoveringLeaf>;
struct DmsInvalidBody {
  std::uint32_t tetrahedra = 0;  ///< of the file
  DmsInvalidFinding finding;
  /// For each face of the boundary, if the finding is about the map.
  std::vector<std::vector<DmsPlaneProof>> planes;
};
/// "tet-reversed", "jacobian", ...: what the statement calls the finding.
std::string_view name_of(const DmsInvalidFinding& finding);
/// Whether the finding is about the map, and not about the domain or the clouds.
bool needs_planes(const DmsInvalidFinding& finding);

Bytes encode(const DmsInvalidBody& body);
/// The whole certificate. `subject.reading_rule` and `as_indexed` are not used.
Bytes encode(const Subject& subject, const DmsInvalidBody& body);

namespace internal {
std::optional<DmsInvalidBody> read_dms_invalid(ByteReader r);
}  // namespace internal

}  // namespace veritope::certificate
