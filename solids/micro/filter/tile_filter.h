// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/filter/tile_filter.h: does the tile of a cell lie in a solid that a mesh, or a closed complex of
// patches, bounds? FilterTilesToM of the microstructure paper, with proofs. Design: docs/design/0074-filtering-tiles.md
// and docs/design/0078-tiles-in-solids-of-patches.md.
#pragma once
#include <array>
#include <memory>

#include "robust/base/result.h"
#include "solids/micro/filter/cell_status.h"
#include "solids/micro/filter/tile_shape.h"
#include "solids/patches/patch_complex.h"
#include "solids/polyhedron/triangle_mesh.h"
#include "splines/bezier.h"

namespace veritope {

/// What a cell may cost before it is undecided.
struct TileFilterLimits {
  int max_pieces = 20000;       ///< parts of patches, all together
  int max_depth = 90;           ///< halvings of one patch
  int max_exact_points = 5000;  ///< control points of parts whose contact is examined in rationals
};

/// The part [lo, hi] of the domain of a map of [0,1]^3 into space, rational or polynomial: the tile in [0,1]^3 is first
/// stretched to the part, then mapped. The map must outlive it.
struct CellMap {
  const BezierVolume<Rational>* map = nullptr;
  PatchPoint lo{Rational(0), Rational(0), Rational(0)};
  PatchPoint hi{Rational(1), Rational(1), Rational(1)};

  /// The image of a point of [0,1]^3. REQUIRES a weight that is not 0 there.
  ExactPoint image(const PatchPoint& at) const;
  ExactPoint image(const TileShape& tile, const TilePatchPoint& at) const;
};

/// Filters tiles against one solid. Immutable: threads may share it.
/// Laws: (1) a status other than undecided is right; (2) it depends on the cell and its tile alone. A tile that touches
/// a solid of patches is undecided.
class TileFilter {
 public:
  /// REQUIRES a mesh that bounds a solid (certified valid), finite, with fewer than 2^30 faces. The mesh must outlive
  /// the filter.
  /// @error as MeshClassifier::make
  /// @cost  near-linear in the facets; approximately 200 bytes a facet
  static Result<TileFilter> make(const TriangleMesh& mesh);
  static Result<TileFilter> make(TriangleMesh&&) = delete;
  /// REQUIRES a complex that bounds a solid (certified valid). It must outlive the filter. CellFinding::vertex is then
  /// a vertex of the complex.
  /// @cost  as PatchClassifier::make; some 8 megabytes, or 2 kilobytes a patch if that is more
  static TileFilter make(const PatchComplex& complex);
  static TileFilter make(PatchComplex&&) = delete;

  TileFilter(TileFilter&&) noexcept;
  ~TileFilter();

  /// REQUIRES a map with three coordinates that is one to one on the cell, as the map of a certified cage is, and lo <
  /// hi.
  /// @cost without surface near the cell a look-up; else the facets near times the pieces that come close to them, or
  ///       pairs of parts of the tile and of the solid that come close to each other
  CellFinding find(const CellMap& cell, const TileShape& tile,
                   const TileFilterLimits& limits = {}) const;
  CellStatus status(const CellMap& cell, const TileShape& tile) const {
    return find(cell, tile).status;
  }

  class Model;
  const Model& model() const { return *model_; }

 private:
  explicit TileFilter(std::unique_ptr<const Model> model);
  std::unique_ptr<const Model> model_;
};

}  // namespace veritope
