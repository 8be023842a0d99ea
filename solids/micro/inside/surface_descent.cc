// SPDX-License-Identifier: LGPL-3.0-or-later
// I1: the surface of a microstructure misses the surface of the solid.
#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "interval/upward.h"
#include "robust/base/parallel.h"
#include "solids/micro/inside/descent_internal.h"
#include "solids/micro/inside/enclosed_patch_internal.h"
#include "solids/micro/inside/grid_spans_internal.h"
#include "solids/micro/inside/inside_parts_internal.h"
#include "solids/micro/sweep_nodes.h"
#include "solids/micro/sweep_start.h"

namespace veritope::internal {

namespace {

constexpr std::size_t kUnitSide = 16;  // cells along an axis that one thread takes at a time
constexpr std::size_t kUnitBridges = 16;
constexpr int kMostLevel = 56;  // the page has 60

using CellNumber = std::array<std::size_t, 3>;
struct CellBlock {
  CellNumber begin, end;
};

// Cells, or bridges and sweeps, that one thread takes at a time.
struct DescentUnit {
  std::uint32_t grid = 0;
  CellBlock cells{};
  std::size_t first_bridge = 0, past_bridge = 0;
};

// Everything that all units share.
struct DescentWork {
  explicit DescentWork(const InsideParts& p) : parts(p), starts(p.micro, p.tiles) {
    const ScopedUpward upward;
    for (const MicroTile& tile : p.micro.tiles) patches.push_back(enclosed_patches(tile));
    for (const MicroGrid& grid : p.micro.grids) {
      auto& to = axes.emplace_back();
      for (std::size_t a = 0; a < 3; ++a)
        to[a] = axis_parts(p.volumes[grid.volume].knots(a), grid.breaks[a]);
    }
  }
  const InsideParts& parts;
  std::vector<std::vector<EnclosedPatch>> patches;
  std::vector<std::array<AxisParts, 3>> axes;
  SweepStarts starts;
};

class UnitDescent {
 public:
  UnitDescent(const DescentWork& work, const DescentUnit& unit, const DescentCounts& most)
      : work_(work),
        parts_(work.parts),
        unit_(unit),
        budget_(most),
        view_(work.parts.solid.surface().view()) {}

  std::optional<InsideDefect> run() {
    const ScopedUpward upward;
    if (unit_.past_bridge > unit_.first_bridge) {
      for (std::size_t b = unit_.first_bridge; b < unit_.past_bridge && !defect_; ++b)
        parts_.micro.sweeps.empty() ? bridge(b) : sweep(b);
    } else {
      block(unit_.cells, nullptr);
    }
    return std::move(defect_);
  }
  const DescentCounts& counts() const { return budget_.counts(); }

 private:
  const MicroGrid& grid() const { return parts_.micro.grids[unit_.grid]; }

  bool has_tile(const CellBlock& b) const {
    const Grid<3> shape = grid().shape();
    for (std::size_t i = b.begin[0]; i < b.end[0]; ++i)
      for (std::size_t j = b.begin[1]; j < b.end[1]; ++j) {
        const auto* const row = grid().tiles.data() + shape.at({i, j, 0});
        if (std::any_of(row + b.begin[2], row + b.end[2], [](std::uint8_t t) { return t != 0; }))
          return true;
      }
    return false;
  }

  void keep_close(std::span<const NodePoints> node, PartNumbers* parts) {
    budget_.add_pairs(view_->keep_close(node, parts));
  }

  // The points of scratch_, as a checker knows them: what it cannot see to be apart is not taken to be.
  void set_points(double checkers_error) {
    points_.assign(scratch_);
    points_.widen(checkers_error);
  }

