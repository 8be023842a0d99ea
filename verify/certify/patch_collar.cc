// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/patch_collar.h"

#include <algorithm>
#include <array>
#include <utility>

#include "robust/base/check.h"
#include "topology/thicken.h"
#include "verify/certify/collar_defects.h"

namespace veritope {
namespace {

using Id = PieceForest::Id;

// The box around the leaves of the cover, which lie in boxes.
Box3d hull_of_leaves(const PieceForest& forest, const StarCover& cover) {
  std::optional<Box3d> out;
  for (Id id = 0; id < cover.box_of_node.size(); ++id)
    if (cover.box_of_node[id] != StarCover::kNone)
      out = out ? hull(*out, forest.node(id).hull) : forest.node(id).hull;
  VT_CHECK(out.has_value(), "a complete cover has leaves");
  return *out;
}

// Between sheets that face each other, cells are no larger than the gap, and a layer of cells lies along the sheets.
struct GapCells {
  double all = 0, most = 0;     ///< approximate numbers of cells: for all boxes, for one box
  std::uint32_t narrowest = 0;  ///< the box with the most
};
GapCells count_gap_cells(const StarCover& cover) {
  GapCells out;
  for (std::uint32_t i = 0; i < cover.boxes.size(); ++i) {
    out.all += cover.boxes[i].gap_squares;
    if (cover.boxes[i].gap_squares > out.most)
      out.most = cover.boxes[i].gap_squares, out.narrowest = i;
  }
  return out;
}
// The estimate is wrong where both sheets lie in one cell with everything between them, as those of a fin may. Covers
// of few cells find this out; after them, an estimate of this many times the allowed cells ends the search.
constexpr double kSurelyTooMany = 8;
constexpr std::size_t kFewCells = std::size_t{1} << 15;

class Search {
 public:
  Search(PieceForest& forest, const StarCover& cover, const CollarSearchOptions& options)
      : forest_(forest), cover_(cover), options_(options), facing_(forest) {}

  PatchCollarSearch run() {
    gaps_ = count_gap_cells(cover_);
    is_narrow_ = gaps_.all > kSurelyTooMany * static_cast<double>(options_.max_cells);
    const Result<OctreeRoot> root = root_around(hull_of_leaves(forest_, cover_));
    if (!root) {
      fail(root.error().message);
      return std::move(out_);
    }
    root_ = *root;
    octree_.emplace(forest_, root_, options_.memory);
    for (int level = 0; level < 2; ++level)
      octree_->split(std::vector<bool>(octree_->cells().size(), true));
    while (!is_done_) try_cells();
    return std::move(out_);
  }

 private:
  void fail(std::string message, std::optional<Box3d> place = {}) {
    Finding& why = out_.open.emplace();
    why.code = "no-collar";
    why.message = std::move(message);
    if (place) why.place.box = forest_.in_model(*place);
    is_done_ = true;
  }

  void try_cells() {
    ++out_.rounds;
    out_.cells_tried += octree_->cells().size();
    Result<CommonSubdivision> complex =
        thicken_to_manifold(OctreeKeySet::make(octree_->keys()).value());
    if (!complex) return fail(complex.error().message);
    const std::vector<BodyDefect> defects = find_defects(*complex);
    if (!defects.empty()) return split_at(*complex, defects);
    conclude(std::move(*complex));
  }

  // Counts are tested first: they are cheap, and rule out most covers that are too coarse.
  std::vector<BodyDefect> find_defects(const CommonSubdivision& complex) {
    boundary_ = analyse_boundary(complex);
    const auto shells = shells_of_bodies(forest_.complex(), forest_, *octree_, complex, boundary_);
    std::vector<BodyDefect> out = find_body_defects(forest_.complex(), shells, boundary_);
    if (!out.empty()) return out;
    collar_ = find_collar(complex).value();
    for (std::uint32_t body = 0; body < collar_.bodies.size(); ++body)
      if (!collar_.bodies[body].is_product)
        out.push_back({body, true,
                       "around shell " + std::to_string(shells[body][0]) + ": " + collar_.message});
    return out;
  }

