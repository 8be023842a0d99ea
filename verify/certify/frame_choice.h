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

  /// The unit normal of the piece around `piece` whose normal differs most from that piece's; nothing if none differs
  /// by 30 degrees or more, as beside a crease.
  std::optional<Point3d> normal_across_crease(Id piece, const std::vector<Id>& around);

  /// Rows along the crease and along the normals of the faces that meet there, so that pieces of both are thin in it,
  /// whatever the angle between them. Nothing if that angle is right: `plain`, the frame along the piece, is thin then.
  std::optional<PieceFrame> along_crease(Id piece, const Point3d& other_normal,
                                         const BoxFrame& plain);

 private:
  std::optional<BoxFrame> own(Id piece);
  std::optional<PieceFrame> with_hull(Id piece, const BoxFrame& frame);
  void keep(const BoxFrame& frame);

  PieceForest& forest_;
  std::vector<BoxFrame> frames_;  // those used last, the last one at the end
};

}  // namespace veritope
