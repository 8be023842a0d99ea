// SPDX-License-Identifier: LGPL-3.0-or-later
#include <cmath>
#include <vector>

#include "interval/box_geometry.h"
#include "robust/base/box3d.h"
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

std::array<Interval, 2> distance_gradient(const Box3& q, const BezierSurface<Interval>& net,
                                          const std::array<double, 2>& at) {
  // The larger part on one side of the parameters has them in a corner, where derivatives are differences.
  BezierSurface<Interval> part = net;
  std::array<bool, 2> is_end{};
  std::array<Interval, 2> size;
  for (std::size_t a = 0; a < 2; ++a) {
    const Interval t(at[a]);
    is_end[a] = at[a] > 0.5;
    size[a] = is_end[a] ? t : Interval(1.0) - t;
    part = is_end[a] ? left_part(std::move(part), a, t) : right_part(std::move(part), a, t);
  }
  const Grid<2> grid = part.grid();
  const auto y = moved_net(q, part);
  const std::size_t n =
      grid.at({is_end[0] ? grid.size[0] - 1 : 0, is_end[1] ? grid.size[1] - 1 : 0});
  const Interval w = y[3][n];
  const Box3 f(y[0][n] / w, y[1][n] / w, y[2][n] / w);
  std::array<Interval, 2> out;
  for (std::size_t a = 0; a < 2; ++a) {
    const std::size_t step = grid.stride(a), other = is_end[a] ? n - step : n + step;
    const double degree = static_cast<double>(grid.size[a] - 1) * (is_end[a] ? -1 : 1);
    const Interval factor = Interval(degree) / size[a], w1 = factor * (y[3][other] - w);
    Box3 d;
    for (std::size_t c = 0; c < 3; ++c) d[c] = (factor * (y[c][other] - y[c][n]) - f[c] * w1) / w;
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

std::array<Box3, 2> first_derivatives(const BezierSurface<Interval>& net, const Box2& part) {
  const BezierSurface<Interval> over = net_over(net, part);
  // With the origin near the part, so that numbers of rational maps are small.
  const Point3d middle = approx_middle(hull_of_net(over));
  const QuotientBounds bounds =
      quotient_bounds(Box3(Interval(middle[0]), Interval(middle[1]), Interval(middle[2])), over);
  std::array<Box3, 2> out;
  for (std::size_t a = 0; a < 2; ++a) {
    const Interval size = Interval(part[a].hi()) - Interval(part[a].lo());
    for (std::size_t c = 0; c < 3; ++c) out[a][c] = bounds.first[a][c] / size;
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

namespace {

// Second derivatives are taken over parts that are wider than this: in smaller ones they are lost in rounding.
constexpr double kNarrow = 0x1p-12;
constexpr int kMaxRounds = 12;

// The second derivatives over a part of the square, by the square's parameters.
std::array<Interval, 3> second_over(const Box3& q, const BezierSurface<Interval>& net,
                                    const Box2& part) {
  std::array<Interval, 3> out = distance_bounds(q, net_over(net, part)).second;
  const Interval u = Interval(part[0].hi()) - Interval(part[0].lo()),
                 v = Interval(part[1].hi()) - Interval(part[1].lo());
  out[0] = out[0] / (u * u);
  out[1] = out[1] / (u * v);
  out[2] = out[2] / (v * v);
  return out;
}

}  // namespace

Box2 contracted(const Box3& q, const BezierSurface<Interval>& net, const Box2& within) {
  Box2 box = within;
  std::array<Interval, 3> second;
  for (int round = 0; round < kMaxRounds; ++round) {
    if (round == 0 || (wid(box[0]) > kNarrow && wid(box[1]) > kNarrow))
      second = second_over(q, net, box);
    const std::array<double, 2> middle{mid(box[0]), mid(box[1])};
    const std::array<Interval, 2> at = distance_gradient(q, net, middle);
    // An approximate inverse of the matrix of second derivatives.
    const double a = approx_middle(second[0]), b = approx_middle(second[1]),
                 d = approx_middle(second[2]), det = a * d - b * b;
    if (!std::isfinite(1 / det)) return box;
    const std::array<std::array<Interval, 2>, 2> y{
        {{Interval(d / det), Interval(-b / det)}, {Interval(-b / det), Interval(a / det)}}};
    const std::array<std::array<Interval, 2>, 2> h{
        {{second[0], second[1]}, {second[1], second[2]}}};
    const std::array<Interval, 2> reach{box[0] - Interval(middle[0]), box[1] - Interval(middle[1])};
    Box2 next;
    bool shrinks = false;
    for (std::size_t i = 0; i < 2; ++i) {
      Interval x = Interval(middle[i]) - (y[i][0] * at[0] + y[i][1] * at[1]);
      for (std::size_t k = 0; k < 2; ++k)
        x += (Interval(i == k ? 1.0 : 0.0) - (y[i][0] * h[0][k] + y[i][1] * h[1][k])) * reach[k];
      next[i] = intersection(x, box[i]);
      if (next[i].is_empty()) return Box2::empty();
      shrinks = shrinks || wid(next[i]) < 0.75 * wid(box[i]);
    }
    box = next;
    if (!shrinks) break;
  }
  return box;
}

Interval contracted_curve(const Box3& q, const BezierSurface<Interval>& net,
                          const Interval& within) {
  Interval box = within, slope;
  for (int round = 0; round < kMaxRounds; ++round) {
    if (round == 0 || wid(box) > kNarrow)
      slope = second_over(q, net, Box2(box, Interval::from_bounds(0.0, 1.0)))[0];
    if (slope.sign() != Sign3::kPositive) return box;
    const double middle = mid(box);
    const Interval at = distance_gradient(q, net, {middle, 0.0})[0];
    const Interval next = intersection(Interval(middle) - at / slope, box);
    const bool shrinks = next.is_empty() || wid(next) < 0.75 * wid(box);
    box = next;
    if (box.is_empty() || !shrinks) break;
  }
  return box;
}

}  // namespace veritope::internal
