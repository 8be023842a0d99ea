// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/vmodel_certificate.h: the certificate of a V-model as plain data, and its encoding. The page:
// docs/certificates/vmodel.md. Integers and bytes only; nothing here decides anything.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "verify/format/star_box_certificate.h"

namespace veritope::certificate {

inline constexpr std::string_view kVModelClaim = "vmodel-1";
inline constexpr std::string_view kVModelMagic = "VTVM";

struct VModelCell {
  bool is_reversed = false;
  std::array<std::vector<Fraction>, 3> added_breaks;  ///< besides the knots, along u, v, w
};
/// What a face of a cell is.
struct VModelFace {
  enum class Kind : std::uint8_t { kBoundary, kCollapsed, kNamed, kGlued };
  Kind kind = Kind::kBoundary;
  std::uint64_t other = 0;    ///< kGlued: the face that it is glued to, with a higher number
  std::uint8_t symmetry = 0;  ///< kGlued: 0 to 7
};
/// The determinant of a piece that has zeros, or whose coefficients are not all positive.
struct VModelDeterminant {
  std::uint64_t piece = 0;
  std::uint32_t zeros = 0;         ///< bits 0 to 25: its sub-faces
  std::vector<std::uint8_t> tree;  ///< in preorder: 0 a leaf, 1 to 3 halved along u, v, w
};
struct VModelBody {
  std::vector<VModelCell> cells;
  std::vector<VModelFace> faces;                ///< six a cell
  std::vector<VModelDeterminant> determinants;  ///< by ascending pieces
  StarBoxBody boundary;                         ///< of version 2
};

/// What the statement says beside its claim.
struct VModelQuantities {
  std::uint64_t cells = 0, pieces = 0, half_v_surfaces = 0, v_surfaces = 0, v_curves = 0,
                v_points = 0;
  std::int64_t euler = 0;
  std::uint64_t reversed = 0, singular = 0, patches = 0, shells = 0, bodies = 0, genus = 0;
};

Bytes encode(const VModelBody& body);
/// The whole certificate. `subject.reading_rule` and `as_indexed` are not used.
Bytes encode(const Subject& subject, const VModelQuantities& quantities, const VModelBody& body);

namespace internal {
std::optional<VModelBody> read_vmodel(ByteReader r);
}  // namespace internal

}  // namespace veritope::certificate
