// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/compose/composed_surface.h: the boundary of a microstructure as patches in space, exactly, a cell at a
// time. Source: [HPE22], section 3.4; composition: docs/design/0009-composition.md. Design:
// docs/design/0077-measures-and-composed-output.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "robust/base/result.h"
#include "solids/micro/microstructure.h"
#include "solids/micro/tile_analysis.h"
#include "splines/bezier.h"

namespace veritope {

/// A cell that holds a tile.
struct ComposedCell {
  std::uint32_t grid = 0, tile = 0;
  std::uint64_t cell = 0;
  std::uint64_t glued_caps = 0;  ///< a bit for each cap that is equal to one of another cell
};

/// A patch of a tile after the map of its cell: of the degrees of the patch, each times the sum of the volume's.
struct ComposedPatch {
  std::uint32_t patch = 0;  ///< its number in the tile
  BezierSurface<Rational> surface{{1, 1}, 3, false};
};

/// All patches of all tiles but for those of equal caps, which lie in the interior of the structure: together they are
/// a closed surface. S_u x S_v turns outward. Tiles of curves and sheets are composed as they are, in their own
/// orientation. Nothing is rounded. Immutable.
class ComposedSurface {
 public:
  /// REQUIRES that the cage is that of micro, the analysed tiles are its tiles, each with at most 64 caps, and that
  /// topology_of finds no defect. All must outlive it.
  /// @error what topology_of refuses; kOverLimit: a patch would have a degree over kMaxSplineDegree
  static Result<ComposedSurface> make(const Microstructure& micro, const VModel& cage,
                                      const std::vector<AnalysedTile>& tiles);

  const std::vector<ComposedCell>& cells() const { return cells_; }
  std::uint64_t num_patches() const { return num_patches_; }
  std::uint64_t num_curves() const { return num_curves_; }  ///< among the patches: degrees (p, 0)
  std::uint64_t num_points() const { return num_points_; }  ///< control points of all patches

  /// The patches of cells()[begin], ..., cells()[end - 1], in this order.
  /// @cost  rational arithmetic: from 0.1 ms for a flat patch in a trilinear volume to seconds for one of degrees 7, 7
  ///        in a tricubic one
  std::vector<std::vector<ComposedPatch>> compose(std::size_t begin, std::size_t end) const;

 private:
  ComposedSurface(const Microstructure& micro, const VModel& cage,
                  const std::vector<AnalysedTile>& tiles)
      : micro_(&micro), cage_(&cage), tiles_(&tiles) {}
  Status find_cells();
  Status count();
  bool is_left_out(const ComposedCell& cell, std::size_t patch) const;

  const Microstructure* micro_;
  const VModel* cage_;
  const std::vector<AnalysedTile>* tiles_;
  std::vector<ComposedCell> cells_;
  std::uint64_t num_patches_ = 0, num_curves_ = 0, num_points_ = 0;
};

}  // namespace veritope
