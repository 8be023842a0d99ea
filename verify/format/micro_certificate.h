// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/micro_certificate.h: the certificate of a microstructure as plain data, and its encoding. The page:
// docs/certificates/microstructure.md. Integers and bytes only; nothing here decides anything.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "verify/format/vmodel_certificate.h"

namespace veritope::certificate {

inline constexpr std::string_view kMicroClaim = "microstructure-1";
inline constexpr std::string_view kMicroMagic = "VTMS";

/// The point about which a tile is star-shaped, and the patch through which a ray from it leaves.
struct StarTileProof {
  std::array<Fraction, 3> centre;
  std::uint64_t exit = 0;
};
/// A body of star-box-2, or why the tile is star-shaped.
using MicroTileProof = std::variant<StarTileProof, StarBoxBody>;
/// The matrix that shows that a bridge is one to one, row by row, and where it is cut into slices, strictly between 0
/// and 1.
struct BridgeProof {
  std::array<Fraction, 9> matrix;
  std::vector<Fraction> cuts;  ///< at most 254
};
/// The matrix that shows that a sweep is one to one, row by row; the depth of a slab, and a speed.
struct SweepProof {
  std::array<Fraction, 9> matrix;
  Fraction depth, speed;
};
struct MicroBody {
  std::vector<MicroTileProof> tiles;
  /// Those of bridges, or those of sweeps: a file has only one of these.
  std::variant<std::vector<BridgeProof>, std::vector<SweepProof>> bridges;
  VModelBody cage;
};

/// What the statement says beside its claim.
struct MicroQuantities {
  std::uint64_t cells = 0, tiles = 0, bridges = 0, glued_caps = 0, components = 0, shells = 0,
                genus = 0;
};

Bytes encode(const MicroBody& body);
/// The whole certificate. `subject.reading_rule` and `as_indexed` are not used.
Bytes encode(const Subject& subject, const MicroQuantities& quantities, const MicroBody& body);

namespace internal {
class StatementWriter;
std::optional<MicroBody> read_micro(ByteReader r);
/// The keys of the numbers.
void state_quantities(StatementWriter& w, const MicroQuantities& quantities);
/// "-3/4"; for longer numbers the number of their bytes.
std::string short_text(const Fraction& x);
}  // namespace internal

}  // namespace veritope::certificate
