// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/patch_collar.h"

#include <algorithm>
#include <array>
#include <utility>

#include "robust/base/check.h"
#include "topology/thicken.h"
#include "verify/certify/collar_defects.h"
#include "verify/certify/patch_decision.h"

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
      : forest_(forest),
        cover_(cover),
        options_(options),
        max_cells_(std::min(options.max_cells, OctreeKeySet::kMaxCells)),
        facing_(forest),
        complex_share_(forest.budget()) {
    if (forest.budget() != nullptr) forest.budget()->forgive();
  }

  PatchCollarSearch run() {
    gaps_ = count_gap_cells(cover_);
    is_narrow_ = gaps_.all > kSurelyTooMany * static_cast<double>(max_cells_);
    const Result<OctreeRoot> root = root_around(hull_of_leaves(forest_, cover_));
    if (!root) {
      fail(root.error().message);
      return std::move(out_);
    }
    root_ = *root;
    octree_.emplace(forest_, root_, options_.memory);
    for (int level = 0; level < 2 && !is_done_; ++level)
      split(std::vector<bool>(octree_->num_cells(), true), "");
    while (!is_done_) try_cells();
    return std::move(out_);
  }

 private:
  void fail(std::string message, std::optional<Box3d> place = {}) {
    if (forest_.is_out_of_memory()) return fail_for_memory();
    end("no-collar", std::move(message), place);
  }
  void fail_for_memory() {
    end(open_code::kMemory, memory_error(*forest_.budget()).message + reached(), {});
  }
  void end(const char* code, std::string message, const std::optional<Box3d>& place) {
    Finding& why = out_.open.emplace();
    why.code = code;
    why.message = std::move(message);
    if (place) why.place.box = forest_.in_model(*place);
    is_done_ = true;
  }
  std::string reached() const {
    return "; covers of up to " + std::to_string(out_.most_cells) + " cells were tried";
  }

  void try_cells() {
    const std::size_t n = octree_->num_cells();
    ++out_.rounds;
    out_.cells_tried += n;
    const std::uint32_t max_faces = most_faces();
    if (3 * n > max_faces) return fail_for_faces();
    Result<CommonSubdivision> complex =
        thicken_to_manifold(OctreeKeySet::make(octree_->keys()).value(), max_faces);
    if (!complex) return fail_for_faces();
    VT_CHECK(complex_share_.resize(std::uint64_t{complex->num_faces()} * kCollarBytesPerFace),
             "more faces than there is room for");
    if (complex->num_cells() > max_cells_) return fail_for_cells("", {});
    out_.most_cells = std::max<std::uint64_t>(out_.most_cells, complex->num_cells());
    const std::vector<BodyDefect> defects = find_defects(*complex);
    if (!defects.empty()) return split_at(std::move(*complex), defects);
    conclude(std::move(*complex));
  }

  // The room for the next complex.
  std::uint32_t most_faces() {
    complex_share_.resize(0);
    if (forest_.budget() == nullptr) return CommonSubdivision::kMaxFaces;
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(
        forest_.budget()->room() / kCollarBytesPerFace, CommonSubdivision::kMaxFaces));
  }
  void fail_for_faces() {
    if (forest_.budget() != nullptr) return fail_for_memory();
    fail("the cells have more faces than a complex may have" + reached());
  }
  void fail_for_cells(const std::string& defect, const std::optional<Box3d>& place) {
    end(open_code::kBudget,
        defect + (defect.empty() ? "" : "; ") + "more than " + std::to_string(max_cells_) +
            " cells would be needed" + reached(),
        place);
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

  void split_at(CommonSubdivision complex, const std::vector<BodyDefect>& defects) {
    const std::vector<bool> which =
        cells_to_split(forest_, facing_, *octree_, complex, boundary_, defects);
    for (std::size_t i = 0; i < which.size(); ++i)
      if (which[i] && octree_->key(i).level() >= options_.max_level)
        return fail(defects.front().message + "; cells of the least size come together here",
                    root_.box(octree_->key(i)));
    const auto num_split =
        static_cast<std::size_t>(std::count(which.begin(), which.end(), true));
    // A surface meets approximately 4 of 8 children.
    if (is_narrow_ && which.size() + 3 * num_split > kFewCells)
      return end(open_code::kBudget,
                 "sheets pass so near each other that more than " +
                     std::to_string(max_cells_) + " cells may be needed" + reached(),
                 cover_.boxes[gaps_.narrowest].star.box);
    const Box3d place =
        root_.box(complex.cells()[boundary_.bodies[defects.front().body].first_cell]);
    drop(std::move(complex));
    split(which, defects.front().message, place);
  }
  // Frees the complex and what was found about it before the cells grow.
  void drop(CommonSubdivision) {
    boundary_ = {};
    collar_ = {};
    complex_share_.resize(0);
  }
  void split(const std::vector<bool>& which, const std::string& defect,
             const std::optional<Box3d>& place = {}) {
    if (octree_->split(which, max_cells_)) return;
    if (forest_.is_out_of_memory()) return fail_for_memory();
    fail_for_cells(defect, place);
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
      return split_at(std::move(complex), twisted);
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
  std::size_t max_cells_;
  FacingOfPieces facing_;
  OctreeRoot root_;
  std::optional<PieceOctree> octree_;
  ComplexBoundary boundary_;
  Collar collar_;
  PatchCollarSearch out_;
  GapCells gaps_;
  MemoryShare complex_share_;
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
