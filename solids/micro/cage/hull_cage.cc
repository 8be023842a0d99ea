// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/cage/hull_cage.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "solids/micro/cage/cage_containment.h"
#include "solids/micro/cage/content_search_internal.h"
#include "solids/micro/cage/scale_floor_internal.h"
#include "solids/micro/cage/short_numbers_internal.h"
#include "solids/vmodel/jacobian_sign.h"
#include "splines/convert.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

using Index3 = std::array<std::size_t, 3>;

constexpr int kMostStepHalvings = 20, kBorderHalvings = 6;
constexpr int kScaleHalvings = 9;
constexpr int kEvenings = 2;
constexpr double kPull = 0.5, kStraightening = 0.3;
constexpr int kMostTrials = 64;         // of a round before all steps are halved
constexpr double kLeastScale = 0x1p-6;  // of the box's determinant

// The control net of the cage, in doubles that are exact.
class CageNet {
 public:
  CageNet(const CageBox& box, const CageGrid& grid, const Rational& unit)
      : grid_of_cage_(grid), unit_(nearest_double(unit)) {
    std::array<std::vector<double>, 3> places;
    for (std::size_t k = 0; k < 3; ++k) {
      axes_[k] = cage_axis(grid, k);
      net_.size[k] = axes_[k].num_control();
      const Rational begin = internal::multiple_below(box.min[k], unit),
                     end = internal::multiple_above(box.max[k], unit);
      for (const Rational& part : internal::rising(axes_[k])) {
        greville_[k].push_back(nearest_double(part));
        places[k].push_back(
            nearest_double(internal::multiple_below(begin + (end - begin) * part, unit)));
      }
    }
    for (std::size_t k = 0; k < 3; ++k) between_[k] = between(greville_[k], grid.spans[k]);
    for (std::size_t n = 0; n < net_.count(); ++n) {
      const Index3 at = net_.index_of(n);
      points_.push_back({places[0][at[0]], places[1][at[1]], places[2][at[2]]});
    }
  }

  const Grid<3>& net() const { return net_; }
  const CageGrid& grid() const { return grid_of_cage_; }
  std::vector<Point3d>& points() { return points_; }
  const std::vector<Point3d>& points() const { return points_; }

