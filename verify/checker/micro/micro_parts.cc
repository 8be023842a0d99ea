// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "micro_parts.h"

std::pair<CellBlock, CellBlock> CellBlock::halves() const {
  size_t axis = 0;
  for (size_t a = 1; a < 3; ++a)
    if (hi[a] - lo[a] > hi[axis] - lo[axis]) axis = a;
  std::pair<CellBlock, CellBlock> r(*this, *this);
  r.first.hi[axis] = r.second.lo[axis] = (lo[axis] + hi[axis]) / 2;
  return r;
}
bool holds_tile(const MicroGrid& g, const CellBlock& b) {
  size_t i[3];
  i[2] = b.lo[2];
  for (i[0] = b.lo[0]; i[0] < b.hi[0]; ++i[0])
    for (i[1] = b.lo[1]; i[1] < b.hi[1]; ++i[1]) {
      const uint8_t* const row = &g.tile[g.cell(i)];
      for (size_t k = 0; k < b.hi[2] - b.lo[2]; ++k)
        if (row[k] != 0) return true;
    }
  return false;
}

TileParts::TileParts(const MicroFile& file, VolumeMaps* maps) : file_(file), maps_(*maps) {
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
  count_ = file.bridges.size() + file.sweeps.size();
  for (const MicroGrid& g : file.grids)
    each_tile(g,
              [&](const size_t*, uint64_t, size_t t) { count_ += file.tiles[t].patches.size(); });
}

void TileParts::find_intervals(const MicroGrid& g) {
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
CellBlock TileParts::block_of_box(const MicroGrid& g, const size_t* box) const {
  CellBlock r;
  for (size_t a = 0; a < 3; ++a) {
    const Interval& i = boxes_of(g).axis[a][box[a]];
    r.lo[a] = i.first, r.hi[a] = i.first + std::max<size_t>(i.at.size(), 1) - 1;
  }
  return r;
}
void TileParts::each_box(const MicroGrid& g,
                         const std::function<void(const size_t*, const CellBlock&)>& use) const {
  const GridBoxes& all = boxes_of(g);
  size_t box[3];
  const auto has_cells = [&](size_t a) { return all.axis[a][box[a]].at.size() > 1; };
  for (box[0] = 0; box[0] < all.axis[0].size(); ++box[0])
    for (box[1] = 0; box[1] < all.axis[1].size() && has_cells(0); ++box[1])
      for (box[2] = 0; box[2] < all.axis[2].size() && has_cells(1); ++box[2]) {
        if (!has_cells(2)) continue;
        const CellBlock block = block_of_box(g, box);
        if (holds_tile(g, block)) use(box, block);
      }
}
void TileParts::box_of_cell(const MicroGrid& g, const size_t* i, size_t* box) const {
  for (size_t a = 0; a < 3; ++a) {
    const std::vector<Ratio>& t = maps_.knots(g.volume, a);
    box[a] = 0;
    while (compare(t[box[a] + 1], g.breaks[a][i[a]]) <= 0) ++box[a];
  }
}

CellNet TileParts::net_in(const MicroGrid& g, const size_t* box, const CellBlock& block) const {
  CellNet r;
  r.net = maps_.net(g.volume, box);
  for (size_t a = 0; a < 3; ++a) {
    const Span &lo = break_in(g, box, a, block.lo[a]), &hi = break_in(g, box, a, block.hi[a]);
    const double begin = std::max(0.0, lo.lo), end = std::min(1.0, hi.hi);
    restrict_net(&r.net, a, begin, end);
    // Both ends are right but for 2^-48; restrict_net may add less than that at the begin.
    r.slack[a] = std::ldexp(1.0, -45) / (end - begin);
  }
  return r;
}
CellNet TileParts::net_of_cell(const MicroGrid& g, const size_t* i) const {
  size_t box[3];
  box_of_cell(g, i, box);
  return net_in(g, box, CellBlock{{i[0], i[1], i[2]}, {i[0] + 1, i[1] + 1, i[2] + 1}});
}

// Horner's scheme: a step's two results differ by less than 2^-50 of their greatest absolute values from exact ones.
DoubleNet TileParts::patch_in(const MicroGrid& g, const size_t* i, size_t tile, size_t s) const {
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
void TileParts::set_points(const DoubleNet& node, const CellNet& cell, PointHull* hull) {
  const DoubleBox x = box_of(node);
  scratch_ = cell.net;
  for (size_t a = 0; a < 3; ++a)
    restrict_net(&scratch_, a, std::min(1.0, std::max(0.0, x.lo[a] - cell.slack[a])),
                 std::max(0.0, std::min(1.0, x.hi[a] + cell.slack[a])));
  set_hull(scratch_, hull);
}

SweepPart::SweepPart(TileParts* parts, const MicroSweep& sweep, uint64_t number, const char* id)
    : parts_(*parts), sweep_(sweep) {
  const MicroFile& file = parts->file();
  const MicroGrid& g = file.grids[sweep.grid];
  const size_t tile = g.tile[sweep.cell] - size_t(1);
  size_t i[3];
  g.place_of(sweep.cell, i);
  cell_ = parts->net_of_cell(g, i);
  const MicroPatch& s = patch_of_cap(file, sweep.grid, sweep.cell, sweep.wall, id, number);
  cap_ = parts->patch_in(g, i, tile, size_t(&s - file.tiles[tile].patches.data()));
}

// The coefficient (x, y) of the curve, its polar form, is (x + y - 2 x y) e + x y f; both factors are exact here, and
// from 0 to 1. With v for the greatest value of e and f, whose errors are d, one of its numbers differs by less than
// 2 d + 2^-49 v from the exact one. Adding t, of the size r, makes an error of less than 2^-50 (r + 2 v).
void SweepPart::set_points(const DoubleNet& cap, double lo, double hi, PointHull* hull) const {
  PointHull on_cap;
  parts_.set_points(cap, cell_, &on_cap);
  DoubleNet sums;  // its numbers become those of the hull
  double error = 0, size = 0;
  for (const auto& v : sweep_.axis)
    for (const Span& x : v) {
      error = std::max(error, x.hi - x.lo);
      size = std::max(size, std::max(std::abs(x.lo), std::abs(x.hi)));
    }
  for (double x : on_cap.p) size = std::max(size, std::abs(x));
  for (size_t form = 0; form < (lo < hi ? 3 : 1); ++form) {
    const double x = form == 2 ? hi : lo, y = form == 0 ? lo : hi;
    double g[3];
    for (size_t k = 0; k < 3; ++k) {
      const Span &e = sweep_.axis[0][k], &f = sweep_.axis[1][k];
      g[k] = (x + y - 2 * x * y) * (e.lo + (e.hi - e.lo) / 2) + x * y * (f.lo + (f.hi - f.lo) / 2);
    }
    for (size_t i = 0; i < on_cap.p.size(); ++i) sums.v.push_back(on_cap.p[i] + g[i % 3]);
  }
  sums.error = on_cap.is_known ? on_cap.error + 2 * error + std::ldexp(size, -46) + kTiny
                               : std::numeric_limits<double>::infinity();
  set_hull(sums, hull);
}
