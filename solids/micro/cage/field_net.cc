// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "solids/micro/cage/field_net_internal.h"

namespace veritope::internal {
namespace {

constexpr int kMostSteps = 40;
constexpr double kLongestStep = 0.75;  // in spans

// Solves a x = b in place by elimination with pivots. REQUIRES a regular matrix.
void solve_dense(std::vector<std::vector<double>> a, std::vector<std::vector<Point3d>>& rights) {
  const std::size_t n = a.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < n; ++r)
      if (std::abs(a[r][c]) > std::abs(a[pivot][c])) pivot = r;
    std::swap(a[c], a[pivot]);
    for (auto& right : rights) std::swap(right[c], right[pivot]);
    for (std::size_t r = c + 1; r < n; ++r) {
      const double f = a[r][c] / a[c][c];
      if (f == 0) continue;
      for (std::size_t k = c; k < n; ++k) a[r][k] -= f * a[c][k];
      for (auto& right : rights) add_times(right[r], -f, right[c]);
    }
  }
  for (auto& right : rights)
    for (std::size_t c = n; c-- > 0;) {
      for (std::size_t k = c + 1; k < n; ++k) add_times(right[c], -a[c][k], right[k]);
      for (double& x : right[c]) x /= a[c][c];
    }
}

}  // namespace

double FieldAxis::knot(std::size_t i) const {
  const auto p = static_cast<std::size_t>(degree_);
  return i <= p ? 0 : static_cast<double>(std::min(i - p, spans_));
}

std::vector<double> FieldAxis::greville() const {
  std::vector<double> out;
  for (std::size_t i = 0; i < num_control(); ++i) {
    double sum = 0;
    for (std::size_t k = 1; k <= static_cast<std::size_t>(degree_); ++k) sum += knot(i + k);
    out.push_back(sum / degree_);
  }
  return out;
}

AxisWeights FieldAxis::weights(double at) const {
  const double floor = std::floor(at);
  const auto p = static_cast<std::size_t>(degree_);
  const std::size_t span = floor <= 0 ? 0 : std::min(static_cast<std::size_t>(floor), spans_ - 1);
  const std::size_t k = span + p;  // the knot at which the span begins
  AxisWeights out;
  out.first = span;
  out.count = p + 1;
  // Row d: the d + 1 splines of degree d from number k - d on, with their derivatives.
  std::array<std::array<double, kMaxFitDegree + 1>, 3> below{}, row{};
  below[0][0] = 1;
  for (std::size_t d = 1; d <= p; ++d) {
    for (auto& r : row) r.fill(0);
    for (std::size_t j = 0; j <= d; ++j) {
      const std::size_t i = k - d + j;
      const auto degree = static_cast<double>(d);
      if (j > 0) {  // the spline of degree d - 1 with number i
        const double width = knot(i + d) - knot(i), f = (at - knot(i)) / width;
        row[0][j] += f * below[0][j - 1];
        row[1][j] += degree / width * below[0][j - 1];
        row[2][j] += degree / width * below[1][j - 1];
      }
      if (j < d) {  // the one after it
        const double width = knot(i + d + 1) - knot(i + 1), f = (knot(i + d + 1) - at) / width;
        row[0][j] += f * below[0][j];
        row[1][j] -= degree / width * below[0][j];
        row[2][j] -= degree / width * below[1][j];
      }
    }
    below = row;
  }
  out.of = below;
  return out;
}

FieldNet::FieldNet(const CageGrid& g)
    : axes{FieldAxis(g.degrees[0], g.spans[0]), FieldAxis(g.degrees[1], g.spans[1]),
           FieldAxis(g.degrees[2], g.spans[2])} {
  for (std::size_t k = 0; k < 3; ++k) grid.size[k] = axes[k].num_control();
  points.resize(grid.count());
}

std::array<AxisWeights, 3> FieldNet::weights(const Parameters3& at) const {
  return {axes[0].weights(at[0]), axes[1].weights(at[1]), axes[2].weights(at[2])};
}

