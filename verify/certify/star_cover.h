// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/star_cover.h: the search for star boxes that cover a patch complex. Theory: docs/THEORY.md §4.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "robust/base/work_share.h"
#include "solids/star_box/star_box.h"
#include "verify/certify/frame_search.h"

namespace veritope {

struct StarCoverOptions {
  int max_level = 20;                 ///< pieces are not split deeper: undecided there
  std::size_t max_boxes = 4'000'000;  ///< boxes that are tried
  double growth = 1.75;               ///< size of a box relative to the hull
  double least_unit = 0x1p-48;        ///< the least unit of boxes that are cut back, and of centres
  /// the least unit of cubes; the search ends where a cube would need a finer one
  double least_cube_unit = 0;
  std::size_t memory = PieceForest::kNetMemory;  ///< bytes that the nets of pieces may take
  /// Where the forest has more nodes, those are dropped, once in a while, that only tests of boxes needed.
  std::size_t most_nodes = std::size_t{1} << 20;
  /// Where a piece has no other box: boxes with zeros (ZeroSearch), mesh boxes of flat patches of any degree, boxes in
  /// frames and with several sheets. Their certificates are of version 2.
  bool with_frames = false;
  double least_framed_unit = 0x1p-34;  ///< the least unit of boxes in frames
  /// Called for each piece without a star box of its own size; the search stops if it returns true.
  std::function<bool(PieceForest::Id piece, std::size_t boxes_tried)> stops_at;
  /// If not null, a step of it shows how much of the patches is covered: each root of the forest counts as 1, a piece
  /// as its share of the root's parameter domain.
  WorkShare* work = nullptr;
};

/// A box and centres on the grid of multiples of unit, a power of two.
struct CoverBox {
  StarBox star;
  double unit;
  bool is_mesh = false;  ///< a mesh box: it has no centres
  /// Where it was cut back between sheets that face each other: the area that the sheets have in common, seen along the
  /// axis of the cut, in squares of their distance; the greatest of all cuts.
  double gap_squares = 0;
  /// A box in a frame, with one sheet or several; then `star` has the plain box around it, and the centres of the first
  /// sheet.
  std::shared_ptr<const FramedBox> framed;
  /// A star box with zeros, or a mesh box of other patches than triangles of degree 1.
  bool needs_version_2 = false;

  static CoverBox of(const FramedBox& framed);
  /// Walks start and end at such boxes only.
  bool has_one_sheet() const { return !is_mesh && (!framed || framed->sheets.sheets.size() == 1); }
};

/// Where no star box was found.
struct UncoveredPiece {
  PieceForest::Id piece;
  enum class Why { kNoCentres, kCrossings, kTooDeep, kTooFine, kBudget, kMemory, kStopped } why;
  /// With kTooFine, why the larger piece of which it is a part had no box; nothing for a whole patch.
  std::optional<Why> above;
  /// Approximate, in the forest's coordinates: see Obstacle.
  double gap = 0, least_cosine = 1;
  /// The pieces between which the gap is; kNone without a gap.
  std::array<PieceForest::Id, 2> facing{PieceForest::kNone, PieceForest::kNone};
};

struct StarCover {
  std::vector<CoverBox> boxes;
  /// For a leaf of the cover the box that holds its hull, for all other nodes kNone. Every way down from a root passes
  /// exactly one leaf.
  std::vector<std::uint32_t> box_of_node;
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  std::vector<UncoveredPiece> uncovered;  ///< empty: every piece has its box
  std::size_t tried = 0, tested_pieces = 0, programs = 0;
  std::shared_ptr<MemoryShare> memory;  ///< what the forest's budget is charged for the boxes
  /// What a box takes here, while it is copied, and in a certificate's body and bytes.
  static constexpr std::size_t kBytesOfBox = 2 * sizeof(CoverBox) + 384;
  bool has_room_for_box() { return make_room(boxes, 1, *memory, kBytesOfBox); }
  bool is_complete() const { return uncovered.empty(); }
  /// Whether some box has several sheets, as beside thin walls.
  bool has_several_sheets() const {
    return std::any_of(boxes.begin(), boxes.end(),
                       [](const CoverBox& b) { return !b.is_mesh && !b.has_one_sheet(); });
  }
  /// Whether a certificate of it needs version 2.
  bool needs_version_2() const {
    return std::any_of(boxes.begin(), boxes.end(),
                       [](const CoverBox& b) { return b.framed != nullptr || b.needs_version_2; });
  }
};

/// Boxes are charged to the forest's budget, with what a certificate takes for them, before they are made.
/// Stops at the first piece that stays uncovered at the greatest level. Among sheets that face each other, the nearest
/// ones come first.
StarCover find_star_cover(PieceForest& forest, const StarCoverOptions& options);

}  // namespace veritope
