// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/interval_boxes/chord_circle.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <vector>

#include "interval/box.h"
#include "interval/enclosure/surface_enclosure.h"
#include "interval/upward.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// |c2x / |c2|| for c2x, c2y >= 0: grows with c2x, falls with c2y.
Interval cosine(const std::array<Interval, 2>& c2) {
  const auto at = [](double x, double y) {
    if (x == 0) return Interval(0.0);
    return Interval(x) / sqrt(sqr(Interval(x)) + sqr(Interval(y)));
  };
  const bool may_be_zero = c2[0].lo() == 0 && c2[1].lo() == 0;
  const double lo = at(c2[0].lo(), c2[1].hi()).lo();
  const double hi = may_be_zero ? 1 : at(c2[0].hi(), c2[1].lo()).hi();
  return Interval::from_bounds(std::max(0.0, lo), std::min(1.0, hi));
}

Interval not_negative(const Interval& a) {
  return intersection(a, Interval::from_bounds(0, kInfinity));
}

struct SearchBox {
  std::vector<Interval> sides;
  double bound;
  friend bool operator<(const SearchBox& a, const SearchBox& b) { return a.bound < b.bound; }
};

// The greatest value of a function over a box of variables. range: encloses the function over a part, empty where the
// part has no feasible point; at: a lower bound of it at some feasible point of a part, -infinity if none was found.
// REQUIRES a live ScopedUpward.
struct Maximiser {
  std::function<Interval(const std::vector<Interval>&)> range;
  std::function<double(const std::vector<Interval>&)> at;

  RadiusEnclosure run(std::vector<Interval> all, const RadiusOptions& options) const {
    std::priority_queue<SearchBox> queue;
    RadiusEnclosure out;
    double least = -kInfinity;
    const auto widths = all;
    const auto push = [&](std::vector<Interval> sides) {
      ++out.boxes;
      const Interval r = range(sides);
      if (r.is_empty() || r.hi() <= least) return;
      least = std::max(least, at(sides));
      queue.push({std::move(sides), r.hi()});
    };
    push(std::move(all));
    while (!queue.empty()) {
      const SearchBox top = queue.top();
      const double bound = std::max(top.bound, least);
      if (least > 0 && bound <= least * (1 + options.relative_width)) break;
      if (out.boxes >= options.max_boxes) break;
      queue.pop();
      const std::size_t axis = widest(top.sides, widths);
      const Interval side = top.sides[axis];
      const double middle = mid(side);
      if (!(side.lo() < middle && middle < side.hi())) {
        queue.push(top);
        break;
      }
      for (const Interval& half :
           {Interval::from_bounds(side.lo(), middle), Interval::from_bounds(middle, side.hi())}) {
        auto sides = top.sides;
        sides[axis] = half;
        push(std::move(sides));
      }
    }
    const double greatest = queue.empty() ? least : std::max(queue.top().bound, least);
    if (!(greatest > -kInfinity)) return out.radius = Interval::empty(), out;
    out.radius = Interval::from_bounds(std::max(0.0, least), greatest);
    out.is_as_asked = greatest <= least * (1 + options.relative_width) || greatest == least;
    return out;
  }

  static std::size_t widest(const std::vector<Interval>& sides, const std::vector<Interval>& all) {
    std::size_t axis = 0;
    double most = -1;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const double whole = wid(all[k]), w = whole > 0 ? wid(sides[k]) / whole : 0;
      if (w > most) most = w, axis = k;
    }
    return axis;
  }
};

bool are_half_widths(const Interval& a) {
  return !a.is_empty() && a.lo() > 0 && std::isfinite(a.hi());
}
Error bad_half_widths() {
  return {Code::kBadArgument, {}, "half-widths of boxes that are not positive and finite"};
}

double sum_down(double a, double b) { return -(fenced(-a) + fenced(-b)); }

}  // namespace

Interval tangent_radius(const std::array<Interval, 2>& c2, const Interval& h_any) {
  const Interval h = not_negative(h_any);
  if (h.is_empty()) return h;
  const Interval two(2.0), four(4.0), sum = h + c2[1];
  const Interval above = sqr(c2[0]) + sqr(c2[1]) + four * h * sum;
  const Interval below = two * (h + sum + two * sqrt(h * sum) * cosine(c2));
  return not_negative(above / below);
}

