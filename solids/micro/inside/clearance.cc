// SPDX-License-Identifier: LGPL-3.0-or-later
// Branch and bound over blocks of cells between knots, in the order of their bounds; cells that may be nearest are
// searched in batches, so that threads share them and the result does not depend on their number.
#include "solids/micro/inside/clearance.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <queue>
#include <utility>
#include <vector>

#include "interval/upward.h"
#include "robust/base/parallel.h"
#include "solids/micro/inside/cell_clearance_internal.h"
#include "solids/micro/inside/grid_spans_internal.h"
#include "splines/blossom_weights.h"
#include "splines/composition_span.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

using namespace internal;

constexpr std::size_t kMostInBatch = 64;

using CellRange = std::array<std::array<std::size_t, 2>, 3>;  // the first, and one past the last

struct CageBlock {
  double bound = 0;
  std::uint64_t number = 0;
  std::uint32_t grid = 0;
  CellRange cells{};
  std::shared_ptr<const PartNet> span;  // the map between the knots; made when the block is halved

  std::size_t size(std::size_t axis) const { return cells[axis][1] - cells[axis][0]; }
  std::size_t longest() const {
    std::size_t axis = 0;
    for (std::size_t a = 1; a < 3; ++a)
      if (size(a) > size(axis)) axis = a;
    return axis;
  }
};
struct IsFartherBlock {
  bool operator()(const CageBlock& a, const CageBlock& b) const {
    return a.bound != b.bound ? a.bound > b.bound : a.number > b.number;
  }
};

class ClearanceSearch {
 public:
  ClearanceSearch(const Microstructure& micro, const DistanceParts& surface, unsigned jobs,
                  const ClearanceLimits& limits)
      : micro_(micro), surface_(surface), jobs_(jobs), limits_(limits) {
    for (const MicroTile& tile : micro.tiles) trees_.emplace_back(tile);
    for (const MicroGrid& grid : micro.grids) {
      auto& to = axes_.emplace_back();
      for (std::size_t a = 0; a < 3; ++a)
        to[a] = axis_parts(breaks_of(micro.cage[grid.volume].axis(a)), grid.breaks[a]);
    }
  }

  Result<std::optional<Clearance>> run() {
    for (std::uint32_t g = 0; g < axes_.size(); ++g) start(g);
    if (queue_.empty() && is_bounded_) return std::optional<Clearance>();
    Clearance out{HUGE_VAL, HUGE_VAL};
    std::size_t size = 1;
    while (is_bounded_) {
      const std::vector<CageBlock> batch = next_cells(size, out.hi);
      if (batch.empty()) break;
      search(batch, out);
      size = std::min(kMostInBatch, 2 * size);
    }
    if (!is_bounded_ || !(out.hi < HUGE_VAL))
      return Error{Code::kNotFinite, {}, "the distances of tiles from the surface are not bounded"};
    if (!queue_.empty()) out.lo = std::min(out.lo, queue_.top().bound);
    out.lo = std::min(out.lo, out.hi);
    return std::optional(out);
  }

 private:
  bool holds_tile(std::uint32_t number, const CellRange& cells) const {
    const MicroGrid& grid = micro_.grids[number];
    const Grid<3> shape = grid.shape();
    for (std::size_t i = cells[0][0]; i < cells[0][1]; ++i)
      for (std::size_t j = cells[1][0]; j < cells[1][1]; ++j) {
        const std::uint8_t* const row = grid.tiles.data() + shape.at({i, j, 0});
        if (std::any_of(row + cells[2][0], row + cells[2][1],
                        [](std::uint8_t t) { return t != 0; }))
          return true;
      }
    return false;
  }

  // The blocks between knots that hold a tile.
  void start(std::uint32_t grid) {
    const auto& axes = axes_[grid];
    const auto range = [&](std::size_t a, std::size_t s) {
      return std::array<std::size_t, 2>{axes[a].first_of_span[s], axes[a].first_of_span[s + 1]};
    };
    for (std::size_t i = 0; i + 1 < axes[0].first_of_span.size(); ++i)
      for (std::size_t j = 0; j + 1 < axes[1].first_of_span.size(); ++j)
        for (std::size_t k = 0; k + 1 < axes[2].first_of_span.size(); ++k) {
          CageBlock block;
          block.grid = grid;
          block.cells = {range(0, i), range(1, j), range(2, k)};
          block.span = span_net(block);
          push(block, HUGE_VAL, false);
        }
  }
  std::shared_ptr<const PartNet> span_net(const CageBlock& block) const {
    const VVolume& volume = micro_.cage[micro_.grids[block.grid].volume];
    std::array<std::size_t, 3> knots;
    for (std::size_t a = 0; a < 3; ++a)
      knots[a] = find_span(volume.axis(a), micro_.grids[block.grid].breaks[a][block.cells[a][0]]);
    return std::make_shared<const PartNet>(bezier_piece(volume, knots));
  }
  PartNet net_of(const CageBlock& block) const {
    Box3 begin, end;
    for (std::size_t a = 0; a < 3; ++a) {
      begin[a] = axes_[block.grid][a].cells[block.cells[a][0]].lo_bound;
      end[a] = axes_[block.grid][a].cells[block.cells[a][1] - 1].hi_bound;
    }
    return block.span->part(begin, end);
  }

