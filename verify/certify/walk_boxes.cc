// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/walk_boxes.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "verify/certify/star_walks.h"

namespace veritope {
namespace {

using Id = PieceForest::Id;

// A box needs pieces of two levels more.
constexpr int kMostLevel = PieceForest::kMaxLevel - 2;
// Where a half-line meets the next shell is known to this part of the width of the box at which it starts.
constexpr double kPartOfWidth = 0.125;
constexpr int kMostVisits = 20'000;

// Where a shell gets a box, and how a half-line goes on from there.
struct Place {
  std::size_t axis;
  bool is_positive;
  // Away from the edges of the patch, in place of as far along the axis as it reaches.
  bool is_inside;

  // The greater, the farther along the axis.
  double reach(const Box3d& hull) const { return is_positive ? hull.hi[axis] : -hull.lo[axis]; }
};
// In this order. Where a curved surface reaches farthest, the hulls of its pieces are thin. At a corner of a plate no
// box may hold one sheet alone, and one in the middle of a face does.
constexpr std::size_t kNumPlaces = 12;
constexpr Place place_of(std::size_t number) {
  return {number % 6 / 2, number % 2 == 0, number >= 6};
}

class WalkBoxes {
 public:
  WalkBoxes(PieceForest& forest, FrameSearch& frames, StarCover* cover)
      : forest_(forest), frames_(frames), cover_(*cover) {}

