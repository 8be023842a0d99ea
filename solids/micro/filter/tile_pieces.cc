// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "interval/box_geometry.h"
#include "solids/micro/filter/tile_pieces_internal.h"
#include "splines/de_casteljau_line.h"

namespace veritope::internal {

namespace {

// |f - bilinear interpolant| <= (max |f_uu| + max |f_vv|) / 8 on the unit square. What an axis contributes, by the
// chain rule for f = F(P(u, v)).
Point3d bend_of(const MapBounds& map, const Point3d& first, const Point3d& second) {
  Point3d out{};
  if (first == Point3d{} && second == Point3d{}) return out;  // the second axis of a curve
  for (std::size_t c = 0; c < 3; ++c) {
    Interval sum;
    for (std::size_t i = 0; i < 3; ++i) {
      const Interval d(first[i]);
      for (std::size_t j = 0; j < 3; ++j)
        sum += Interval(map.second[c][i][j]) * d * Interval(first[j]);
      sum += Interval(map.first[c][i]) * Interval(second[i]);
    }
    out[c] = (sum * Interval(0.125)).hi();
  }
  return out;
}

// The value of a patch at a point of the unit square.
Box3 patch_value(const BezierSurface<Interval>& patch, double u, double v) {
  const std::array<AffineBlend<Interval>, 2> at{
      AffineBlend<Interval>{Interval(1.0) - Interval(u), Interval(u)},
      AffineBlend<Interval>{Interval(1.0) - Interval(v), Interval(v)}};
  const std::size_t rows = static_cast<std::size_t>(patch.degree(0)) + 1,
                    columns = static_cast<std::size_t>(patch.degree(1)) + 1;
  std::array<Interval, static_cast<std::size_t>(kMaxPatchDegree) + 1> line, row;
  Box3 out;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto net = patch.component(static_cast<int>(c));
    for (std::size_t i = 0; i < rows; ++i) {
      std::copy_n(net.begin() + static_cast<std::ptrdiff_t>(i * columns), columns, row.begin());
      keep_right(row.data(), 1, patch.degree(1), at[1]);
      line[i] = row[0];
    }
    keep_right(line.data(), 1, patch.degree(0), at[0]);
    // Control points are in the unit cube, and so is the value.
    out[c] = intersection(line[0], Interval::from_bounds(0, 1));
  }
  return out;
}

double approx_length(const Box3& a, const Box3& b) {
  const Point3d p = approx_middle(a), q = approx_middle(b);
  return std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]);
}

}  // namespace

TilePieces::TilePieces(const CellNet& net, const TileShape& tile) : net_(net), tile_(tile) {
  corners_.reserve(tile.corners().size());
  for (const Box3& p : tile.corners()) corners_.push_back(net.values(p));
}

bool TilePieces::bound() {
  const MapBounds map = net_.bounds();
  const auto is_bounded = [](const Point3d& row) {
    return row[0] < HUGE_VAL && row[1] < HUGE_VAL && row[2] < HUGE_VAL;
  };
  for (std::size_t c = 0; c < 3; ++c) {
    if (!is_bounded(map.first[c])) return false;
    for (const Point3d& row : map.second[c])
      if (!is_bounded(row)) return false;
  }
  for (const TileShape::Side& side : tile_.patches()) {
    bend_.emplace_back();
    for (std::size_t axis = 0; axis < 2; ++axis)
      bend_.back()[axis] = bend_of(map, side.first[axis], side.second[axis]);
    for (const Point3d& bend : bend_.back())
      if (!is_bounded(bend)) return false;
  }
  return true;
}

TilePiece TilePieces::root(std::uint32_t patch) const {
  TilePiece out;
  out.patch = patch;
  out.bend = bend_[patch];
  const auto& numbers = tile_.patches()[patch].corners;
  for (std::size_t i = 0; i < 4; ++i) out.corners[i] = corners_[numbers[i]];
  return out;
}

std::pair<TilePiece, TilePiece> TilePieces::halves(const TilePiece& piece,
                                                   std::size_t* axis) const {
  const auto& p = piece.corners;
  const double along_u = approx_length(p[0], p[1]) + approx_length(p[2], p[3]) + piece.bend[0][0] +
                         piece.bend[0][1] + piece.bend[0][2];
  const double along_v = approx_length(p[0], p[2]) + approx_length(p[1], p[3]) + piece.bend[1][0] +
                         piece.bend[1][1] + piece.bend[1][2];
  const std::size_t a = along_u >= along_v || tile_.patches()[piece.patch].is_curve() ? 0 : 1,
                    b = 1 - a;
  *axis = a;
  std::pair<TilePiece, TilePiece> out{piece, piece};
  const auto number = [](std::uint64_t n, int level) {
    return std::ldexp(static_cast<double>(n), -level);
  };
  ++out.first.level[a];
  out.first.at[a] = 2 * piece.at[a];
  out.second.level[a] = out.first.level[a];
  out.second.at[a] = out.first.at[a] + 1;
  // Both sides of a curve are one point.
  const TileShape::Side& of = tile_.patches()[piece.patch];
  Box3 cut;
  for (std::size_t side = 0; side < 2; ++side) {
    std::array<double, 2> at{};
    at[a] = number(out.second.at[a], out.second.level[a]);
    at[b] = number(piece.at[b] + side, piece.level[b]);
    if (side == 0 || !of.is_curve()) cut = net_.values(patch_value(of.enclosed, at[0], at[1]));
    out.first.corners[(std::size_t{1} << a) + (side << b)] = cut;
    out.second.corners[side << b] = cut;
  }
  for (double& bound : out.first.bend[a]) bound = (Interval(bound) * Interval(0.25)).hi();
  out.second.bend[a] = out.first.bend[a];
  return out;
}

Point3d excess_of(const TilePiece& piece) {
  Point3d out;
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = (Interval(piece.bend[0][c]) + Interval(piece.bend[1][c])).hi();
  return out;
}

Box3d box_of(const TilePiece& piece) {
  Box3d out = outer_box(piece.corners[0]);
  for (std::size_t i = 1; i < 4; ++i) out = hull(out, outer_box(piece.corners[i]));
  for (std::size_t c = 0; c < 3; ++c) {
    const Interval bend = Interval(piece.bend[0][c]) + Interval(piece.bend[1][c]);
    out.lo[c] = (Interval(out.lo[c]) - bend).lo();
    out.hi[c] = (Interval(out.hi[c]) + bend).hi();
  }
  return out;
}

}  // namespace veritope::internal
