// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/patch_tile_peers.h: Open CASCADE's answers to whether a tile of Bezier patches lies in a solid of patches; its
// headers stay in its file.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "solids/patches/patch.h"

namespace veritope::bench {

/// BRepExtrema_DistShapeShape between the faces of a tile and the shell of the patches, which are sewn into one solid;
/// BRepClass3d_SolidClassifier for a corner of a tile that is apart.
class OcctTiles {
 public:
  /// The patches as Bezier faces.
  class Tile {
   public:
    explicit Tile(std::span<const BezierSurface<Rational>> patches);
    ~Tile();
    Tile(const Tile&) = delete;

   private:
    friend class OcctTiles;
    struct Faces;
    std::unique_ptr<Faces> faces_;
  };

  explicit OcctTiles(std::span<const Patch> patches);
  ~OcctTiles();
  OcctTiles(const OcctTiles&) = delete;

  bool is_inside(const Tile& tile) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace veritope::bench
