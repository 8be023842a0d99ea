// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "robust/base/check.h"
#include "solids/micro/bridge_faces.h"
#include "solids/micro/mesh/bridge_mesh_internal.h"
#include "splines/de_casteljau.h"
#include "splines/knot_insertion.h"

namespace veritope::internal {
namespace {

constexpr int kBoundDepth = 2;
// The pairs of axes of CellMapBounds::second.
constexpr std::array<std::array<std::size_t, 2>, 6> kBoundPairs = {
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

Interval up_to(double x) { return Interval::from_bounds(0, x); }

}  // namespace

BridgeMesh::BridgeMesh(const VVolume& volume, const MicroBridge& bridge)
    : net_(bridge_map(bridge)) {
  MicroGrid grid;  // the box of the bridge, cut at knots
  for (std::size_t a = 0; a < 3; ++a) {
    const auto x = net_.component(static_cast<int>(a));
    const auto [lo, hi] = std::minmax_element(x.begin(), x.end());
    const KnotAxis<Rational>& axis = volume.axis(a);
    grid.breaks[a].push_back(*lo);
    for (const Rational& t : breaks_of(axis)) {
      if (!(*lo < t && t < *hi)) continue;
      grid.breaks[a].push_back(t);
      num_creases_[a] += multiplicity(axis, t) >= axis.degree ? 1 : 0;
    }
    grid.breaks[a].push_back(*hi);
  }
  add_parts(volume, grid);
}

BridgeMesh::BridgeMesh(const VVolume& volume, const MicroGrid& cell,
                       const BezierSurface<Rational>& cap, const MicroSweep& sweep)
    : net_({cap.degree(0), cap.degree(1), 0}, 3, false,
           {cap.coefficients().begin(), cap.coefficients().end()}),
      curve_(sweep.axis) {
  add_parts(volume, cell);
}

void BridgeMesh::add_parts(const VVolume& volume, const MicroGrid& grid) {
  const CageCells cells(volume, grid);
  const Grid<3> shape = grid.shape();
  CageRow row;
  for (std::size_t n = 0; n < shape.count(); ++n) {
    const auto at = shape.index_of(n);
    Part& part = parts_.emplace_back(Part{{}, cells.new_map()});
    for (std::size_t a = 0; a < 3; ++a)
      part.box[a] = {grid.breaks[a][at[a]], grid.breaks[a][at[a] + 1]};
    if (at[2] == 0) cells.enter_row(at[0], at[1], row);
    cells.cell(row, at[2], part.map);
  }
}

Box3 BridgeMesh::value(const std::array<Rational, 3>& at) const {
  const std::vector<Rational> p = evaluate<Rational, 3>(net_, at);
  for (const Part& part : parts_) {
    if (!part.box.contains({p[0], p[1], p[2]})) continue;
    Box3 local;
    for (std::size_t a = 0; a < 3; ++a)
      local[a] = intersection(enclose((p[a] - part.box[a].lo) / part.box[a].width()),
                              Interval::from_bounds(0, 1));
    Box3 out = part.map.value(local);
    if (!curve_) return out;
    const Rational &w = at[2], first = Rational(2) * w * (Rational(1) - w), second = w * w;
    for (std::size_t c = 0; c < 3; ++c)
      out[c] += enclose(first * (*curve_)[0][c] + second * (*curve_)[1][c]);
    return out;
  }
  VT_CHECK(false, "the point of a bridge is not in the box of its control points");
}

double BridgeMesh::approx_size() const {
  const Rational half = Rational(1) / Rational(2), zero(0), one(1);
  const auto length = [&](const std::array<Rational, 3>& from, const std::array<Rational, 3>& to) {
    const auto p = mid(value(from)), q = mid(value(to));
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  };
  return std::min({length({half, half, zero}, {half, half, one}),
                   length({zero, half, one}, {one, half, one}),
                   length({half, zero, one}, {half, one, one})});
}

// Upper bounds of derivatives by the volume's own parameters.
CellMapBounds BridgeMesh::map_bounds() const {
  CellMapBounds out;
  for (const Part& part : parts_) {
    const CellMapBounds b = part.map.bounds(kBoundDepth);
    std::array<Interval, 3> length;
    for (std::size_t a = 0; a < 3; ++a) length[a] = enclose(part.box[a].width());
    for (std::size_t a = 0; a < 3; ++a)
      out.first[a] = std::max(out.first[a], (Interval(b.first[a]) / length[a]).hi());
    for (std::size_t k = 0; k < 6; ++k)
      out.second[k] = std::max(
          out.second[k],
          (Interval(b.second[k]) / (length[kBoundPairs[k][0]] * length[kBoundPairs[k][1]])).hi());
  }
  return out;
}

// Bounds of the absolute values of the coordinates of a derivative of the bridge.
std::array<Interval, 3> BridgeMesh::derivative_bounds(std::size_t axis, std::size_t order) const {
  const Grid<3> grid = net_.grid();
  const std::size_t n = grid.size[axis] - 1, step = grid.stride(axis);
  std::array<double, 3> most{};
  if (n < order) return {up_to(0), up_to(0), up_to(0)};
  const Rational factor(order == 1 ? n : n * (n - 1));
  for (std::size_t c = 0; c < 3; ++c) {
    const auto x = net_.component(static_cast<int>(c));
    Rational greatest;
    grid.for_each_line(axis, [&](std::size_t first) {
      for (std::size_t i = 0; i + order <= n; ++i) {
        const std::size_t at = first + i * step;
        const Rational d = order == 1 ? x[at + step] - x[at]
                                      : x[at + 2 * step] - x[at + step] - x[at + step] + x[at];
        greatest = std::max(greatest, abs(d));
      }
    });
    most[c] = round_up(greatest * factor);
  }
  return {up_to(most[0]), up_to(most[1]), up_to(most[2])};
}

// An eighth of the second derivative of T(b(.)), as of patches (patch_bend_internal.h). Where b passes a crease of T,
// the slope of its image jumps there by at most twice its greatest length, and interpolation on a part of length h is
// off by a quarter of h times the jumps, of which there are at most as many at a plane as the degree of b.
BridgeError BridgeMesh::error() const {
  const CellMapBounds map = map_bounds();
  BridgeError out;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto s = derivative_bounds(axis, 1), second = derivative_bounds(axis, 2);
    Interval sum, crease;
    for (std::size_t k = 0; k < 6; ++k) {
      const auto [a, b] = kBoundPairs[k];
      sum += Interval(a == b ? 1.0 : 2.0) * up_to(map.second[k]) * s[a] * s[b];
    }
    for (std::size_t a = 0; a < 3; ++a) {
      sum += up_to(map.first[a]) * second[a];
      crease += Interval(0.5 * num_creases_[a] * net_.degree(axis)) * up_to(map.first[a]) * s[a];
    }
    out.bend[axis] = (Interval(0.125) * sum).hi();
    out.crease[axis] = crease.hi();
  }
  if (!curve_) return out;
  // The second derivative of the curve 2 w (1 - w) e + w^2 f is 2 (f - 2 e).
  Interval sum;
  for (std::size_t c = 0; c < 3; ++c)
    sum += sqr(enclose((*curve_)[1][c] - Rational(2) * (*curve_)[0][c]));
  out.bend[2] = (Interval(0.25) * sqrt(sum)).hi();
  return out;
}

}  // namespace veritope::internal
