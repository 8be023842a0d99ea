// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/side_overlaps.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "robust/base/box3d.h"
#include "solids/patches/common_roots.h"
#include "solids/patches/curve_agreement_internal.h"
#include "splines/bezier_domain.h"

namespace veritope {
namespace {

using Curve = Patch::Curve;

struct OpenSide {
  PatchSide side;
  Box3d box;  // contains the side
};

bool has_positive_weights(const Curve& curve) {
  if (!curve.is_rational()) return true;
  const auto weights = curve.component(3);
  return std::all_of(weights.begin(), weights.end(),
                     [](const Rational& w) { return w.sign() == Sign::kPositive; });
}

Box3d box_of(const Curve& curve) {
  Box3d out;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto x = curve.component(static_cast<int>(c));
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Rational at = curve.is_rational() ? x[i] / curve.component(3)[i] : x[i];
      const double lo = round_down(at), hi = round_up(at);
      out.lo[c] = i == 0 ? lo : std::min(out.lo[c], lo);
      out.hi[c] = i == 0 ? hi : std::max(out.hi[c], hi);
    }
  }
  return out;
}

std::vector<OpenSide> open_sides(const PatchComplex& complex) {
  std::vector<OpenSide> out;
  for (std::uint32_t e = 0; e < complex.num_edges(); ++e) {
    if (complex.sides(e).size() != 1) continue;
    const PatchSide side = complex.sides(e)[0];
    const Curve curve = complex.patch(side.patch).side(side.side);
    if (has_positive_weights(curve)) out.push_back({side, box_of(curve)});
  }
  return out;
}

// The axis along which the boxes are spread over the most of their own lengths.
std::size_t sweep_axis(const std::vector<OpenSide>& sides) {
  std::array<double, 3> spread{};
  for (std::size_t c = 0; c < 3; ++c) {
    double lo = sides[0].box.lo[c], hi = sides[0].box.hi[c], sum = 0;
    for (const OpenSide& s : sides) {
      lo = std::min(lo, s.box.lo[c]), hi = std::max(hi, s.box.hi[c]);
      sum += s.box.hi[c] - s.box.lo[c];
    }
    spread[c] = (hi - lo) / (sum + (hi - lo) * 0x1p-30);
  }
  return static_cast<std::size_t>(std::max_element(spread.begin(), spread.end()) - spread.begin());
}

// Calls visit(i, j) for pairs of sides whose boxes meet, until it returns false.
template <typename Visit>
void for_each_pair(std::vector<OpenSide>& sides, Visit visit) {
  if (sides.empty()) return;
  const std::size_t axis = sweep_axis(sides);
  std::sort(sides.begin(), sides.end(), [&](const OpenSide& a, const OpenSide& b) {
    return std::tie(a.box.lo[axis], a.side) < std::tie(b.box.lo[axis], b.side);
  });
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size() && sides[j].box.lo[axis] <= sides[i].box.hi[axis];
         ++j)
      if (meets(sides[i].box, sides[j].box) && !visit(sides[i].side, sides[j].side)) return;
}

class Comparison {
 public:
  Comparison(const PatchComplex& complex, PatchSide a, PatchSide b)
      : sides_{std::min(a, b), std::max(a, b)},
        curves_{complex.patch(sides_[0].patch).side(sides_[0].side),
                complex.patch(sides_[1].patch).side(sides_[1].side)} {}

  // The arc along which both sides run; nothing if they meet in single points only.
  std::optional<SideOverlap> run() {
    put_ends(0);
    put_ends(1);
    std::optional<SideOverlap> best;
    for (std::size_t i = 0; i < points_.size(); ++i)
      for (std::size_t j = 0; j < points_.size(); ++j) {
        if (!(points_[i][0] < points_[j][0]) || points_[i][1] == points_[j][1]) continue;
        const auto found = between(points_[i], points_[j]);
        if (found && (!best || is_better(*found, *best))) best = found;
      }
    return best;
  }
  bool is_undecided() const { return is_undecided_; }

