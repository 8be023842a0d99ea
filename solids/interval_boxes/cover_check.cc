// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>

#include "solids/interval_boxes/box_sets_internal.h"
#include "solids/interval_boxes/cover_check_internal.h"
#include "solids/base/box_hierarchy.h"

namespace veritope {
namespace {

// Whether `box` without boxes[from...] is empty up to parts of lower dimension.
bool is_covered_by(const Box3d& box, const std::vector<Box3d>& boxes, std::size_t from,
                   std::size_t dimension) {
  for (; from < boxes.size(); ++from) {
    const Box3d& b = boxes[from];
    bool overlaps = true;
    for (std::size_t k = 0; k < dimension; ++k)
      overlaps = overlaps && box.lo[k] < b.hi[k] && b.lo[k] < box.hi[k];
    if (!overlaps) continue;
    Box3d rest = box;  // what is left; each axis cuts off up to two parts
    for (std::size_t k = 0; k < dimension; ++k) {
      if (rest.lo[k] < b.lo[k]) {
        Box3d part = rest;
        part.hi[k] = b.lo[k];
        if (!is_covered_by(part, boxes, from + 1, dimension)) return false;
        rest.lo[k] = b.lo[k];
      }
      if (b.hi[k] < rest.hi[k]) {
        Box3d part = rest;
        part.lo[k] = b.hi[k];
        if (!is_covered_by(part, boxes, from + 1, dimension)) return false;
        rest.hi[k] = b.hi[k];
      }
    }
    return true;
  }
  return false;
}

}  // namespace

bool is_in_union(const Box3d& box, const std::vector<Box3d>& boxes, int dimension) {
  return is_covered_by(box, boxes, 0, static_cast<std::size_t>(dimension));
}

namespace internal {
namespace {

using Id = PieceForest::Id;

class CoverCheck {
 public:
  CoverCheck(BoundaryModel& model, const std::vector<Box3d>& boxes, const CoverOptions& options,
             bool wants_interiors)
      : forest_(model.forest()),
        dimension_(model.dimension()),
        boxes_(boxes),
        tree_(boxes),
        options_(options),
        wants_interiors_(wants_interiors),
        found_(options.max_listed) {}

  ConditionResult run() {
    for (std::uint32_t r = 0; r < forest_.num_roots() && !is_spent_; ++r) visit(forest_.root(r));
    return found_.finish();
  }

 private:
  static constexpr int kMaxLevel = 20;

  void visit(Id id) {
    if (is_spent_) return;
    const Box3d hull = forest_.node(id).hull;
    // Only what is near height 0 counts in a wall.
    if (dimension_ == 2 && (hull.hi[2] < 0 || hull.lo[2] > 0)) return;
    found_.count();
    std::vector<Box3d> near;
    tree_.visit([&](const Box3d& b) { return meets_in_plane(b, hull); },
                [&](std::uint32_t i) { near.push_back(boxes_[i]); });
    if (near.empty()) {
      found_.add({BoxOffence::Why::kUncovered, {}, hull, 0});
      return;
    }
    if (is_covered(hull, near)) return;
    if (++visits_ > options_.max_pieces) {
      found_.add({BoxOffence::Why::kUndecided, {}, hull, 0});
      is_spent_ = true;
      return;
    }
    if (wants_interiors_ && near.size() <= 16 && crosses_uncovered_plane(id, hull, near)) {
      found_.add({BoxOffence::Why::kUncovered, {}, hull, 0});
      return;
    }
    if (forest_.node(id).level >= kMaxLevel || !forest_.may_split(id)) {
      found_.add({BoxOffence::Why::kUndecided, {}, hull, 0});
      is_spent_ = ++stuck_ >= kMaxStuck;
      return;
    }
    const Id first = forest_.children(id);
    for (Id k = 0; k < 4; ++k) visit(first + k);
  }

  bool meets_in_plane(const Box3d& a, const Box3d& b) const {
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k)
      if (a.hi[k] < b.lo[k] || b.hi[k] < a.lo[k]) return false;
    return true;
  }

  bool is_covered(const Box3d& hull, const std::vector<Box3d>& near) const {
    if (!wants_interiors_) return is_in_union(hull, near, dimension_);
    return std::any_of(near.begin(), near.end(),
                       [&](const Box3d& b) { return is_in_interior(hull, b, dimension_); });
  }

  // A piece is connected: it meets every plane with points of it on both sides.
  bool crosses_uncovered_plane(Id id, const Box3d& hull, const std::vector<Box3d>& near) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k)
      for (const Box3d& b : near)
        for (const double at : {b.lo[k], b.hi[k]}) {
          if (!(hull.lo[k] < at && at < hull.hi[k])) continue;
          const bool is_open = std::none_of(near.begin(), near.end(), [&](const Box3d& c) {
            return interior_meets(c, hull, k, at);
          });
          if (is_open && reaches(id, k, at, true, 4) && reaches(id, k, at, false, 4)) return true;
        }
    return false;
  }
  // Whether the interior of c meets the part of the hull in the plane x_k = at.
  bool interior_meets(const Box3d& c, const Box3d& hull, std::size_t k, double at) const {
    for (std::size_t j = 0; j < static_cast<std::size_t>(dimension_); ++j) {
      const double lo = j == k ? at : hull.lo[j], hi = j == k ? at : hull.hi[j];
      if (!(lo < c.hi[j] && c.lo[j] < hi)) return false;
    }
    return true;
  }
  // Whether a part of the piece lies strictly on one side of x_k = at.
  bool reaches(Id id, std::size_t k, double at, bool above, int depth) {
    const Box3d hull = forest_.node(id).hull;
    if (above ? hull.lo[k] > at : hull.hi[k] < at) return true;
    if (above ? hull.hi[k] <= at : hull.lo[k] >= at) return false;
    if (depth == 0 || !forest_.may_split(id)) return false;
    const Id first = forest_.children(id);
    for (Id c = 0; c < 4; ++c)
      if (reaches(first + c, k, at, above, depth - 1)) return true;
    return false;
  }

  static constexpr int kMaxStuck = 8;  // one curve of contact has infinitely many pieces

  PieceForest& forest_;
  int dimension_;
  const std::vector<Box3d>& boxes_;
  BoxHierarchy tree_;
  const CoverOptions& options_;
  bool wants_interiors_;
  Findings found_;
  std::size_t visits_ = 0;
  int stuck_ = 0;
  bool is_spent_ = false;
};

}  // namespace

ConditionResult decide_b1(BoundaryModel& model, const std::vector<Box3d>& boxes,
                          const CoverOptions& options) {
  return CoverCheck(model, boxes, options, false).run();
}

ConditionResult decide_c1(BoundaryModel& model, const std::vector<Box3d>& boxes,
                          const CoverOptions& options) {
  return CoverCheck(model, boxes, options, true).run();
}

}  // namespace internal
}  // namespace veritope
