// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_sweep_pairs.cc: Q3 and Q4 of docs/certificates/microstructure.md.
#include "micro_sweeps.h"

namespace {

const int kMostLevelOfPair = 40;
const size_t kMostBlocks = 1 << 21;  // that are kept for the next sweep

DoubleBox box_of(const PointHull& hull) {
  if (hull.is_known) return hull.box;
  const double far = std::numeric_limits<double>::infinity();
  return DoubleBox{{-far, -far, -far}, {far, far, far}};
}
double extent(const DoubleBox& b) {
  return std::max(b.hi[0] - b.lo[0], std::max(b.hi[1] - b.lo[1], b.hi[2] - b.lo[2]));
}

// The least and the greatest value of v.p over the points p, or more. With r for the greatest value of the points and e
// for their error, and d for that of v, whose numbers have the sum s, a computed one differs by less than s e + 3 d (r +
// e) + 2^-48 s r from the exact one.
Span values_of(const PointHull& hull, const Span* v) {
  Span r = {0, 0};
  double x[3], sum = 0, error = 0, size = 0;
  for (size_t k = 0; k < 3; ++k) {
    x[k] = v[k].lo + (v[k].hi - v[k].lo) / 2;
    sum += std::abs(x[k]);
    error = std::max(error, v[k].hi - v[k].lo);
    for (double end : {hull.box.lo[k], hull.box.hi[k]}) size = std::max(size, std::abs(end));
  }
  for (size_t i = 0; i < hull.p.size(); i += 3) {
    const double value = x[0] * hull.p[i] + x[1] * hull.p[i + 1] + x[2] * hull.p[i + 2];
    r.lo = i == 0 ? value : std::min(r.lo, value);
    r.hi = i == 0 ? value : std::max(r.hi, value);
  }
  const double more = 2 * (sum * hull.error + 3 * error * (size + hull.error)) +
                      std::ldexp(sum * size, -46) + kTiny;
  return Span{r.lo - more, r.hi + more};
}

}  // namespace

BlockTree::BlockTree(TileParts* parts) : parts_(*parts) {
  const std::vector<MicroGrid>& grids = parts->file().grids;
  std::vector<DoubleBox> boxes;
  for (uint32_t g = 0; g < grids.size(); ++g)
    parts->each_box(grids[g], [&](const size_t* box, const CellBlock& block) {
      const uint32_t knots[3] = {uint32_t(box[0]), uint32_t(box[1]), uint32_t(box[2])};
      nodes_.push_back(make(g, knots, block));
      boxes.push_back(nodes_.back().box);
    });
  roots_ = nodes_.size();
  tree_.reset(new BoxTree(boxes));
}
BlockTree::Node BlockTree::make(uint32_t grid, const uint32_t* knots, const CellBlock& block) {
  Node r;
  r.grid = grid, r.block = block, r.child = 0;
  std::copy(knots, knots + 3, r.knots);
  const MicroGrid& g = parts_.file().grids[grid];
  r.is_held = holds_tile(g, block);
  if (!r.is_held) return r;
  const size_t box[3] = {knots[0], knots[1], knots[2]};
  PointHull hull;
  set_hull(parts_.net_in(g, box, block).net, &hull);
  r.box = box_of(hull);
  return r;
}
void BlockTree::tidy() {
  if (nodes_.size() <= roots_ + kMostBlocks) return;
  nodes_.erase(nodes_.begin() + long(roots_), nodes_.end());
  for (Node& n : nodes_) n.child = 0;
}
void BlockTree::each_cell(
    const DoubleBox& box, const std::function<void()>& count,
    const std::function<void(const MicroGrid&, const size_t*, const CellNet&)>& use) {
  tidy();
  std::vector<uint32_t> open;
  tree_->each(box, [&](uint32_t root) {
    open.push_back(root);
    return true;
  });
  while (!open.empty()) {
    const uint32_t i = open.back();
    open.pop_back();
    if (!nodes_[i].is_held || !nodes_[i].box.meets(box)) continue;
    count();
    const CellBlock block = nodes_[i].block;
    const uint32_t grid = nodes_[i].grid;
    uint32_t knots[3];
    std::copy(nodes_[i].knots, nodes_[i].knots + 3, knots);
    if (block.is_cell()) {
      const size_t at[3] = {knots[0], knots[1], knots[2]};
      const MicroGrid& g = parts_.file().grids[grid];
      use(g, block.lo, parts_.net_in(g, at, block));
      continue;
    }
    if (nodes_[i].child == 0) {
      nodes_[i].child = uint32_t(nodes_.size());
      const std::pair<CellBlock, CellBlock> halves = block.halves();
      nodes_.push_back(make(grid, knots, halves.first));
      nodes_.push_back(make(grid, knots, halves.second));
    }
    open.push_back(nodes_[i].child), open.push_back(nodes_[i].child + 1);
  }
}