 private:
  using Pair = std::array<Rational, 2>;  // parameters on both sides

  // The common points of the ends of one side with the other.
  void put_ends(std::size_t own) {
    for (const int end : {0, 1}) {
      const auto roots = internal::parameters_of(internal::point_at(curves_[own], Rational(end)),
                                                 curves_[1 - own]);
      for (const auto& [lo, hi] : roots.roots) {
        if (lo < hi) {
          is_undecided_ = true;
          continue;
        }
        Pair pair;
        pair[own] = Rational(end), pair[1 - own] = lo;
        if (std::find(points_.begin(), points_.end(), pair) == points_.end())
          points_.push_back(std::move(pair));
      }
    }
  }

  std::optional<SideOverlap> between(const Pair& from, const Pair& to) const {
    SideOverlap out;
    out.sides = sides_;
    out.at = {{{from[0], to[0]}, {from[1], to[1]}}};
    const auto agreement = internal::agreement_of(internal::arc_of(curves_[0], out.at[0]),
                                                  internal::arc_of(curves_[1], out.at[1]));
    if (!agreement) return std::nullopt;
    out.agreement = *agreement;
    return out;
  }
  static bool is_better(const SideOverlap& a, const SideOverlap& b) {
    if (a.agreement != b.agreement) return a.agreement < b.agreement;
    return b.at[0][1] - b.at[0][0] < a.at[0][1] - a.at[0][0];
  }

  std::array<PatchSide, 2> sides_;
  std::array<Curve, 2> curves_;
  std::vector<Pair> points_;
  bool is_undecided_ = false;
};

bool is_inner(const Rational& t) { return Rational(0) < t && t < Rational(1); }

}  // namespace

SideOverlaps find_side_overlaps(const PatchComplex& complex, std::size_t max_pairs) {
  SideOverlaps out;
  std::vector<OpenSide> sides = open_sides(complex);
  std::size_t compared = 0;
  for_each_pair(sides, [&](PatchSide a, PatchSide b) {
    if (compared++ == max_pairs) return out.is_complete = false;
    Comparison comparison(complex, a, b);
    if (auto found = comparison.run()) {
      out.found.push_back(std::move(*found));
    } else if (comparison.is_undecided()) {
      out.undecided.push_back({std::min(a, b), std::max(a, b)});
    }
    return true;
  });
  std::sort(out.found.begin(), out.found.end(),
            [](const SideOverlap& a, const SideOverlap& b) { return a.sides < b.sides; });
  std::sort(out.undecided.begin(), out.undecided.end());
  return out;
}

std::vector<TJunction> t_junctions_of(const PatchComplex& complex,
                                      const std::vector<SideOverlap>& overlaps) {
  std::vector<TJunction> out;
  for (const SideOverlap& o : overlaps) {
    if (o.agreement != CurveAgreement::kAffine) continue;
    for (const std::size_t own : {std::size_t{0}, std::size_t{1}})
      for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        if (!is_inner(o.at[own][end])) continue;
        const PatchSide other = o.sides[1 - own];
        const std::uint32_t n = complex.patch(other.patch).num_sides();
        const bool is_start = o.at[1 - own][end].sign() == Sign::kZero;
        const PatchCorner corner{other.patch, is_start ? other.side : (other.side + 1) % n};
        out.push_back({o.sides[own], o.at[own][end], corner, other});
      }
  }
  const auto place = [](const TJunction& t) { return std::tie(t.side, t.at); };
  std::sort(out.begin(), out.end(), [&](const TJunction& a, const TJunction& b) {
    return std::tie(a.side, a.at, a.corner) < std::tie(b.side, b.at, b.corner);
  });
  out.erase(
      std::unique(out.begin(), out.end(),
                  [&](const TJunction& a, const TJunction& b) { return place(a) == place(b); }),
      out.end());
  return out;
}

}  // namespace veritope
