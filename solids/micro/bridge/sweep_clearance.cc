// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <memory>

#include "interval/box_geometry.h"
#include "interval/upward.h"
#include "robust/base/parallel.h"
#include "solids/micro/bridge/sweep_clearance_internal.h"

namespace veritope::internal {
namespace {

constexpr int kMostNodeLevel = 38;  // the page has 40

// The products of points with the axes and with the rows of a matrix.
using Spread = std::array<Interval, 6>;

Interval range_of(const Box3& v, const std::vector<Box3>& points) {
  Interval out = dot(v, points.front());
  for (const Box3& p : points) out = hull(out, dot(v, p));
  return out;
}
Spread spread_of(const std::array<Box3, 3>& rows, const std::vector<Box3>& points) {
  Spread out;
  for (std::size_t c = 0; c < 3; ++c) {
    out[c] = points.front()[c];
    for (const Box3& p : points) out[c] = hull(out[c], p[c]);
    out[3 + c] = range_of(rows[c], points);
  }
  return out;
}
bool is_left_of(const Interval& a, const Interval& b) { return a.hi() < b.lo(); }
bool are_parted(const Interval& a, const Interval& b) {
  return is_left_of(a, b) || is_left_of(b, a);
}
bool boxes_meet(const Spread& a, const Spread& b) {
  return !are_parted(a[0], b[0]) && !are_parted(a[1], b[1]) && !are_parted(a[2], b[2]);
}
bool are_apart(const Spread& a, const Spread& b) {
  for (std::size_t k = 0; k < a.size(); ++k)
    if (are_parted(a[k], b[k])) return true;
  return false;
}
double size_of_spread(const Spread& s) {
  double out = 0;
  for (std::size_t c = 0; c < 3; ++c) out = std::max(out, s[c].hi() - s[c].lo());
  return out;
}

// The products of the points of nodes of a sweep, kept for its parts and steps.
class SweepSpreads {
 public:
  SweepSpreads(const SweepNodes& nodes, const std::array<Box3, 3>& rows)
      : nodes_(nodes), rows_(rows) {}
  Spread operator()(const SweepNodes::Node& node) {
    const Spread &a = of_part(node), &b = of_step(node);
    Spread out;
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = a[k] + b[k];
    return out;
  }

 private:
  const Spread& of_part(const SweepNodes::Node& node) {
    if (parts_.size() <= node.part) parts_.resize(node.part + 1);
    if (!parts_[node.part]) parts_[node.part] = spread_of(rows_, nodes_.cap_points(node));
    return *parts_[node.part];
  }
  const Spread& of_step(const SweepNodes::Node& node) {
    if (steps_.size() <= node.step) steps_.resize(node.step + 1);
    if (!steps_[node.step]) {
      const auto& g = nodes_.curve_points(node);
      steps_[node.step] = spread_of(rows_, {g.begin(), g.end()});
    }
    return *steps_[node.step];
  }
  const SweepNodes& nodes_;
  const std::array<Box3, 3>& rows_;
  std::vector<std::optional<Spread>> parts_, steps_;
};

// Patches of the tile of a cell, halved as they are asked for. Node 0 is the cell.
class TileTree {
 public:
  struct Node {
    std::array<int, 2> degrees{};
    std::vector<Box3> net;  // in the parameters of the volume
    int level = 0;
    Spread spread;
    bool is_in_slab = false;
    std::vector<std::uint32_t> children;
  };

  TileTree(const Microstructure& micro, const VolumeSpace& space, std::uint32_t grid,
           std::uint64_t cell, const PlacedSweep& sweep)
      : micro_(micro), space_(space), grid_(micro.grids[grid]), cell_(cell), sweep_(sweep) {
    if (sweep.cap.grid == grid && sweep.cap.cell == cell) find_slab();
    at_ = grid_.shape().index_of(cell);
    Node whole;
    for (std::size_t a = 0; a < 3; ++a) {
      origin_[a] = enclose(grid_.breaks[a][at_[a]]);
      width_[a] = enclose(grid_.breaks[a][at_[a] + 1] - grid_.breaks[a][at_[a]]);
    }
    Box3 first, last;
    for (std::size_t a = 0; a < 3; ++a) {
      first[a] = origin_[a];
      last[a] = enclose(grid_.breaks[a][at_[a] + 1]);
    }
    whole.net = {first, last};
    nodes_.push_back(finished(std::move(whole)));
    nodes_.front().is_in_slab = false;
  }

