// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/star_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "robust/base/check.h"
#include "verify/certify/box_search.h"
#include "verify/certify/frame_search.h"
#include "verify/certify/walk_boxes.h"
#include "verify/certify/zero_search.h"

namespace veritope {
namespace {

using Id = PieceForest::Id;
using Why = UncoveredPiece::Why;

// Orders pieces by the least size at which they may have boxes. The search follows a contact to the greatest level at
// once, and takes pieces of one size depth first, the last one first, so that successive nets are near each other.
// Pieces whose surroundings were not examined yet come before all others: a contact must not wait until wider gaps
// elsewhere are covered.
class CoverSearch {
 public:
  CoverSearch(PieceForest& forest, const StarCoverOptions& options)
      : forest_(forest),
        options_(options),
        search_(forest, options),
        zeros_(forest, options),
        frames_(forest, options.growth, options.least_framed_unit, options.least_unit),
        framed_share_(forest.budget()),
        step_(options.work, static_cast<double>(forest.num_roots())) {
    if (const MemoryBudget* budget = forest.budget(); budget != nullptr)
      most_nodes_ = std::min<std::uint64_t>(most_nodes_,
                                            std::max(kFewNodes, budget->limit() / kBudgetOfNode));
    out_.memory = std::make_shared<MemoryShare>(forest.budget());
  }

  StarCover run() {
    const auto& order = forest_.roots().order();
    for (std::size_t k = order.size(); k-- > 0;) push(forest_.root(order[k]), kUnknownScale);
    while (!open_.empty() && out_.uncovered.empty()) {
      const Open next = open_.top();
      open_.pop();
      if (!is_covered(next.id)) cover(next);
      if (is_covered(next.id)) count_covered(next.id);
      if (lacks_memory(next.id)) try_again_with_fewer_nodes(next);
      const std::size_t nodes = forest_.num_nodes() - forest_.num_dropped();
      if (nodes > most_nodes_ && out_.is_complete()) drop_nodes();  // an obstacle names nodes
    }
    out_.tested_pieces = search_.tested_pieces(), out_.programs = search_.programs();
    if (out_.is_complete()) {
      keep_leaves();
      if (options_.with_frames) add_boxes_for_walks(forest_, frames_, &out_);
      keep_leaves();
    }
    out_.memory->resize_anyway(out_.boxes.size() * StarCover::kBytesOfBox + framed_share_.bytes());
    return std::move(out_);
  }

 private:
  struct Open {
    int scale;  // the expected box's size, as a power of two, or kUnknownScale
    std::uint64_t number;
    Id id;
    int crowded;  // number of nested pieces around it that had no box because too many others were met
    std::optional<Why> above;  // why the piece around it had no box
    friend bool operator<(const Open& a, const Open& b) {  // a comes later
      return a.scale != b.scale ? a.scale > b.scale : a.number < b.number;
    }
  };
  // Fewer nodes are never dropped. Nodes, and nets of some, take about a quarter of the budget before.
  static constexpr std::uint64_t kFewNodes = 1 << 17, kBudgetOfNode = 1024;
  static constexpr int kUnknownScale = -101, kLeastScale = -100, kMostScale = 100;
  // Where features are small, boxes meet a quarter of the pieces at each further level; at a contact near a pole they
  // meet the same number at all levels.
  static constexpr int kMostCrowded = 6;

  void push(Id id, int scale, int crowded = 0, std::optional<Why> above = std::nullopt) {
    open_.push({scale, next_number_++, id, crowded, above});
  }

  std::uint32_t& box_of(Id id) {
    if (out_.box_of_node.size() <= id)
      out_.box_of_node.resize(std::max<std::size_t>(id + 1, forest_.num_nodes()), StarCover::kNone);
    return out_.box_of_node[id];
  }
  bool is_covered(Id id) {
    for (; id != PieceForest::kNone; id = forest_.node(id).parent)
      if (box_of(id) != StarCover::kNone) return true;
    return false;
  }

