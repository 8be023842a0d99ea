// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "solids/micro/filter/cell_net_internal.h"
#include "splines/de_casteljau.h"

namespace veritope::internal {

namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr std::size_t kSmallNet = 64;  // tricubic

// Contracts a net along its last axis, then along the one before, until one number is left; `work` is overwritten.
Interval net_value(Interval* work, const Grid<3>& grid,
                   const std::array<AffineBlend<Interval>, 3>& at) {
  std::size_t lines = grid.size[0] * grid.size[1];
  for (std::size_t axis = 3; axis-- > 0;) {
    const std::size_t size = grid.size[axis];
    for (std::size_t line = 0; line < lines; ++line) {
      Interval* const p = work + line * size;
      keep_right(p, 1, static_cast<int>(size) - 1, at[axis]);
      work[line] = p[0];
    }
    if (axis > 0) lines = axis == 2 ? grid.size[0] : 1;
  }
  return work[0];
}

// The hull of the derivative of a net along two axes, or along one of them (second = 3).
Interval derivative_hull(std::span<const Interval> c, const Grid<3>& grid, std::size_t first,
                         std::size_t second) {
  std::array<std::size_t, 3> reach{};
  ++reach[first];
  if (second < 3) ++reach[second];
  double factor = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    if (reach[a] >= grid.size[a]) return Interval();
    for (std::size_t i = 1; i <= reach[a]; ++i) factor *= static_cast<double>(grid.size[a] - i);
  }
  const std::size_t s = grid.stride(first), t = second < 3 ? grid.stride(second) : 0;
  bool is_begun = false;
  Interval out;
  for (std::size_t i = 0; i + reach[0] < grid.size[0]; ++i)
    for (std::size_t j = 0; j + reach[1] < grid.size[1]; ++j)
      for (std::size_t k = 0; k + reach[2] < grid.size[2]; ++k) {
        const Interval* const p = c.data() + grid.at({i, j, k});
        Interval d = p[s] - p[0];
        if (second < 3) d = (p[s + t] - p[t]) - d;
        out = is_begun ? hull(out, d) : d;
        is_begun = true;
      }
  return Interval(factor) * out;
}

}  // namespace

CellNet::CellNet(const BezierVolume<Rational>& map)
    : net_(map.degrees(), map.num_components(), map.is_rational()) {
  VT_CHECK(map.dimension() == 3, "the map of a cell has three coordinates");
  for (std::size_t i = 0; i < net_.coefficients().size(); ++i)
    net_.coefficients()[i] = enclose(map.coefficients()[i]);
  find_hull();
}

CellNet::CellNet(BezierVolume<Interval> net) : net_(std::move(net)) { find_hull(); }

void CellNet::find_hull() {
  hull_ = empty_box();
  for (std::size_t i = 0; i < net_.grid().count(); ++i) {
    Box3 p(net_.component(0)[i], net_.component(1)[i], net_.component(2)[i]);
    if (net_.is_rational()) {
      const Interval& w = net_.component(3)[i];
      if (w.sign() != Sign3::kPositive) {
        hull_ = {{-kUnbounded, -kUnbounded, -kUnbounded}, {kUnbounded, kUnbounded, kUnbounded}};
        return;
      }
      for (std::size_t c = 0; c < 3; ++c) p[c] = p[c] / w;
    }
    hull_ = veritope::hull(hull_, outer_box(p));
  }
}

Box3 CellNet::values(const Box3& at) const {
  std::array<AffineBlend<Interval>, 3> blends;
  for (std::size_t a = 0; a < 3; ++a) blends[a] = {Interval(1.0) - at[a], at[a]};
  const Grid<3> grid = net_.grid();
  std::array<Interval, kSmallNet> small;
  std::vector<Interval> large(grid.count() > kSmallNet ? grid.count() : 0);
  Interval* const work = large.empty() ? small.data() : large.data();
  std::array<Interval, 4> x;
  for (int c = 0; c < net_.num_components(); ++c) {
    std::copy(net_.component(c).begin(), net_.component(c).end(), work);
    x[static_cast<std::size_t>(c)] = net_value(work, grid, blends);
  }
  Box3 out(x[0], x[1], x[2]);
  for (std::size_t c = 0; c < 3; ++c) {
    if (net_.is_rational()) out[c] = out[c] / x[3];
    out[c] = intersection(out[c], Interval::from_bounds(hull_.lo[c], hull_.hi[c]));
  }
  return out;
}

MapBounds CellNet::bounds() const {
  MapBounds out;
  const Grid<3> grid = net_.grid();
  constexpr std::size_t kNone = 3;
  if (!net_.is_rational()) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto net = net_.component(static_cast<int>(c));
      for (std::size_t i = 0; i < 3; ++i) {
        out.first[c][i] = mag(derivative_hull(net, grid, i, kNone));
        for (std::size_t j = 0; j <= i; ++j)
          out.second[c][i][j] = out.second[c][j][i] = mag(derivative_hull(net, grid, i, j));
      }
    }
    return out;
  }
  if (!is_finite(hull_)) {
    for (std::size_t c = 0; c < 3; ++c) {
      out.first[c].fill(kUnbounded);
      for (Point3d& row : out.second[c]) row.fill(kUnbounded);
    }
    return out;
  }
  // For f = X / w, moved so that the middle of the hull is the origin:
  // f_i = (X_i - f w_i) / w, f_ij = (X_ij - f_i w_j - f_j w_i - f w_ij) / w.
  const auto weights = net_.component(3);
  Interval w = weights[0];
  for (const Interval& x : weights) w = veritope::hull(w, x);
  std::array<Interval, 3> w1;
  std::array<std::array<Interval, 3>, 3> w2;
  for (std::size_t i = 0; i < 3; ++i) {
    w1[i] = derivative_hull(weights, grid, i, kNone);
    for (std::size_t j = 0; j <= i; ++j) w2[i][j] = w2[j][i] = derivative_hull(weights, grid, i, j);
  }
  const Point3d middle = approx_centre(hull_);
  std::vector<Interval> x(grid.count());
  for (std::size_t c = 0; c < 3; ++c) {
    const auto net = net_.component(static_cast<int>(c));
    const Interval origin(middle[c]);
    Interval f = Interval::from_bounds(hull_.lo[c], hull_.hi[c]) - origin;
    for (std::size_t n = 0; n < x.size(); ++n) x[n] = net[n] - origin * weights[n];
    std::array<Interval, 3> f1;
    for (std::size_t i = 0; i < 3; ++i) {
      f1[i] = (derivative_hull(x, grid, i, kNone) - f * w1[i]) / w;
      out.first[c][i] = mag(f1[i]);
    }
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        out.second[c][i][j] = out.second[c][j][i] = mag(
            (derivative_hull(x, grid, i, j) - f1[i] * w1[j] - f1[j] * w1[i] - f * w2[i][j]) / w);
  }
  return out;
}

std::pair<CellNet, CellNet> CellNet::halves(std::size_t axis, const Interval& t) const {
  const AffineBlend<Interval> blend{Interval(1.0) - t, t};
  BezierVolume<Interval> left = net_, right = net_;
  on_lines(left, axis, [&](Interval* first, std::size_t stride) {
    keep_left(first, stride, net_.degree(axis), blend);
  });
  on_lines(right, axis, [&](Interval* first, std::size_t stride) {
    keep_right(first, stride, net_.degree(axis), blend);
  });
  return {CellNet(std::move(left)), CellNet(std::move(right))};
}

}  // namespace veritope::internal