Interval psi(const BoxPair& pair) {
  const Interval h = not_negative(pair.e1[1] + pair.e2[1] - pair.c2[1]);
  if (h.is_empty()) return h;
  // p lies on the right edge: h <= e1y, the same as c2y >= e2y.
  Interval out = Interval::empty();
  bool is_always_p = h.hi() <= pair.e1[1].lo();
  const Interval near = intersection(h, Interval::from_bounds(0, pair.e1[1].hi()));
  const Interval high = intersection(pair.c2[1], Interval::from_bounds(pair.e2[1].lo(), kInfinity));
  if (!near.is_empty() && !high.is_empty()) {
    const Interval &x = pair.c2[0], &px = pair.e1[0], two(2.0);
    const Interval c = sqr(x) + sqr(high), p = sqr(px) + sqr(near);
    const Interval cross = two * (x * near + high * px);
    // To the right of p it would meet l once more, outside of b1.
    const Interval centre = (c * near + high * p) / cross;
    is_always_p = is_always_p && centre.hi() <= px.lo();
    if (centre.lo() <= px.hi())
      out = sqrt(c) * sqrt(p) * sqrt(sqr(px - x) + sqr(high + near)) / cross;
  }
  return is_always_p ? out : hull(out, tangent_radius(pair.c2, h));
}

Result<RadiusEnclosure> greatest_chord_radius(const HalfWidths& half_widths,
                                              const RadiusOptions& options) {
  const auto& e = half_widths.range;
  if (!are_half_widths(e[0]) || !are_half_widths(e[1])) return bad_half_widths();
  const ScopedUpward upward;
  const Interval two(2.0);
  const auto pair_of = [](const std::vector<Interval>& v) {
    return BoxPair{{v[0], v[1]}, {v[2], v[4]}, {v[3], v[5]}};
  };
  Maximiser search;
  search.range = [&](const std::vector<Interval>& v) {
    if (v[0].lo() > (v[2] + v[3]).hi() || v[4].lo() > v[5].hi()) return Interval::empty();
    return psi(pair_of(v));
  };
  search.at = [&](const std::vector<Interval>& v) {
    std::array<double, 6> m;
    for (std::size_t k = 0; k < 6; ++k) m[k] = mid(v[k]);
    m[4] = std::min(m[4], m[5]);
    if (m[4] < e[1].lo()) return -kInfinity;
    m[0] = std::min(m[0], sum_down(m[2], m[3]));
    m[1] = std::min(m[1], sum_down(m[4], m[5]));
    std::vector<Interval> point;
    for (const double x : m) point.emplace_back(x);
    const Interval r = psi(pair_of(point));
    return r.is_empty() ? -kInfinity : r.lo();
  };
  const auto twice = [&](const Interval& a) { return Interval::from_bounds(0, (two * a).hi()); };
  return search.run({twice(e[0]), twice(e[1]), e[0], e[0], e[1], e[1]}, options);
}

Result<RadiusEnclosure> greatest_chord_radius(const std::array<Interval, 3>& half_widths,
                                              std::size_t up, const RadiusOptions& options) {
  if (up > 2) return Error{Code::kBadArgument, {}, "axis " + std::to_string(up) + " of space"};
  for (const Interval& e : half_widths)
    if (!are_half_widths(e)) return bad_half_widths();
  const ScopedUpward upward;
  const Interval two(2.0), e = half_widths[up];
  const Interval across =
      two * sqrt(sqr(half_widths[(up + 1) % 3]) + sqr(half_widths[(up + 2) % 3]));
  Maximiser search;
  search.range = [](const std::vector<Interval>& v) {
    return tangent_radius({v[0], v[1]}, v[2] + v[3] - v[1]);
  };
  search.at = [](const std::vector<Interval>& v) {
    const double a = mid(v[2]), b = mid(v[3]), y = std::min(mid(v[1]), sum_down(a, b));
    const Interval r =
        tangent_radius({Interval(mid(v[0])), Interval(y)}, Interval(a) + Interval(b) - Interval(y));
    return r.is_empty() ? -kInfinity : r.lo();
  };
  return search.run(
      {Interval::from_bounds(0, across.hi()), Interval::from_bounds(0, (two * e).hi()), e, e},
      options);
}

