// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/wall_pairs.h"

#include <algorithm>
#include <utility>

#include "solids/vmodel/v_parts.h"

namespace veritope {
namespace {

// An interval of a face's parameters, and the index of the cell along that parameter.
struct Strip {
  Rational lo, hi;
  std::size_t index = 0;
  bool is_reversed = false;  // the cell's parameter runs from hi to lo
};
// The cells of a grid along one of its outer faces, in the parameters of a face of a volume.
struct GridFace {
  std::uint32_t grid = 0;
  int wall = 0;
  bool is_swapped = false;                   // strips k lie along the other parameter of the wall
  std::array<std::vector<Strip>, 2> strips;  // by coordinates of the face, ascending
};

class PairVisitor {
 public:
  PairVisitor(const Microstructure& micro, const VModel& cage,
              const std::function<bool(const WallPair&)>& visit)
      : micro_(micro), cage_(cage), visit_(visit), first_grid_(micro.cage.size() + 1) {
    for (const MicroGrid& g : micro.grids) ++first_grid_[g.volume + 1];
    for (std::size_t v = 0; v < micro.cage.size(); ++v) first_grid_[v + 1] += first_grid_[v];
  }

  bool run() {
    for (std::uint32_t g = 0; g < micro_.grids.size() && goes_on_; ++g) inner_walls(g);
    for (std::uint32_t g = 0; g < micro_.grids.size() && goes_on_; ++g)
      for (std::size_t axis = 0; axis < 3; ++axis) outer_walls(g, axis);
    return num_meetings_ <= kMaxWallMeetings;
  }

 private:
  const MicroGrid& grid(std::uint32_t g) const { return micro_.grids[g]; }

  void inner_walls(std::uint32_t g) {
    const MicroGrid& m = grid(g);
    const Grid<3> shape = m.shape();
    for (std::size_t axis = 0; axis < 3 && goes_on_; ++axis) {
      const std::size_t step = shape.stride(axis), block = step * shape.size[axis];
      const int end = static_cast<int>(2 * axis + 1);
      for (std::size_t c = 0; c < m.tiles.size() && goes_on_; ++c) {
        if (c % block >= block - step) {
          c += step - 1;
          continue;
        }
        if (m.tiles[c] == 0 || m.tiles[c + step] == 0) continue;
        goes_on_ = visit_({{CellWall{g, c, end}, CellWall{g, c + step, end - 1}}, nullptr, true});
      }
    }
  }

  // Meetings of the walls at the end of an axis with those of other grids of the volume, and of both ends with glued
  // faces.
  void outer_walls(std::uint32_t g, std::size_t axis) {
    const MicroGrid& m = grid(g);
    const auto at_end = static_cast<int>(2 * axis + 1);
    for (std::uint32_t h = first_grid_[m.volume]; h < first_grid_[m.volume + 1] && goes_on_; ++h)
      if (h != g && grid(h).breaks[axis].front() == m.breaks[axis].back())
        meet(plain_face(g, at_end), plain_face(h, at_end - 1));
    for (const int end : {0, 1}) {
      const VFaceNumber f = face_of(g, axis, end);
      if (f == kNoVFace || !cage_.face(f).is_glued() || cage_.face(f).mate < f) continue;
      const VFaceNumber mate = cage_.face(f).mate;
      for (std::uint32_t h = first_grid_[mate / 6]; h < first_grid_[mate / 6 + 1] && goes_on_;
           ++h) {
        if (face_of(h, mate % 6 / 2, static_cast<int>(mate % 2)) != mate) continue;
        meet(unit_face(g, static_cast<int>(f % 6), std::nullopt),
             unit_face(h, static_cast<int>(mate % 6), cage_.face(f).symmetry));
      }
    }
  }
  // The face of the volume in which the outer walls of the grid lie, if any.
  VFaceNumber face_of(std::uint32_t g, std::size_t axis, int end) const {
    const KnotAxis<Rational>& a = micro_.cage[grid(g).volume].axis(axis);
    const auto& breaks = grid(g).breaks[axis];
    const bool is_there =
        end == 0 ? breaks.front() == a.domain_begin() : breaks.back() == a.domain_end();
    return is_there ? static_cast<VFaceNumber>(6 * grid(g).volume + 2 * axis) +
                          static_cast<VFaceNumber>(end)
                    : kNoVFace;
  }

