// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/filter/tile_walk_internal.h: the decision about one tile near the surface of the solid. Internal to
// solids/micro/filter.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "solids/micro/filter/filter_model_internal.h"
#include "solids/micro/filter/tile_pieces_internal.h"

namespace veritope::internal {

/// Decides the status of one cell. All functions REQUIRE a live ScopedUpward.
class TileWalk {
 public:
  TileWalk(const TileFilter::Model& model, const CellNet& net, const CellMap& cell,
           const TileShape& tile, const TileFilterLimits& limits)
      : model_(model),
        cell_(cell),
        limits_(limits),
        pieces_(net, tile),
        obstacles_(model.obstacles(cell, tile, limits)) {}

  CellFinding run();

 private:
  struct OpenPiece {
    TilePiece piece;
    std::vector<std::uint32_t> near;  ///< the obstacles that are not proved apart from it
  };

  const TileShape& tile() const { return pieces_.tile(); }
  bool is_crossing() const { return inside_ && off_; }
  Value3 note(const TilePiece& piece, std::size_t corner);
  void note_exactly(const TilePatchPoint& at);
  void note_touching();
  void note_corners();
  void open_patches();
  void visit_breadth_first();
  void visit_depth_first();
  bool settle(OpenPiece* open);
  void halve(const OpenPiece& open, std::vector<OpenPiece>* out);
  CellFinding finish();
  CellFinding found(CellStatus status) const;
  std::optional<CellFinding> find_shells_inside();

  const TileFilter::Model& model_;
  const CellMap& cell_;
  const TileFilterLimits& limits_;
  TilePieces pieces_;
  std::unique_ptr<Obstacles> obstacles_;
  std::vector<Value3> corner_values_;
  std::optional<TilePatchPoint> inside_, off_;
  std::optional<ExactPoint> contact_;
  std::vector<OpenPiece> open_;
  std::vector<TilePiece>
      apart_;  ///< parts of patches that are apart from all obstacles, where not the whole patch is
  std::vector<TilePiece> touching_;  ///< the first parts that touch
  std::vector<char> is_patch_apart_;
  bool has_unsettled_ = false, is_touching_ = false;
  /// Whether every point of the touching parts is a limit of points in the interior of M, or off M.
  bool is_near_inside_ = true, is_near_outside_ = true;
  int num_pieces_ = 0, most_pieces_ = limits_.max_pieces;
};

}  // namespace veritope::internal