  // Only parts of the surface that are nearer than `known` matter. A block keeps its span's map if it is to.
  void push(CageBlock& block, double known, bool keeps_span) {
    if (!holds_tile(block.grid, block.cells)) return;
    ++nodes_;
    is_bounded_ = is_bounded_ && net_of(block).points(&scratch_);
    if (is_bounded_) {
      points_.assign(scratch_);
      is_bounded_ = is_finite(points_.box);
    }
    if (!is_bounded_) return;
    // Boxes only: the search of a cell looks closer.
    double bound = known;
    surface_.visit_near(
        points_.box, [&] { return bound; },
        [&](std::uint32_t part) { bound = std::min(bound, surface_.distance(part, points_.box)); });
    block.bound = std::max(block.bound, bound);
    block.number = nodes_;
    if (!keeps_span) block.span = nullptr;
    queue_.push(block);
  }

  // Blocks of one cell that may hold what is nearest, those with the least bounds.
  std::vector<CageBlock> next_cells(std::size_t most, double known) {
    std::vector<CageBlock> out;
    while (is_bounded_ && !queue_.empty() && out.size() < most &&
           (nodes_ < limits_.nodes || !(known < HUGE_VAL))) {
      if (known < HUGE_VAL &&
          queue_.top().bound >= (Interval(known) / Interval(kEnoughClearance)).lo())
        break;
      CageBlock block = queue_.top();
      queue_.pop();
      if (block.span == nullptr) block.span = span_net(block);
      const std::size_t axis = block.longest();
      if (block.size(axis) == 1) {
        out.push_back(std::move(block));
        continue;
      }
      CageBlock low = block, high = block;
      low.cells[axis][1] = high.cells[axis][0] = block.cells[axis][0] + block.size(axis) / 2;
      push(low, known, true);
      push(high, known, true);
    }
    return out;
  }

  void search(const std::vector<CageBlock>& batch, Clearance& out) {
    std::vector<CellClearance> found(batch.size());
    const double known = out.hi;
    parallel_for(batch.size(), 1, jobs_, [&](std::size_t n, std::size_t, std::size_t) {
      const ScopedUpward upward;
      const CageBlock& block = batch[n];
      const MicroGrid& grid = micro_.grids[block.grid];
      const std::array<std::size_t, 3> cell = {block.cells[0][0], block.cells[1][0],
                                               block.cells[2][0]};
      const std::size_t tile = grid.tiles[grid.shape().at(cell)] - std::size_t{1};
      found[n] = clearance_of_cell(net_of(block), trees_[tile], grid.numbers_of(cell), surface_,
                                   known, limits_.nodes_of_cell);
    });
    for (const CellClearance& c : found) {
      is_bounded_ = is_bounded_ && c.is_bounded;
      out.lo = std::min(out.lo, c.lo);
      out.hi = std::min(out.hi, c.hi);
      nodes_ += c.nodes;
    }
  }

  const Microstructure& micro_;
  const DistanceParts& surface_;
  unsigned jobs_;
  const ClearanceLimits& limits_;
  std::vector<PatchTree> trees_;
  std::vector<std::array<AxisParts, 3>> axes_;  // by grids
  std::priority_queue<CageBlock, std::vector<CageBlock>, IsFartherBlock> queue_;
  std::uint64_t nodes_ = 0;
  bool is_bounded_ = true;
  std::vector<Box3> scratch_;
  NodePoints points_;
};

Result<std::optional<Clearance>> clearance_from(const Microstructure& micro,
                                                const DistanceParts& surface, unsigned jobs,
                                                const ClearanceLimits& limits) {
  if (surface.is_empty()) return std::optional<Clearance>();
  const ScopedUpward upward;
  return ClearanceSearch(micro, surface, jobs, limits).run();
}

}  // namespace

Result<std::optional<Clearance>> clearance_of(const Microstructure& micro, const TriangleMesh& mesh,
                                              unsigned jobs, const ClearanceLimits& limits) {
  return clearance_from(micro, *internal::DistanceParts::of(mesh), jobs, limits);
}

Result<std::optional<Clearance>> clearance_of(const Microstructure& micro,
                                              const PatchComplex& complex, unsigned jobs,
                                              const ClearanceLimits& limits) {
  return clearance_from(micro, *internal::DistanceParts::of(complex), jobs, limits);
}

}  // namespace veritope
