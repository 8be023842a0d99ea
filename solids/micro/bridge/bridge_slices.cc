// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/bridge/bridge_slices.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "interval/upward.h"

namespace veritope {
namespace {

Box3d outer_box_of(const Box3& b) {
  return {{b[0].lo(), b[1].lo(), b[2].lo()}, {b[0].hi(), b[1].hi(), b[2].hi()}};
}

}  // namespace

BridgeSlices::BridgeSlices(const MicroBridge& bridge) : volume_(bridge.volume), box_(empty_box()) {
  const ScopedUpward upward;
  for (std::size_t i = 0; i + 2 < bridge.points.size(); i += 3) {
    std::array<Box3, 3>& line = lines_.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t c = 0; c < 3; ++c) line[k][c] = enclose(bridge.points[i + k][c]);
  }
  slices_.push_back(slice(0, 0));
  box_ = slices_.front().box;
}

// REQUIRES a live ScopedUpward. The weights are doubles.
BridgeSlice BridgeSlices::slice(int level, std::uint32_t index) const {
  const double s = std::ldexp(static_cast<double>(index), -level),
               t = std::ldexp(static_cast<double>(index) + 1, -level);
  BridgeSlice out{level, index, empty_box()};
  for (const auto& [a, b] : {std::pair{s, s}, std::pair{s, t}, std::pair{t, t}}) {
    const double middle = (1 - a) * b + a * (1 - b);
    const Interval first((1 - a) * (1 - b)), second(middle), third(a * b);
    for (const std::array<Box3, 3>& line : lines_)
      out.box = hull(out.box, outer_box_of(first * line[0] + second * line[1] + third * line[2]));
  }
  return out;
}

bool BridgeSlices::halve(std::size_t slice) {
  const BridgeSlice old = slices_[slice];
  if (old.level >= kMaxLevel) return false;
  const ScopedUpward upward;
  slices_[slice] = this->slice(old.level + 1, 2 * old.index);
  slices_.insert(slices_.begin() + static_cast<std::ptrdiff_t>(slice) + 1,
                 this->slice(old.level + 1, 2 * old.index + 1));
  return true;
}

std::vector<Rational> BridgeSlices::cuts() const {
  std::vector<Rational> out;
  for (std::size_t i = 1; i < slices_.size(); ++i)
    out.push_back(Rational(slices_[i].index) * Rational::power_of_two(-slices_[i].level));
  return out;
}

TileCells::TileCells(const Microstructure& micro) : micro_(micro), grids_of_(micro.cage.size()) {
  for (std::uint32_t g = 0; g < micro.grids.size(); ++g) {
    grids_of_[micro.grids[g].volume].push_back(g);
    Lines& lines = lines_.emplace_back();
    for (std::size_t a = 0; a < 3; ++a)
      for (const Rational& x : micro.grids[g].breaks[a]) {
        lines.lo[a].push_back(round_down(x));
        lines.hi[a].push_back(round_up(x));
      }
  }
}

bool TileCells::meets(std::uint32_t volume, const Box3d& box, const CapPlace* own) const {
  const auto& grids = grids_of_[volume];
  return std::any_of(grids.begin(), grids.end(),
                     [&](std::uint32_t g) { return meets_grid(g, box, own); });
}

bool TileCells::meets_grid(std::uint32_t grid, const Box3d& box, const CapPlace* own) const {
  const MicroGrid& m = micro_.grids[grid];
  const Grid<3> shape = m.shape();
  std::array<std::size_t, 3> first{}, last{};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto &lo = lines_[grid].lo[a], &hi = lines_[grid].hi[a];
    // Cell i lies between the breaks i and i + 1.
    const auto begin = std::lower_bound(hi.begin() + 1, hi.end(), box.lo[a]) - hi.begin() - 1;
    const auto end = std::upper_bound(lo.begin(), lo.end() - 1, box.hi[a]) - lo.begin();
    if (begin >= end) return false;
    first[a] = static_cast<std::size_t>(begin);
    last[a] = static_cast<std::size_t>(end);
  }
  for (std::size_t i = first[0]; i < last[0]; ++i)
    for (std::size_t j = first[1]; j < last[1]; ++j)
      for (std::size_t k = first[2]; k < last[2]; ++k) {
        const std::size_t cell = shape.at({i, j, k});
        if (m.tiles[cell] == 0) continue;
        if (own == nullptr || own->grid != grid || own->cell != cell) return true;
      }
  return false;
}