  const Node& operator[](std::uint32_t node) const { return nodes_[node]; }
  bool may_be_halved(std::uint32_t node) const { return nodes_[node].level < kMostNodeLevel; }
  const std::vector<std::uint32_t>& children(std::uint32_t node) {
    if (nodes_[node].children.empty()) {
      std::vector<Node> parts = node == 0 ? patches() : halves(nodes_[node]);
      for (Node& part : parts) {
        nodes_[node].children.push_back(static_cast<std::uint32_t>(nodes_.size()));
        nodes_.push_back(finished(std::move(part)));
      }
    }
    return nodes_[node].children;
  }

 private:
  void find_slab() {
    const auto axis = static_cast<std::size_t>(sweep_.cap.wall / 2);
    const std::size_t i = grid_.shape().index_of(cell_)[axis];
    const Rational &lo = grid_.breaks[axis][i], &hi = grid_.breaks[axis][i + 1];
    if (sweep_.cap.wall % 2 == 1)
      slab_lo_ = round_up(hi - sweep_.depth * (hi - lo));
    else
      slab_hi_ = round_down(lo + sweep_.depth * (hi - lo));
    slab_axis_ = axis;
  }
  std::vector<Node> patches() const {
    std::vector<Node> out;
    const auto numbers = grid_.numbers_of(at_);
    for (const TilePatch& patch : micro_.tiles[grid_.tiles[cell_] - 1u].patches) {
      Node& node = out.emplace_back();
      node.degrees = patch.degrees;
      for (const TilePoint& p : points_at(patch, number_of(patch, numbers))) {
        Box3& q = node.net.emplace_back();
        for (std::size_t a = 0; a < 3; ++a) q[a] = origin_[a] + width_[a] * enclose(p[a]);
      }
    }
    return out;
  }
  static std::vector<Node> halves(const Node& node) {
    std::vector<Node> out(2);
    out[0].degrees = out[1].degrees = node.degrees;
    out[0].level = out[1].level = node.level + 1;
    out[0].net = out[1].net = node.net;
    const Grid<2> grid{{static_cast<std::size_t>(node.degrees[0]) + 1,
                        static_cast<std::size_t>(node.degrees[1]) + 1}};
    const std::size_t axis = static_cast<std::size_t>(node.level) % 2, step = grid.stride(axis),
                      n = grid.size[axis] - 1;
    const Interval half(0.5);
    grid.for_each_line(axis, [&](std::size_t first) {
      for (std::size_t r = 1; r <= n; ++r) {
        for (std::size_t i = 0; i + r <= n; ++i) {
          Box3& p = out[1].net[first + i * step];
          p = half * (p + out[1].net[first + (i + 1) * step]);
        }
        out[0].net[first + r * step] = out[1].net[first];
      }
    });
    return out;
  }
  // With the spread of its points in space.
  Node finished(Node node) const {
    Box3 x = node.net.front();
    for (const Box3& p : node.net) x = hull(x, p);
    if (slab_axis_)
      node.is_in_slab = x[*slab_axis_].lo() >= slab_lo_ && x[*slab_axis_].hi() <= slab_hi_;
    node.spread.fill(Interval::entire());
    std::vector<HullPoints> hulls;
    const Box3d box{{x[0].lo(), x[1].lo(), x[2].lo()}, {x[0].hi(), x[1].hi(), x[2].hi()}};
    if (!space_.hulls(box, &hulls) || hulls.empty()) return node;
    HullPoints all;
    for (const HullPoints& points : hulls) all.insert(all.end(), points.begin(), points.end());
    node.spread = spread_of(sweep_.rows, all);
    return node;
  }

