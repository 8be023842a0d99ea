// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/star_cover.h"

#include <algorithm>
#include <cmath>

#include "robust/base/fp_guard.h"
#include "verify/certify/centre_search.h"

namespace veritope {
namespace {

using Id = PieceForest::Id;
using Why = UncoveredPiece::Why;

// Boxes and centres are multiples of their box's size divided by about this.
constexpr double kGrid = 64;
constexpr std::size_t kMostPieces = 4096;

class CoverSearch {
 public:
  CoverSearch(PieceForest& forest, const StarCoverOptions& options)
      : forest_(forest), options_(options) {}

  StarCover run() {
    const auto& order = forest_.roots().order();
    for (std::size_t k = 0; k < order.size() && out_.uncovered.empty(); ++k)
      cover(forest_.root(order[k]));
    out_.box_of_node.resize(forest_.num_nodes(), StarCover::kNone);
    if (out_.is_complete()) keep_leaves();
    return std::move(out_);
  }

 private:
  std::uint32_t& box_of(Id id) {
    if (out_.box_of_node.size() <= id)
      out_.box_of_node.resize(std::max<std::size_t>(id + 1, forest_.num_nodes()), StarCover::kNone);
    return out_.box_of_node[id];
  }

  void cover(Id id) {
    forest_.limit_memory(options_.memory);
    if (box_of(id) != StarCover::kNone || try_box(id)) return;
    if (forest_.node(id).level >= options_.max_level || out_.tried >= options_.max_boxes) {
      out_.uncovered.push_back(
          {id, out_.tried >= options_.max_boxes ? Why::kBudget : last_failure_});
      return;
    }
    if (options_.stops_at && options_.stops_at(id, out_.tried)) {
      out_.uncovered.push_back({id, Why::kStopped});
      return;
    }
    const Id first = forest_.children(id);
    for (Id k = 0; k < 4 && out_.uncovered.empty(); ++k) cover(first + k);
  }

  // Boxes are numbered anew, in the order of the leaves; those that cover only parts of other leaves go.
  void keep_leaves() {
    std::vector<std::uint32_t> leaf_box(forest_.num_nodes(), StarCover::kNone),
        number(out_.boxes.size(), StarCover::kNone);
    std::vector<CoverBox> boxes;
    const auto visit = [&](auto& self, Id id) -> void {
      const std::uint32_t box = out_.box_of_node[id];
      if (box == StarCover::kNone) {
        for (Id k = 0; k < 4; ++k) self(self, forest_.node(id).first_child + k);
        return;
      }
      if (number[box] == StarCover::kNone) {
        number[box] = static_cast<std::uint32_t>(boxes.size());
        boxes.push_back(out_.boxes[box]);
      }
      leaf_box[id] = number[box];
    };
    for (std::uint32_t r = 0; r < forest_.num_roots(); ++r) visit(visit, forest_.root(r));
    out_.boxes = std::move(boxes);
    out_.box_of_node = std::move(leaf_box);
  }

  // A cube around the hull, on a grid of a power of two.
  CoverBox box_around(const Box3d& hull) const {
    const double half = 0.5 * options_.growth * extent(hull);
    const double unit = std::exp2(std::ceil(std::log2(2 * half / kGrid)));
    const Point3d m = approx_centre(hull);
    CoverBox out;
    out.unit = unit;
    for (std::size_t k = 0; k < 3; ++k) {
      out.star.box.lo[k] = std::floor((m[k] - half) / unit) * unit;
      out.star.box.hi[k] = std::ceil((m[k] + half) / unit) * unit;
    }
    return out;
  }

  bool try_box(Id id) {
    const Box3d hull = forest_.node(id).hull;
    ++out_.tried;
    // Coordinates are at most 1; a hull is longer where weights are not known to be positive.
    if (!(extent(hull) > 0) || !(extent(hull) < 8)) return fail(Why::kNoCentres);
    CoverBox cover = box_around(hull);
    if (!is_promising(id, cover)) return fail(Why::kNoCentres);
    tested_.clear(), held_.clear();
    if (!find_pieces(forest_, cover.star.box, 0.5 * extent(cover.star.box), kMostPieces, &tested_,
                     &held_))
      return fail(Why::kTooDeep);
    out_.tested_pieces += tested_.size();
    const bool has_centres =
        (place_centres(&cover) && has_star_signs(forest_, tested_, cover.star)) ||
        search_centres(&cover);
    if (!has_centres) return fail(Why::kNoCentres);
    const auto crossings = crossing_number(forest_, tested_, cover.star);
    if (crossings != 1) return fail(Why::kCrossings);
    accept(cover);
    return true;
  }
  bool fail(Why why) {
    last_failure_ = why;
    return false;
  }
  void accept(const CoverBox& cover) {
    const auto number = static_cast<std::uint32_t>(out_.boxes.size());
    out_.boxes.push_back(cover);
    for (const Id id : held_)
      if (box_of(id) == StarCover::kNone) box_of(id) = number;
  }