  bool is_border(const Index3& at) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (at[k] == 0 || at[k] + 1 == net_.size[k]) return true;
    return false;
  }
  // Whether a face along the axis has the control point.
  bool is_in_face(const Index3& at, std::size_t axis) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (k != axis && (at[k] == 0 || at[k] + 1 == net_.size[k])) return true;
    return false;
  }
  // The numbers along an axis of the control points whose Greville abscissae lie in the span, up to rounding.
  std::vector<std::size_t> in_span(std::size_t axis, std::size_t span) const {
    std::vector<std::size_t> out;
    const auto begin = static_cast<double>(span);
    // Control point i is that of span i - degree to i.
    const std::size_t last = span + static_cast<std::size_t>(grid_of_cage_.degrees[axis]);
    for (std::size_t i = span; i <= last; ++i) {
      const double place = greville_[axis][i] * static_cast<double>(grid_of_cage_.spans[axis]);
      if (place > begin - 0x1p-20 && place < begin + 1 + 0x1p-20) out.push_back(i);
    }
    return out;
  }
  double rounded(double x) const { return std::nearbyint(x / unit_) * unit_; }

  CellVolume cell() const {
    std::vector<Rational> all;
    for (std::size_t k = 0; k < 3; ++k)
      for (const Point3d& p : points_) all.push_back(Rational::from_double(p[k]));
    return CellVolume(axes_, 3, false, std::move(all));
  }

  // The means of the neighbours of a control point of the border, one for each axis along which it has two in a common
  // face: where it would lie if the net were straight.
  std::vector<Point3d> straight(const std::vector<Point3d>& values, std::size_t n) const {
    const Index3 at = net_.index_of(n);
    std::vector<Point3d> out;
    for (std::size_t a = 0; a < 3; ++a) {
      if (!is_in_face(at, a) || at[a] == 0 || at[a] + 1 == net_.size[a]) continue;
      Index3 before = at, after = at;
      --before[a];
      ++after[a];
      const std::vector<double>& g = greville_[a];
      const double t = (g[at[a]] - g[before[a]]) / (g[after[a]] - g[before[a]]);
      const Point3d &p = values[net_.at(before)], &q = values[net_.at(after)];
      Point3d mean;
      for (std::size_t k = 0; k < 3; ++k) mean[k] = (1 - t) * p[k] + t * q[k];
      out.push_back(mean);
    }
    return out;
  }

  // Makes moves of the border linear between control points that are about a knot span apart: near the ends of an axis
  // others are so close to each other that different moves would fold the map.
  void coarsen(std::vector<Point3d>& moves) const {
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t n = 0; n < net_.count(); ++n) {
        const Index3 at = net_.index_of(n);
        const auto [low, high, part] = between_[a][at[a]];
        if (low == high || !is_in_face(at, a)) continue;
        Index3 first = at, second = at;
        first[a] = low;
        second[a] = high;
        const Point3d &p = moves[net_.at(first)], &q = moves[net_.at(second)];
        for (std::size_t k = 0; k < 3; ++k) moves[n][k] = (1 - part) * p[k] + part * q[k];
      }
    }
  }

  // Sets the moves of inner control points: the Boolean sum of those of the border.
  void spread(std::vector<Point3d>& moves) const {
    for (std::size_t n = 0; n < net_.count(); ++n) {
      const Index3 at = net_.index_of(n);
      if (is_border(at)) continue;
      Point3d sum{};
      for (unsigned axes = 1; axes < 8; ++axes) {
        const double sign = axes == 3 || axes == 5 || axes == 6 ? -1 : 1;
        for (unsigned ends = 0; ends < 8; ++ends) {
          if ((ends & ~axes) != 0) continue;
          Index3 on = at;
          double weight = sign;
          for (std::size_t k = 0; k < 3; ++k) {
            if ((axes >> k & 1) == 0) continue;
            const bool is_end = (ends >> k & 1) != 0;
            on[k] = is_end ? net_.size[k] - 1 : 0;
            weight *= is_end ? greville_[k][at[k]] : 1 - greville_[k][at[k]];
          }
          const Point3d& move = moves[net_.at(on)];
          for (std::size_t k = 0; k < 3; ++k) sum[k] += weight * move[k];
        }
      }
      moves[n] = sum;
    }
  }

 private:
  // Control points between which another one lies, and where; both are the same for one that stands for itself.
  struct Between {
    std::size_t low, high;
    double part;
  };
  static std::vector<Between> between(const std::vector<double>& greville, std::uint64_t spans) {
    const double least = 0.75 / static_cast<double>(spans);
    const std::size_t end = greville.size() - 1;
    std::vector<std::size_t> kept{0};
    for (std::size_t i = 1; i < end && spans > 1; ++i)
      if (greville[i] - greville[kept.back()] >= least && 1 - greville[i] >= least)
        kept.push_back(i);
    kept.push_back(end);
    std::vector<Between> out;
    for (std::size_t i = 0; i <= end; ++i) {
      const auto next = std::lower_bound(kept.begin(), kept.end(), i);
      if (*next == i || spans == 1) {
        out.push_back({i, i, 0});
        continue;
      }
      const std::size_t low = *(next - 1);
      out.push_back(
          {low, *next, (greville[i] - greville[low]) / (greville[*next] - greville[low])});
    }
    return out;
  }

  CageGrid grid_of_cage_;
  double unit_;
  std::array<std::vector<Between>, 3> between_;
  std::array<KnotAxis<Rational>, 3> axes_;
  std::array<std::vector<double>, 3> greville_;
  Grid<3> net_;
  std::vector<Point3d> points_;
};

// What cannot be accepted of a net: the control points of the border whose steps are too long.
class NetTrial {
 public:
  NetTrial(const CageNet& net, const internal::ContentSearch& search, double least_scale)
      : net_(net), search_(search), least_scale_(least_scale), is_blamed_(net.net().count()) {}

