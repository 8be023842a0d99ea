// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/frame_choice.h: frames for boxes around pieces, few distinct ones: searched in floating point; what
// lies in a box is proved elsewhere. Theory: docs/THEORY.md §4b.
#pragma once
#include <optional>
#include <vector>

#include "solids/star_box/box_frame.h"

namespace veritope {

/// A frame, and the hull of the piece in it.
struct PieceFrame {
  BoxFrame frame;
  Box3d hull;
};

class FrameChoice {
 public:
  using Id = PieceForest::Id;
  /// Rows of frames have about this length: directions are right to 2^-25.
  static constexpr double kRowLength = 0x1p24;

  explicit FrameChoice(PieceForest& forest) : forest_(forest) {}

  /// Rows along the piece's longer side, across it, and along its normal; a frame that another piece had if this one
  /// is not much thicker in it, so that planes and cylinders share theirs. Nothing if the piece has no normal.
  std::optional<PieceFrame> along(Id piece);

  /// For a piece beside a crease: rows along the crease and along the normals of the faces that meet there, so that
  /// pieces of both are thin in it, whatever the angle between them. Nothing if the normals of the pieces around it
  /// show no crease, or one at a right angle, which `plain`, the frame along the piece, serves as well.
  std::optional<PieceFrame> at_crease(Id piece, const std::vector<Id>& around,
                                      const BoxFrame& plain);

 private:
  std::optional<BoxFrame> own(Id piece);
  std::optional<PieceFrame> with_hull(Id piece, const BoxFrame& frame);
  void keep(const BoxFrame& frame);

  PieceForest& forest_;
  std::vector<BoxFrame> frames_;  // those used last, the last one at the end
};

}  // namespace veritope
