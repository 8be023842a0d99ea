// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/dms_certificate.h: the certificates of a simplex-spline solid as plain data, and their encoding. The
// pages: docs/certificates/dms-solid.md, dms-solid-2.md. Integers and bytes only; nothing here decides anything.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "verify/format/star_box_certificate.h"

namespace veritope::certificate {

inline constexpr std::string_view kDmsClaim = "dms-solid-1";
inline constexpr std::string_view kDmsMagic = "VTDM";
inline constexpr std::string_view kDms2Claim = "dms-solid-2";
inline constexpr std::string_view kDms2Magic = "VTD2";

/// The plane vector . x = number.
struct DmsPlaneProof {
  std::array<Fraction, 3> vector;
  Fraction number;
};
/// A node of a tree that is cut: edge 0 to 5, at its middle if there is no parameter.
struct DmsCutProof {
  std::uint8_t edge = 0;
  std::optional<Fraction> at;
};
struct DmsLeafProof {
  bool is_polynomial = false;  ///< of kind P
  std::array<Fraction, 9> matrix;
  std::vector<DmsPlaneProof> planes;
};
/// In preorder.
using DmsTreeProof = std::vector<std::variant<DmsCutProof, DmsLeafProof>>;

struct DmsTileProof {
  std::array<std::uint64_t, 3> points{};
  std::vector<DmsPlaneProof> planes;
};
struct DmsBody {
  std::vector<std::array<Fraction, 3>> points;     ///< added ones
  std::vector<DmsTreeProof> trees;                 ///< of the tetrahedra
  std::vector<std::vector<DmsPlaneProof>> planes;  ///< of the faces of the boundary
  std::vector<std::vector<DmsTileProof>>
      tiles;                    ///< of these faces; none: the face is its only tile
  StarBoxBody domain, surface;  ///< of version 2
};

/// The convex hull of some tetrahedra, and the matrix by which the map is one to one on it.
struct DmsBlockProof {
  std::vector<std::uint64_t> tetrahedra;
  std::array<Fraction, 9> matrix;
  std::vector<DmsPlaneProof> planes;
};
/// Two faces of the boundary.
struct DmsPairProof {
  enum class Kind : std::uint8_t { kApart, kChain, kAtEdge };

  std::uint64_t first = 0, second = 0;
  Kind kind = Kind::kApart;
  std::vector<std::uint64_t> chain, tetrahedra;     ///< kChain: vertices; of the edges between them
  std::array<Fraction, 2> feet;                     ///< kAtEdge
  std::vector<std::array<Fraction, 3>> directions;  ///< two if kAtEdge, or else one
};
/// A body of version 2.
struct DmsPairsBody {
  std::vector<DmsTreeProof> trees;                 ///< of the tetrahedra
  std::vector<std::vector<DmsPlaneProof>> planes;  ///< of the faces of the boundary
  std::vector<DmsBlockProof> blocks;
  std::vector<DmsPairProof> pairs;
  StarBoxBody domain;  ///< of version 2
};

/// What the statement says beside its claim.
struct DmsQuantities {
  std::uint64_t tetrahedra = 0, control_points = 0, leaves = 0;
  std::uint64_t patches = 0;  ///< version 2: faces of the boundary
  std::uint64_t shells = 0, bodies = 0, genus = 0;
};

Bytes encode(const DmsBody& body);
/// The whole certificate. `subject.reading_rule` and `as_indexed` are not used.
Bytes encode(const Subject& subject, const DmsQuantities& quantities, const DmsBody& body);
Bytes encode(const DmsPairsBody& body);
Bytes encode(const Subject& subject, const DmsQuantities& quantities, const DmsPairsBody& body);

namespace internal {
std::optional<DmsBody> read_dms_body(ByteReader r);
std::optional<DmsPairsBody> read_dms_pairs_body(ByteReader r);
}  // namespace internal

}  // namespace veritope::certificate
