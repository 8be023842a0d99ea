// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/star_box/box_frame.h: boxes whose sides follow the surface: {x : l <= A x <= h} for a matrix A of integers.
// Theory: docs/THEORY.md §4b. A matrix serves hulls only; centres and normals stay in the forest's coordinates.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "solids/pieces/piece_forest.h"

namespace veritope {

/// A regular matrix of integers below 2^31 in absolute value. "In the frame" means: multiplied by it.
class BoxFrame {
 public:
  using Rows = std::array<std::array<std::int64_t, 3>, 3>;
  static constexpr std::int64_t kEntryLimit = std::int64_t{1} << 31;

  /// The unit matrix.
  BoxFrame();
  /// Nothing if an entry is too large or the determinant is 0; decided exactly.
  static std::optional<BoxFrame> make(const Rows& rows);

  const Rows& rows() const { return rows_; }
  bool is_plain() const;
  friend bool operator==(const BoxFrame& a, const BoxFrame& b) { return a.rows_ == b.rows_; }

  /// Contains A x for the exact x; for all x in the box.
  Box3d in_frame(const Point3d& x) const;
  Box3d in_frame(const Box3d& x) const;
  /// Contains all x for which A x lies in the box.
  Box3d around(const Box3d& in_frame) const;
  /// Approximate, for searches: A^-1 y.
  Point3d approx_back(const Point3d& in_frame) const;

 private:
  Rows rows_;
  std::array<std::array<double, 3>, 3> back_;  // the inverse, approximately
};

/// Contains A P for all exact control points P of the node; unbounded where a weight is not surely positive.
Box3d hull_in_frame(PieceForest& forest, PieceForest::Id id, const BoxFrame& frame);
/// The hull of hull_in_frame, or nothing if it misses `box`: fast where the node is far from it.
std::optional<Box3d> hull_that_meets(PieceForest& forest, PieceForest::Id id, const BoxFrame& frame,
                                     const Box3d& box);

/// Returns what hull_in_frame and hull_that_meets return, and remembers hulls in the latest frame: for searches that
/// come back to a piece.
class FrameHulls {
 public:
  explicit FrameHulls(PieceForest& forest) : forest_(forest), known_(kSlots) {}

  void use(const BoxFrame& frame);
  Box3d of(PieceForest::Id id);
  std::optional<Box3d> that_meets(PieceForest::Id id, const Box3d& box);

 private:
  static constexpr std::size_t kSlots = 1024;
  struct Known {
    PieceForest::Id id = PieceForest::kNone;
    bool has_hull = false;
    Box3d around, hull;  // the box around the node's hull, in the frame; the hull in the frame
  };
  Known& slot_of(PieceForest::Id id);

  PieceForest& forest_;
  BoxFrame frame_;
  std::uint64_t drops_ = 0;  // of the forest, when the frame was taken into use
  std::vector<Known> known_;
};

}  // namespace veritope