  void block(const CellBlock& b, const PartNumbers* from) {
    if (defect_ || budget_.is_spent() || !has_tile(b)) return;
    const auto& axes = work_.axes[unit_.grid];
    std::array<std::size_t, 3> spans{};
    Box3 begin, end;
    std::size_t longest = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      spans[a] = axes[a].cells[b.begin[a]].span;
      begin[a] = axes[a].cells[b.begin[a]].lo_bound;
      end[a] = axes[a].cells[b.end[a] - 1].hi_bound;
      if (b.end[a] - b.begin[a] > b.end[longest] - b.begin[longest]) longest = a;
    }
    const PartNet net = parts_.volumes[grid().volume].net(spans).part(begin, end);
    std::optional<PartNumbers> close;
    if (net.points(&scratch_)) {
      set_points(net.checkers_error());
      close = from == nullptr ? view_->near(points_.box) : *from;
      keep_close({&points_, 1}, &*close);
      if (close->empty()) return;
    }
    const PartNumbers* const list = close ? &*close : from;
    const std::size_t size = b.end[longest] - b.begin[longest];
    if (size == 1) {
      if (list == nullptr) return fail_on_weights();
      return cell(b.begin, net, *list);
    }
    CellBlock low = b, high = b;
    low.end[longest] = high.begin[longest] = b.begin[longest] + size / 2;
    block(low, list);
    block(high, list);
  }
  void fail_on_weights() {
    defect_ = InsideDefect{"I1", {}, {}, {}, "a weight of the cage is not proved to be positive"};
  }

  void cell(const CellNumber& number, const PartNet& net, const PartNumbers& close) {
    const Grid<3> shape = grid().shape();
    CellPatch at{unit_.grid, shape.at(number), 0};
    const auto numbers = grid().numbers_of(number);
    const auto& patches = work_.patches[grid().tiles[at.cell] - 1u];
    for (; at.patch < patches.size() && !defect_ && !budget_.is_spent(); ++at.patch) {
      const EnclosedPatch& patch = patches[at.patch];
      PatchNode root{patch.degrees, {}, 0};
      const std::int32_t t =
          patch.wall ? numbers[static_cast<std::size_t>(*patch.wall)] : std::int32_t{0};
      patch_points(patch, t, &root.points);
      const auto close_to = [&](const PatchNode& node, PartNumbers* near) {
        const Box3 x = node.box();
        const PartNet part = net.part(lower_ends(x), upper_ends(x));
        if (!part.points(&scratch_)) return;
        set_points(net.checkers_error());
        keep_close({&points_, 1}, near);
      };
      if (const auto left = descend(std::move(root), close, kMostLevel, budget_, close_to))
        fail(parts_.name(at), *left, at, std::nullopt);
    }
  }

  void bridge(std::size_t number) {
    const MicroBridge& b = parts_.micro.bridges[number];
    const BridgeMaps maps(parts_.volumes[b.volume]);
    const auto close_to = [&](const BridgeNode& node, PartNumbers* near) {
      std::vector<NodePoints> all;
      if (!maps.points(node.box(), &all)) return;
      if (all.size() > 1) budget_.add_nodes(all.size() - 1);
      for (NodePoints& points : all) points.widen(maps.checkers_error());
      keep_close(all, near);
    };
    BridgeNode root = enclosed_bridge(b);
    PartNumbers all = parts_near(maps, root);
    if (const auto left = descend(std::move(root), std::move(all), kMostLevel, budget_, close_to))
      fail("bridge " + std::to_string(number), *left, std::nullopt,
           static_cast<std::uint32_t>(number));
  }
  // REQUIRES a cap of one patch.
  void sweep(std::size_t number) {
    const MicroSweep& s = parts_.micro.sweeps[number];
    const double error = parts_.volumes[parts_.micro.grids[s.cap.grid].volume].checkers_error();
    SweepNodes nodes(work_.starts.wall(s.cap), work_.starts.cap(s.cap).value(), s.axis);
    nodes.points({}, &scratch_);
    set_points(error);
    PartNumbers all = view_->near(points_.box);
    std::sort(all.begin(), all.end());
    const auto close_to = [&](const SweepPart& part, PartNumbers* near) {
      nodes.points(part.node, &scratch_);
      set_points(error);
      keep_close({&points_, 1}, near);
    };
    if (const auto left =
            descend(SweepPart{&nodes, {}, 0}, std::move(all), kMostLevel, budget_, close_to))
      fail("sweep " + std::to_string(number), *left, std::nullopt,
           static_cast<std::uint32_t>(number));
  }
  PartNumbers parts_near(const BridgeMaps& maps, const BridgeNode& node) const {
    std::vector<NodePoints> all;
    Box3d box = empty_box();
    if (maps.points(node.box(), &all))
      for (NodePoints& points : all) {
        points.widen(maps.checkers_error());
        box = hull(box, points.box);
      }
    else
      box = parts_.solid.surface().box();
    PartNumbers out = view_->near(box);
    std::sort(out.begin(), out.end());
    return out;
  }
  void fail(const std::string& what, std::uint32_t part, std::optional<CellPatch> patch,
            std::optional<std::uint32_t> bridge) {
    const std::uint32_t source = view_->source(part);
    defect_ = InsideDefect{"I1", patch, bridge, source,
                           what + " is not proved to miss " + parts_.solid.name(source)};
  }

