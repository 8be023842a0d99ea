// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/intersect/intersection_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "interval/box_geometry.h"

namespace veritope {
namespace {

constexpr int kMostHalvingsOfASegment = 12;
/// Limits the segments of a branch that come from halving: weights far apart make bounds that no halving improves.
constexpr std::size_t kMostSegments = 5000;
constexpr double kAny = std::numeric_limits<double>::infinity();

using internal::approx_middle;
using internal::dot, internal::norm;

/// An upper bound of |v|.
double norm_above(const Box3& v) { return norm(v).hi(); }

const std::vector<double>& nodes_of(std::size_t degree) {
  thread_local std::map<std::size_t, std::vector<double>> known;
  auto& nodes = known[degree];
  if (nodes.empty()) nodes = internal::chebyshev_nodes(degree);
  return nodes;
}

/// One coordinate of a cubic at t: an enclosure.
Interval cubic(const std::array<Point4, 4>& c, std::size_t i, const Interval& t) {
  const Interval s = Interval(1.0) - t, three(3.0);
  return s * s * (s * Interval(c[0][i]) + three * t * Interval(c[1][i])) +
         t * t * (three * s * Interval(c[2][i]) + t * Interval(c[3][i]));
}
Interval control_hull(const std::array<Point4, 4>& c, std::size_t i) {
  const auto [lo, hi] = std::minmax({c[0][i], c[1][i], c[2][i], c[3][i]});
  return Interval::from_bounds(lo, hi);
}

/// The span of an axis that holds an interval of parameters, and by how much the interval sticks out. At the domain's
/// ends pieces are continued, but no further than rounding goes.
struct SpanAt {
  std::size_t span = 0;
  double outside = 0;
};
SpanAt span_at(const EnclosedSurface& s, std::size_t axis, const Interval& x) {
  const auto& b = s.breaks(axis);
  const double m = approx_middle(x);
  const auto above = std::upper_bound(b.begin() + 1, b.end() - 1, m);
  SpanAt out;
  out.span = static_cast<std::size_t>(above - b.begin()) - 1;
  out.outside = std::max({0.0, b[out.span] - x.lo(), x.hi() - b[out.span + 1]});
  return out;
}

class Gap {
 public:
  Gap(const EnclosedSurface& s1, const EnclosedSurface& s2) : surfaces_{&s1, &s2} {}

  /// The bound. Infinite if the cubic leaves the pieces that hold its middle; not the least bound if it is above
  /// `give_up_above`.
  double of(const std::array<Point4, 4>& c, double give_up_above) const {
    std::array<SpanAt, 4> places;
    double slack = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const EnclosedSurface& s = *surfaces_[i / 2];
      const Interval x = control_hull(c, i);
      places[i] = span_at(s, i % 2, x);
      const auto& b = s.breaks(i % 2);
      const double span = b[places[i].span + 1] - b[places[i].span];
      if (places[i].outside > 0x1p-30 * span) return std::numeric_limits<double>::infinity();
    }
    for (std::size_t i = 0; i < 4; ++i)
      if (places[i].outside > 0) slack += places[i].outside * speed(c, places, i);
    const std::size_t degree = degree_of();
    double most = 0;
    // The inner nodes come first: cubics that touch at both ends are worst there.
    const std::vector<double>& nodes = nodes_of(degree);
    for (std::size_t k = 0; k < nodes.size() && most <= give_up_above; ++k) {
      const Interval at(nodes[(k + nodes.size() / 2) % nodes.size()]);
      const Box3 p = surfaces_[0]->point_of_piece(places[0].span, places[1].span, cubic(c, 0, at),
                                                  cubic(c, 1, at));
      const Box3 q = surfaces_[1]->point_of_piece(places[2].span, places[3].span, cubic(c, 2, at),
                                                  cubic(c, 3, at));
      most = std::max(most, norm_above(p - q));
    }
    // For rational pieces the numerator is the polynomial: |S1 - S2| = |numerator| / (w1 w2).
    double spread = 1;
    for (std::size_t k = 0; k < 2; ++k) {
      const Interval w =
          surfaces_[k]->weight_of_piece(places[2 * k].span, places[2 * k + 1].span,
                                        control_hull(c, 2 * k), control_hull(c, 2 * k + 1));
      if (!(w.lo() > 0)) return std::numeric_limits<double>::infinity();
      spread *= (Interval(w.hi()) / Interval(w.lo())).hi();
    }
    return internal::lebesgue_bound(degree) * most * spread + slack;
  }