  void split_at(const CommonSubdivision& complex, const std::vector<BodyDefect>& defects) {
    const std::vector<bool> which =
        cells_to_split(forest_, facing_, *octree_, complex, boundary_, defects);
    std::size_t more = 0;
    for (std::size_t i = 0; i < which.size(); ++i) {
      if (!which[i]) continue;
      const OctreeKey key = octree_->cells()[i].key;
      more += 3;  // a surface meets approximately 4 of 8 children
      if (key.level() >= options_.max_level)
        return fail(defects.front().message + "; cells of the least size come together here",
                    root_.box(key));
    }
    if (is_narrow_ && which.size() + more > kFewCells)
      return fail("sheets pass so near each other that more than " +
                      std::to_string(options_.max_cells) +
                      " cells may be needed; covers of up to " + std::to_string(which.size()) +
                      " were tried",
                  cover_.boxes[gaps_.narrowest].star.box);
    if (which.size() + more > options_.max_cells) {
      const std::uint32_t cell = boundary_.bodies[defects.front().body].first_cell;
      return fail(defects.front().message + "; more than " + std::to_string(options_.max_cells) +
                      " cells would be needed",
                  root_.box(complex.cells()[cell]));
    }
    octree_->split(which);
  }

  // The cells are a collar around each shell; it remains to prove where the shells lie in it.
  void conclude(CommonSubdivision complex) {
    Misplaced why;
    std::optional<CollarPlace> place =
        place_surface(forest_, cover_, root_, complex, collar_.boundary, &why);
    if (!place)
      return fail(why.message, why.piece == PieceForest::kNone
                                   ? std::nullopt
                                   : std::optional(forest_.node(why.piece).hull));
    std::vector<Shore> shores;
    for (std::optional<Shore>& s : find_shores(forest_, cover_, root_, complex, collar_.boundary)) {
      if (!s)
        return fail(
            "no free path from the collar's boundary to a star box or to infinity was found");
      shores.push_back(std::move(*s));
    }
    if (const auto twisted = twisted_bodies(shores); !twisted.empty())
      return split_at(complex, twisted);
    const CollapseCheck check = replay_collapse(complex, collar_.d_plus_faces(), collar_.collapses);
    VT_CHECK(check.fault == CollapseFault::kNone, "a collapse that was found cannot be replayed");
    out_.collar.emplace(PatchCollar{root_, std::move(complex), std::move(collar_),
                                    std::move(*place), std::move(shores)});
    is_done_ = true;
  }
  // The bodies whose two sides do not have the winding numbers 0 and 1.
  std::vector<BodyDefect> twisted_bodies(const std::vector<Shore>& shores) const {
    std::vector<BodyDefect> out;
    for (std::uint32_t k = 0; k < collar_.bodies.size(); ++k)
      if (shores[collar_.bodies[k].d_plus].winding == shores[collar_.bodies[k].d_minus].winding)
        out.push_back({k, true, "the winding numbers on both sides of the cells are equal"});
    return out;
  }

  PieceForest& forest_;
  const StarCover& cover_;
  const CollarSearchOptions& options_;
  FacingOfPieces facing_;
  OctreeRoot root_;
  std::optional<PieceOctree> octree_;
  ComplexBoundary boundary_;
  Collar collar_;
  PatchCollarSearch out_;
  GapCells gaps_;
  bool is_narrow_ = false, is_done_ = false;
};

}  // namespace

bool may_have_octree(const PatchComplex& complex) {
  const Result<PieceForest> forest = PieceForest::make(complex, PieceForest::FrameChoice::kPlain);
  return forest && root_around(hull_of_roots(*forest));
}

PatchCollarSearch find_patch_collar(PieceForest& forest, const StarCover& cover,
                                    const CollarSearchOptions& options) {
  VT_CHECK(cover.is_complete(), "a collar is sought around a surface that is covered");
  return Search(forest, cover, options).run();
}

}  // namespace veritope