  const DescentWork& work_;
  const InsideParts& parts_;
  const DescentUnit& unit_;
  DescentBudget budget_;
  std::unique_ptr<SurfaceView> view_;
  std::optional<InsideDefect> defect_;
  std::vector<Box3> scratch_;
  NodePoints points_;
};

std::vector<DescentUnit> descent_units(const DescentWork& work) {
  std::vector<DescentUnit> out;
  for (std::uint32_t g = 0; g < work.axes.size(); ++g) {
    std::array<std::vector<std::pair<std::size_t, std::size_t>>, 3> ranges;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto& firsts = work.axes[g][a].first_of_span;
      for (std::size_t s = 0; s + 1 < firsts.size(); ++s) {
        const std::size_t n = firsts[s + 1] - firsts[s], num = num_chunks(n, kUnitSide);
        for (std::size_t i = 0; i < num; ++i)
          ranges[a].emplace_back(firsts[s] + n * i / num, firsts[s] + n * (i + 1) / num);
      }
    }
    for (const auto& x : ranges[0])
      for (const auto& y : ranges[1])
        for (const auto& z : ranges[2])
          out.push_back({g, {{x.first, y.first, z.first}, {x.second, y.second, z.second}}, 0, 0});
  }
  const std::size_t n = work.parts.micro.num_bridges();
  for (std::size_t b = 0; b < n; b += kUnitBridges)
    out.push_back({0, {}, b, std::min(n, b + kUnitBridges)});
  return out;
}

DescentCounts most_work(const InsideParts& parts) {
  std::uint64_t num_parts = parts.micro.num_bridges();
  for (const MicroGrid& grid : parts.micro.grids)
    for (const std::uint8_t t : grid.tiles)
      if (t != 0) num_parts += parts.micro.tiles[t - 1u].patches.size();
  return {parts.limits.nodes + parts.limits.nodes_of_part * num_parts, parts.limits.pairs};
}

}  // namespace

std::optional<InsideDefect> surface_defect(const InsideParts& parts) {
  const DescentWork work(parts);
  const std::vector<DescentUnit> units = descent_units(work);
  const DescentCounts most = most_work(parts);
  std::vector<std::optional<InsideDefect>> defects(units.size());
  std::vector<DescentCounts> counts(units.size());
  // Units after one with a defect do not matter.
  std::atomic<std::size_t> first_bad{units.size()};
  parallel_for(units.size(), 1, parts.jobs, [&](std::size_t k, std::size_t, std::size_t) {
    if (k > first_bad.load(std::memory_order_relaxed)) return;
    UnitDescent descent(work, units[k], most);
    defects[k] = descent.run();
    counts[k] = descent.counts();
    if (!defects[k] && counts[k].is_within(most)) return;
    std::size_t known = first_bad.load();
    while (k < known && !first_bad.compare_exchange_weak(known, k)) {
    }
  });
  DescentCounts sum;
  for (std::size_t k = 0; k < units.size(); ++k) {
    if (defects[k]) return std::move(defects[k]);
    sum.add(counts[k]);
    if (!sum.is_within(most))
      return InsideDefect{"I1",
                          {},
                          {},
                          {},
                          "that the surfaces do not meet takes more than " +
                              std::to_string(most.nodes) + " parts of patches, or " +
                              std::to_string(most.pairs) + " comparisons with " +
                              parts.solid.sources()};
  }
  return std::nullopt;
}

}  // namespace veritope::internal
