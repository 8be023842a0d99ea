// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/frame_proposals.h: frames for boxes around pieces, few distinct ones: searched in floating point; what
// lies in a box is proved elsewhere. Lengths and angles are those of a ShapeMetric. Theory: docs/THEORY.md §4b.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "solids/star_box/box_frame.h"
#include "verify/certify/shape_metric.h"

namespace veritope {

/// A frame, and what a search needs to measure lengths in it.
struct SearchFrame {
  BoxFrame frame;
  std::array<Point3d, 3> rows;  ///< the frame's, scaled to length 1, of images under the metric
  Point3d unit;                 ///< what a length of 1 along each row is in the frame

  Box3d in_lengths(const Box3d& in_frame) const;
  Box3d in_frame(const Box3d& in_lengths) const;
};
/// A frame, and the hull of the piece in it, in lengths.
struct PieceFrame : SearchFrame {
  Box3d hull;
};

class FrameProposals {
 public:
  using Id = PieceForest::Id;
  /// Rows of frames have about this length: directions are right to 2^-27, and entries take four bytes in a
  /// certificate.
  static constexpr double kRowLength = 0x1p26;

  FrameProposals(PieceForest& forest, const ShapeMetric& metric)
      : forest_(forest), metric_(metric) {}

  const ShapeMetric& metric() const { return metric_; }

  /// Rows along the piece's longer side, across it, and along its normal; a frame that another piece had if this one
  /// is not much thicker in it, so that planes and cylinders share theirs. Nothing if the piece has no normal.
  std::optional<PieceFrame> along(Id piece);

  /// The unit normal of the piece around `piece` whose normal differs most from that piece's, of images under the
  /// metric; nothing if none differs by 30 degrees or more, as beside a crease.
  std::optional<Point3d> normal_across_crease(Id piece, const std::vector<Id>& around);

  /// Rows along the crease and along the normals of the faces that meet there, so that pieces of both are thin in it,
  /// whatever the angle between them. Nothing if that angle is right: `plain`, the frame along the piece, is thin then.
  std::optional<PieceFrame> along_crease(Id piece, const Point3d& other_normal,
                                         const PieceFrame& plain);

 private:
  std::optional<Point3d> unit_normal(Id piece);
  std::optional<SearchFrame> with_rows(const std::array<Point3d, 3>& rows) const;
  std::optional<SearchFrame> own(Id piece);
  std::optional<PieceFrame> with_hull(Id piece, const SearchFrame& frame);
  void keep(const SearchFrame& frame);

  PieceForest& forest_;
  ShapeMetric metric_;
  std::vector<SearchFrame> frames_;  // those used last, the last one at the end
};

}  // namespace veritope