  // The numbers of control points of the border, ascending; empty: the net is accepted.
  std::vector<std::size_t> blamed() {
    const CellVolume cell = net_.cell();
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t end = 0; end < 2; ++end) test_face(cell, axis, end);
    test_scale(cell);
    std::vector<std::size_t> out;
    for (std::size_t n = 0; n < is_blamed_.size(); ++n)
      if (is_blamed_[n]) out.push_back(n);
    return out;
  }

 private:
  void test_face(const CellVolume& cell, std::size_t axis, std::size_t end) {
    const auto pieces = bezier_pieces(side_of(cell, axis, end));
    const std::array<std::size_t, 2> others = v_face_axes(axis);
    const Grid<2> grid = pieces.grid();
    for (std::size_t n = 0; n < grid.count(); ++n) {
      if (!search_.met_by(internal::enclosed(pieces.pieces[n]), kBorderHalvings)) continue;
      const auto span = grid.index_of(n);
      Index3 first{};
      first[others[0]] = span[0];
      first[others[1]] = span[1];
      blame_window(first, axis, end);
    }
  }

  void test_scale(const CellVolume& cell) {
    const auto pieces = bezier_pieces(nearest_double(cell).value());
    const Grid<3> grid = pieces.grid();
    for (std::size_t n = 0; n < grid.count(); ++n) {
      if (internal::has_scale(pieces.pieces[n], least_scale_, kScaleHalvings)) continue;
      // The faces that are nearest to the span.
      const Index3 span = grid.index_of(n);
      std::size_t nearest = span[0];
      for (std::size_t k = 0; k < 3; ++k)
        nearest = std::min({nearest, span[k], grid.size[k] - 1 - span[k]});
      for (std::size_t k = 0; k < 3; ++k) {
        if (span[k] == nearest) blame_window(span, k, 0);
        if (grid.size[k] - 1 - span[k] == nearest) blame_window(span, k, 1);
      }
    }
  }

  // The control points of a face that count most in the span: those that lie in it by their Greville abscissae.
  void blame_window(const Index3& span, std::size_t axis, std::size_t end) {
    std::array<std::vector<std::size_t>, 3> chosen;
    for (std::size_t k = 0; k < 3; ++k) chosen[k] = net_.in_span(k, span[k]);
    chosen[axis] = {end == 0 ? 0 : net_.net().size[axis] - 1};
    for (const std::size_t i : chosen[0])
      for (const std::size_t j : chosen[1])
        for (const std::size_t k : chosen[2]) is_blamed_[net_.net().at({i, j, k})] = true;
  }

  const CageNet& net_;
  const internal::ContentSearch& search_;
  double least_scale_;
  std::vector<bool> is_blamed_;
};

class HullPull {
 public:
  HullPull(const CageContent& content, const HullCageOptions& options, const CageBox& box,
           const Rational& unit)
      : content_(content),
        search_(content),
        margin_(nearest_double(options.margin)),
        net_(box, options.grid, unit) {
    least_scale_ = kLeastScale;
    for (std::size_t k = 0; k < 3; ++k)
      least_scale_ *=
          nearest_double(box.max[k] - box.min[k]) / static_cast<double>(options.grid.spans[k]);
  }

  HullCage run(int rounds) {
    HullCage out{net_.cell(), 0, 0};
    for (int round = 0; round < rounds; ++round) {
      if (!step(out.shortened)) break;
      CellVolume cell = net_.cell();
      if (!is_proved(cell)) break;
      out.cell = std::move(cell);
      ++out.rounds;
    }
    return out;
  }

 private:
  // False if no control point moves.
  bool step(std::uint64_t& shortened) {
    const std::vector<Point3d> before = net_.points();
    std::vector<Point3d> targets(before.size());
    std::vector<int> halvings(before.size(), 0);
    for (std::size_t n = 0; n < before.size(); ++n)
      if (net_.is_border(net_.net().index_of(n))) targets[n] = move_of(before[n]);
    for (int pass = 0; pass < kEvenings; ++pass) even_out(targets);
    add_straightening(before, targets);
    for (int trial = 0;; ++trial) {
      if (!apply(before, targets, halvings)) return false;
      const std::vector<std::size_t> blamed = NetTrial(net_, search_, least_scale_).blamed();
      if (blamed.empty()) return true;
      bool is_shorter = false;
      for (const std::size_t n : blamed) {
        if (halvings[n] > kMostStepHalvings || targets[n] == Point3d{}) continue;
        halvings[n] += 1 + trial / 4;
        ++shortened;
        is_shorter = true;
      }
      // Others are in the way then, since the net before the round was accepted.
      if (is_shorter && trial < kMostTrials) continue;
      for (int& h : halvings) ++h;
    }
  }

