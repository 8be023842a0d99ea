// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/patch_decision.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "interval/upward.h"
#include "solids/pieces/patch_volume.h"
#include "verify/certify/cover_question.h"
#include "verify/certify/crossing_search.h"
#include "verify/certify/star_box_certifier.h"

namespace veritope {
namespace {

// Crossings are sought near pieces of at least this level. The first searches are free; each further one requires that
// more boxes were tried. All patches are searched once: at the first piece of kTroubleLevel without a box after trying
// boxes has taken approximately as long as that search, otherwise at the end if no cover was found.
constexpr int kFirstSearchLevel = 2, kTroubleLevel = 5;
constexpr std::size_t kFreeSearches = 16, kBoxesPerSearch = 64, kBoxesBeforeTrouble = 2048;
// The search starts again with boxes in frames where boxes along the axes would be many: thin walls, gaps.
constexpr std::size_t kBoxesBeforeFrames = 4096, kBoxesOfPatch = 8;

Finding question(const char* code, std::string message) {
  Finding out;
  out.code = code;
  out.message = std::move(message);
  return out;
}

Finding complex_question(const PatchComplex& complex) {
  Finding open = question(open_code::kNoSurface, kNoSurfaceText);
  for (const PatchFinding& f : complex.findings()) {
    if (f.defect == PatchDefect::kAdjacentPoles) continue;
    open.message += "; " + describe(complex, f);
    if (!f.sides.empty()) open.place.patch = f.sides[0].patch;
    break;
  }
  return open;
}

class Decider {
 public:
  Decider(const PatchComplex& complex, const PatchDecisionOptions& options,
          std::optional<PieceForest>* forest)
      : complex_(complex), options_(options), forest_(*forest) {}

  PatchDecision run() {
    if (!complex_.is_closed_oriented_surface()) {
      if (auto witness = find_side_witness(complex_, options_.outer))
        return refuted(std::move(*witness));
      return open(complex_question(complex_));
    }
    if (auto error = make_forest(options_.in_plain_frame ? PieceForest::FrameChoice::kPlain
                                                         : PieceForest::FrameChoice::kFitted))
      return open(std::move(*error));
    if (const auto side = inner_pole()) return decide_with_inner_pole(*side);
    auto crossing = cover_or_cross(false);
    if (!crossing && may_need_frames()) {
      const std::optional<CoverQuestion> why = give_up_for_frames();
      if (auto error = make_forest(PieceForest::FrameChoice::kWhole))
        return why ? open(*why) : open(std::move(*error));
      crossing = cover_or_cross(true);
      const bool is_covered = out_.cover.is_complete() && fits_certificate(*forest_, out_.cover);
      if (!why && !crossing && !is_covered) {  // boxes along the axes only took too long
        if (auto error = make_forest(PieceForest::FrameChoice::kFitted))
          return open(std::move(*error));
        is_patient_ = true;
        crossing = cover_or_cross(false);
      }
      if (why && !crossing && !out_.cover.is_complete()) return open(*why);
    }
    if (crossing) return refuted(*crossing);
    if (!out_.cover.is_complete()) return open(cover_question(*forest_, out_.cover));
    return decide_sides();
  }

 private:
  // Degenerate and repeated patches are asked for last, so that they cost other models nothing.
  const std::optional<MeetingWitness>& degenerate_patch() {
    if (!std::exchange(has_sought_degenerate_, true)) degenerate_ = find_meeting(complex_);
    return degenerate_;
  }
  PatchDecision open(Finding why) {
    if (const auto& meeting = degenerate_patch()) return refuted(*meeting);
    out_.open = std::move(why);
    return std::move(out_);
  }
  PatchDecision open(CoverQuestion why) {
    out_.facing = std::move(why.facing);
    return open(std::move(why.finding));
  }
  PatchDecision refuted(PatchRefutation refutation) {
    out_.refutation = std::move(refutation);
    return std::move(out_);
  }

