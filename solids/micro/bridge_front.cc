// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/bridge_front.h"

#include <utility>
#include <vector>

#include "splines/bezier_degree.h"
#include "splines/bezier_domain.h"

namespace veritope {
namespace {

VFaceNumber face_at(const Microstructure& micro, const CapPlace& cap) {
  const MicroGrid& grid = micro.grids[cap.grid];
  const auto axis = static_cast<std::size_t>(cap.wall / 2);
  const Grid<3> shape = grid.shape();
  const std::size_t index = shape.index_of(cap.cell)[axis];
  const KnotAxis<Rational>& a = micro.cage[grid.volume].axis(axis);
  const bool is_outer =
      cap.wall % 2 == 0
          ? index == 0 && grid.breaks[axis].front() == a.domain_begin()
          : index + 1 == shape.size[axis] && grid.breaks[axis].back() == a.domain_end();
  return is_outer ? 6 * grid.volume + static_cast<VFaceNumber>(cap.wall) : kNoVFace;
}

// Brings points of a face of a volume to the face that is glued to it.
class FaceCrossing {
 public:
  FaceCrossing(const Microstructure& micro, const VModel& cage, VFaceNumber face)
      : micro_(micro), role_(cage.face(face)), from_(face) {}

  TilePoint operator()(const TilePoint& p) const {
    const auto axes = v_face_axes(from_ % 6 / 2), to = v_face_axes(role_.mate % 6 / 2);
    std::array<Rational, 2> t;
    for (std::size_t k = 0; k < 2; ++k) {
      const KnotAxis<Rational>& a = micro_.cage[from_ / 6].axis(axes[k]);
      t[k] = (p[axes[k]] - a.domain_begin()) / (a.domain_end() - a.domain_begin());
    }
    if ((role_.symmetry & 1) != 0) std::swap(t[0], t[1]);
    TilePoint out;
    for (std::size_t k = 0; k < 2; ++k) {
      if ((role_.symmetry >> (k + 1) & 1) != 0) t[k] = Rational(1) - t[k];
      const KnotAxis<Rational>& a = micro_.cage[role_.mate / 6].axis(to[k]);
      out[to[k]] = a.domain_begin() + (a.domain_end() - a.domain_begin()) * t[k];
    }
    const KnotAxis<Rational>& across = micro_.cage[role_.mate / 6].axis(role_.mate % 6 / 2);
    out[role_.mate % 6 / 2] = role_.mate % 2 == 0 ? across.domain_begin() : across.domain_end();
    return out;
  }

 private:
  const Microstructure& micro_;
  const VFaceRole& role_;
  VFaceNumber from_;
};

BezierSurface<Rational> surface_through(const std::array<int, 2>& degrees,
                                        const std::vector<TilePoint>& points) {
  BezierSurface<Rational> out(degrees, 3, false);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) out.component(static_cast<int>(c))[i] = points[i][c];
  return out;
}

// The sign of the cap's area, seen against the axis: twice the area inside of the polygon of the boundary's control
// points. (A wrong one only makes a bridge whose determinant is negative, which no proof accepts.)
Sign sign_of_area(const BezierSurface<Rational>& cap, std::size_t axis) {
  const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
  Rational sum;
  std::vector<std::size_t> rim;
  for (std::size_t side = 0; side < kTileSides; ++side)
    for (int i = 0; i < tile_side_degree(cap.degrees(), side); ++i)
      rim.push_back(tile_side_index(cap.degrees(), side, static_cast<std::size_t>(i)));
  const auto x = cap.component(static_cast<int>(a)), y = cap.component(static_cast<int>(b));
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const std::size_t p = rim[i], q = rim[(i + 1) % rim.size()];
    sum += x[p] * y[q] - x[q] * y[p];
  }
  return sum.sign();
}

}  // namespace

std::optional<BridgeFront> front_of(const Microstructure& micro, const VModel& cage,
                                    const CapPlace& cap) {
  const MicroGrid& grid = micro.grids[cap.grid];
  BridgeFront out;
  const VFaceNumber face = face_at(micro, cap);
  if (face == kNoVFace) {
    out.volume = grid.volume;
    out.axis = static_cast<std::size_t>(cap.wall / 2);
    out.is_upward = cap.wall % 2 == 1;
    const std::size_t index = grid.shape().index_of(cap.cell)[out.axis];
    out.at = grid.breaks[out.axis][index + static_cast<std::size_t>(cap.wall % 2)];
    return out;
  }
  const VFaceRole& role = cage.face(face);
  if (!role.is_glued()) return std::nullopt;
  out.volume = role.mate / 6;
  out.axis = role.mate % 6 / 2;
  out.is_upward = role.mate % 2 == 0;
  const KnotAxis<Rational>& a = micro.cage[out.volume].axis(out.axis);
  out.at = out.is_upward ? a.domain_begin() : a.domain_end();
  out.is_in_face = true;
  return out;
}

std::optional<BezierSurface<Rational>> cap_on_front(const Microstructure& micro, const VModel& cage,
                                                    const std::vector<AnalysedTile>& tiles,
                                                    const CapPlace& cap, const BridgeFront& front) {
  const MicroGrid& grid = micro.grids[cap.grid];
  const AnalysedTile& tile = tiles[grid.tiles[cap.cell] - 1u];
  const auto& caps = tile.caps_of_wall[static_cast<std::size_t>(cap.wall)];
  if (caps.size() != 1 || tile.caps[caps[0]].patches.size() != 1) return std::nullopt;
  const TilePatch& patch = tile.tile.patches[tile.caps[caps[0]].patches[0]];
  const auto at = grid.shape().index_of(cap.cell);
  std::vector<TilePoint> points = points_at(patch, number_of(patch, grid.numbers_of(at)));
  for (TilePoint& p : points) {
    for (std::size_t a = 0; a < 3; ++a) {
      const Rational& lo = grid.breaks[a][at[a]];
      p[a] = lo + (grid.breaks[a][at[a] + 1] - lo) * p[a];
    }
    if (front.is_in_face) p = FaceCrossing(micro, cage, face_at(micro, cap))(p);
  }
  return surface_through(patch.degrees, points);
}

BezierSurface<Rational> turned_beyond(BezierSurface<Rational> cap, const BridgeFront& front) {
  const bool is_positive = sign_of_area(cap, front.axis) == Sign::kPositive;
  return is_positive == front.is_upward ? cap : swapped(cap, 0, 1);
}

std::optional<unsigned> start_symmetry(const MicroBridge& bridge,
                                       const BezierSurface<Rational>& cap) {
  std::vector<TilePoint> row;
  for (int i = 0; i <= bridge.degrees[0]; ++i)
    for (int j = 0; j <= bridge.degrees[1]; ++j) row.push_back(bridge.points[bridge.at(i, j, 0)]);
  const BezierSurface<Rational> start = surface_through(bridge.degrees, row);
  for (unsigned symmetry = 0; symmetry < 8; ++symmetry) {
    BezierSurface<Rational> turned = (symmetry & 1) != 0 ? swapped(start, 0, 1) : start;
    for (std::size_t axis = 0; axis < 2; ++axis)
      if ((symmetry >> (axis + 1) & 1) != 0) turned = reversed(turned, axis);
    const auto both = to_common_degrees(turned, cap);
    if (both.first == both.second) return symmetry;
  }
  return std::nullopt;
}

}  // namespace veritope
