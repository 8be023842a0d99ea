// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/inside/clearance.h: how far the tiles of a microstructure are from the surface of the solid in which
// they lie. Design: docs/design/0085-bridges-in-measures-and-clearance.md.
#pragma once
#include <cstdint>
#include <optional>

#include "robust/base/result.h"
#include "solids/micro/microstructure.h"
#include "solids/patches/patch_complex.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// lo <= the least distance between a point of a tile and one of the surface <= hi. hi is the distance of two such
/// points, rounded up.
struct Clearance {
  double lo = 0, hi = 0;
};

/// What a search may cost before it ends with what is known.
struct ClearanceLimits {
  std::uint64_t nodes = std::uint64_t{1} << 21;  ///< parts of the cage and of patches
  std::uint64_t nodes_of_cell = 20000;           ///< of the patches of one cell
};

/// Tiles, with their caps; bridges do not count, since they lead to the surface. hi is at most 1.01 lo, unless the
/// limits are reached, or distances are so small beside the coordinates that rounding hides them (10^-12 of them).
/// Nothing if no cell holds a tile, or the surface has no part. The result is the same for every number of jobs.
/// REQUIRES validate(micro), positive weights, a cage that is one to one, and tiles none of which holds a point of the
/// surface in its interior, such as those that filter_tiles_to keeps.
/// @error kNotFinite: numbers beyond the range of binary64, or a weight that is not proved positive
/// @cost  blocks of cells in the order of their distances, then the patches of the cells that may be nearest
Result<std::optional<Clearance>> clearance_of(const Microstructure& micro, const TriangleMesh& mesh,
                                              unsigned jobs, const ClearanceLimits& limits = {});
Result<std::optional<Clearance>> clearance_of(const Microstructure& micro,
                                              const PatchComplex& complex, unsigned jobs,
                                              const ClearanceLimits& limits = {});

}  // namespace veritope
