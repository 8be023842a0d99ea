// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_table_internal.h: the frames of one tetrahedron's knots, and which of their tetrahedra contain a point.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <unordered_map>

#include "predicates/entry_path.h"
#include "splines/dms_spline.h"

namespace veritope::internal {

/// The frames of all quadruples that were asked for; they do not depend on the point.
class DmsTable {
 public:
  /// knots.number[m][i] is a place of `points`; those of a corner are less than those of the next.
  DmsTable(const DmsKnots& knots, std::array<const ExactPoint3*, 4 * (kMaxDmsDegree + 1)> points)
      : knots_(knots), points_(points) {}

  const DmsKnots& knots() const { return knots_; }
  /// The first four affinely independent knots of the set in ascending order; null if there are none.
  const SimplexFrame<Rational>* frame(const KnotSet& set);
  std::size_t num_frames() const { return frames_.size(); }
  std::array<const ExactPoint3*, 4> corners(const SimplexFrame<Rational>& frame) const {
    return {points_[frame.knots[0]], points_[frame.knots[1]], points_[frame.knots[2]],
            points_[frame.knots[3]]};
  }

 private:
  const SimplexFrame<Rational>* frame_of(const std::array<KnotNumber, 4>& four);

  DmsKnots knots_;
  std::array<const ExactPoint3*, 4 * (kMaxDmsDegree + 1)> points_;
  std::unordered_map<std::uint32_t, std::optional<SimplexFrame<Rational>>> frames_;
};

/// The answers about one point, for SimplexSplines.
class DmsAnswers {
 public:
  DmsAnswers(DmsTable& table, const EntryPath& path) : table_(table), path_(path) {}

  const SimplexFrame<Rational>* frame(const KnotSet& set) { return table_.frame(set); }
  bool contains(const SimplexFrame<Rational>& frame) const {
    return is_entered(table_.corners(frame), path_);
  }

 private:
  DmsTable& table_;
  const EntryPath& path_;
};

}  // namespace veritope::internal
