// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/collar_certificate.h: the collar certificate, versions 1 and 2, as plain data, and its encoding.
// The pages: docs/certificates/collar.md and collar-2.md. Integers and bytes only; nothing here decides anything.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "verify/format/star_box_certificate.h"

namespace veritope::certificate {

inline constexpr std::string_view kCollarClaim = "collar-1";
inline constexpr std::string_view kCollar2Claim = "collar-2";

struct CollarBody {
  StarBoxBody star;  ///< of either version, which is that of the collar
  /// The least corner of the root, in units of 2^(star.exponent + shift); its edge is 2^20 of them.
  std::uint64_t shift = 0;
  std::array<std::int64_t, 3> corner{};
  std::vector<std::uint64_t> cells;      ///< codes, ascending
  std::vector<std::uint8_t> sides;       ///< 1: the component of the boundary belongs to d+
  std::vector<std::uint32_t> collapses;  ///< a face for each cell
  std::vector<std::uint8_t>
      leaves;  ///< preorder, for each leaf of star.trees: 0 = four children, 1 = leaf
  std::vector<WalkPath> shores;  ///< from the least vertex of each component of the boundary
};

Bytes encode(const CollarBody& body);
/// The whole certificate, of kCollarClaim or kCollar2Claim. REQUIRES collapses.size() == cells.size().
Bytes encode(const Subject& subject, const StarBoxQuantities& quantities, const CollarBody& body);

namespace internal {
/// Reads what follows the entities in a body with this many patches.
void read(ByteReader& r, std::uint64_t patches, CollarBody& out);
/// A whole body of version 2, which needs neither its statement nor its model.
std::optional<CollarBody> read_collar_2(ByteReader r);
}  // namespace internal

}  // namespace veritope::certificate
