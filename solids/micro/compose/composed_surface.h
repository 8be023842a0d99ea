// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/compose/composed_surface.h: the boundary of a microstructure as patches in space, exactly, a cell at a
// time. Source: [HPE22], section 3.4; composition: docs/design/0009-composition.md. Design:
// docs/design/0077-measures-and-composed-output.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robust/base/result.h"
#include "solids/micro/microstructure.h"
#include "solids/micro/tile_analysis.h"
#include "splines/bezier.h"

namespace veritope {

class CellPiece;
namespace internal {
class VolumePieces;
}  // namespace internal

/// A cell that holds a tile.
struct ComposedCell {
  std::uint32_t grid = 0, tile = 0;
  std::uint64_t cell = 0;
  /// A bit for each cap that lies inside: one that is equal to a cap of another cell, or that a composed bridge covers.
  std::uint64_t covered_caps = 0;
  std::vector<std::uint32_t>
      bridges;  ///< those that start here and are composed, or the sweeps, ascending
};

/// A patch of a tile, or a free face of a bridge, after the map of the volume: of its degrees, each times the sum of
/// the volume's.
struct ComposedPatch {
  std::uint32_t patch = 0;  ///< its number in the tile, or in free_faces of the bridge
  std::optional<std::uint32_t>
      bridge;  ///< the number of the bridge or sweep; nothing for a patch of the tile
  BezierSurface<Rational> surface{{1, 1}, 3, false};
};

/// All patches of all tiles and the free faces of all bridges, but for patches of equal caps and of caps that bridges
/// cover, which lie in the interior of the structure: together they are a closed surface. S_u x S_v turns outward. A
/// bridge is left out, and its cap stays, where its net is in no box of the parameters on which the map of the volume
/// is one polynomial, or rational, map: where it crosses a knot that the map needs, its faces after the map are no
/// patches with polynomial sides. The faces of a sweep, which is in space, have the degrees of the composed cap and 2;
/// no sweep is left out. Tiles of curves and sheets are composed as they are, in their own orientation. Nothing is
/// rounded. Immutable.
class ComposedSurface {
 public:
  /// REQUIRES that the cage is that of micro, the analysed tiles are its tiles, each with at most 64 caps, that
  /// topology_of finds no defect, and bridges as docs/certificates/microstructure.md demands. All must outlive it.
  /// @error what topology_of refuses; kBadArgument: a bridge starts at a wall that does not hold one cap; kOverLimit: a
  /// patch would have a degree over kMaxSplineDegree
  static Result<ComposedSurface> make(const Microstructure& micro, const VModel& cage,
                                      const std::vector<AnalysedTile>& tiles);

  ComposedSurface(ComposedSurface&&) noexcept;
  ~ComposedSurface();

  const std::vector<ComposedCell>& cells() const { return cells_; }
  std::uint64_t num_patches() const { return num_patches_; }
  std::uint64_t num_curves() const { return num_curves_; }  ///< among the patches: degrees (p, 0)
  std::uint64_t num_points() const { return num_points_; }  ///< control points of all patches
  /// Numbers of bridges that are left out, ascending.
  const std::vector<std::uint32_t>& bridges_left_out() const { return left_out_; }

  /// The patches of cells()[begin], ..., cells()[end - 1], in this order; those of a tile, then those of its bridges.
  /// @cost  rational arithmetic: from 0.1 ms for a flat patch in a trilinear volume to seconds for one of degrees 7, 7
  ///        in a tricubic one
  std::vector<std::vector<ComposedPatch>> compose(std::size_t begin, std::size_t end) const;

 private:
  ComposedSurface(const Microstructure& micro, const VModel& cage,
                  const std::vector<AnalysedTile>& tiles);
  Status find_cells();
  Status cover_equal_caps(const std::vector<std::vector<std::uint32_t>>& numbers);
  Status cover_bridged_caps(const std::vector<std::vector<std::uint32_t>>& numbers);
  Status cover_swept_caps(const std::vector<std::vector<std::uint32_t>>& numbers);
  const TilePatch& patch_of_sweep(std::uint32_t number) const;
  std::array<int, 2> degrees_after(std::uint32_t volume, const std::array<int, 2>& degrees) const;
  Status count_faces(std::uint32_t number);
  void compose_sweep(std::uint32_t number, CellPiece& piece,
                     std::vector<ComposedPatch>& out) const;
  Status count();
  Status count_patch(std::uint32_t volume, const std::array<int, 2>& degrees,
                     const std::string& name);
  bool is_left_out(const ComposedCell& cell, std::size_t patch) const;
  void compose_tile(const ComposedCell& cell, CellPiece& piece,
                    std::vector<ComposedPatch>& out) const;
  void compose_bridge(std::uint32_t number, std::vector<ComposedPatch>& out) const;

  const Microstructure* micro_;
  const VModel* cage_;
  const std::vector<AnalysedTile>* tiles_;
  std::vector<ComposedCell> cells_;
  std::vector<internal::VolumePieces> pieces_;  // by volumes; none without bridges
  std::vector<std::optional<std::array<std::size_t, 3>>> span_of_bridge_;
  std::vector<std::uint32_t> left_out_;
  std::uint64_t num_patches_ = 0, num_curves_ = 0, num_points_ = 0;
};

}  // namespace veritope
