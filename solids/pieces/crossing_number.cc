// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/pieces/crossing_number.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "robust/base/check.h"
#include "solids/pieces/exact_winding.h"
#include "solids/pieces/piece_bounds.h"
#include "solids/pieces/piece_net_internal.h"

namespace veritope {
namespace {

// Key of letters. c-, c+: the two centres, `inside` and `outside`; d = c+ - c-, and k its axis of greatest |d|.
// i, j: the other two axes, k + 1 and k + 2 modulo 3; the projection along d onto the plane k = 0 has the coordinates
// x (axis i) and y (axis j), times d_k. turn: a rotation of that plane with a scaling, so that the half-line
// y = 0, x > 0 does not pass through ends of curves. w: the weight of a homogeneous control point.
// A stretch is a part of a line of parameters; its sign is the direction in which a piece passes it.

constexpr int kMaxHalvings = 30;
constexpr int kUnitBits = 48;  // parameters along sides are integers times 2^-48

// A stretch of a line of parameters: on an inner line of a patch, or on the curve that two patches share.
struct Stretch {
  std::uint64_t line[2];  // which line: (patch and family, place), or (kShared, edge)
  std::uint64_t begin, end;
  int sign;  // +1: passed from begin to end
  PieceForest::Id node;
  std::uint32_t side;
  friend bool operator<(const Stretch& a, const Stretch& b) {
    if (a.line[0] != b.line[0]) return a.line[0] < b.line[0];
    if (a.line[1] != b.line[1]) return a.line[1] < b.line[1];
    return a.begin != b.begin ? a.begin < b.begin : a.end < b.end;
  }
};
constexpr std::uint64_t kShared = ~std::uint64_t{0};
constexpr std::uint64_t kWhole = std::uint64_t{1} << kUnitBits;

// Where a side of a node lies: on line `place` of its family, between two parameters; sign -1 if it is travelled
// downwards.
struct Location {
  std::uint64_t family, place, begin, end;
  int sign;
};

Location locate(const PieceForest::Form& form, const PieceForest::Node& node, std::uint32_t side) {
  if (form.shape.is_triangle) {
    const std::uint64_t unit = kWhole >> node.level;
    // Side s runs from corner s to corner s + 1; the coordinate of corner s + 2 is constant, that of corner s + 1 grows
    // along it.
    const std::uint64_t sum = std::uint64_t{1} << node.level;
    const std::uint64_t a = (node.is_upside_down ? sum + 1 : sum - 1) - node.i - node.j;
    const std::uint64_t x[3] = {a, node.i, node.j};
    const std::uint64_t along = x[(side + 1) % 3], place = x[(side + 2) % 3];
    if (node.is_upside_down) return {side, place * unit, (along - 1) * unit, along * unit, -1};
    return {side, place * unit, along * unit, (along + 1) * unit, 1};
  }
  const std::uint64_t u = kWhole >> (form.root_bits[0] + node.level);
  const std::uint64_t v = kWhole >> (form.root_bits[1] + node.level);
  switch (side) {
    case 0: return {0, node.j * v, node.i * u, (node.i + 1) * u, 1};
    case 1: return {1, (node.i + 1) * u, node.j * v, (node.j + 1) * v, 1};
    case 2: return {0, (node.j + 1) * v, node.i * u, (node.i + 1) * u, -1};
    default: return {1, node.i * u, node.j * v, (node.j + 1) * v, -1};
  }
}

// What a curve contributes to the winding around the origin: crossings of the half-line y = 0, x > 0 from below.
// Control points are homogeneous, relative to the centre, projected along d, and turned.
struct Curve {
  std::vector<double> x, y;
  double error_x, error_y;
  std::uint64_t begin, end;  // its parameters