  // The pieces that wait are apart from each other, so that each part of a patch counts once.
  void count_covered(Id id) { step_.add(std::ldexp(1.0, -2 * forest_.node(id).level)); }

  void cover(const Open& open) {
    const Id id = open.id;
    forest_.limit_memory(options_.memory);
    if (out_.tried >= options_.max_boxes) return give_up(id, Why::kBudget);
    if (!has_memory()) return give_up(id, Why::kMemory);
    ++out_.tried;
    if (search_.try_piece(id)) {
      accept(search_.box(), search_.held());
      VT_CHECK(box_of(id) != StarCover::kNone, "a box does not cover the piece it was made for");
      return;
    }
    if (options_.with_frames && search_.may_have_zeros() && zeros_.try_piece(id)) {
      accept(zeros_.box(), zeros_.held());
      return;
    }
    if (options_.with_frames && frames_.try_piece(id)) {
      accept(CoverBox::of(frames_.box()), frames_.held());
      if (box_of(id) != StarCover::kNone) return;
    }
    if (forest_.is_out_of_memory()) return give_up(id, Why::kMemory);
    if (options_.stops_at && options_.stops_at(id, out_.tried)) return give_up(id, Why::kStopped);
    const bool is_crowded = search_.why() == Why::kTooDeep;
    const int crowded = is_crowded ? open.crowded + 1 : 0;
    const bool is_spent = out_.tried >= options_.max_boxes;
    if (forest_.node(id).level >= options_.max_level || is_spent || crowded > kMostCrowded ||
        search_.why() == Why::kTooFine) {
      const Obstacle obstacle = search_.obstacle();
      out_.uncovered.push_back({id, is_spent ? Why::kBudget : search_.why(), open.above,
                                obstacle.gap, obstacle.least_cosine, obstacle.facing});
      return;
    }
    const int scale = is_crowded ? open.scale : scale_of(id);
    if (!forest_.may_split(id)) return give_up(id, Why::kMemory);
    const Id first = forest_.children(id);
    for (const Id k : {3u, 2u, 1u, 0u}) push(first + k, scale, crowded, search_.why());
  }
  // Drops the nodes that are neither leaves, so far, nor above one, nor above a piece that waits. Half of the memory
  // must be free then; otherwise the nodes may be twice as many.
  void drop_nodes() {
    std::vector<Open> open;
    std::vector<bool> is_open(forest_.num_nodes());
    for (; !open_.empty(); open_.pop())
      if (!is_covered(open_.top().id)) {
        open.push_back(open_.top());
        is_open[open.back().id] = true;
      } else {
        count_covered(open_.top().id);
      }
    open_ = std::priority_queue<Open>({}, std::move(open));
    for (std::uint32_t r = 0; r < forest_.num_roots(); ++r) drop_below(forest_.root(r), is_open);
    while (2 * (forest_.num_nodes() - forest_.num_dropped()) > most_nodes_) most_nodes_ *= 2;
  }
  bool lacks_memory(Id id) const {
    return forest_.is_out_of_memory() && out_.uncovered.size() == 1 &&
           out_.uncovered[0].piece == id && out_.uncovered[0].why == Why::kMemory;
  }
  // Nodes that only tests needed may have taken all of the memory. If half of all nodes can be dropped, the piece is
  // tried once more.
  void try_again_with_fewer_nodes(const Open& open) {
    if (open.id == tried_again_) return;
    tried_again_ = open.id;
    open_.push(open);  // so that its node stays
    drop_nodes();
    if (2 * forest_.num_dropped() < forest_.num_nodes()) return;
    out_.uncovered.clear();
    forest_.budget()->forgive();
  }
  // Returns whether the node must stay.
  bool drop_below(Id id, const std::vector<bool>& is_open) {
    const bool has_box = box_of(id) != StarCover::kNone;
    bool must_stay = false;
    const Id first = forest_.node(id).first_child;
    for (Id k = 0; k < 4 && first != PieceForest::kNone && !has_box; ++k)
      must_stay |= drop_below(first + k, is_open);
    if (!must_stay) {
      forget_boxes_below(id);
      forest_.drop_children(id);
    }
    return has_box || must_stay || is_open[id];
  }
  void forget_boxes_below(Id id) {
    const Id first = forest_.node(id).first_child;
    for (Id k = 0; k < 4 && first != PieceForest::kNone; ++k) {
      box_of(first + k) = StarCover::kNone;
      forget_boxes_below(first + k);
    }
  }
  // Room for one more box, before it is sought.
  bool has_memory() { return out_.has_room_for_box() && !forest_.is_out_of_memory(); }
  // Nothing is known about what is near the piece.
  void give_up(Id id, Why why) {
    out_.uncovered.push_back({id, why, std::nullopt, std::numeric_limits<double>::infinity(), 1});
  }
  int scale_of(Id id) {
    if (search_.num_looked_at() == 1) return kUnknownScale;
    const double size = std::min(search_.obstacle().least_gap, extent(forest_.node(id).hull));
    if (!(size > 0)) return kLeastScale;
    return std::clamp(std::ilogb(size), kLeastScale, kMostScale);
  }
  void accept(const CoverBox& box, const std::vector<Id>& held) {
    const auto number = static_cast<std::uint32_t>(out_.boxes.size());
    if (box.framed) framed_share_.resize_anyway(framed_share_.bytes() + bytes_of(*box.framed));
    out_.boxes.push_back(box);
    for (const Id id : held)
      if (box_of(id) == StarCover::kNone) box_of(id) = number;
  }

