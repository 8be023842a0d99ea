// SPDX-License-Identifier: LGPL-3.0-or-later
#include <cmath>
#include <vector>

#include "interval/box_geometry.h"
#include "solids/classify/distance_net_internal.h"
#include "splines/de_casteljau.h"

namespace veritope::internal {

namespace {

// The hull of the net's differences along two axes, times the factor of the derivative; second = 2: along one only.
Interval difference_hull(const std::vector<Interval>& c, const Grid<2>& grid, std::size_t first,
                         std::size_t second) {
  std::array<std::size_t, 2> reach{};
  ++reach[first];
  if (second < 2) ++reach[second];
  double factor = 1;
  for (std::size_t a = 0; a < 2; ++a) {
    if (reach[a] >= grid.size[a]) return Interval();
    for (std::size_t i = 1; i <= reach[a]; ++i) factor *= static_cast<double>(grid.size[a] - i);
  }
  const std::size_t s = grid.stride(first), t = second < 2 ? grid.stride(second) : 0;
  Interval out = Interval::empty();
  for (std::size_t i = 0; i + reach[0] < grid.size[0]; ++i)
    for (std::size_t j = 0; j + reach[1] < grid.size[1]; ++j) {
      const Interval* const p = c.data() + grid.at({i, j});
      Interval d = p[s] - p[0];
      if (second < 2) d = (p[s + t] - p[t]) - d;
      out = hull(out, d);
    }
  return Interval(factor) * out;
}

// The homogeneous net moved so that q is the origin: its components, the weight last.
std::array<std::vector<Interval>, 4> moved_net(const Box3& q, const BezierSurface<Interval>& net) {
  std::array<std::vector<Interval>, 4> out;
  const std::size_t n = net.component(0).size();
  out[3].assign(n, Interval(1.0));
  if (net.is_rational()) out[3].assign(net.component(3).begin(), net.component(3).end());
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < n; ++i)
      out[c].push_back(net.component(static_cast<int>(c))[i] - q[c] * out[3][i]);
  return out;
}

// For f = Y / w: f_s = (Y_s - f w_s) / w, f_st = (Y_st - f_s w_t - f_t w_s - f w_st) / w.
struct QuotientBounds {
  Box3 f;
  std::array<Box3, 2> first;
  std::array<Box3, 3> second;
};

QuotientBounds quotient_bounds(const Box3& q, const BezierSurface<Interval>& net) {
  const auto y = moved_net(q, net);
  const Grid<2> grid = net.grid();
  QuotientBounds out;
  Interval w = Interval::empty();
  out.f = Box3::empty();
  for (std::size_t i = 0; i < y[3].size(); ++i) {
    w = hull(w, y[3][i]);
    out.f = hull(out.f, Box3(y[0][i] / y[3][i], y[1][i] / y[3][i], y[2][i] / y[3][i]));
  }
  constexpr std::array<std::array<std::size_t, 2>, 3> kPairs{{{0, 0}, {0, 1}, {1, 1}}};
  std::array<Interval, 2> w1;
  std::array<Interval, 3> w2;
  if (net.is_rational()) {
    for (std::size_t a = 0; a < 2; ++a) w1[a] = difference_hull(y[3], grid, a, 2);
    for (std::size_t k = 0; k < 3; ++k)
      w2[k] = difference_hull(y[3], grid, kPairs[k][0], kPairs[k][1]);
  }
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t a = 0; a < 2; ++a)
      out.first[a][c] = (difference_hull(y[c], grid, a, 2) - out.f[c] * w1[a]) / w;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = kPairs[k];
      out.second[k][c] = (difference_hull(y[c], grid, a, b) - out.first[a][c] * w1[b] -
                          out.first[b][c] * w1[a] - out.f[c] * w2[k]) /
                         w;
    }
  }
  return out;
}

}  // namespace

bool DistanceBounds::is_convex() const {
  return second[0].sign() == Sign3::kPositive && second[2].sign() == Sign3::kPositive &&
         (second[0] * second[2] - sqr(second[1])).sign() == Sign3::kPositive;
}

DistanceBounds distance_bounds(const Box3& q, const BezierSurface<Interval>& net) {
  const QuotientBounds b = quotient_bounds(q, net);
  DistanceBounds out;
  for (std::size_t a = 0; a < 2; ++a) out.first[a] = dot(b.f, b.first[a]);
  out.second[0] =
      sqr(b.first[0][0]) + sqr(b.first[0][1]) + sqr(b.first[0][2]) + dot(b.f, b.second[0]);
  out.second[1] = dot(b.first[0], b.first[1]) + dot(b.f, b.second[1]);
  out.second[2] =
      sqr(b.first[1][0]) + sqr(b.first[1][1]) + sqr(b.first[1][2]) + dot(b.f, b.second[2]);
  return out;
}

