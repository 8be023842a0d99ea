// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/interval_boxes/box_trace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "solids/interval_boxes/box_sets_internal.h"
#include "solids/pieces/piece_descent.h"
#include "solids/star_box/place_centres.h"

namespace veritope {
namespace {

using Ids = std::vector<PieceForest::Id>;

bool is_in(const Box3d& a, const Box3d& b, int dimension) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
    if (a.lo[k] < b.lo[k] || b.hi[k] < a.hi[k]) return false;
  return true;
}

// Looks for evidence that V may meet the box: a hull inside the box, a piece that crosses it (a rectangle), a piece at
// the deepest level, or the end of the budget. The search is depth first: where V enters an edge or a corner, it
// reaches the deepest level at once.
struct Doubt {
  PieceForest& forest;
  const Box3d& box;
  std::size_t left;
  std::optional<std::size_t> normal;  // the axis normal to a rectangle

  Doubt(PieceForest& all, const Box3d& b, std::size_t visits) : forest(all), box(b), left(visits) {
    std::size_t flat = 0;
    for (std::size_t k = 0; k < 3; ++k)
      if (box.lo[k] == box.hi[k]) ++flat, normal = k;
    if (flat != 1) normal.reset();
  }

  // The whole piece projects into the rectangle and has corners on both sides (approximately: this only raises a doubt,
  // it proves nothing).
  bool crosses(PieceForest::Id id, const Box3d& hull) const {
    const std::size_t k = *normal;
    Box3d over = hull;
    over.lo[k] = over.hi[k] = box.lo[k];
    if (!is_inside(over, box)) return false;
    const PieceForest::Form& form = forest.form(forest.node(id).patch);
    const Patch& shape = forest.complex().patch(forest.node(id).patch);
    const std::size_t count = form.shape.count();
    const double* const net = forest.control(id);
    bool is_below = false, is_above = false;
    for (std::uint32_t s = 0; s < shape.num_sides(); ++s) {
      const std::size_t corner = shape.side_index(s, 0);
      const double w = form.is_rational ? net[3 * count + corner] : 1;
      const double height = net[k * count + corner] - w * (box.lo[k] - form.origin[k]);
      (height < 0 ? is_below : is_above) = true;
    }
    return is_below && is_above;
  }

  bool visit(PieceForest::Id id) {
    const Box3d hull = forest.node(id).hull;
    if (!meets(hull, box)) return false;
    if (left == 0 || is_in(hull, box, 3) || !forest.may_split(id)) return true;
    --left;
    if (normal && crosses(id, hull)) return true;
    const PieceForest::Id first = forest.children(id);
    std::array<std::pair<double, PieceForest::Id>, 4> order;
    const Point3d middle = approx_centre(box);
    for (PieceForest::Id k = 0; k < 4; ++k) {
      const Point3d c = approx_centre(forest.node(first + k).hull);
      double d = 0;
      for (std::size_t a = 0; a < 3; ++a) d = std::max(d, std::abs(c[a] - middle[a]));
      order[k] = {d, first + k};
    }
    std::sort(order.begin(), order.end());
    for (const auto& [distance, child] : order)
      if (visit(child)) return true;
    return false;
  }
};

class Tracer {
 public:
  Tracer(BoundaryModel& model, const TraceOptions& options)
      : model_(model), forest_(model.forest()), options_(options) {}

  // Other places for cuts, for use where a cut may be almost tangent to V.
  BoxTrace run(const Box3d& box) {
    BoxTrace out;
    std::size_t cells = 0;
    for (const double shift : {0.0, 0x1.9p-5, -0x1.3p-4}) {
      cut_shift_ = shift;
      left_ = options_.max_cells;
      out = run_once(box);
      out.cells = cells += options_.max_cells - left_;
      if (out.kind != BoxTrace::Kind::kUndecided) break;
    }
    return out;
  }

 private:
  BoxTrace run_once(const Box3d& box) {
    std::vector<Box3d> disks;
    BoxTrace out = cut(box, 0, &disks);
    if (out.kind == BoxTrace::Kind::kSurface) out.is_connected = hang_together(disks);
    return out;
  }
  static BoxTrace missed() { return {BoxTrace::Kind::kMissed, 0, false, {}, 0}; }
  static BoxTrace disk() { return {BoxTrace::Kind::kSurface, 1, true, {}, 0}; }
  static BoxTrace undecided(const Box3d& place) {
    return {BoxTrace::Kind::kUndecided, 0, false, place, 0};
  }