FieldJet FieldNet::jet(const std::array<AxisWeights, 3>& weights) const {
  const auto& [u, v, w] = weights;
  FieldJet out;
  for (std::size_t i = 0; i < u.count; ++i) {
    // Values and derivatives along v, values along w, and so on: [v][w].
    std::array<std::array<Point3d, 3>, 2> sum{};
    for (std::size_t j = 0; j < v.count; ++j) {
      const Point3d* const line = &points[grid.at({u.first + i, v.first + j, w.first})];
      std::array<Point3d, 3> s{};
      for (std::size_t k = 0; k < w.count; ++k)
        for (std::size_t d = 0; d < 3; ++d) add_times(s[d], w.of[d][k], line[k]);
      for (std::size_t d = 0; d < 3; ++d) add_times(sum[0][d], v.of[0][j], s[d]);
      for (std::size_t d = 0; d < 2; ++d) add_times(sum[1][d], v.of[1][j], s[d]);
    }
    const double value = u.of[0][i], slope = u.of[1][i];
    add_times(out.point, value, sum[0][0]);
    add_times(out.along[0], slope, sum[0][0]);
    add_times(out.along[1], value, sum[1][0]);
    add_times(out.along[2], value, sum[0][1]);
    add_times(out.along_w[0], slope, sum[0][1]);
    add_times(out.along_w[1], value, sum[1][1]);
    add_times(out.along_w[2], value, sum[0][2]);
  }
  return out;
}

std::optional<Parameters3> FieldNet::locate(const Point3d& p, const Parameters3& start,
                                            double beyond) const {
  Parameters3 at = start;
  for (int step = 0; step < kMostSteps; ++step) {
    const FieldJet j = jet(weights(at));
    const double det = j.det();
    if (!(det > 0)) return std::nullopt;
    const Point3d off = {p[0] - j.point[0], p[1] - j.point[1], p[2] - j.point[2]};
    Parameters3 move = {dot(off, cross(j.along[1], j.along[2])) / det,
                        dot(off, cross(j.along[2], j.along[0])) / det,
                        dot(off, cross(j.along[0], j.along[1])) / det};
    double longest = 0;
    for (const double x : move) longest = std::max(longest, std::abs(x));
    if (!std::isfinite(longest)) return std::nullopt;
    const double part = longest > kLongestStep ? kLongestStep / longest : 1;
    for (std::size_t k = 0; k < 3; ++k)
      at[k] = std::clamp(at[k] + part * move[k], -beyond,
                         static_cast<double>(axes[k].spans()) + beyond);
    if (longest > 1e-9) continue;
    // A point that is held at the limit keeps a move.
    return at;
  }
  return std::nullopt;
}

FieldNet FieldNet::on_box(const Parameters3& low, const Parameters3& high) const {
  FieldNet out = *this;
  std::array<std::vector<std::vector<double>>, 3> matrices;
  std::array<std::vector<AxisWeights>, 3> places;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto spans = static_cast<double>(axes[k].spans());
    for (const double g : axes[k].greville()) {
      places[k].push_back(axes[k].weights(low[k] + (high[k] - low[k]) * (g / spans)));
      const AxisWeights own = axes[k].weights(g);
      auto& row = matrices[k].emplace_back(axes[k].num_control(), 0.0);
      for (std::size_t i = 0; i < own.count; ++i) row[own.first + i] = own.of[0][i];
    }
  }
  for (std::size_t n = 0; n < grid.count(); ++n) {
    const auto i = grid.index_of(n);
    out.points[n] = jet({places[0][i[0]], places[1][i[1]], places[2][i[2]]}).point;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<std::vector<Point3d>> lines;
    std::vector<std::size_t> firsts;
    const std::size_t stride = grid.stride(k);
    grid.for_each_line(k, [&](std::size_t first) {
      firsts.push_back(first);
      auto& line = lines.emplace_back();
      for (std::size_t i = 0; i < grid.size[k]; ++i) line.push_back(out.points[first + i * stride]);
    });
    solve_dense(matrices[k], lines);
    for (std::size_t l = 0; l < lines.size(); ++l)
      for (std::size_t i = 0; i < grid.size[k]; ++i)
        out.points[firsts[l] + i * stride] = lines[l][i];
  }
  return out;
}

CellVolume FieldNet::cell(const CageGrid& g, const Rational& scale, const CellPoint& shift) const {
  std::array<KnotAxis<Rational>, 3> knots;
  for (std::size_t k = 0; k < 3; ++k) knots[k] = cage_axis(g, k);
  std::vector<Rational> all;
  for (std::size_t k = 0; k < 3; ++k)
    for (const Point3d& p : points) all.push_back(Rational::from_double(p[k]) * scale + shift[k]);
  return CellVolume(std::move(knots), 3, false, std::move(all));
}

}  // namespace veritope::internal