  void run() {
    const auto& boxes = cover_.boxes;
    have_several_ = std::any_of(boxes.begin(), boxes.end(),
                                [](const CoverBox& b) { return !b.is_mesh && !b.has_one_sheet(); });
    if (!have_several_ &&
        std::none_of(boxes.begin(), boxes.end(), [](const CoverBox& b) { return b.is_mesh; }))
      return;
    add_boxes(shells_that_need_a_box(), place_of(0));
    for (std::size_t i = 1; i < kNumPlaces; ++i) {
      const std::vector<std::uint32_t> missing = find_shell_walks(forest_, cover_).missing;
      if (missing.empty()) return;
      add_boxes(missing, place_of(i));
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
    while (id != PieceForest::kNone && box_of(id) == StarCover::kNone) id = forest_.node(id).parent;
    return id;
  }

  template <typename Visit>
  void for_each_leaf(Visit visit) const {
    for (Id id = 0; id < cover_.box_of_node.size(); ++id)
      if (cover_.box_of_node[id] != StarCover::kNone) visit(id);
  }
  std::vector<std::uint32_t> shells_that_need_a_box() {
    const std::size_t num_shells = forest_.complex().shells().size();
    std::vector<bool> has_start(num_shells);
    if (!have_several_)
      for_each_leaf([&](Id id) {
        if (cover_.boxes[box_of(id)].has_one_sheet()) has_start[shell_of(id)] = true;
      });
    std::vector<std::uint32_t> out;
    for (std::uint32_t shell = 0; shell < num_shells; ++shell)
      if (!has_start[shell]) out.push_back(shell);
    return out;
  }
  // For each shell the leaf that reaches farthest; for a place inside a patch, of the leaves that are long.
  std::vector<Id> farthest_leaves(const Place& place) {
    const std::size_t num_shells = forest_.complex().shells().size();
    std::vector<double> longest(num_shells);
    for_each_leaf([&](Id id) {
      double& size = longest[shell_of(id)];
      size = std::max(size, extent(forest_.node(id).hull));
    });
    std::vector<Id> out(num_shells, PieceForest::kNone);
    for_each_leaf([&](Id id) {
      const Box3d& hull = forest_.node(id).hull;
      if (place.is_inside && extent(hull) < 0.5 * longest[shell_of(id)]) return;
      Id& best = out[shell_of(id)];
      if (best == PieceForest::kNone || place.reach(hull) > place.reach(forest_.node(best).hull))
        best = id;
    });
    return out;
  }
  Id next_child(Id id, const Place& place) {
    const Id first = forest_.children(id);
    // The last child and the first one in turn: of a tensor piece and of a triangle, they lead away from its sides.
    if (place.is_inside) return first + (forest_.node(id).level % 2 == 0 ? 3 : 0);
    Id out = first;
    for (Id k = 1; k < 4; ++k)
      if (place.reach(forest_.node(first + k).hull) > place.reach(forest_.node(out).hull))
        out = first + k;
    return out;
  }

  void add_boxes(const std::vector<std::uint32_t>& shells, const Place& place) {
    const std::vector<Id> farthest = farthest_leaves(place);
    for (const std::uint32_t shell : shells) {
      const auto box = add_box(farthest[shell], [&](Id id) { return next_child(id, place); });
      if (box && have_several_) add_box_beyond(*box, shell, place);
    }
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

  // A box for the shell that the half-line of the place meets first, from the centre of the box that is farther along
  // it.
  void add_box_beyond(std::uint32_t number, std::uint32_t shell, const Place& place) {
    const StarBox& box = cover_.boxes[number].star;
    const double step = box.outside[place.axis] - box.inside[place.axis];
    const Point3d from = (step > 0) == place.is_positive ? box.outside : box.inside;
    const Id target = first_hit(from, shell, place, kPartOfWidth * std::abs(step));
    if (target == PieceForest::kNone) return;
    if (cover_.boxes[box_of(leaf_above(target))].has_one_sheet()) return;
    add_box(target, [&](Id id) { return child_towards(id, target); });
  }
  Id child_towards(Id id, Id target) {
    for (Id up = target; up != PieceForest::kNone; up = forest_.node(up).parent)
      if (forest_.node(up).parent == id) return up;
    return PieceForest::kNone;
  }

  // The first piece of another shell that the half-line from `from` meets, no longer along it than `most` and within a
  // leaf of the cover, or kNone. Approximate: the half-line meets its hull. A large piece across the half-line, such as
  // a side of a plate, is short along it and may have no box: only its parts do.
  Id first_hit(const Point3d& from, std::uint32_t shell, const Place& place, double most) {
    const std::size_t along = place.axis;
    const auto is_met = [&](const Box3d& b) {
      for (std::size_t k = 0; k < 3; ++k)
        if (k != along && !(b.lo[k] <= from[k] && from[k] <= b.hi[k])) return false;
      return place.reach(b) >= (place.is_positive ? from[along] : -from[along]);
    };
    struct Open {
      double distance;
      Id id;
      bool operator<(const Open& b) const { return distance > b.distance; }  // the least one on top
    };
    std::priority_queue<Open> open;
    const auto push = [&](Id id) {
      const Box3d& hull = forest_.node(id).hull;
      if (is_met(hull)) open.push({place.is_positive ? hull.lo[along] : -hull.hi[along], id});
    };
    forest_.roots().visit(is_met, [&](std::uint32_t number) {
      if (shell_of(forest_.root(number)) != shell) push(forest_.root(number));
    });
    for (int visits = 0; !open.empty() && visits < kMostVisits; ++visits) {
      const Id id = open.top().id;
      open.pop();
      const Box3d& hull = forest_.node(id).hull;
      if (hull.hi[along] - hull.lo[along] <= most && leaf_above(id) != PieceForest::kNone)
        return id;
      if (forest_.node(id).level >= kMostLevel || !forest_.may_split(id)) return PieceForest::kNone;
      const Id first = forest_.children(id);
      for (Id k = 0; k < 4; ++k) push(first + k);
    }
    return PieceForest::kNone;
  }

  PieceForest& forest_;
  FrameSearch& frames_;
  StarCover& cover_;
  bool have_several_ = false;
};

}  // namespace

void add_boxes_for_walks(PieceForest& forest, FrameSearch& frames, StarCover* cover) {
  WalkBoxes(forest, frames, cover).run();
}

}  // namespace veritope
