// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_table.h: the frames of one tetrahedron's knots, and which of their tetrahedra contain a point.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <unordered_map>

#include "predicates/entry_path.h"
#include "splines/dms_spline.h"

namespace veritope::internal {

/// Knot i of corner m has the number m kKnotsOfCorner + i, or that of an equal knot before it in the cloud.
inline constexpr std::size_t kKnotsOfCorner = kMaxDmsDegree + 1;

/// The frames of all quadruples that were asked for; they do not depend on the point.
class DmsTable {
 public:
  /// knots.number[m][i] is a place of `points`.
  DmsTable(const DmsKnots& knots, std::array<const ExactPoint3*, 4 * kKnotsOfCorner> points)
      : knots_(knots), points_(points) {}

  const DmsKnots& knots() const { return knots_; }
  /// REQUIRES the number of a knot.
  const ExactPoint3& point(KnotNumber knot) const { return *points_[knot]; }
  /// Four affinely independent knots of the set; null if the set has no such four. If the last knots of the four
  /// corners are independent they are chosen: what the recurrence leaves of V_γ are then the V of lesser γ, which the
  /// other γ share, and few sets that lack a corner.
  const SimplexFrame<Rational>* frame(const KnotSet& set);
  std::size_t num_frames() const { return frames_.size(); }
  std::array<const ExactPoint3*, 4> corners(const SimplexFrame<Rational>& frame) const {
    return {points_[frame.knots[0]], points_[frame.knots[1]], points_[frame.knots[2]],
            points_[frame.knots[3]]};
  }

 private:
  const SimplexFrame<Rational>* frame_of(const std::array<KnotNumber, 4>& four);
  const SimplexFrame<Rational>* find_frame(const KnotSet& set);

  DmsKnots knots_;
  std::array<const ExactPoint3*, 4 * kKnotsOfCorner> points_;
  std::unordered_map<std::uint32_t, std::optional<SimplexFrame<Rational>>> frames_;
  std::unordered_map<KnotSet, const SimplexFrame<Rational>*, KnotSetHash> chosen_;
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