  const Microstructure& micro_;
  const VolumeSpace& space_;
  const MicroGrid& grid_;
  std::uint64_t cell_;
  const PlacedSweep& sweep_;
  std::array<std::size_t, 3> at_{};
  Box3 origin_, width_;
  std::optional<std::size_t> slab_axis_;
  double slab_lo_ = -std::numeric_limits<double>::infinity(),
         slab_hi_ = std::numeric_limits<double>::infinity();
  std::vector<Node> nodes_;
};

// The descent of Q3 for the tile of one cell.
bool are_missed(TileTree& tree, SweepNodes& nodes, SweepSpreads& spreads, PairBudget& budget) {
  std::vector<std::pair<std::uint32_t, SweepNodes::Node>> stack = {{0, {}}};
  while (!stack.empty()) {
    const auto [tile, node] = stack.back();
    stack.pop_back();
    if (tree[tile].is_in_slab) continue;
    const Spread spread = spreads(node);
    if (!boxes_meet(tree[tile].spread, spread)) continue;
    if (++budget.spent > budget.most) return false;
    if (are_apart(tree[tile].spread, spread)) continue;
    const bool sweep_is_larger = size_of_spread(tree[tile].spread) < size_of_spread(spread);
    if (node.level < kMostNodeLevel && (sweep_is_larger || !tree.may_be_halved(tile))) {
      const auto [a, b] = nodes.halves(node);
      stack.emplace_back(tile, b);
      stack.emplace_back(tile, a);
    } else if (tree.may_be_halved(tile)) {
      for (const std::uint32_t part : tree.children(tile)) stack.emplace_back(part, node);
    } else {
      return false;
    }
  }
  return true;
}

}  // namespace

PlacedSweep::PlacedSweep(const SweepStarts& starts, const MicroSweep& sweep,
                         const SweepWitness& witness)
    : cap(sweep.cap),
      depth(witness.depth),
      nodes(starts.wall(sweep.cap), starts.cap(sweep.cap).value(), sweep.axis),
      box(nodes.box({})) {
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) rows[r][c] = enclose(witness.matrix[3 * r + c]);
}

TilesInSpace::TilesInSpace(const Microstructure& micro, const std::vector<VolumeSpace>& spaces,
                           unsigned jobs)
    : micro_(micro), spaces_(spaces) {
  for (std::uint32_t g = 0; g < micro.grids.size(); ++g) add_blocks(g);
  std::vector<Box3d> boxes(blocks_.size());
  parallel_for(blocks_.size(), 256, jobs, [&](std::size_t, std::size_t begin, std::size_t end) {
    const ScopedUpward upward;
    for (std::size_t b = begin; b < end; ++b) {
      const Block& block = blocks_[b];
      const Grid<3> shape = micro_.grids[block.grid].shape();
      std::array<std::size_t, 3> first, past;
      for (std::size_t a = 0; a < 3; ++a) {
        first[a] = block.first[a];
        past[a] = std::min<std::size_t>(shape.size[a], block.first[a] + kBlockSide);
      }
      boxes[b] = image_of(block.grid, parameters_of(block.grid, first, past));
    }
  });
  tree_ = BoxHierarchy(boxes);
}

// Those with tiles.
void TilesInSpace::add_blocks(std::uint32_t grid) {
  const MicroGrid& m = micro_.grids[grid];
  const Grid<3> shape = m.shape();
  Grid<3> blocks;
  for (std::size_t a = 0; a < 3; ++a)
    blocks.size[a] = (shape.size[a] + kBlockSide - 1) / kBlockSide;
  std::vector<char> has_tile(blocks.count());
  for (std::size_t c = 0; c < m.tiles.size(); ++c) {
    if (m.tiles[c] == 0) continue;
    auto at = shape.index_of(c);
    for (std::size_t& i : at) i /= kBlockSide;
    has_tile[blocks.at(at)] = 1;
  }
  for (std::size_t b = 0; b < has_tile.size(); ++b) {
    if (has_tile[b] == 0) continue;
    Block& out = blocks_.emplace_back();
    out.grid = grid;
    for (std::size_t a = 0; a < 3; ++a)
      out.first[a] = static_cast<std::uint32_t>(blocks.index_of(b)[a]) * kBlockSide;
  }
}

Box3d TilesInSpace::parameters_of(std::uint32_t grid, const std::array<std::size_t, 3>& first,
                                  const std::array<std::size_t, 3>& past) const {
  Box3d out;
  for (std::size_t a = 0; a < 3; ++a) {
    out.lo[a] = round_down(micro_.grids[grid].breaks[a][first[a]]);
    out.hi[a] = round_up(micro_.grids[grid].breaks[a][past[a]]);
  }
  return out;
}