// The nodes of a patch in a cell, or of a sweep, made when they are needed.
class SweepPairs::Nodes {
 public:
  struct Node {
    DoubleNet net;      // in the cell's unit cube
    double begin, end;  // of w
    int level;
    uint32_t child;  // the lower half; 0: not made yet
    DoubleBox box;   // contains the points
    Span rows[6];    // the values of the rows of K, or of two, at the points
    bool is_known, is_passed;
  };
  // Rows: of these matrices; others: null.
  Nodes(TileParts* parts, const CellNet& cell, const MicroSweep* first, const MicroSweep* second)
      : parts_(*parts), cell_(cell), matrix_{first, second} {}

  void start(const DoubleNet& net, const SweepPart* sweep, const MicroSweep* slab) {
    sweep_ = sweep, slab_ = slab;
    nodes_.clear();
    add(net, 0, 1, 0);
  }
  const Node& operator[](uint32_t i) const { return nodes_[i]; }
  size_t rows() const { return matrix_[1] != nullptr ? 6 : 3; }
  uint32_t children(uint32_t i) {
    if (nodes_[i].child != 0) return nodes_[i].child;
    const uint32_t child = nodes_[i].child = uint32_t(nodes_.size());
    const int level = nodes_[i].level;
    const double begin = nodes_[i].begin, end = nodes_[i].end, middle = (begin + end) / 2;
    DoubleNet lower = nodes_[i].net, upper = lower;
    const bool is_along = sweep_ != nullptr && level % 3 == 2;
    if (!is_along)
      halve_net(nodes_[i].net, size_t(sweep_ != nullptr ? level % 3 : level % 2), &lower, &upper);
    add(std::move(lower), begin, is_along ? middle : end, level + 1);
    add(std::move(upper), is_along ? middle : begin, end, level + 1);
    return child;
  }

 private:
  void add(DoubleNet net, double begin, double end, int level) {
    nodes_.push_back(Node());
    Node& n = nodes_.back();
    n.begin = begin, n.end = end, n.level = level, n.child = 0;
    if (sweep_ != nullptr)
      sweep_->set_points(net, begin, end, &hull_);
    else
      parts_.set_points(net, cell_, &hull_);
    n.box = box_of(hull_);
    n.is_known = hull_.is_known;
    for (size_t r = 0; r < rows() && n.is_known; ++r)
      n.rows[r] = values_of(hull_, &matrix_[r / 3]->matrix[r % 3 * 3]);
    n.is_passed = slab_ != nullptr && is_in_slab(::box_of(net));
    n.net = std::move(net);
  }
  // The box of a patch in the cell, whose coefficients are from 0 to 1 by T2.
  bool is_in_slab(const DoubleBox& x) const {
    const size_t axis = slab_->wall / 2;
    if (slab_->depth.lo == 1) return true;
    const double off = slab_->wall % 2 == 0 ? x.hi[axis] : 1 - x.lo[axis];
    return off + std::ldexp(1.0, -50) <= slab_->depth.lo;
  }

  TileParts& parts_;
  const CellNet& cell_;
  const MicroSweep* const matrix_[2];
  const SweepPart* sweep_ = nullptr;  // null: these are the nodes of a patch
  const MicroSweep* slab_ = nullptr;  // nodes in the slab of this sweep are passed over
  std::vector<Node> nodes_;
  PointHull hull_;
};

