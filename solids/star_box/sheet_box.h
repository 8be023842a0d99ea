// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/star_box/sheet_box.h: the conditions of a star box in a frame, with one sheet or several. Theory:
// docs/THEORY.md §4b. With the unit matrix and one sheet it is a star box of §4.
#pragma once
#include <vector>

#include "solids/star_box/box_frame.h"
#include "solids/star_box/sheet_separator.h"

namespace veritope {

struct Sheet {
  Point3d inside, outside;  ///< c-, c+
  /// For each separator of the box the side on which the sheet lies; kZero: the separator says nothing about it.
  std::vector<Sign> signs;
};

/// Whether the sheets lie on different sides of a separator. REQUIRES as many signs of both.
bool are_apart(const Sheet& a, const Sheet& b);

struct SheetBox {
  BoxFrame frame;
  Box3d box;  ///< in the frame
  std::vector<Sheet> sheets;
  /// For any two sheets one of them has opposite signs.
  std::vector<SheetSeparator> separators;
};

/// Which pieces a sheet box tests, and which it covers.
struct SheetPieces {
  std::vector<std::vector<PieceForest::Id>> tested;  ///< sheet by sheet
  std::vector<PieceForest::Id>
      held;  ///< visited pieces whose hulls lie in the box, parents before their children
  std::size_t num_visited = 0;  ///< how many pieces the descent looked at
};

/// T: descends to the pieces that meet the box and belong to one of its sheets (S1 for its centres, S3 for its
/// separators). Returns false if more than `most` pieces are needed, the descent visits 16 times as many, or a piece of
/// the greatest level belongs to none.
bool find_sheet_pieces(PieceForest& forest, const SheetBox& box, std::size_t most,
                       SheetPieces* pieces);

/// Whether all of T, S1, S2, S3 of §4b hold, the centres lie in the interior and the signs keep any two sheets apart.
bool is_sheet_box(PieceForest& forest, const SheetBox& box, std::size_t most, SheetPieces* pieces);

}  // namespace veritope
