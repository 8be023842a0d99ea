// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_off.cc: I1 of docs/certificates/micro-inside.md for the patches of tiles.
#include "micro_off.h"

namespace {

const int kMostLevelOff = 60;

bool holds_tile(const MicroGrid& g, const size_t* lo, const size_t* hi) {
  size_t i[3];
  i[2] = lo[2];
  for (i[0] = lo[0]; i[0] < hi[0]; ++i[0])
    for (i[1] = lo[1]; i[1] < hi[1]; ++i[1]) {
      const uint8_t* const row = &g.tile[g.cell(i)];
      for (size_t k = 0; k < hi[2] - lo[2]; ++k)
        if (row[k] != 0) return true;
    }
  return false;
}

}  // namespace

void halve_net(const DoubleNet& net, size_t axis, DoubleNet* lower, DoubleNet* upper) {
  *lower = net, *upper = net;
  restrict_net(lower, axis, 0, 0.5);
  restrict_net(upper, axis, 0.5, 1);
}

OffSurface::OffSurface(const MicroFile& file, const Triangles& triangles, VolumeMaps* maps)
    : file_(file), triangles_(triangles), maps_(*maps) {
  for (const MicroGrid& g : file.grids) find_intervals(g);
  for (const MicroTile& tile : file.tiles) {
    lists_.push_back(Lists());
    for (const MicroPatch& s : tile.patches) {
      lists_.back().push_back(std::vector<DoubleNet>(s.lists));
      for (size_t l = 0; l < s.lists; ++l) {
        DoubleNet& net = lists_.back().back()[l];
        net.n[0] = size_t(s.p) + 1, net.n[1] = size_t(s.q) + 1;
        for (size_t i = s.at(l, 0, 0, 0); i < s.at(l + 1, 0, 0, 0); ++i)
          net.add(span_of(s.net[i], s.scale));
      }
    }
  }
  uint64_t parts = file.bridges.size();
  for (const MicroGrid& g : file.grids)
    each_tile(g, [&](const size_t*, uint64_t, size_t t) { parts += file.tiles[t].patches.size(); });
  most_nodes_ = (uint64_t(1) << 22) + 64 * parts;
}

// Horner's scheme: a step's two results differ by less than 2^-50 of their greatest absolute values from exact ones.
DoubleNet OffSurface::patch_in(const MicroGrid& g, const size_t* i, size_t tile, size_t s) const {
  const std::vector<DoubleNet>& lists = lists_[tile][s];
  const MicroPatch& patch = file_.tiles[tile].patches[s];
  DoubleNet r = lists.back();
  if (lists.size() == 1) return r;
  const double t = double(g.number(i, size_t(patch.wall))) / kWholeNumber;
  for (size_t l = lists.size() - 1; l-- > 0;) {
    const DoubleNet& next = lists[l];
    const double size = r.size() + next.size();
    for (size_t k = 0; k < r.v.size(); ++k) r.v[k] = r.v[k] * t + next.v[k];
    r.error += next.error + std::ldexp(size, -47) + kTiny;
  }
  return r;
}

void OffSurface::find_intervals(const MicroGrid& g) {
  boxes_.push_back(GridBoxes());
  for (size_t a = 0; a < 3; ++a) {
    const std::vector<Ratio>&t = maps_.knots(g.volume, a), &b = g.breaks[a];
    size_t i = 0;
    for (size_t k = 0; k + 1 < t.size(); ++k) {
      const Ratio length = t[k + 1] - t[k];
      while (i < b.size() && compare(b[i], t[k]) < 0) ++i;
      Interval interval = {{}, i};
      for (size_t at = i; at < b.size() && compare(b[at], t[k + 1]) <= 0; ++at)
        interval.at.push_back(span_of(ratio_quotient(b[at] - t[k], length)));
      boxes_.back().axis[a].push_back(std::move(interval));
    }
  }
}
OffSurface::CellNet OffSurface::net_in(const Region& region, const Block& block) const {
  CellNet r;
  r.net = *region.net;
  for (size_t a = 0; a < 3; ++a) {
    const Span &lo = region.axis[a]->at[block.lo[a] - region.axis[a]->first],
               &hi = region.axis[a]->at[block.hi[a] - region.axis[a]->first];
    const double begin = std::max(0.0, lo.lo), end = std::min(1.0, hi.hi);
    restrict_net(&r.net, a, begin, end);
    // Both ends are right but for 2^-48; restrict_net may add less than that at the begin.
    r.slack[a] = std::ldexp(1.0, -45) / (end - begin);
  }
  return r;
}
void OffSurface::check_block(const MicroGrid& g, const Region& region, const Block& block) {
  if (!holds_tile(g, block.lo, block.hi)) return;
  const CellNet cell = net_in(region, block);
  PointHull hull;
  set_hull(cell.net, &hull);
  if (hull.is_known && triangles_.miss(hull.box)) return;
  size_t axis = 0;
  for (size_t a = 1; a < 3; ++a)
    if (block.hi[a] - block.lo[a] > block.hi[axis] - block.lo[axis]) axis = a;
  if (block.hi[axis] - block.lo[axis] == 1) return check_cell(g, block.lo, cell);
  Block lower = block, upper = block;
  lower.hi[axis] = upper.lo[axis] = (block.lo[axis] + block.hi[axis]) / 2;
  check_block(g, region, lower);
  check_block(g, region, upper);
}