  static void mix(const std::vector<Point3d>& means, double part, const Point3d& from,
                  Point3d& to) {
    for (const Point3d& mean : means)
      for (std::size_t k = 0; k < 3; ++k)
        to[k] += part / static_cast<double>(means.size()) * (mean[k] - from[k]);
  }
  void even_out(std::vector<Point3d>& moves) const {
    std::vector<Point3d> out = moves;
    for (std::size_t n = 0; n < moves.size(); ++n)
      if (net_.is_border(net_.net().index_of(n)))
        mix(net_.straight(moves, n), 0.5, moves[n], out[n]);
    moves = std::move(out);
  }
  void add_straightening(const std::vector<Point3d>& points, std::vector<Point3d>& moves) const {
    for (std::size_t n = 0; n < moves.size(); ++n)
      if (net_.is_border(net_.net().index_of(n)))
        mix(net_.straight(points, n), kStraightening, points[n], moves[n]);
  }

  // Halfway along the line to the nearest place, less the margin.
  Point3d move_of(const Point3d& p) const {
    const Point3d place = search_.approx_nearest(p);
    const Point3d way = {place[0] - p[0], place[1] - p[1], place[2] - p[2]};
    const double length = std::sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
    if (!(length > margin_)) return {};
    const double part = kPull * (length - margin_) / length;
    return {part * way[0], part * way[1], part * way[2]};
  }

  bool apply(const std::vector<Point3d>& before, const std::vector<Point3d>& targets,
             const std::vector<int>& halvings) {
    std::vector<Point3d> moves = targets;
    for (std::size_t n = 0; n < moves.size(); ++n)
      for (double& x : moves[n])
        x = halvings[n] > kMostStepHalvings ? 0 : std::ldexp(x, -halvings[n]);
    net_.coarsen(moves);
    net_.spread(moves);
    bool has_moved = false;
    for (std::size_t n = 0; n < moves.size(); ++n)
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = net_.rounded(before[n][k] + moves[n][k]);
        has_moved = has_moved || x != before[n][k];
        net_.points()[n][k] = x;
      }
    return has_moved;
  }

  bool is_proved(const CellVolume& cell) const {
    const Result<VModel> model = make_v_model({cell}, VOrientation::kKeep);
    return model && decide_determinants(*model).is_proved() && !find_gap(*model, content_);
  }

  const CageContent& content_;
  internal::ContentSearch search_;
  double margin_, least_scale_;
  CageNet net_;
};

}  // namespace

Result<HullCage> hull_cage(const CageContent& content, const HullCageOptions& options) {
  if (const Status fits = check_cage_grid(options.grid); !fits) return fits.error();
  if (options.margin.sign() != Sign::kPositive)
    return bad_argument("margin must be positive, not " + options.margin.to_string());
  if (content.num_parts() == 0) return bad_argument("content without a part has no cage");
  const CageBox box = grown(box_of(content), options.margin);
  std::uint64_t spans = 1;
  for (const std::uint64_t n : options.grid.spans) spans *= n;
  if (spans > kMaxHullSpans)
    return Error{Code::kOverLimit,
                 {},
                 "spans of a hull are at most " + std::to_string(kMaxHullSpans) +
                     " in all, and there are " + std::to_string(spans)};
  // The margin is part of the box, so that it has a diagonal.
  const Rational unit =
      internal::power_of_two_below(margin_length(box, Rational(1))) * Rational::power_of_two(-16);
  for (const CellPoint* const p : {&box.min, &box.max})
    for (const Rational& x : *p)
      if (abs(x) > unit * Rational::power_of_two(50))
        return Error{
            Code::kOverLimit,
            {},
            "content of this size is too far from the origin: a coordinate is " + x.to_string()};
  return HullPull(content, options, box, unit).run(options.rounds);
}

}  // namespace veritope