bool is_in_open_box(const MicroBridge& bridge, const VVolume& volume, const BridgeFront& front) {
  for (std::size_t i = 0; i < bridge.points.size(); ++i) {
    if (i % (kBridgeAxisDegree + 1) == 0) continue;
    const TilePoint& p = bridge.points[i];
    if (!front.is_beyond(p[front.axis])) return false;
    for (std::size_t a = 0; a < 3; ++a)
      if (p[a] <= volume.axis(a).domain_begin() || volume.axis(a).domain_end() <= p[a])
        return false;
  }
  return true;
}

bool cut_off_tiles(const TileCells& cells, const CapPlace& cap, const BridgeFront& front,
                   BridgeSlices& slices) {
  for (std::size_t i = 0; i < slices.slices().size();) {
    const CapPlace* const own = i == 0 && !front.is_in_face ? &cap : nullptr;
    if (!cells.meets(slices.volume(), slices.slices()[i].box, own))
      ++i;
    else if (!slices.halve(i))
      return false;
  }
  return true;
}

namespace {

// Cuts both until their slices are disjoint; false if that does not succeed.
bool separate(BridgeSlices& a, BridgeSlices& b) {
  for (std::size_t i = 0; i < a.slices().size();) {
    bool is_cut = false;
    for (std::size_t j = 0; j < b.slices().size();) {
      if (!meets(a.slices()[i].box, b.slices()[j].box)) {
        ++j;
        continue;
      }
      // The longer one is cut.
      const bool cuts_first = a.slices()[i].level < BridgeSlices::kMaxLevel &&
                              (b.slices()[j].level >= BridgeSlices::kMaxLevel ||
                               extent(a.slices()[i].box) >= extent(b.slices()[j].box));
      if (cuts_first) {
        a.halve(i);
        is_cut = true;
        break;
      }
      if (!b.halve(j)) return false;
    }
    if (!is_cut) ++i;
  }
  return true;
}

}  // namespace

DisjointBridges::DisjointBridges(const Microstructure& micro) {
  std::vector<std::array<std::uint64_t, 3>> counts(micro.cage.size());
  for (const MicroGrid& grid : micro.grids)
    for (std::size_t a = 0; a < 3; ++a)
      counts[grid.volume][a] =
          std::max<std::uint64_t>(counts[grid.volume][a], grid.breaks[a].size() - 1);
  for (std::size_t v = 0; v < micro.cage.size(); ++v) {
    Point3d size;
    for (std::size_t a = 0; a < 3; ++a) {
      const KnotAxis<Rational>& axis = micro.cage[v].axis(a);
      size[a] = nearest_double(axis.domain_end() - axis.domain_begin()) /
                static_cast<double>(std::max<std::uint64_t>(1, counts[v][a]));
    }
    bins_.emplace_back(size);
  }
}

std::optional<std::size_t> DisjointBridges::add(BridgeSlices bridge) {
  const std::uint32_t volume = bridge.volume();
  std::vector<std::pair<std::uint32_t, BridgeSlices>> changed;
  for (const std::uint32_t i : bins_[volume].near(bridge.box())) {
    if (!meets(bridges_[i].box(), bridge.box())) continue;
    BridgeSlices other = bridges_[i];
    if (!separate(bridge, other)) return i;
    changed.emplace_back(i, std::move(other));
  }
  for (auto& [i, slices] : changed) bridges_[i] = std::move(slices);
  bins_[volume].add(static_cast<std::uint32_t>(bridges_.size()), bridge.box());
  bridges_.push_back(std::move(bridge));
  return std::nullopt;
}

}  // namespace veritope