void OffSurface::set_points(const DoubleNet& node, const CellNet& cell, PointHull* hull) {
  const DoubleBox x = box_of(node);
  scratch_ = cell.net;
  for (size_t a = 0; a < 3; ++a)
    restrict_net(&scratch_, a, std::min(1.0, std::max(0.0, x.lo[a] - cell.slack[a])),
                 std::max(0.0, std::min(1.0, x.hi[a] + cell.slack[a])));
  set_hull(scratch_, hull);
}
void OffSurface::check_cell(const MicroGrid& g, const size_t* i, const CellNet& cell) {
  const size_t tile = g.tile[g.cell(i)] - size_t(1);
  PointHull hull;
  std::vector<std::pair<DoubleNet, int>> nodes;  // with their levels
  for (size_t s = 0; s < file_.tiles[tile].patches.size(); ++s) {
    nodes.push_back(std::make_pair(patch_in(g, i, tile, s), 0));
    while (!nodes.empty()) {
      add_nodes(1);
      const std::pair<DoubleNet, int> node = std::move(nodes.back());
      nodes.pop_back();
      set_points(node.first, cell, &hull);
      if (triangles_.miss(hull, &pairs_)) continue;
      require(node.second < kMostLevelOff, "I1", "a tile may meet the model, in cell",
              g.first_cell + g.cell(i));
      nodes.resize(nodes.size() + 2);
      std::pair<DoubleNet, int>* const halves = &nodes[nodes.size() - 2];
      halve_net(node.first, size_t(node.second % 2), &halves[0].first, &halves[1].first);
      halves[0].second = halves[1].second = node.second + 1;
    }
  }
}
void OffSurface::check_cells() {
  for (const MicroGrid& g : file_.grids) {
    const GridBoxes& all = boxes_[size_t(&g - file_.grids.data())];
    size_t box[3];
    Block block;
    const auto has_cells = [&](size_t a) {
      const Interval& i = all.axis[a][box[a]];
      block.lo[a] = i.first, block.hi[a] = i.first + i.at.size() - 1;
      return i.at.size() > 1;
    };
    for (box[0] = 0; box[0] < all.axis[0].size(); ++box[0])
      for (box[1] = 0; box[1] < all.axis[1].size() && has_cells(0); ++box[1])
        for (box[2] = 0; box[2] < all.axis[2].size() && has_cells(1); ++box[2])
          if (has_cells(2) && holds_tile(g, block.lo, block.hi))
            check_block(g, region_of(g, box), block);
  }
}

void OffSurface::point_near(const PatchOfCell& patch, double* point) {
  const MicroGrid& g = file_.grids[patch.grid];
  size_t i[3], box[3];
  Block block;
  g.place_of(patch.cell, i);
  for (size_t a = 0; a < 3; ++a) {
    const std::vector<Ratio>& t = maps_.knots(g.volume, a);
    box[a] = 0;
    while (compare(t[box[a] + 1], g.breaks[a][i[a]]) <= 0) ++box[a];
    block.lo[a] = i[a], block.hi[a] = i[a] + 1;
  }
  const CellNet cell = net_in(region_of(g, box), block);
  DoubleNet node = patch_in(g, i, g.tile[patch.cell] - size_t(1), patch.patch);
  PointHull hull;
  uint64_t pairs = 0;
  for (int level = 0;; ++level) {  // the half that begins at (0, 0)
    set_points(node, cell, &hull);
    if (triangles_.miss(hull, &pairs)) break;
    require(level < kMostLevelOff, "I1", "a shell's first patch may meet the model, in cell",
            g.first_cell + patch.cell);
    restrict_net(&node, size_t(level % 2), 0, 0.5);
  }
  std::copy(hull.p.begin(), hull.p.begin() + 3, point);
}