  // A side inside of its entity's domain that is collapsed: P1 excludes it.
  std::optional<PatchSide> inner_pole() const {
    for (std::uint32_t p = 0; p < complex_.patches().size(); ++p)
      for (std::uint32_t s = 0; s < complex_.patch(p).num_sides(); ++s)
        if (complex_.is_collapsed({p, s}) && !is_outer(options_.outer, {p, s}))
          return PatchSide{p, s};
    return std::nullopt;
  }
  PatchDecision decide_with_inner_pole(PatchSide side) {
    CrossingSearch search(*forest_);
    if (auto crossing = search.among_patches()) return refuted(*crossing);
    if (auto crossing = search.everywhere()) return refuted(*crossing);
    Finding why = question(open_code::kNoSurface,
                           "a line inside of a surface is mapped to one point: different places of "
                           "the surface have one image");
    why.place.patch = side.patch;
    return open(std::move(why));
  }

  std::optional<Finding> make_forest(PieceForest::FrameChoice choice) {
    out_.cover = {};  // their memory is there for the next ones
    forest_.reset();
    if (options_.budget != nullptr) options_.budget->forgive();
    Result<PieceForest> forest = PieceForest::make(complex_, choice, options_.budget);
    if (!forest) return question(open_code::kOutOfRange, forest.error().message);
    forest_.emplace(std::move(*forest));
    return std::nullopt;
  }

  bool may_need_frames() const {
    return options_.with_frames && !out_.cover.is_complete() &&
           out_.cover.uncovered.front().why != UncoveredPiece::Why::kTooFine;
  }
  // What stands in the way of boxes along the axes; nothing if the search for them only took too long. The forest to
  // which the finding refers may go.
  std::optional<CoverQuestion> give_up_for_frames() const {
    if (out_.cover.uncovered.front().why == UncoveredPiece::Why::kStopped) return std::nullopt;
    return cover_question(*forest_, out_.cover);
  }

  // Returns a crossing or a contact that was found before the search for the cover, at a piece without a star box
  // during it, or where it ended.
  std::optional<PatchRefutation> cover_or_cross(bool with_frames) {
    CrossingSearch search(*forest_, options_.with_contacts_on_borders);
    if (!with_frames)
      if (auto crossing = search.among_patches()) return *crossing;
    std::optional<PatchRefutation> found;
    std::size_t searches = 0;
    bool is_everywhere = false;
    const auto look_everywhere = [&] {
      if (std::exchange(is_everywhere, true)) return;
      found = search.everywhere();
      if (!found) found = degenerate_patch();
      if (!found) found = search.touching_everywhere();
      forest_->limit_memory(options_.cover.memory);
    };
    StarCoverOptions options = options_.cover;
    options.least_unit = std::max(options.least_unit, least_unit_that_fits(*forest_));
    options.least_cube_unit = least_unit_of_any(*forest_);
    options.least_framed_unit = least_unit_that_fits(*forest_) * 2 * FrameProposals::kRowLength;
    options.with_frames = with_frames;
    const std::size_t before_frames =
        kBoxesBeforeFrames + kBoxesOfPatch * complex_.patches().size();
    options.stops_at = [&](PieceForest::Id piece, std::size_t tried) {
      if (options_.with_frames && !with_frames && !is_patient_ && tried >= before_frames)
        return true;
      if (options_.cover.stops_at && options_.cover.stops_at(piece, tried)) return true;
      if (forest_->node(piece).level >= kTroubleLevel && tried >= kBoxesBeforeTrouble)
        look_everywhere();
      if (found) return true;
      if (forest_->node(piece).level < kFirstSearchLevel ||
          searches * kBoxesPerSearch > tried + kFreeSearches * kBoxesPerSearch)
        return false;
      ++searches;
      found = search.near(piece);
      return found.has_value();
    };
    out_.cover = find_star_cover(*forest_, options);
    out_.boxes_tried = out_.cover.tried;
    if (found || out_.cover.is_complete()) return found;
    if (options_.with_frames && !with_frames && !is_patient_) return std::nullopt;
    for (PieceForest::Id id = out_.cover.uncovered.front().piece; id != PieceForest::kNone;
         id = forest_->node(id).parent)
      if ((found = search.near(id))) return found;
    look_everywhere();
    if (found) return found;
    // Places in large pieces have the simplest parameters.
    std::vector<PieceForest::Id> line;
    for (PieceForest::Id id = out_.cover.uncovered.front().piece; id != PieceForest::kNone;
         id = forest_->node(id).parent)
      line.push_back(id);
    for (; !line.empty(); line.pop_back())
      if ((found = search.touching_near(line.back()))) return found;
    return std::nullopt;
  }

