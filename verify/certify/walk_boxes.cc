// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/walk_boxes.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace veritope {
namespace {

using Id = PieceForest::Id;

// A box needs pieces of two levels more.
constexpr int kMostLevel = PieceForest::kMaxLevel - 2;
// Where a half-line meets the next shell is known to this part of the width of the box at which it starts.
constexpr double kPartOfWidth = 0.125;
constexpr int kMostVisits = 20'000;

class WalkBoxes {
 public:
  WalkBoxes(PieceForest& forest, FrameSearch& frames, StarCover* cover)
      : forest_(forest), frames_(frames), cover_(*cover) {}

  void run() {
    const auto& boxes = cover_.boxes;
    const bool have_several = std::any_of(boxes.begin(), boxes.end(), [](const CoverBox& b) {
      return !b.is_mesh && !b.has_one_sheet();
    });
    if (!have_several &&
        std::none_of(boxes.begin(), boxes.end(), [](const CoverBox& b) { return b.is_mesh; }))
      return;
    for (const Id leaf : farthest_leaves(have_several)) {
      if (leaf == PieceForest::kNone) continue;
      const auto box = add_box(leaf, [&](Id id) { return farthest_child(id); });
      if (box && have_several) add_box_beyond(*box, shell_of(leaf));
    }
  }

 private:
  std::uint32_t shell_of(Id id) const { return forest_.complex().shell(forest_.node(id).patch); }
  std::uint32_t& box_of(Id id) {
    if (cover_.box_of_node.size() <= id)
      cover_.box_of_node.resize(forest_.num_nodes(), StarCover::kNone);
    return cover_.box_of_node[id];
  }
  // The node itself or the ancestor that is a leaf of the cover; kNone if the node is above leaves.
  Id leaf_above(Id id) {
    Id out = PieceForest::kNone;
    for (Id up = id; up != PieceForest::kNone; up = forest_.node(up).parent)
      if (box_of(up) != StarCover::kNone) out = up;
    return out;
  }

  // For each shell that needs a box, a covered node where it reaches farthest along x.
  std::vector<Id> farthest_leaves(bool have_several) {
    const std::size_t num_shells = forest_.complex().shells().size();
    std::vector<bool> has_start(num_shells);
    std::vector<Id> out(num_shells, PieceForest::kNone);
    for (Id id = 0; id < cover_.box_of_node.size(); ++id) {
      if (cover_.box_of_node[id] == StarCover::kNone) continue;
      const std::uint32_t shell = shell_of(id);
      if (!have_several && cover_.boxes[box_of(id)].has_one_sheet() && leaf_above(id) == id)
        has_start[shell] = true;
      Id& best = out[shell];
      if (best == PieceForest::kNone || forest_.node(id).hull.hi[0] > forest_.node(best).hull.hi[0])
        best = id;
    }
    for (std::size_t shell = 0; shell < num_shells; ++shell)
      if (has_start[shell]) out[shell] = PieceForest::kNone;
    return out;
  }
  Id farthest_child(Id id) {
    const Id first = forest_.children(id);
    Id out = first;
    for (Id k = 1; k < 4; ++k)
      if (forest_.node(first + k).hull.hi[0] > forest_.node(out).hull.hi[0]) out = first + k;
    return out;
  }

  // Descends from the leaf around `id` to the child that `next` names until one has a box with one sheet; the other
  // parts of the leaf keep theirs. Returns the box's number; nothing if none was found.
  template <typename Next>
  std::optional<std::uint32_t> add_box(Id id, Next next) {
    id = leaf_above(id);
    const std::uint32_t box = box_of(id);
    std::vector<Id> parents;
    while (forest_.node(id).level < kMostLevel && cover_.has_room_for_box() &&
           !forest_.is_out_of_memory()) {
      if (frames_.try_piece(id, true) && is_held(id)) return replace(parents, id, box);
      if (!forest_.may_split(id)) return std::nullopt;
      parents.push_back(id);
      id = next(id);
      if (id == PieceForest::kNone) return std::nullopt;
    }
    return std::nullopt;
  }
  bool is_held(Id id) const {
    return std::find(frames_.held().begin(), frames_.held().end(), id) != frames_.held().end();
  }
  // The node gets the box that was found, and the siblings of it and of its parents get `box`, which all of them had.
  std::uint32_t replace(const std::vector<Id>& parents, Id id, std::uint32_t box) {
    for (const Id parent : parents) {
      const Id first = forest_.children(parent);
      box_of(parent) = StarCover::kNone;
      for (Id k = 0; k < 4; ++k) box_of(first + k) = box;
    }
    const auto number = static_cast<std::uint32_t>(cover_.boxes.size());
    box_of(id) = number;
    cover_.boxes.push_back(CoverBox::of(frames_.box()));
    return number;
  }

  // A box for the shell that the half-line along x meets first, from the centre of the box that is farther along x.
  void add_box_beyond(std::uint32_t number, std::uint32_t shell) {
    const StarBox& box = cover_.boxes[number].star;
    const bool is_outside_farther = box.outside[0] > box.inside[0];
    const Point3d from = is_outside_farther ? box.outside : box.inside;
    const double width = std::abs(box.outside[0] - box.inside[0]);
    const Id target = first_hit(from, shell, kPartOfWidth * width);
    if (target == PieceForest::kNone) return;
    if (cover_.boxes[box_of(leaf_above(target))].has_one_sheet()) return;
    add_box(target, [&](Id id) { return child_towards(id, target); });
  }
  Id child_towards(Id id, Id target) {
    for (Id up = target; up != PieceForest::kNone; up = forest_.node(up).parent)
      if (forest_.node(up).parent == id) return up;
    return PieceForest::kNone;
  }

  // The first piece of another shell that the half-line from `from` along x meets, no longer along x than `most` and
  // within a leaf of the cover, or kNone. Approximate: the half-line meets its hull. A large piece across x, such as a
  // side of a plate, is short along x and may have no box: only its parts do.
  Id first_hit(const Point3d& from, std::uint32_t shell, double most) {
    const auto is_met = [&](const Box3d& b) {
      return b.hi[0] >= from[0] && b.lo[1] <= from[1] && from[1] <= b.hi[1] && b.lo[2] <= from[2] &&
             from[2] <= b.hi[2];
    };
    struct Open {
      double x;
      Id id;
      bool operator<(const Open& b) const { return x > b.x; }  // the least one on top
    };
    std::priority_queue<Open> open;
    const auto push = [&](Id id) {
      if (is_met(forest_.node(id).hull)) open.push({forest_.node(id).hull.lo[0], id});
    };
    forest_.roots().visit(is_met, [&](std::uint32_t number) {
      if (shell_of(forest_.root(number)) != shell) push(forest_.root(number));
    });
    for (int visits = 0; !open.empty() && visits < kMostVisits; ++visits) {
      const Id id = open.top().id;
      open.pop();
      const Box3d& hull = forest_.node(id).hull;
      if (hull.hi[0] - hull.lo[0] <= most && leaf_above(id) != PieceForest::kNone) return id;
      if (forest_.node(id).level >= kMostLevel || !forest_.may_split(id)) return PieceForest::kNone;
      const Id first = forest_.children(id);
      for (Id k = 0; k < 4; ++k) push(first + k);
    }
    return PieceForest::kNone;
  }

  PieceForest& forest_;
  FrameSearch& frames_;
  StarCover& cover_;
};

}  // namespace

void add_boxes_for_walks(PieceForest& forest, FrameSearch& frames, StarCover* cover) {
  WalkBoxes(forest, frames, cover).run();
}

}  // namespace veritope