 private:
  std::size_t degree_of() const {
    std::size_t sum = 0, most = 0;
    for (const EnclosedSurface* s : surfaces_) {
      const std::size_t degree = 3 * (s->degrees()[0] + s->degrees()[1]);
      sum += degree, most = std::max(most, degree);
    }
    return surfaces_[0]->is_rational() || surfaces_[1]->is_rational() ? sum : most;
  }
  /// How fast the surface and the piece, continued beyond its knot, may part there: both start from the same point.
  double speed(const std::array<Point4, 4>& c, const std::array<SpanAt, 4>& places,
               std::size_t i) const {
    const std::size_t k = i / 2;
    const Interval u = control_hull(c, 2 * k), v = control_hull(c, 2 * k + 1);
    const auto both = surfaces_[k]->range(u, v);
    const auto own = surfaces_[k]->range_of_piece(places[2 * k].span, places[2 * k + 1].span, u, v);
    return i % 2 == 0 ? norm_above(both.du) + norm_above(own.du)
                      : norm_above(both.dv) + norm_above(own.dv);
  }
  const EnclosedSurface* surfaces_[2];
};

class Tracer {
 public:
  Tracer(const EnclosedSurface& s1, const EnclosedSurface& s2, double gap)
      : s1_(s1), s2_(s2), gap_(s1, s2), wanted_(gap) {}

  void add_step(const DomainArc& arc, double from, double to) {
    add(arc.tube, at(arc.tube, from), at(arc.tube, to), 0);
  }
  std::vector<CurveSegment> take() { return std::move(out_); }

 private:
  struct Knot {
    double w;
    Box4 x;
    Point4 middle, rate;
  };
  Knot at(const IntersectionTube& tube, double w) const {
    Knot out{w, {}, {}, {}};
    out.x = locate(s1_, s2_, tube, w, &out.rate);
    out.middle = approx_middle(out.x);
    return out;
  }

  bool may_halve(int halvings) const {
    return halvings < kMostHalvingsOfASegment && out_.size() < kMostSegments;
  }
  void add(const IntersectionTube& tube, const Knot& a, const Knot& b, int halvings) {
    CurveSegment segment;
    const double third = (b.w - a.w) / 3;
    for (std::size_t i = 0; i < 4; ++i) {
      segment.control[0][i] = a.middle[i];
      segment.control[1][i] = a.middle[i] + third * a.rate[i];
      segment.control[2][i] = b.middle[i] - third * b.rate[i];
      segment.control[3][i] = b.middle[i];
    }
    segment.gap = gap_.of(segment.control, may_halve(halvings) ? wanted_ : kAny);
    if (segment.gap > wanted_ && may_halve(halvings)) {
      const Knot m = at(tube, cut_place(tube, a, b));
      add(tube, a, m, halvings + 1);
      add(tube, m, b, halvings + 1);
      return;
    }
    if (std::isinf(segment.gap)) segment.gap = gap_of_short(segment.control);
    describe(tube, a, b, &segment);
    out_.push_back(segment);
  }

  /// Where the arc passes a knot of a surface, if it does between a and b, else the middle.
  double cut_place(const IntersectionTube& tube, const Knot& a, const Knot& b) const {
    const double half = a.w + 0.5 * (b.w - a.w);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& breaks = (i < 2 ? s1_ : s2_).breaks(i % 2);
      const auto [lo, hi] = std::minmax(a.middle[i], b.middle[i]);
      const double margin = 0x1p-34 * (hi - lo);
      const auto knot = std::upper_bound(breaks.begin(), breaks.end(), lo + margin);
      if (knot == breaks.end() || *knot >= hi - margin) continue;
      double w = half, w0 = a.w, w1 = b.w;
      for (int step = 0; step < 60 && std::abs(w1 - w0) > 0x1p-50 * std::abs(b.w); ++step) {
        const Knot m = at(tube, w);
        const double value = m.middle[i] - *knot;
        ((value < 0) == (a.middle[i] < *knot) ? w0 : w1) = w;
        const double newton = w - value / m.rate[i];
        if (std::abs(value) <= 0x1p-50 * std::max(std::abs(*knot), hi - lo)) break;
        w = newton > std::min(w0, w1) && newton < std::max(w0, w1) ? newton : w0 + 0.5 * (w1 - w0);
      }
      if (w != a.w && w != b.w) return w;
    }
    return half;
  }

  /// A bound of first order only, for pieces across knots that are too short to be halved.
  double gap_of_short(const std::array<Point4, 4>& c) const {
    const auto r1 = s1_.range(control_hull(c, 0), control_hull(c, 1));
    const auto r2 = s2_.range(control_hull(c, 2), control_hull(c, 3));
    return norm_above(r1.point - r2.point);
  }