namespace {

// The greatest curvature turned into the least radius.
RadiusEnclosure radius_of(RadiusEnclosure curvature) {
  const Interval k = curvature.radius;
  curvature.radius = k.is_empty() ? Interval::from_bounds(0, kInfinity)
                     : k.hi() == 0
                         ? Interval::from_bounds(std::numeric_limits<double>::max(), kInfinity)
                         : recip(k);
  return curvature;
}

Error unbounded() {
  return {Code::kBadArgument,
          {},
          "the curvature is not bounded within the budget: a point without a tangent or normal?"};
}

// Knots inside the domain, or at the seam, at which the first derivative may jump.
template <std::size_t N>
bool may_have_corners(const BSpline<Rational, N>& map) {
  for (const auto& axis : map.axes())
    for (const Rational& u : axis.knots) {
      const bool is_joined = (axis.domain_begin() < u && u < axis.domain_end()) ||
                             (axis.is_periodic && u == axis.domain_begin());
      if (is_joined && multiplicity(axis, u) >= axis.degree) return true;
    }
  return false;
}

// curvature(enclosure, box): contains the absolute curvatures over a box of parameters.
template <std::size_t N, typename Curvature>
Result<RadiusEnclosure> least_radius(const BSpline<Rational, N>& map, const RadiusOptions& options,
                                     Curvature curvature) {
  if (may_have_corners(map))
    return Error{
        Code::kBadArgument,
        {},
        "there may be a corner at a knot of multiplicity degree or more: cut the map there"};
  const auto prepared = SplineEnclosure<N>::prepare(map, 3);
  if (!prepared) return prepared.error();
  if (prepared->dimension() != static_cast<int>(N) + 1)
    return Error{Code::kBadArgument,
                 {},
                 N == 1 ? "a curve that is not in the plane" : "a surface that is not in space"};
  const ScopedUpward upward;
  const auto over = [&](const std::vector<Interval>& v, auto part) {
    Box<N> at;
    for (std::size_t k = 0; k < N; ++k) at[k] = part(v[k]);
    return curvature(*prepared, at);
  };
  Maximiser search;
  search.range = [&](const std::vector<Interval>& v) {
    return over(v, [](const Interval& side) { return side; });
  };
  search.at = [&](const std::vector<Interval>& v) {
    return over(v, [](const Interval& side) { return Interval(mid(side)); }).lo();
  };
  const Box<N> domain = prepared->domain();
  const RadiusEnclosure greatest = search.run({domain.begin(), domain.end()}, options);
  if (!std::isfinite(greatest.radius.hi())) return unbounded();
  return radius_of(greatest);
}

}  // namespace

Result<RadiusEnclosure> least_curvature_radius(const BSpline<Rational, 1>& curve,
                                               const RadiusOptions& options) {
  return least_radius(curve, options, [](const SplineEnclosure<1>& at, const Box<1>& t) {
    const auto d = at.derivative({1}, t).value(), dd = at.derivative({2}, t).value();
    const Interval speed = sqr(d[0]) + sqr(d[1]);
    return abs(d[0] * dd[1] - d[1] * dd[0]) / (speed * sqrt(speed));
  });
}

Result<RadiusEnclosure> least_curvature_radius(const BSpline<Rational, 2>& surface,
                                               const RadiusOptions& options) {
  return least_radius(surface, options, [](const SplineEnclosure<2>& at, const Box2& uv) {
    const auto k = enclose_curvatures(at, uv).value();
    return max(abs(k.principal_min), abs(k.principal_max));
  });
}

std::optional<bool> satisfies_eq4(const RadiusEnclosure& r_max, const RadiusEnclosure& r_kappa) {
  if (r_max.radius.is_empty() || r_kappa.radius.is_empty()) return std::nullopt;
  if (r_max.radius.hi() <= r_kappa.radius.lo()) return true;
  if (r_max.radius.lo() > r_kappa.radius.hi()) return false;
  return std::nullopt;
}

}  // namespace veritope
