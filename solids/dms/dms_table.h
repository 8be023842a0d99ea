// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_table.h: the frames of one tetrahedron's knots, and which of their tetrahedra contain a point.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "predicates/entry_path.h"
#include "solids/dms/dms_model.h"
#include "splines/dms_spline.h"

namespace veritope::internal {

/// Knot i of corner m has the number m kKnotsOfCorner + i, or that of an equal knot before it in the cloud.
inline constexpr std::size_t kKnotsOfCorner = kMaxDmsDegree + 1;

/// The first four knots of the set that is_independent(four) accepts, or nothing. First come the last knots of the
/// corners, then the last but one of each, and so on: what the recurrence leaves of V_γ are then the V of lesser γ,
/// which the other γ share, and few sets that lack a corner.
template <typename IsIndependent>
std::optional<std::array<KnotNumber, 4>> four_independent(const KnotSet& set,
                                                          IsIndependent is_independent) {
  std::array<KnotNumber, KnotSet::kMaxSize> order{};
  std::size_t count = 0;
  for (std::size_t depth = 0, found = 1; found > 0; ++depth) {
    found = 0;
    for (std::size_t end = set.size(); end > 0;) {
      const std::size_t corner = set[end - 1] / kKnotsOfCorner;
      std::size_t seen = 0;
      for (std::size_t i = end; i > 0 && set[i - 1] / kKnotsOfCorner == corner; end = --i) {
        const bool is_repeated = i < set.size() && set[i] == set[i - 1];
        if (!is_repeated && seen++ == depth) order[count++] = set[i - 1], ++found;
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      for (std::size_t k = j + 1; k < count; ++k)
        for (std::size_t l = k + 1; l < count; ++l) {
          std::array<KnotNumber, 4> four{order[i], order[j], order[k], order[l]};
          std::sort(four.begin(), four.end());
          if (is_independent(four)) return four;
        }
  return std::nullopt;
}

/// What frame_of makes of these four knots; null if it makes null of all quadruples.
template <typename FrameOf>
auto choose_frame(const KnotSet& set, FrameOf frame_of)
    -> decltype(frame_of(std::array<KnotNumber, 4>{})) {
  decltype(frame_of(std::array<KnotNumber, 4>{})) found = nullptr;
  four_independent(set, [&](const auto& four) {
    found = frame_of(four);
    return found != nullptr;
  });
  return found;
}

/// The numbers of the knots of a tetrahedron.
DmsKnots dms_knots(const DmsModel& model, std::uint32_t tetrahedron);

/// The frames of all quadruples that were asked for; they do not depend on the point.
class DmsTable {
 public:
  /// knots.number[m][i] is a place of `points`.
  DmsTable(const DmsKnots& knots, std::array<const ExactPoint3*, 4 * kKnotsOfCorner> points)
      : knots_(knots), points_(points) {}

  const DmsKnots& knots() const { return knots_; }
  /// Four affinely independent knots of the set, as choose_frame takes them; null if the set has no such four.
  const SimplexFrame<Rational>* frame(const KnotSet& set);
  std::size_t num_frames() const { return frames_.size(); }
  /// REQUIRES a number of the tetrahedron's knots.
  const ExactPoint3& point(KnotNumber number) const { return *points_[number]; }
  std::array<const ExactPoint3*, 4> corners(const SimplexFrame<Rational>& frame) const {
    return {points_[frame.knots[0]], points_[frame.knots[1]], points_[frame.knots[2]],
            points_[frame.knots[3]]};
  }

 private:
  const SimplexFrame<Rational>* frame_of(const std::array<KnotNumber, 4>& four);

  DmsKnots knots_;
  std::array<const ExactPoint3*, 4 * kKnotsOfCorner> points_;
  std::unordered_map<std::uint32_t, std::optional<SimplexFrame<Rational>>> frames_;
  std::unordered_map<KnotSet, const SimplexFrame<Rational>*, KnotSetHash> chosen_;
};

/// The table of a tetrahedron. first_knot[v] is the place of t_0 of vertex v among the knots, which must outlive it.
DmsTable make_dms_table(const DmsModel& model, std::uint32_t tetrahedron,
                        const std::vector<ExactPoint3>& knots,
                        const std::vector<std::size_t>& first_knot);

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
