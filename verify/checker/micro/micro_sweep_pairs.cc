// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_sweep_pairs.cc: Q3 and Q4 of docs/certificates/microstructure.md.
#include "micro_sweeps.h"

namespace {

const int kMostLevelOfPair = 40;
const size_t kMostBlocks = 1 << 21;  // that are kept for the next sweep
const uint32_t kNoNode = 0xffffffff;
const int kMostLevelKept = 10;  // of nodes that are kept for other pairs

DoubleBox box_of(const PointHull& hull) {
  if (hull.is_known) return hull.box;
  const double far = std::numeric_limits<double>::infinity();
  return DoubleBox{{-far, -far, -far}, {far, far, far}};
}
double extent(const DoubleBox& b) {
  return std::max(b.hi[0] - b.lo[0], std::max(b.hi[1] - b.lo[1], b.hi[2] - b.lo[2]));
}

// The least and the greatest value of v.p over the points p, or more. With r for the greatest value of the points and e
// for their error, and d for that of v, whose numbers have the sum s, a computed one differs by less than
// s e + 3 d (r + e) + 2^-48 s r from the exact one.
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
      nodes_.back().number = uint32_t(boxes.size());
      boxes.push_back(nodes_.back().box);
    });
  roots_ = nodes_.size();
  tree_.reset(new BoxTree(boxes));
}
BlockTree::Node BlockTree::make(uint32_t grid, const uint32_t* knots, const CellBlock& block) {
  Node r;
  r.grid = grid, r.block = block, r.child = 0, r.number = kNoNode;
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
std::pair<BlockTree::Node, BlockTree::Node> BlockTree::halves(const Node& node) {
  if (node.number != kNoNode && nodes_[node.number].child != 0) {
    const uint32_t child = nodes_[node.number].child;
    return std::make_pair(nodes_[child], nodes_[child + 1]);
  }
  const std::pair<CellBlock, CellBlock> blocks = node.block.halves();
  std::pair<Node, Node> r(make(node.grid, node.knots, blocks.first),
                          make(node.grid, node.knots, blocks.second));
  if (node.number == kNoNode || nodes_.size() + 2 > roots_ + kMostBlocks) return r;
  r.first.number = nodes_[node.number].child = uint32_t(nodes_.size());
  nodes_.push_back(r.first);
  r.second.number = uint32_t(nodes_.size());
  nodes_.push_back(r.second);
  return r;
}
void BlockTree::each_cell(
    const DoubleBox& box, const std::function<void()>& count,
    const std::function<void(const MicroGrid&, const size_t*, const CellNet&)>& use) {
  std::vector<Node> open;
  tree_->each(box, [&](uint32_t root) {
    open.push_back(nodes_[root]);
    return true;
  });
  while (!open.empty()) {
    const Node node = open.back();
    open.pop_back();
    if (!node.is_held || !node.box.meets(box)) continue;
    count();
    if (node.block.is_cell()) {
      const size_t knots[3] = {node.knots[0], node.knots[1], node.knots[2]};
      const MicroGrid& g = parts_.file().grids[node.grid];
      use(g, node.block.lo, parts_.net_in(g, knots, node.block));
      continue;
    }
    const std::pair<Node, Node> half = halves(node);
    open.push_back(half.first), open.push_back(half.second);
  }
}

struct PairNode {
  DoubleNet net;      // in the cell's unit cube
  double begin, end;  // of w
  int level;
  DoubleBox box;  // contains the points
  Span rows[6];   // the values of the rows of K, or of two, at the points
  bool is_known, is_passed;
  PairPointer half[2];  // kept for other pairs; of few levels
};
// Makes the nodes of a patch in a cell, or of a sweep.
class PairNodes {
 public:
  // The rows of these matrices; second: null if there is one.
  PairNodes(TileParts* parts, const CellNet& cell, const MicroSweep* first,
            const MicroSweep* second)
      : parts_(*parts), cell_(cell), matrix_{first, second} {}

  // sweep: null for a patch; nodes that lie in the slab of `slab` are passed over.
  PairPointer start(const DoubleNet& net, const SweepPart* sweep, const MicroSweep* slab) {
    sweep_ = sweep, slab_ = slab;
    return make(net, 0, 1, 0);
  }
  size_t rows() const { return matrix_[1] != nullptr ? 6 : 3; }
  void halve(const PairPointer& node, PairPointer* half) {
    half[0] = node->half[0], half[1] = node->half[1];
    if (half[0] != nullptr) return;
    const int level = node->level;
    const double begin = node->begin, end = node->end, middle = (begin + end) / 2;
    DoubleNet lower, upper;
    const bool is_along = sweep_ != nullptr && level % 3 == 2;
    if (is_along)
      lower = upper = node->net;
    else
      halve_net(node->net, size_t(sweep_ != nullptr ? level % 3 : level % 2), &lower, &upper);
    half[0] = make(std::move(lower), begin, is_along ? middle : end, level + 1);
    half[1] = make(std::move(upper), is_along ? middle : begin, end, level + 1);
    if (level < kMostLevelKept) node->half[0] = half[0], node->half[1] = half[1];
  }

 private:
  PairPointer make(DoubleNet net, double begin, double end, int level) {
    const PairPointer r = std::make_shared<PairNode>();
    r->begin = begin, r->end = end, r->level = level;
    if (sweep_ != nullptr)
      sweep_->set_points(net, begin, end, &hull_);
    else
      parts_.set_points(net, cell_, &hull_);
    r->box = box_of(hull_);
    r->is_known = hull_.is_known;
    for (size_t k = 0; k < rows() && r->is_known; ++k)
      r->rows[k] = values_of(hull_, &matrix_[k / 3]->matrix[k % 3 * 3]);
    r->is_passed = slab_ != nullptr && is_in_slab(::box_of(net));
    r->net = std::move(net);
    return r;
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
  const SweepPart* sweep_ = nullptr;
  const MicroSweep* slab_ = nullptr;
  PointHull hull_;
};

SweepPairs::SweepPairs(TileParts* parts)
    : parts_(*parts),
      file_(parts->file()),
      blocks_(parts),
      most_pairs_((uint64_t(1) << 22) + (uint64_t(1) << 12) * file_.sweeps.size()) {}

void SweepPairs::descend(PairNodes* a, const PairPointer& first, PairNodes* b,
                         const PairPointer& second, const char* id, uint64_t number) {
  std::vector<std::pair<PairPointer, PairPointer>> open(1, std::make_pair(first, second));
  while (!open.empty()) {
    const std::pair<PairPointer, PairPointer> at = std::move(open.back());
    open.pop_back();
    const PairNode &x = *at.first, &y = *at.second;
    if (x.is_passed || !x.box.meets(y.box)) continue;
    add_pair(id);
    bool is_apart = false;
    for (size_t r = 0; r < a->rows() && x.is_known && y.is_known; ++r)
      is_apart = is_apart || x.rows[r].hi < y.rows[r].lo || y.rows[r].hi < x.rows[r].lo;
    if (is_apart) continue;
    require(std::min(x.level, y.level) < kMostLevelOfPair, id,
            "it may meet a tile or another sweep: sweep", number);
    const bool is_first = y.level == kMostLevelOfPair ||
                          (x.level < kMostLevelOfPair && !(extent(x.box) < extent(y.box)));
    PairPointer half[2];
    (is_first ? a : b)->halve(is_first ? at.first : at.second, half);
    for (const PairPointer& h : half)
      open.push_back(is_first ? std::make_pair(h, at.second) : std::make_pair(at.first, h));
  }
}

void SweepPairs::check_tiles(const MicroSweep& sweep, uint64_t number) {
  const SweepPart part(&parts_, sweep, number, "Q3");
  PairNodes of_sweep(&parts_, part.cell(), &sweep, nullptr);
  const PairPointer whole = of_sweep.start(part.cap(), &part, nullptr);
  boxes_.push_back(whole->box);
  PointHull hull;
  blocks_.each_cell(
      whole->box, [this] { add_pair("Q3"); },
      [&](const MicroGrid& g, const size_t* i, const CellNet& cell) {
        const bool is_own = &g == &file_.grids[sweep.grid] && g.cell(i) == sweep.cell;
        set_hull(cell.net, &hull);
        for (size_t r = 0; r < 3 && !is_own && hull.is_known && whole->is_known; ++r) {
          const Span v = values_of(hull, &sweep.matrix[3 * r]);
          if (v.hi < whole->rows[r].lo || whole->rows[r].hi < v.lo) return;
        }
        const size_t tile = g.tile[g.cell(i)] - size_t(1);
        PairNodes of_patch(&parts_, cell, &sweep, nullptr);
        for (size_t s = 0; s < file_.tiles[tile].patches.size(); ++s) {
          const PairPointer patch =
              of_patch.start(parts_.patch_in(g, i, tile, s), nullptr, is_own ? &sweep : nullptr);
          descend(&of_patch, patch, &of_sweep, whole, "Q3", number);
        }
      });
}

void SweepPairs::check_sweeps() {
  const BoxTree tree(boxes_);
  for (uint32_t i = 0; i < boxes_.size(); ++i) {
    std::unique_ptr<const SweepPart> part;
    tree.each(boxes_[i], [&](uint32_t j) {
      if (j <= i) return true;
      const MicroSweep &a = file_.sweeps[i], &b = file_.sweeps[j];
      if (part == nullptr) part.reset(new SweepPart(&parts_, a, i, "Q4"));
      const SweepPart other(&parts_, b, j, "Q4");
      PairNodes of_part(&parts_, part->cell(), &a, &b), of_other(&parts_, other.cell(), &a, &b);
      const PairPointer first = of_part.start(part->cap(), part.get(), nullptr),
                        second = of_other.start(other.cap(), &other, nullptr);
      descend(&of_part, first, &of_other, second, "Q4", i);
      return true;
    });
  }
}