std::array<Interval, 2> distance_gradient_at_corner(const Box3& q,
                                                    const BezierSurface<Interval>& net) {
  const Grid<2> grid = net.grid();
  const auto y = moved_net(q, net);
  const Interval w = y[3][0];
  const Box3 f(y[0][0] / w, y[1][0] / w, y[2][0] / w);
  std::array<Interval, 2> out;
  for (std::size_t a = 0; a < 2; ++a) {
    const std::size_t step = grid.stride(a);
    const Interval degree(static_cast<double>(grid.size[a] - 1));
    const Interval w1 = degree * (y[3][step] - w);
    Box3 d;
    for (std::size_t c = 0; c < 3; ++c) d[c] = (degree * (y[c][step] - y[c][0]) - f[c] * w1) / w;
    out[a] = dot(f, d);
  }
  return out;
}

BezierSurface<Interval> net_over(const BezierSurface<Interval>& net, const Box2& part) {
  BezierSurface<Interval> out = net;
  for (std::size_t a = 0; a < 2; ++a) {
    const Interval lo(part[a].lo()), hi(part[a].hi());
    if (part[a].hi() < 1) out = left_part(std::move(out), a, hi);
    if (part[a].lo() > 0) out = right_part(std::move(out), a, Interval(lo / hi));
  }
  return out;
}

Box3 hull_of_net(const BezierSurface<Interval>& net) {
  Box3 out = Box3::empty();
  for (std::size_t i = 0; i < net.component(0).size(); ++i) {
    Box3 p(net.component(0)[i], net.component(1)[i], net.component(2)[i]);
    if (net.is_rational())
      for (std::size_t c = 0; c < 3; ++c) p[c] = p[c] / net.component(3)[i];
    out = hull(out, p);
  }
  return out;
}

Box2 contracted(const Box3& q, const BezierSurface<Interval>& net, const Box2& within) {
  Box2 box = within;
  for (int round = 0; round < 8; ++round) {
    const BezierSurface<Interval> part = net_over(net, box);
    const DistanceBounds all = distance_bounds(q, part);
    // The gradient at the middle, in the units of the part: the half's is half as large.
    BezierSurface<Interval> half = right_part(part, 0, Interval(0.5));
    half = right_part(std::move(half), 1, Interval(0.5));
    const std::array<Interval, 2> corner = distance_gradient_at_corner(q, half);
    const std::array<Interval, 2> at{Interval(2.0) * corner[0], Interval(2.0) * corner[1]};
    // An approximate inverse of the matrix of second derivatives.
    const double a = approx_middle(all.second[0]), b = approx_middle(all.second[1]),
                 d = approx_middle(all.second[2]), det = a * d - b * b;
    if (!std::isfinite(1 / det)) return box;
    const std::array<std::array<Interval, 2>, 2> y{
        {{Interval(d / det), Interval(-b / det)}, {Interval(-b / det), Interval(a / det)}}};
    const std::array<std::array<Interval, 2>, 2> h{
        {{all.second[0], all.second[1]}, {all.second[1], all.second[2]}}};
    const Interval reach = Interval::from_bounds(-0.5, 0.5), one(1.0), zero;
    Box2 next;
    bool shrinks = false;
    for (std::size_t i = 0; i < 2; ++i) {
      Interval x = Interval(0.5) - (y[i][0] * at[0] + y[i][1] * at[1]);
      for (std::size_t k = 0; k < 2; ++k)
        x += ((i == k ? one : zero) - (y[i][0] * h[0][k] + y[i][1] * h[1][k])) * reach;
      x = intersection(x, Interval::from_bounds(0.0, 1.0));
      if (x.is_empty()) return Box2::empty();
      const Interval lo(box[i].lo()), size = Interval(box[i].hi()) - lo;
      next[i] = intersection(lo + size * x, box[i]);
      shrinks = shrinks || wid(next[i]) < 0.75 * wid(box[i]);
    }
    if (next.is_empty()) return next;
    box = next;
    if (!shrinks || wid(box[0]) <= 0 || wid(box[1]) <= 0) break;
  }
  return box;
}

Interval contracted_curve(const Box3& q, const BezierSurface<Interval>& net,
                          const Interval& within) {
  Interval box = within;
  for (int round = 0; round < 8; ++round) {
    const BezierSurface<Interval> part = net_over(net, Box2(box, Interval::from_bounds(0.0, 1.0)));
    const Interval slope = distance_bounds(q, part).second[0];
    if (slope.sign() != Sign3::kPositive) return box;
    const BezierSurface<Interval> half = right_part(part, 0, Interval(0.5));
    const Interval at = Interval(2.0) * distance_gradient_at_corner(q, half)[0];
    const Interval x = intersection(Interval(0.5) - at / slope, Interval::from_bounds(0.0, 1.0));
    if (x.is_empty()) return x;
    const Interval lo(box.lo()), next = intersection(lo + (Interval(box.hi()) - lo) * x, box);
    const bool shrinks = wid(next) < 0.75 * wid(box);
    box = next;
    if (box.is_empty() || !shrinks || wid(box) <= 0) break;
  }
  return box;
}

}  // namespace veritope::internal