SweepPairs::SweepPairs(TileParts* parts)
    : parts_(*parts),
      file_(parts->file()),
      blocks_(parts),
      most_pairs_((uint64_t(1) << 22) + (uint64_t(1) << 12) * file_.sweeps.size()) {}

void SweepPairs::descend(Nodes* a, Nodes* b, const char* id, uint64_t number) {
  std::vector<std::pair<uint32_t, uint32_t>> open(1, std::make_pair(0u, 0u));
  while (!open.empty()) {
    const std::pair<uint32_t, uint32_t> at = open.back();
    open.pop_back();
    const Nodes::Node &x = (*a)[at.first], &y = (*b)[at.second];
    if (x.is_passed || !x.box.meets(y.box)) continue;
    add_pair(id);
    bool is_apart = false;
    for (size_t r = 0; r < a->rows() && x.is_known && y.is_known; ++r)
      is_apart = is_apart || x.rows[r].hi < y.rows[r].lo || y.rows[r].hi < x.rows[r].lo;
    if (is_apart) continue;
    const bool is_first = y.level == kMostLevelOfPair ||
                          (x.level < kMostLevelOfPair && !(extent(x.box) < extent(y.box)));
    require(std::min(x.level, y.level) < kMostLevelOfPair, id,
            "it may meet a tile or another sweep: sweep", number);
    if (is_first) {
      const uint32_t child = a->children(at.first);
      open.push_back(std::make_pair(child, at.second));
      open.push_back(std::make_pair(child + 1, at.second));
    } else {
      const uint32_t child = b->children(at.second);
      open.push_back(std::make_pair(at.first, child));
      open.push_back(std::make_pair(at.first, child + 1));
    }
  }
}

void SweepPairs::check_tiles(const MicroSweep& sweep, uint64_t number) {
  const SweepPart part(&parts_, sweep, number, "Q3");
  Nodes of_sweep(&parts_, part.cell(), &sweep, nullptr);
  of_sweep.start(part.cap(), &part, nullptr);
  const Nodes::Node whole = of_sweep[0];
  boxes_.push_back(whole.box);
  PointHull hull;
  blocks_.each_cell(
      whole.box, [this] { add_pair("Q3"); },
      [&](const MicroGrid& g, const size_t* i, const CellNet& cell) {
        const bool is_own = &g == &file_.grids[sweep.grid] && g.cell(i) == sweep.cell;
        set_hull(cell.net, &hull);
        for (size_t r = 0; r < 3 && !is_own && hull.is_known && whole.is_known; ++r) {
          const Span v = values_of(hull, &sweep.matrix[3 * r]);
          if (v.hi < whole.rows[r].lo || whole.rows[r].hi < v.lo) return;
        }
        const size_t tile = g.tile[g.cell(i)] - size_t(1);
        Nodes of_patch(&parts_, cell, &sweep, nullptr);
        for (size_t s = 0; s < file_.tiles[tile].patches.size(); ++s) {
          of_patch.start(parts_.patch_in(g, i, tile, s), nullptr, is_own ? &sweep : nullptr);
          descend(&of_patch, &of_sweep, "Q3", number);
        }
      });
}

void SweepPairs::check_sweeps() {
  const BoxTree tree(boxes_);
  for (uint32_t i = 0; i < boxes_.size(); ++i) {
    std::unique_ptr<const SweepPart> first;
    tree.each(boxes_[i], [&](uint32_t j) {
      if (j <= i) return true;
      const MicroSweep &a = file_.sweeps[i], &b = file_.sweeps[j];
      if (first == nullptr) first.reset(new SweepPart(&parts_, a, i, "Q4"));
      const SweepPart second(&parts_, b, j, "Q4");
      Nodes of_first(&parts_, first->cell(), &a, &b), of_second(&parts_, second.cell(), &a, &b);
      of_first.start(first->cap(), first.get(), nullptr);
      of_second.start(second.cap(), &second, nullptr);
      descend(&of_first, &of_second, "Q4", i);
      return true;
    });
  }
}