Box3d TilesInSpace::image_of(std::uint32_t grid, const Box3d& parameters) const {
  constexpr double kAll = std::numeric_limits<double>::max();
  std::vector<HullPoints> hulls;
  if (!spaces_[micro_.grids[grid].volume].hulls(parameters, &hulls))
    return {{-kAll, -kAll, -kAll}, {kAll, kAll, kAll}};
  Box3d out = empty_box();
  for (const HullPoints& points : hulls)
    for (const Box3& p : points)
      out = hull(out, Box3d{{p[0].lo(), p[1].lo(), p[2].lo()}, {p[0].hi(), p[1].hi(), p[2].hi()}});
  return out;
}

bool TilesInSpace::are_missed_by(PlacedSweep& sweep, PairBudget& budget) const {
  std::vector<std::uint32_t> near;
  tree_.visit([&](const Box3d& b) { return meets(b, sweep.box); },
              [&](std::uint32_t block) { near.push_back(block); });
  std::sort(near.begin(), near.end());
  SweepSpreads spreads(sweep.nodes, sweep.rows);
  for (const std::uint32_t b : near) {
    const Block& block = blocks_[b];
    const MicroGrid& grid = micro_.grids[block.grid];
    const Grid<3> shape = grid.shape();
    for (std::uint32_t n = 0; n < kBlockSide * kBlockSide * kBlockSide; ++n) {
      std::array<std::size_t, 3> at, past;
      bool is_in = true;
      for (std::size_t a = 0; a < 3; ++a) {
        at[a] = block.first[a] + (n >> a & 1);
        past[a] = at[a] + 1;
        is_in = is_in && at[a] < shape.size[a];
      }
      if (!is_in || grid.tiles[shape.at(at)] == 0) continue;
      if (!meets(image_of(block.grid, parameters_of(block.grid, at, past)), sweep.box)) continue;
      TileTree tree(micro_, spaces_[grid.volume], block.grid, shape.at(at), sweep);
      if (!are_missed(tree, sweep.nodes, spreads, budget)) return false;
    }
  }
  return true;
}

namespace {

// The products of the points of a node with three vectors.
std::array<Interval, 3> products_of(const SweepNodes& nodes, const SweepNodes::Node& node,
                                    const std::array<Box3, 3>& vectors) {
  const auto& g = nodes.curve_points(node);
  const std::vector<Box3> curve(g.begin(), g.end());
  std::array<Interval, 3> out;
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = range_of(vectors[k], nodes.cap_points(node)) + range_of(vectors[k], curve);
  return out;
}
bool are_parted_along(const std::array<Interval, 3>& a, const std::array<Interval, 3>& b) {
  return are_parted(a[0], b[0]) || are_parted(a[1], b[1]) || are_parted(a[2], b[2]);
}

bool are_disjoint(PlacedSweep& a, PlacedSweep& b, PairBudget& budget) {
  std::vector<std::pair<SweepNodes::Node, SweepNodes::Node>> stack(1);
  while (!stack.empty()) {
    const auto [x, y] = stack.back();
    stack.pop_back();
    const Box3d box_x = a.nodes.box(x), box_y = b.nodes.box(y);
    if (!meets(box_x, box_y)) continue;
    if (++budget.spent > budget.most) return false;
    if (are_parted_along(products_of(a.nodes, x, a.rows), products_of(b.nodes, y, a.rows)) ||
        are_parted_along(products_of(a.nodes, x, b.rows), products_of(b.nodes, y, b.rows)))
      continue;
    if (x.level >= kMostNodeLevel || y.level >= kMostNodeLevel) return false;
    if (extent(box_x) >= extent(box_y)) {
      const auto [low, high] = a.nodes.halves(x);
      stack.emplace_back(high, y);
      stack.emplace_back(low, y);
    } else {
      const auto [low, high] = b.nodes.halves(y);
      stack.emplace_back(x, high);
      stack.emplace_back(x, low);
    }
  }
  return true;
}

}  // namespace

std::optional<std::size_t> DisjointSweeps::add(PlacedSweep sweep, PairBudget& budget) {
  if (!bins_) {
    const double size = extent(sweep.box);
    bins_.emplace(Point3d{size, size, size});
  }
  for (const std::uint32_t i : bins_->near(sweep.box))
    if (meets(sweeps_[i].box, sweep.box) && !are_disjoint(sweeps_[i], sweep, budget)) return i;
  bins_->add(static_cast<std::uint32_t>(sweeps_.size()), sweep.box);
  sweeps_.push_back(std::move(sweep));
  return std::nullopt;
}

}  // namespace veritope::internal