  PatchDecision decide_sides() {
    if (!fits_certificate(*forest_, out_.cover))
      return open(question(open_code::kOutOfRange,
                           "star boxes were found, but checkers cannot hold their coordinates: in "
                           "units of the least one they have over 60 bits, or units are out of "
                           "range"));
    out_.walks = find_shell_walks(*forest_, out_.cover);
    if (!out_.walks.missing.empty()) {
      const std::uint32_t shell = out_.walks.missing.front();
      return open(at_shell(shell, question(open_code::kNoWalk,
                                           "no straight path from this shell to infinity or to the "
                                           "shell around it was found")));
    }
    const auto& walks = out_.walks.walks;
    const auto wrong = std::find_if(walks.begin(), walks.end(), is_wrong);
    if (wrong == walks.end()) {
      conclude();
      return std::move(out_);
    }
    Finding why = orientation_question(*wrong);
    if (!put_wrong_walk_last()) return open(std::move(why));
    const ShellWalk& last = out_.walks.walks.back();
    return refuted(ReversedShell{last.shell, last.winding_inside});
  }
  static bool is_wrong(const ShellWalk& w) { return w.winding_inside != 1; }

  // False if every wrong shell is the end of another shell's walk.
  bool put_wrong_walk_last() {
    auto& walks = out_.walks.walks;
    std::vector<std::uint32_t> shell_of_box(out_.cover.boxes.size());
    for (PieceForest::Id id = 0; id < out_.cover.box_of_node.size(); ++id)
      if (out_.cover.box_of_node[id] != StarCover::kNone)
        shell_of_box[out_.cover.box_of_node[id]] = complex_.shell(forest_->node(id).patch);
    std::vector<bool> is_end(complex_.shells().size());
    for (const ShellWalk& w : walks)
      if (w.direction == 6) is_end[shell_of_box[w.end_box]] = true;
    const auto last = std::find_if(walks.begin(), walks.end(), [&](const ShellWalk& w) {
      return is_wrong(w) && !is_end[w.shell];
    });
    if (last == walks.end()) return false;
    std::rotate(last, last + 1, walks.end());
    return true;
  }

  Finding orientation_question(const ShellWalk& walk) const {
    return at_shell(
        walk.shell,
        question(open_code::kOrientation,
                 "the winding number is " + std::to_string(walk.winding_inside) +
                     " on the inner side of this shell and " +
                     std::to_string(walk.winding_outside) +
                     " on the outer one, not 1 and 0: its normals point the wrong way, or it is "
                     "wrongly nested"));
  }
  Finding at_shell(std::uint32_t shell, Finding why) const {
    why.place.patch = complex_.shells()[shell].first_patch;
    why.place.shell = shell;
    return why;
  }
  void conclude() {
    out_.is_valid = true;
    out_.bodies = out_.walks.num_bodies();
    const std::vector<Interval> volumes = shell_volumes(*forest_, options_.tolerance);
    for (std::size_t s = 0; s < volumes.size(); ++s)
      out_.shells.push_back(
          {complex_.shells()[s].euler(), complex_.shells()[s].genus().value(), true, volumes[s]});
    for (const ShellWalk& w : out_.walks.walks) out_.shells[w.shell].is_outward = w.starts_outside;
    const ScopedUpward upward;
    Interval sum;
    for (const Interval& v : volumes) sum += v;
    out_.volume = sum;
  }

  const PatchComplex& complex_;
  const PatchDecisionOptions& options_;
  std::optional<PieceForest>& forest_;
  bool is_patient_ = false;  // boxes along the axes may be as many as the options say
  bool has_sought_degenerate_ = false;
  std::optional<MeetingWitness> degenerate_;
  PatchDecision out_;
};

}  // namespace

PatchDecision decide_patches(const PatchComplex& complex, const PatchDecisionOptions& options,
                             std::optional<PieceForest>* forest) {
  return Decider(complex, options, forest).run();
}

}  // namespace veritope