  GridFace plain_face(std::uint32_t g, int wall) const {
    GridFace out{g, wall, false, {}};
    const auto axes = v_face_axes(static_cast<std::size_t>(wall / 2));
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& breaks = grid(g).breaks[axes[k]];
      for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        out.strips[k].push_back({breaks[i], breaks[i + 1], i, false});
    }
    return out;
  }
  // Parameters over the domain are brought to [0, 1]; with a symmetry, which takes those of another face to these, to
  // those of the other face.
  GridFace unit_face(std::uint32_t g, int wall, std::optional<unsigned> symmetry) const {
    GridFace out = plain_face(g, wall);
    const auto axes = v_face_axes(static_cast<std::size_t>(wall / 2));
    for (std::size_t k = 0; k < 2; ++k) {
      const KnotAxis<Rational>& a = micro_.cage[grid(g).volume].axis(axes[k]);
      const Rational length = a.domain_end() - a.domain_begin();
      const bool reverses = symmetry.has_value() && (*symmetry >> (k + 1) & 1) != 0;
      for (Strip& s : out.strips[k]) {
        s.lo = (s.lo - a.domain_begin()) / length;
        s.hi = (s.hi - a.domain_begin()) / length;
        if (!reverses) continue;
        std::swap(s.lo, s.hi);
        s.lo = Rational(1) - s.lo;
        s.hi = Rational(1) - s.hi;
        s.is_reversed = true;
      }
      if (reverses) std::reverse(out.strips[k].begin(), out.strips[k].end());
    }
    if (symmetry.has_value() && (*symmetry & 1) != 0) {
      out.is_swapped = true;
      std::swap(out.strips[0], out.strips[1]);
    }
    return out;
  }

  using StripPair = std::array<const Strip*, 2>;
  static std::vector<StripPair> common_strips(const std::vector<Strip>& a,
                                              const std::vector<Strip>& b) {
    std::vector<StripPair> out;
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
      if (std::max(a[i].lo, b[j].lo) < std::min(a[i].hi, b[j].hi)) out.push_back({&a[i], &b[j]});
      if (a[i].hi < b[j].hi)
        ++i;
      else
        ++j;
    }
    return out;
  }
  void meet(const GridFace& a, const GridFace& b) {
    const auto first = common_strips(a.strips[0], b.strips[0]),
               second = common_strips(a.strips[1], b.strips[1]);
    const std::uint64_t meetings = std::uint64_t{first.size()} * second.size();
    num_meetings_ += meetings;
    if (num_meetings_ > kMaxWallMeetings) {
      goes_on_ = false;
      return;
    }
    for (const StripPair& s : first)
      for (const StripPair& t : second)
        if (goes_on_) meet_in(a, b, {s, t});
  }
  std::uint64_t cell_of(const GridFace& face, const std::array<std::size_t, 2>& indices) const {
    const Grid<3> shape = grid(face.grid).shape();
    const auto axis = static_cast<std::size_t>(face.wall / 2);
    std::array<std::size_t, 3> at{};
    at[axis] = face.wall % 2 == 0 ? 0 : shape.size[axis] - 1;
    const auto others = v_face_axes(axis);
    for (std::size_t k = 0; k < 2; ++k) at[others[k]] = indices[face.is_swapped ? 1 - k : k];
    return shape.at(at);
  }
  void meet_in(const GridFace& a, const GridFace& b, const std::array<StripPair, 2>& strips) {
    const std::array<const GridFace*, 2> faces = {&a, &b};
    std::array<CellWall, 2> walls;
    for (std::size_t side = 0; side < 2; ++side) {
      walls[side] = {faces[side]->grid,
                     cell_of(*faces[side], {strips[0][side]->index, strips[1][side]->index}),
                     faces[side]->wall};
      if (grid(walls[side].grid).tiles[walls[side].cell] == 0) return;
    }
    std::array<WallPlacement, 2> placements;
    for (std::size_t side = 0; side < 2; ++side) {
      placements[side].is_swapped = faces[side]->is_swapped;
      for (std::size_t k = 0; k < 2; ++k) {  // in the coordinates in which the first wall is [0, 1]
        const Strip& unit = *strips[k][0];
        const Strip& s = *strips[k][side];
        const Rational length = unit.hi - unit.lo;
        placements[side].scale[k] = (s.hi - s.lo) / length;
        placements[side].offset[k] = (s.lo - unit.lo) / length;
        if (s.is_reversed) {
          placements[side].offset[k] += placements[side].scale[k];
          placements[side].scale[k].negate();
        }
      }
    }
    goes_on_ = visit_({walls, &placements, false});
  }

  const Microstructure& micro_;
  const VModel& cage_;
  const std::function<bool(const WallPair&)>& visit_;
  std::vector<std::uint32_t> first_grid_;  // of each volume; grids come by volumes
  bool goes_on_ = true;
  std::uint64_t num_meetings_ = 0;
};

}  // namespace

bool for_each_wall_pair(const Microstructure& micro, const VModel& cage,
                        const std::function<bool(const WallPair&)>& visit) {
  return PairVisitor(micro, cage, visit).run();
}

std::string name_of_wall(const Microstructure& micro, const CellWall& wall) {
  const auto at = micro.grids[wall.grid].shape().index_of(wall.cell);
  return v_face_name(static_cast<std::size_t>(wall.wall)) + " of cell (" + std::to_string(at[0]) +
         ", " + std::to_string(at[1]) + ", " + std::to_string(at[2]) + ") of grid " +
         std::to_string(wall.grid);
}

}  // namespace veritope