  // disks: unless null, collects the boxes that are decided as one and that V meets.
  BoxTrace cut(const Box3d& box, int splits, std::vector<Box3d>* disks) {
    if (left_ == 0) return undecided(box);
    --left_;
    if (const auto whole = decide(box)) {
      if (disks != nullptr && !whole->is_missed()) disks->push_back(box);
      return *whole;
    }
    const std::size_t axis = longest_axis(box);
    if (splits == options_.max_splits) return undecided(box);
    // Cuts avoid the middle: symmetric models have their poles and tangencies there.
    const double length = box.hi[axis] - box.lo[axis];
    const double at =
        box.lo[axis] + length * ((splits % 2 == 0 ? 0x1.0ap-1 : 0x1.f1p-2) + cut_shift_);
    Box3d low = box, high = box, slab = box;
    low.hi[axis] = slab.hi[axis] = at + length * 0x1.1p-4;
    high.lo[axis] = slab.lo[axis] = at - length * 0x1.1p-4;
    if (!(box.lo[axis] < slab.lo[axis] && slab.lo[axis] < slab.hi[axis] &&
          slab.hi[axis] < box.hi[axis]))
      return undecided(box);
    const BoxTrace a = cut(low, splits + 1, disks);
    if (a.kind == BoxTrace::Kind::kUndecided) return a;
    const BoxTrace b = cut(high, splits + 1, disks);
    if (b.kind == BoxTrace::Kind::kUndecided) return b;
    if (a.is_missed()) return b;
    if (b.is_missed()) return a;
    const BoxTrace c = cut(slab, splits + 1, nullptr);
    if (c.kind == BoxTrace::Kind::kUndecided) return c;
    return {BoxTrace::Kind::kSurface, a.euler + b.euler - c.euler, false, {}, 0};
  }

  std::size_t longest_axis(const Box3d& box) const {
    std::size_t axis = 0;
    for (std::size_t k = 1; k < static_cast<std::size_t>(model_.dimension()); ++k)
      if (box.hi[axis] - box.lo[axis] < box.hi[k] - box.lo[k]) axis = k;
    return axis;
  }

  // Tries to decide the box as one: missed, a disk, or unknown.
  std::optional<BoxTrace> decide(const Box3d& box) {
    // Condition T of THEORY 4: pieces that are no longer than half of the box (of a wall: in the plane).
    Ids tested;
    const double longest = 0.5 * size_of(box, model_.dimension());
    if (!descend_to(forest_, box, 16 * options_.max_pieces, [&](PieceForest::Id id) {
          if (size_of(forest_.node(id).hull, model_.dimension()) > longest)
            return PieceStep::kSplit;
          tested.push_back(id);
          return tested.size() <= options_.max_pieces ? PieceStep::kTaken : PieceStep::kStop;
        }))
      return std::nullopt;
    if (tested.empty()) return missed();
    if (const auto answer = by_monotone_axes(box, tested)) return answer;
    return by_star(box, tested);
  }

  // Tries the signs that are already known first: small pieces inherit those of a larger one, and the determinants'
  // nets are most of the cost.
  std::optional<BoxTrace> by_monotone_axes(const Box3d& box, const Ids& tested) {
    const auto known =
        common_signs(tested, [&](PieceForest::Id id) { return model_.known_normal_signs(id); });
    if (const auto answer = by_monotone_axes(box, tested, known, {})) return answer;
    const auto all =
        common_signs(tested, [&](PieceForest::Id id) { return model_.normal_signs(id); });
    return by_monotone_axes(box, tested, all, known);
  }
  template <typename Signs>
  static std::array<int, 3> common_signs(const Ids& tested, Signs signs_of) {
    std::array<int, 3> signs = signs_of(tested.front());
    for (const PieceForest::Id id : tested) {
      const auto s = signs_of(id);
      for (std::size_t k = 0; k < 3; ++k)
        if (s[k] != signs[k]) signs[k] = 0;
    }
    return signs;
  }
  // A set of axes on which no entry of `tried` is 0 has been tried.
  std::optional<BoxTrace> by_monotone_axes(const Box3d& box, const Ids& tested,
                                           const std::array<int, 3>& signs,
                                           const std::array<int, 3>& tried) {
    // More axes make L and H smaller.
    for (const unsigned axes : {7u, 3u, 5u, 6u, 1u, 2u, 4u}) {
      Box3d low = box, high = box;
      bool fits = true, is_new = false;
      for (std::size_t k = 0; k < 3; ++k) {
        if ((axes >> k & 1) == 0) continue;
        fits = fits && signs[k] != 0;
        is_new = is_new || tried[k] == 0;
        const double bottom = signs[k] > 0 ? box.lo[k] : box.hi[k];
        const double top = signs[k] > 0 ? box.hi[k] : box.lo[k];
        low.lo[k] = low.hi[k] = bottom, high.lo[k] = high.hi[k] = top;
      }
      if (!fits || !is_new || !is_missed(forest_, low) || !is_missed(forest_, high)) continue;
      const auto crossings =
          crossing_number(forest_, tested, {box, approx_centre(low), approx_centre(high)});
      if (!crossings) continue;
      // All crossings of the line have one sign, so at most this many lie between L and H. If none does, V misses the
      // box: a V that met it would cross the line there.
      if (*crossings == 0) return missed();
      if (*crossings == 1 && is_met(model_, box)) return disk();
    }
    return std::nullopt;
  }