  void halve(Curve* right) {
    const int n = static_cast<int>(x.size()) - 1;
    const auto largest = [](const std::vector<double>& v) {
      double m = 0;
      for (const double c : v) m = std::max(m, std::abs(c));
      return m;
    };
    error_x = internal::error_after_halving(error_x, largest(x), n);
    error_y = internal::error_after_halving(error_y, largest(y), n);
    *right = *this;
    internal::split_keeping_left(x.data(), 1, n, right->x.data(), 1, internal::kHalves);
    internal::split_keeping_left(y.data(), 1, n, right->y.data(), 1, internal::kHalves);
    right->begin = end = begin + (end - begin) / 2;
  }
};

std::optional<bool> is_up(const Curve& curve, double y) {
  if (internal::is_surely_positive(y, curve.error_y)) return true;
  if (internal::is_surely_negative(y, curve.error_y)) return false;
  return std::nullopt;
}

// The winding number of the part of the curve between two parameters, which are integers times those of its halves.
std::optional<int> winding(Curve& curve, std::uint64_t from, std::uint64_t to, int halvings) {
  if (curve.end <= from || to <= curve.begin) return 0;
  if (from <= curve.begin && curve.end <= to) {
    bool up = true, down = true, back = true, ahead = true;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      up = up && internal::is_surely_positive(curve.y[i], curve.error_y);
      down = down && internal::is_surely_negative(curve.y[i], curve.error_y);
      back = back && internal::is_surely_negative(curve.x[i], curve.error_x);
      ahead = ahead && internal::is_surely_positive(curve.x[i], curve.error_x);
    }
    if (up || down || back) return 0;
    if (ahead) {
      const auto at_begin = is_up(curve, curve.y.front()), at_end = is_up(curve, curve.y.back());
      if (!at_begin || !at_end) return std::nullopt;
      return int{*at_end} - int{*at_begin};
    }
    if (halvings == 0) return std::nullopt;
    --halvings;
  }
  Curve right;
  curve.halve(&right);
  const auto a = winding(curve, from, to, halvings);
  if (!a) return std::nullopt;
  const auto b = winding(right, from, to, halvings);
  if (!b) return std::nullopt;
  return *a + *b;
}

class CrossingCounter {
 public:
  CrossingCounter(PieceForest& forest, const CentreLine& line) : forest_(forest), line_(line) {
    for (std::size_t k = 0; k < 3; ++k) d_[k] = line.outside[k] - line.inside[k];
    k_ = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (std::abs(d_[k]) > std::abs(d_[k_])) k_ = k;
    i_ = (k_ + 1) % 3, j_ = (k_ + 2) % 3;
  }

  std::optional<int> count(const std::vector<PieceForest::Id>& tested) {
    for (const PieceForest::Id id : tested) add_sides(id);
    std::sort(stretches_.begin(), stretches_.end());
    // On symmetric models some half-lines pass through ends of curves, so several are tried.
    for (const auto& turn : {std::array<double, 2>{1, 0}, std::array<double, 2>{0.8125, 0.59375},
                             std::array<double, 2>{-0.375, 0.90625}}) {
      turn_ = turn;
      if (const auto sum = sum_of_windings()) return d_[k_] > 0 ? *sum : -*sum;
    }
    turn_ = {1, 0}, exact_left_ = kMostExact;
    const auto sum = sum_of_windings();
    if (!sum) return std::nullopt;
    return d_[k_] > 0 ? *sum : -*sum;
  }

 private:
  void add_sides(PieceForest::Id id) {
    const PieceForest::Node& node = forest_.node(id);
    const PieceForest::Form& form = forest_.form(node.patch);
    for (std::uint32_t s = 0; s < (form.shape.is_triangle ? 3u : 4u); ++s) {
      const Location at = locate(form, node, s);
      Stretch stretch{{(std::uint64_t{node.patch} << 2) + at.family, at.place},
                      at.begin,
                      at.end,
                      at.sign,
                      id,
                      s};
      if (forest_.side_of_patch(node, s)) {
        const PatchComplex& complex = forest_.complex();
        const PatchSide side{node.patch, s};
        if (complex.is_collapsed(side)) continue;
        const auto mate = complex.mate(side);
        VT_CHECK(mate.has_value(), "an open side in a complex without defects");
        stretch.line[0] = kShared, stretch.line[1] = complex.edge(side);
        // Parameters run along the side that comes first; its mate is travelled in the opposite direction. Sides 2 and
        // 3 of a tensor run downwards.
        const bool runs_up = form.shape.is_triangle || s < 2;
        if (runs_up != (side < *mate)) {
          stretch.begin = kWhole - at.end, stretch.end = kWhole - at.begin;
          stretch.sign = -at.sign;
        }
      }
      stretches_.push_back(stretch);
    }
  }

  std::optional<int> sum_of_windings() {
    int sum = 0;
    for (std::size_t first = 0; first < stretches_.size();) {
      std::size_t last = first + 1;
      while (last < stretches_.size() && stretches_[last].line[0] == stretches_[first].line[0] &&
             stretches_[last].line[1] == stretches_[first].line[1])
        ++last;
      const auto part = winding_on_line(first, last);
      if (!part) return std::nullopt;
      sum += *part;
      first = last;
    }
    return sum;
  }

