// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/build_bridges.h: BridgeTilesToM and BuildBridgeTile, algorithms 3 and 4 of [HPE22], in the
// parameters of the cage: every cap of a tile whose neighbour was not kept is continued to the skin of the solid.
// Design: docs/design/0079-bridges.md and 0089-microstructures-in-solids-of-patches.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "robust/base/result.h"
#include "solids/micro/microstructure.h"
#include "solids/micro/tile_analysis.h"
#include "solids/patches/patch_complex.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

struct BridgeOptions {
  /// The second list lies alpha times the distance to the solid's surface from the cap: the shape control of algorithm
  /// 4.
  double alpha = 0.5;
  /// How far the end of a bridge may be from the surface; > 0.
  double skin = 0;
  unsigned jobs = 1;  ///< threads; the result is the same for every number
};

/// Why a cap has no bridge: TileVerify.
enum class BridgeDrop : std::uint8_t {
  kFlat,  ///< the cap is nearer to the surface than a twentieth of the arm
  kBox,  ///< it would leave the parameters of its volume; the wall is collapsed or holds more than a cap of one patch
  kFolded,  ///< no matrix was found that shows that it is one to one
  kTile,    ///< it meets a tile
  kSkin,    ///< it meets the surface, or its end is not near enough
  kBridge,  ///< it meets another bridge
};
inline constexpr std::size_t kNumBridgeDrops = 6;
/// "flat", "box", "folded", "tile", "skin", "bridge".
const char* bridge_drop_name(BridgeDrop drop);

/// An interval of doubles.
struct BridgeRange {
  double lo = 0, hi = 0;
};

struct BridgeReport {
  std::uint64_t caps = 0;  ///< those to be bridged
  std::uint64_t built = 0;
  std::array<std::uint64_t, kNumBridgeDrops> dropped{};  ///< by BridgeDrop
  /// Those that are not built, with their reasons, by ascending caps.
  std::vector<std::pair<CapPlace, BridgeDrop>> without;
  /// Tries whose determinants were positive, and how many of them got a matrix: for statistics.
  std::uint64_t unfolded = 0, proved_unfolded = 0;
  /// The greatest distance of a point of an end face from the surface lies in it, for each bridge. 0 without bridges.
  BridgeRange reach;
  /// Contains the angle between the images of the axis on both sides of the wall, in degrees, at each point of each
  /// cap. 0 without bridges.
  BridgeRange kink;
};

/// A hundredth of the diagonal of a box around the mesh or the patches, approximately. REQUIRES a vertex; a patch, and
/// positive weights.
double default_skin(const TriangleMesh& mesh);
double default_skin(const PatchComplex& complex);

/// Adds a bridge to each cap of a tile that meets no other cell with a tile, where it is proved that the bridge
/// satisfies R1 to R4 of docs/certificates/microstructure.md, lies in the interior of the solid, and ends within
/// `skin` of its surface. Up to 16 ends are tried for each cap.
/// REQUIRES a mesh that bounds a solid (certified valid), finite; a cage that is certified, around it; tiles that are
/// proved to lie in the interior of the solid; no bridges.
/// @error kOverLimit: too many pairs of walls between grids, too many bridges; FastSpline::prepare
/// @cost  milliseconds for each cap
Result<BridgeReport> build_bridges(const TriangleMesh& mesh, const VModel& cage,
                                   const std::vector<AnalysedTile>& tiles,
                                   const BridgeOptions& options, Microstructure& micro);
/// Leads bridges to a complex of patches that bounds a solid (certified valid), in the same way.
Result<BridgeReport> build_bridges(const PatchComplex& complex, const VModel& cage,
                                   const std::vector<AnalysedTile>& tiles,
                                   const BridgeOptions& options, Microstructure& micro);

}  // namespace veritope