  std::optional<BoxTrace> by_star(const Box3d& box, const Ids& tested) {
    Point3d direction = mean_normal(forest_, tested, NormalWeight::kEqual);
    for (std::size_t k = 0; k < 3; ++k) direction[k] /= box.hi[k] - box.lo[k];
    StarBox star{box, {}, {}};
    for (const double part : {0.5, 0.9})
      if (place_centres(direction, part, &star) && are_centres(forest_, tested, star) &&
          crossing_number(forest_, tested, star) == 1)
        return disk();
    return std::nullopt;
  }

  // The boxes as nodes, joined where a part of V lies in both.
  bool hang_together(const std::vector<Box3d>& disks) {
    std::vector<std::size_t> root(disks.size());
    std::iota(root.begin(), root.end(), std::size_t{0});
    const auto find = [&](std::size_t i) {
      while (root[i] != i) i = root[i] = root[root[i]];
      return i;
    };
    std::size_t components = disks.size();
    for (std::size_t i = 0; i < disks.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        if (!meets(disks[i], disks[j]) || find(i) == find(j)) continue;
        if (!is_met(model_, common_part(disks[i], disks[j]))) continue;
        root[find(i)] = find(j);
        --components;
      }
    return components == 1;
  }

  BoundaryModel& model_;
  PieceForest& forest_;
  const TraceOptions& options_;
  std::size_t left_ = 0;
  double cut_shift_ = 0;
};

}  // namespace

BoxTrace trace(BoundaryModel& model, const Box3d& forest_box, const TraceOptions& options) {
  model.forest().limit_memory(options.memory);
  return Tracer(model, options).run(forest_box);
}

bool is_missed(PieceForest& forest, const Box3d& box, std::size_t max_visits) {
  Doubt doubt(forest, box, max_visits);
  bool found = false;
  forest.roots().visit([&](const Box3d& b) { return !found && meets(b, box); },
                       [&](std::uint32_t n) { found = found || doubt.visit(forest.root(n)); });
  return !found;
}

namespace {

// A piece that may contain a piece inside the box. A piece is split the sooner, the nearer its hull is to the middle of
// the box in units of the box's sides; smaller pieces come first. A piece that only touches a side comes last, since no
// part of it lies in the box.
struct Candidate {
  double distance, size;
  PieceForest::Id id;
  friend bool operator<(const Candidate& a, const Candidate& b) {
    return a.distance != b.distance ? a.distance > b.distance : a.size > b.size;
  }
};

// V lies in a side, or so near a side that smaller parts are no more likely to lie in the box.
bool is_flat_in_a_side(const Box3d& hull, const Box3d& box, int dimension) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
    if ((hull.lo[k] < box.lo[k] || box.hi[k] < hull.hi[k]) &&
        hull.hi[k] - hull.lo[k] <= 0x1p-30 * (box.hi[k] - box.lo[k]))
      return true;
  return false;
}

Candidate candidate(const Box3d& hull, const Box3d& box, int dimension, PieceForest::Id id) {
  Candidate out{0, size_of(hull, dimension), id};
  const Point3d middle = approx_centre(box);
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
    const double gap = std::max(hull.lo[k] - middle[k], middle[k] - hull.hi[k]);
    out.distance = std::max(out.distance, gap / (box.hi[k] - box.lo[k]));
  }
  return out;
}

}  // namespace

bool is_met(BoundaryModel& model, const Box3d& box, std::size_t max_visits) {
  PieceForest& forest = model.forest();
  const int dimension = model.dimension();
  if (!is_solid(box, dimension)) return false;  // hulls have an interior
  std::priority_queue<Candidate> queue;
  bool found = false;
  const auto look_at = [&](PieceForest::Id id) {
    const Box3d& hull = forest.node(id).hull;
    if (!meets(hull, box) || is_flat_in_a_side(hull, box, dimension)) return;
    found = found || is_in(hull, box, dimension);
    queue.push(candidate(hull, box, dimension, id));
  };
  forest.roots().visit([&](const Box3d& b) { return meets(b, box); },
                       [&](std::uint32_t n) { look_at(forest.root(n)); });
  while (!found && !queue.empty()) {
    const PieceForest::Id id = queue.top().id;
    queue.pop();
    if (max_visits-- == 0) return false;
    if (!forest.may_split(id)) continue;
    const PieceForest::Id first = forest.children(id);
    for (PieceForest::Id k = 0; k < 4; ++k) look_at(first + k);
  }
  return found;
}

}  // namespace veritope