  // The winding of the parts of the stretches [first, last) of one line that do not cancel.
  std::optional<int> winding_on_line(std::size_t first, std::size_t last) {
    if (last - first == 2 && stretches_[first].begin == stretches_[first + 1].begin &&
        stretches_[first].end == stretches_[first + 1].end &&
        stretches_[first].sign == -stretches_[first + 1].sign)
      return 0;
    cuts_.clear();
    for (std::size_t k = first; k < last; ++k) {
      cuts_.push_back(stretches_[k].begin);
      cuts_.push_back(stretches_[k].end);
    }
    std::sort(cuts_.begin(), cuts_.end());
    cuts_.erase(std::unique(cuts_.begin(), cuts_.end()), cuts_.end());
    int sum = 0;
    for (std::size_t c = 0; c + 1 < cuts_.size(); ++c) {
      int net = 0;
      const Stretch* on = nullptr;
      for (std::size_t k = first; k < last; ++k)
        if (stretches_[k].begin <= cuts_[c] && cuts_[c + 1] <= stretches_[k].end) {
          net += stretches_[k].sign;
          on = &stretches_[k];
        }
      if (net == 0) continue;
      const auto winding = winding_of(*on, cuts_[c], cuts_[c + 1]);
      if (!winding) return std::nullopt;
      sum += net * on->sign * *winding;
    }
    return sum;
  }

  // The winding number of that part of a node's side, in the side's direction of travel.
  std::optional<int> winding_of(const Stretch& on, std::uint64_t begin, std::uint64_t end) {
    const PieceForest::Form& form = forest_.form(forest_.node(on.node).patch);
    const double* const net = forest_.control(on.node);
    const std::size_t count = form.shape.count();
    const Patch& patch = forest_.complex().patch(forest_.node(on.node).patch);
    const std::size_t length = patch.side_length(on.side);
    Point3d c;
    double error = 0, size = 0;
    const double w_error = form.is_rational ? forest_.control_error(on.node, 3) : 0;
    for (std::size_t k = 0; k < 3; ++k) {
      c[k] = line_.inside[k] - form.origin[k];
      error = std::max(error, forest_.control_error(on.node, k) + w_error * std::abs(c[k]));
    }
    Curve curve;
    for (std::size_t t = 0; t < length; ++t) {
      const std::size_t at = patch.side_index(on.side, t);
      const double w = form.is_rational ? net[3 * count + at] : 1;
      Point3d p;
      for (std::size_t k = 0; k < 3; ++k) {
        const double m = net[k * count + at];
        p[k] = internal::relative_to_centre(m, w, c[k]);
        size = std::max(size, std::abs(m) + w * std::abs(c[k]));
      }
      const double x = internal::projected(p[i_], p[k_], d_[i_], d_[k_]);
      const double y = internal::projected(p[j_], p[k_], d_[j_], d_[k_]);
      const auto xy = internal::turned(turn_[0], turn_[1], x, y);
      curve.x.push_back(xy[0]);
      curve.y.push_back(xy[1]);
    }
    curve.error_x = curve.error_y = internal::crossing_bound(error, size, std::abs(d_[k_]), turn_);
    curve.begin = 0, curve.end = on.end - on.begin;
    // Parameters in the direction of travel: forward from on.begin, or backward from on.end.
    const std::uint64_t from = on.sign > 0 ? begin - on.begin : on.end - end;
    const std::uint64_t to = from + (end - begin);
    const auto sum = winding(curve, from, to, kMaxHalvings);
    if (sum || exact_left_ == 0) return sum;
    --exact_left_;
    const ExactPiece* const piece = forest_.exact(on.node);
    if (piece == nullptr) return std::nullopt;
    return exact_winding(*piece, patch, on.side, line_, {i_, j_, k_}, from, to,
                         std::countr_zero(on.end - on.begin));
  }

  PieceForest& forest_;
  const CentreLine& line_;
  Point3d d_;
  std::size_t i_, j_, k_;
  static constexpr int kMostExact = 64;
  std::array<double, 2> turn_{};
  int exact_left_ = 0;  // stretches that integers may decide, on the half-line (1, 0)
  std::vector<Stretch> stretches_;
  std::vector<std::uint64_t> cuts_;
};

}  // namespace

std::optional<int> crossing_number(PieceForest& forest, const std::vector<PieceForest::Id>& tested,
                                   const CentreLine& line) {
  return CrossingCounter(forest, line).count(tested);
}

}  // namespace veritope