  void describe(const IntersectionTube& tube, const Knot& a, const Knot& b,
                CurveSegment* segment) const {
    const Interval w = Interval::from_bounds(std::min(a.w, b.w), std::max(a.w, b.w));
    const Box4 ends = hull(a.x, b.x);
    Box4 x = tube.over(w);
    const Interval step = w - Interval(a.w);
    for (std::size_t i = 0; i < 4; ++i)
      x[i] = hull(ends[i], intersection(x[i], a.x[i] + tube.derivative[i] * step));
    segment->parameters = x;
    const auto r1 = s1_.range(x[0], x[1]), r2 = s2_.range(x[2], x[3]);
    segment->space = intersection(r1.point, r2.point);
    if (segment->space.is_empty()) segment->space = r1.point;
    segment->length = length_of(derivative_over(tube, r1.du, r1.dv, r2.du, r2.dv), a, b, r1);
  }

  /// The length is at least the chord. It is at most the integral of t.e times the greatest |t| / t.e, where t are the
  /// tangents and e is a unit vector along the chord; the integral is the chord's own component along e.
  Interval length_of(const Box4& derivative, const Knot& a, const Knot& b,
                     const EnclosedSurface::Range& range) const {
    const Interval sign(b.w < a.w ? -1.0 : 1.0);
    Box3 tangent;
    for (std::size_t c = 0; c < 3; ++c)
      tangent[c] = sign * (range.du[c] * derivative[0] + range.dv[c] * derivative[1]);
    const Box3 chord = s1_.range(b.x[0], b.x[1]).point - s1_.range(a.x[0], a.x[1]).point;
    const Interval length = norm(chord);
    const Interval steps = Interval(std::max(a.w, b.w)) - Interval(std::min(a.w, b.w));
    double above = (norm(tangent) * steps).hi();
    const Box3 middles(Interval(approx_middle(chord[0])), Interval(approx_middle(chord[1])),
                       Interval(approx_middle(chord[2])));
    const Interval size = norm(middles);
    if (size.lo() > 0) {
      const Box3 e(middles[0] / size, middles[1] / size, middles[2] / size);
      const Interval along = dot(tangent, e);
      if (along.lo() > 0) {
        Box3 across;  // (identity - e e^T) t
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j)
            across[i] = across[i] + (Interval(i == j ? 1.0 : 0.0) - e[i] * e[j]) * tangent[j];
        const Interval tilt = Interval(norm(across).hi()) / Interval(along.lo());
        above = std::min(above, (dot(chord, e) * sqrt(Interval(1.0) + sqr(tilt))).hi());
      }
    }
    return Interval::from_bounds(std::min(std::max(0.0, length.lo()), above), above);
  }

  const EnclosedSurface &s1_, &s2_;
  Gap gap_;
  double wanted_;
  std::vector<CurveSegment> out_;
};

}  // namespace

namespace internal {

std::vector<double> chebyshev_nodes(std::size_t degree) {
  std::vector<double> nodes;
  const double n = static_cast<double>(degree) + 1;
  for (std::size_t k = 0; k <= degree; ++k)
    nodes.push_back(0.5 +
                    0.5 * std::cos((2 * static_cast<double>(k) + 1) * std::numbers::pi / (2 * n)));
  return nodes;
}

double lebesgue_bound(std::size_t degree) {
  return 1.001 * (0.6366197724 * std::log(static_cast<double>(degree) + 1) + 1);
}

}  // namespace internal

std::vector<CurveSegment> trace_branch(const EnclosedSurface& s1, const EnclosedSurface& s2,
                                       const BranchSet& set, const BranchChain& chain, double gap) {
  Tracer tracer(s1, s2, gap);
  for (const BranchStep& step : chain.steps)
    tracer.add_step(set.arcs[step.arc], step.from, step.to);
  return tracer.take();
}

Box4 box_over(const EnclosedSurface& s1, const EnclosedSurface& s2, const DomainArc& arc,
              const Interval& place, double inner) {
  const Box4 at = locate(s1, s2, arc.tube, inner);
  const Interval step = place - Interval(inner);
  Box4 out;
  for (std::size_t i = 0; i < 4; ++i) out[i] = at[i] + arc.tube.derivative[i] * step;
  return out;
}

double length_over(const EnclosedSurface& s1, const DomainArc& arc, const Interval& place) {
  const Box4 x = arc.tube.over(place);
  const auto range = s1.range(x[0], x[1]);
  Box3 tangent;
  for (std::size_t c = 0; c < 3; ++c)
    tangent[c] = range.du[c] * arc.tube.derivative[0] + range.dv[c] * arc.tube.derivative[1];
  return (norm(tangent) * (Interval(place.hi()) - Interval(place.lo()))).hi();
}

double gap_of_cubic(const EnclosedSurface& s1, const EnclosedSurface& s2,
                    const std::array<Point4, 4>& control) {
  return Gap(s1, s2).of(control, kAny);
}

}  // namespace veritope
