// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/intersect/intersection_clip.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace veritope {
namespace {

/// At greater depths a tube gets as narrow as the boxes of single points, and its content cannot be decided.
constexpr int kMostHalvingsOfATube = 14;
/// The limit for one tube. An arc that touches a border needs two at each depth; one that runs along it would need all.
constexpr int kMostHalved = 60;

class Clipper {
 public:
  Clipper(const EnclosedSurface& s1, const EnclosedSurface& s2, std::vector<DomainArc>* arcs,
          std::vector<Box4>* unresolved)
      : s1_(s1), s2_(s2), arcs_(arcs), unresolved_(unresolved) {
    for (std::size_t i = 0; i < 4; ++i) domain_[i] = parameter_domain(s1, s2, i);
  }

  void clip(const IntersectionTube& tube, int halvings) {
    DomainArc arc{tube, Interval(tube.w_lo), Interval(tube.w_hi)};
    if (is_inside(tube.over(Interval::from_bounds(tube.w_lo, tube.w_hi)))) {
      arcs_->push_back(arc);
      return;
    }
    const Box4 x = box_of(tube);
    for (std::size_t i = 0; i < 4; ++i) {
      if (is_disjoint(x[i], domain_[i])) return;
      if (is_subset(x[i], domain_[i])) continue;
      const Sign3 rate = tube.derivative[i].sign();
      if (rate != Sign3::kPositive && rate != Sign3::kNegative) return halve(tube, x, halvings);
      const bool rises = rate == Sign3::kPositive;
      const bool is_cut =
          (!(x[i].lo() < domain_[i].lo()) || cut(&arc, i, domain_[i].lo(), rises)) &&
          (!(x[i].hi() > domain_[i].hi()) || cut(&arc, i, domain_[i].hi(), !rises));
      if (is_cut) continue;
      unresolved_->push_back(x);
      return;
    }
    if (arc.begin.lo() > arc.end.hi()) return;
    if (arc.begin.hi() < arc.end.lo()) {
      arcs_->push_back(arc);
    } else {
      unresolved_->push_back(x);
    }
  }

 private:
  bool is_inside(const Box4& x) const {
    for (std::size_t i = 0; i < 4; ++i)
      if (!is_subset(x[i], domain_[i])) return false;
    return true;
  }
  /// A box around the tube, as tight as the derivative allows.
  Box4 box_of(const IntersectionTube& tube) const {
    const Interval w = Interval::from_bounds(tube.w_lo, tube.w_hi);
    const double middle = tube.w_lo + 0.5 * (tube.w_hi - tube.w_lo);
    const Box4 at = locate(s1_, s2_, tube, middle);
    const Interval step = w - Interval(middle);
    Box4 out = tube.over(w);
    for (std::size_t i = 0; i < 4; ++i)
      out[i] = intersection(out[i], at[i] + tube.derivative[i] * step);
    return out;
  }

  void halve(const IntersectionTube& tube, const Box4& x, int halvings) {
    if (halvings >= kMostHalvingsOfATube || ++num_halved_ > kMostHalved) {
      unresolved_->push_back(x);
      return;
    }
    const double middle = tube.w_lo + 0.5 * (tube.w_hi - tube.w_lo);
    // The halves share more than one point, so that each holds an end of the other.
    const double reach = 0x1p-6 * (tube.w_hi - tube.w_lo);
    const auto low = shortened(s1_, s2_, tube, tube.w_lo, middle + reach);
    const auto high = shortened(s1_, s2_, tube, middle - reach, tube.w_hi);
    if (!low || !high) {
      unresolved_->push_back(x);
      return;
    }
    clip(*low, halvings + 1);
    clip(*high, halvings + 1);
  }

  /// Compares parameter i at w with the bound: -1 before it, +1 after it, 0 unknown.
  int side(const IntersectionTube& tube, std::size_t i, double bound, double w) const {
    const Box4 at = locate(s1_, s2_, tube, w);
    return at[i].hi() < bound ? -1 : (at[i].lo() > bound ? 1 : 0);
  }

  /// Keeps what follows the place where parameter i is `bound` (keep_behind), or what precedes it. Returns false if it
  /// is not decided whether the tube's range holds that place.
  bool cut(DomainArc* arc, std::size_t i, double bound, bool keep_behind) const {
    const IntersectionTube& tube = arc->tube;
    const int rises = tube.derivative[i].sign() == Sign3::kPositive ? 1 : -1;
    const auto place = crossing(tube, i, bound, rises);
    if (!place) return false;
    if (keep_behind) {
      if (place->hi() <= tube.w_lo) return true;
      arc->begin = max(arc->begin, *place);
      arc->begins_on_border = true;
    } else {
      if (place->lo() >= tube.w_hi) return true;
      arc->end = min(arc->end, *place);
      arc->ends_on_border = true;
    }
    return true;
  }

  /// Where x[i] passes the bound: an interval of w, which lies beyond the tube's range if x[i] does not pass it within.
  std::optional<Interval> crossing(const IntersectionTube& tube, std::size_t i, double bound,
                                   int rises) const {
    const double width = tube.w_hi - tube.w_lo;
    const int at_lo = rises * side(tube, i, bound, tube.w_lo);
    const int at_hi = rises * side(tube, i, bound, tube.w_hi);
    if (at_lo > 0) return Interval(tube.w_lo - width);
    if (at_hi < 0) return Interval(tube.w_hi + width);
    if (at_lo == 0 || at_hi == 0) return std::nullopt;
    // Regula falsi's first guess, then brackets that grow until both sides are sure.
    double w = tube.w_lo + 0.5 * width;
    for (int step = 0; step < 4; ++step) {
      const Box4 at = locate(s1_, s2_, tube, w);
      const double value = 0.5 * (at[i].lo() + at[i].hi()) - bound;
      const double rate = 0.5 * (tube.derivative[i].lo() + tube.derivative[i].hi());
      w = std::clamp(w - value / rate, tube.w_lo, tube.w_hi);
    }
    for (double reach = 0x1p-40 * width; reach < width; reach *= 8) {
      const double a = std::max(tube.w_lo, w - reach), b = std::min(tube.w_hi, w + reach);
      const bool is_before = a == tube.w_lo || rises * side(tube, i, bound, a) < 0;
      const bool is_behind = b == tube.w_hi || rises * side(tube, i, bound, b) > 0;
      if (is_before && is_behind) return Interval::from_bounds(a, b);
    }
    return Interval::from_bounds(tube.w_lo, tube.w_hi);
  }

  const EnclosedSurface &s1_, &s2_;
  int num_halved_ = 0;
  std::array<Interval, 4> domain_;
  std::vector<DomainArc>* arcs_;
  std::vector<Box4>* unresolved_;
};

}  // namespace

Interval parameter_domain(const EnclosedSurface& s1, const EnclosedSurface& s2, std::size_t i) {
  const EnclosedSurface& s = i < 2 ? s1 : s2;
  return Interval::from_bounds(s.domain_begin(i % 2), s.domain_end(i % 2));
}

void clip_to_domains(const EnclosedSurface& s1, const EnclosedSurface& s2,
                     const IntersectionTube& tube, std::vector<DomainArc>* arcs,
                     std::vector<Box4>* unresolved) {
  Clipper(s1, s2, arcs, unresolved).clip(tube, 0);
}

}  // namespace veritope