  // Whether the piece alone has centres: about.
  bool is_promising(Id id, const CoverBox& cover) {
    tested_.assign(1, id);
    CoverBox copy = cover;
    return (place_centres(&copy) && has_star_signs(forest_, tested_, copy.star)) ||
           search_centres(&copy);
  }

  // The mean normal of the tested pieces, not of unit length.
  Point3d mean_normal() {
    Point3d sum{};
    for (const Id id : tested_) {
      const std::size_t n = forest_.form(forest_.node(id).patch).determinant.count();
      const double* const g = forest_.approx_determinants(id);
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < n; ++i) sum[k] -= g[(k + 1) * n + i];
    }
    return sum;
  }

  static double on_grid(double v, double unit) { return std::nearbyint(v / unit) * unit; }

  // On the line through the box's middle along the mean normal.
  bool place_centres(CoverBox* cover) {
    const Point3d n = mean_normal();
    double largest = 0;
    for (const double c : n) largest = std::max(largest, std::abs(c));
    if (!(largest > 0) || !std::isfinite(largest)) return false;
    const Box3d& box = cover->star.box;
    const Point3d m = approx_centre(box);
    for (std::size_t k = 0; k < 3; ++k) {
      const double step = 0.75 * 0.5 * (box.hi[k] - box.lo[k]) * (n[k] / largest);
      cover->star.inside[k] = inner(on_grid(m[k] - step, cover->unit), box, k, cover->unit);
      cover->star.outside[k] = inner(on_grid(m[k] + step, cover->unit), box, k, cover->unit);
    }
    return true;
  }
  static double inner(double v, const Box3d& box, std::size_t k, double unit) {
    return std::clamp(v, box.lo[k] + unit, box.hi[k] - unit);
  }

  bool search_centres(CoverBox* cover) {
    ++out_.programs;
    const Box3d& box = cover->star.box;
    const double size = extent(box), enough = 1e-3 * size;
    Box3d room = box;
    for (std::size_t k = 0; k < 3; ++k)
      room.lo[k] += 2 * cover->unit, room.hi[k] -= 2 * cover->unit;
    half_spaces_.clear();
    for (const Id id : tested_) add_half_spaces(id);
    const auto inside = deepest_point(half_spaces_, room, enough);
    if (!inside) return false;
    for (HalfSpace& h : half_spaces_) h = {{-h.a[0], -h.a[1], -h.a[2]}, -h.b};
    const auto outside = deepest_point(half_spaces_, room, enough);
    if (!outside) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      cover->star.inside[k] = on_grid(inside->point[k], cover->unit);
      cover->star.outside[k] = on_grid(outside->point[k], cover->unit);
    }
    return has_star_signs(forest_, tested_, cover->star);
  }

  // g_c > 0 for every coefficient of the piece, as half-spaces for c.
  void add_half_spaces(Id id) {
    const PieceForest::Node& node = forest_.node(id);
    const PieceForest::Form& form = forest_.form(node.patch);
    const std::size_t n = form.determinant.count();
    const double* const g = forest_.approx_determinants(id);
    forest_.for_each_kept(node, [&](std::size_t i) {
      HalfSpace h{{g[n + i], g[2 * n + i], g[3 * n + i]}, g[i]};
      const double length = std::hypot(h.a[0], h.a[1], h.a[2]);
      if (!(length > 0)) {
        half_spaces_.push_back({{0, 0, 0}, -1});  // never satisfied: g_c does not depend on c
        return;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        h.a[k] /= length;
        h.b -= h.a[k] * form.origin[k] * length;
      }
      h.b /= length;
      half_spaces_.push_back(h);
    });
  }

  PieceForest& forest_;
  const StarCoverOptions& options_;
  StarCover out_;
  Why last_failure_ = Why::kNoCentres;
  std::vector<Id> tested_, held_;
  std::vector<HalfSpace> half_spaces_;
};

}  // namespace

StarCover find_star_cover(PieceForest& forest, const StarCoverOptions& options) {
  return CoverSearch(forest, options).run();
}

}  // namespace veritope