  // What it takes here, and in a certificate's body and bytes.
  static std::uint64_t bytes_of(const FramedBox& box) {
    std::uint64_t out = 2 * sizeof(FramedBox);
    for (const Sheet& s : box.sheets.sheets) out += 2 * sizeof(Sheet) + s.signs.size();
    for (const SheetSeparator& q : box.sheets.separators)
      out += 2 * (sizeof(SheetSeparator) + q.coefficients.size() * sizeof(q.coefficients[0]));
    return out;
  }

  // Renumbers the boxes in the order of the leaves; drops those that cover only parts of other leaves.
  void keep_leaves() {
    out_.box_of_node.resize(forest_.num_nodes(), StarCover::kNone);
    std::vector<std::uint32_t> leaf_box(forest_.num_nodes(), StarCover::kNone),
        number(out_.boxes.size(), StarCover::kNone);
    std::vector<CoverBox> boxes;
    const auto visit = [&](auto& self, Id id) -> void {
      const std::uint32_t box = out_.box_of_node[id];
      if (box == StarCover::kNone) {
        for (Id k = 0; k < 4; ++k) self(self, forest_.node(id).first_child + k);
        return;
      }
      if (number[box] == StarCover::kNone) {
        number[box] = static_cast<std::uint32_t>(boxes.size());
        boxes.push_back(out_.boxes[box]);
      }
      leaf_box[id] = number[box];
    };
    for (std::uint32_t r = 0; r < forest_.num_roots(); ++r) visit(visit, forest_.root(r));
    out_.boxes = std::move(boxes);
    out_.box_of_node = std::move(leaf_box);
  }

  PieceForest& forest_;
  const StarCoverOptions& options_;
  BoxSearch search_;
  ZeroSearch zeros_;
  FrameSearch frames_;
  StarCover out_;
  MemoryShare framed_share_;
  WorkStep step_;
  std::priority_queue<Open> open_;
  std::uint64_t next_number_ = 0;
  std::size_t most_nodes_ = options_.most_nodes;
  Id tried_again_ = PieceForest::kNone;
};

}  // namespace

CoverBox CoverBox::of(const FramedBox& framed) {
  CoverBox out;
  const Sheet& first = framed.sheets.sheets.front();
  out.star = {framed.sheets.frame.around(framed.sheets.box), first.inside, first.outside};
  out.unit = framed.unit;
  out.framed = std::make_shared<const FramedBox>(framed);
  return out;
}

StarCover find_star_cover(PieceForest& forest, const StarCoverOptions& options) {
  return CoverSearch(forest, options).run();
}

}  // namespace veritope
