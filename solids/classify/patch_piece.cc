// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/patch_piece.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "interval/box_geometry.h"
#include "splines/bezier_triangle_algebra.h"
#include "splines/de_casteljau.h"

namespace veritope {

using namespace internal;

namespace {

BezierSurface<Interval> enclosed_net(const Patch& patch) {
  const Patch::Tensor map =
      patch.is_triangle() ? as_tensor_product(patch.triangle()) : patch.tensor();
  std::vector<Interval> c;
  c.reserve(map.coefficients().size());
  for (const Rational& x : map.coefficients()) c.push_back(enclose(x));
  return {map.degrees(), map.num_components(), map.is_rational(), std::move(c)};
}

// The curve in two equal columns.
BezierSurface<Interval> enclosed_net(const Patch::Curve& curve) {
  std::vector<Interval> c;
  for (const Rational& x : curve.coefficients()) {
    c.push_back(enclose(x));
    c.push_back(c.back());
  }
  return {{curve.degree(0), 1}, curve.num_components(), curve.is_rational(), std::move(c)};
}

double approx_gap(const Box3& a, const Box3& b) {
  const Point3d p = approx_middle(a), q = approx_middle(b);
  return std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]);
}

}  // namespace

PatchPiece::PatchPiece(const Patch& patch, std::uint32_t number)
    : patch_(number), net_(enclosed_net(patch)) {
  find_hull();
}

PatchPiece::PatchPiece(const Patch::Curve& curve, std::uint32_t number)
    : patch_(number), net_(enclosed_net(curve)) {
  find_hull();
}

PatchPiece::PatchPiece(BezierSurface<Interval> net, const PatchPiece& whole, std::size_t axis,
                       bool is_second)
    : patch_(whole.patch_), at_(whole.at_), level_(whole.level_), net_(std::move(net)) {
  ++level_[axis];
  at_[axis] = 2 * at_[axis] + (is_second ? 1 : 0);
  find_hull();
}

void PatchPiece::find_hull() {
  const Grid<2> grid = net_.grid();
  const bool is_rational = net_.is_rational();
  const auto point = [&](std::size_t n) {
    Box3 p(net_.component(0)[n], net_.component(1)[n], net_.component(2)[n]);
    if (!is_rational) return p;
    for (std::size_t c = 0; c < 3; ++c) p[c] = p[c] / net_.component(3)[n];
    return p;
  };
  const std::size_t m = grid.size[0] - 1, n = grid.size[1] - 1;
  for (std::size_t i = 0; i < 4; ++i)
    corners_[i] = point(grid.at({(i & 1) != 0 ? m : 0, (i & 2) != 0 ? n : 0}));
  excess_ = {};
  for (std::size_t i = 0; i <= m; ++i) {
    // Any t of [0,1] serves.
    const Interval t(static_cast<double>(i) / static_cast<double>(m)), s = Interval(1.0) - t;
    const Box3 low = s * corners_[0] + t * corners_[1], high = s * corners_[2] + t * corners_[3];
    for (std::size_t j = 0; j <= n; ++j) {
      if ((i == 0 || i == m) && (j == 0 || j == n)) continue;
      const Interval v(static_cast<double>(j) / static_cast<double>(n));
      const Box3 d = point(grid.at({i, j})) - ((Interval(1.0) - v) * low + v * high);
      for (std::size_t c = 0; c < 3; ++c) excess_[c] = std::max(excess_[c], mag(d[c]));
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    Interval side = corners_[0][c];
    for (std::size_t i = 1; i < 4; ++i) side = veritope::hull(side, corners_[i][c]);
    box_.lo[c] = (side - Interval(excess_[c])).lo();
    box_.hi[c] = (side + Interval(excess_[c])).hi();
  }
}

double PatchPiece::size() const {
  double out = 0;
  for (std::size_t c = 0; c < 3; ++c) out = std::max(out, box_.hi[c] - box_.lo[c]);
  return out;
}

Interval PatchPiece::range(std::size_t axis) const {
  const auto at = [&](std::uint64_t n) {
    return std::ldexp(static_cast<double>(n), -level_[axis]);
  };
  return Interval::from_bounds(at(at_[axis]), at(at_[axis] + 1));
}

std::size_t PatchPiece::longer_axis() const {
  // The middle of the net tells the length of a part whose ends are at one place.
  const Grid<2> grid = net_.grid();
  const auto middle = [&](std::size_t a, std::size_t end) {
    std::array<std::size_t, 2> at{};
    at[a] = end == 0 ? 0 : grid.size[a] - 1;
    at[1 - a] = grid.size[1 - a] / 2;
    const std::size_t n = grid.at(at);
    Box3 p(net_.component(0)[n], net_.component(1)[n], net_.component(2)[n]);
    if (net_.is_rational())
      for (std::size_t c = 0; c < 3; ++c) p[c] = p[c] / net_.component(3)[n];
    return p;
  };
  const double bend = excess_[0] + excess_[1] + excess_[2];
  const double u = approx_gap(corners_[0], corners_[1]) + approx_gap(corners_[2], corners_[3]) +
                   approx_gap(middle(0, 0), middle(0, 1));
  const double v = approx_gap(corners_[0], corners_[2]) + approx_gap(corners_[1], corners_[3]) +
                   approx_gap(middle(1, 0), middle(1, 1));
  // A part that is more bent than long is cut along both axes in turn.
  if (bend > u + v) return level_[0] <= level_[1] ? 0 : 1;
  return u >= v ? 0 : 1;
}

std::pair<PatchPiece, PatchPiece> PatchPiece::halves(std::size_t axis) const {
  BezierSurface<Interval> left = net_, right = net_;
  const HalfBlend<Interval> half{Interval(0.5)};
  const Grid<2> grid = net_.grid();
  const std::size_t step = grid.stride(axis);
  for (int c = 0; c < net_.num_components(); ++c) {
    Interval* const a = left.component(c).data();
    Interval* const b = right.component(c).data();
    grid.for_each_line(axis, [&](std::size_t first) {
      split_keeping_right(b + first, step, net_.degree(axis), a + first, step, half);
    });
  }
  return {PatchPiece(std::move(left), *this, axis, false),
          PatchPiece(std::move(right), *this, axis, true)};
}

}  // namespace veritope
