// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/patch_decision.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "interval/upward.h"
#include "solids/star_box/patch_volume.h"
#include "verify/certify/star_box_certifier.h"

namespace veritope {
namespace {

using Kind = OpenQuestion::Kind;

std::string text_of(UncoveredPiece::Why why) {
  switch (why) {
    case UncoveredPiece::Why::kNoCentres:
      return "no point pair sees all patches near this piece from both sides: a fold, a contact, a "
             "cusp, or a vertex whose normals lie in no open half-space";
    case UncoveredPiece::Why::kCrossings:
      return "several sheets pass near this piece: a crossing, a contact, or a gap that is too "
             "small";
    case UncoveredPiece::Why::kTooDeep:
      return "too many patches, or pieces of very different sizes, meet near this piece";
    case UncoveredPiece::Why::kBudget: return "the number of boxes that may be tried is spent";
  }
  return "";
}

Kind kind_of(UncoveredPiece::Why why) {
  return why == UncoveredPiece::Why::kBudget ? Kind::kBudget : Kind::kNoStarBox;
}

// About: a gap in the frame, along its axis of the greatest unit; see Obstacle.
std::string obstacle_text(const UncoveredPiece& piece, const PieceForest::Frame& frame) {
  char text[160];
  std::string out;
  if (std::isfinite(piece.gap)) {
    const int scale = *std::min_element(frame.scale.begin(), frame.scale.end());
    std::snprintf(text, sizeof text, "; sheets that face each other pass at about %.3g",
                  std::ldexp(piece.gap, -scale));
    out += text;
  }
  if (piece.least_cosine < 0.99) {
    std::snprintf(text, sizeof text, "; normals near it differ by up to %.0f degrees",
                  std::acos(std::clamp(piece.least_cosine, -1.0, 1.0)) * 57.29577951308232);
    out += text;
  }
  return out;
}

OpenQuestion complex_question(const PatchComplex& complex) {
  OpenQuestion open{Kind::kComplex, {}, {}, {}, "the patches are no closed oriented surface"};
  for (const PatchFinding& f : complex.findings()) {
    if (f.defect == PatchDefect::kAdjacentPoles) continue;
    open.message += "; " + describe(complex, f);
    if (!f.sides.empty()) open.patch = f.sides[0].patch;
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
    if (!complex_.is_closed_oriented_surface()) return open(complex_question(complex_));
    Result<PieceForest> forest = PieceForest::make(complex_);
    if (!forest) return open({Kind::kOutOfRange, {}, {}, {}, forest.error().message});
    forest_.emplace(std::move(*forest));
    out_.cover = find_star_cover(*forest_, options_.cover);
    out_.boxes_tried = out_.cover.tried;
    if (!out_.cover.is_complete()) return open(cover_question());
    if (!fits_certificate(*forest_, out_.cover))
      return open({Kind::kOutOfRange,
                   {},
                   {},
                   {},
                   "the model lies too far from the origin for its size, or has parts of too "
                   "different sizes: coordinates of "
                   "boxes, in units of the least one, would have over 60 bits"});
    out_.walks = find_shell_walks(*forest_, out_.cover);
    if (!out_.walks.missing.empty()) {
      const std::uint32_t shell = out_.walks.missing.front();
      return open(
          {Kind::kNoWalk,
           complex_.shells()[shell].first_patch,
           shell,
           {},
           "no straight path from this shell to infinity or to the shell around it was found"});
    }
    for (const ShellWalk& w : out_.walks.walks)
      if (w.winding_inside != 1) return open(orientation_question(w));
    conclude();
    return std::move(out_);
  }

 private:
  PatchDecision open(OpenQuestion question) {
    out_.open = std::move(question);
    return std::move(out_);
  }
  OpenQuestion cover_question() const {
    const UncoveredPiece& piece = out_.cover.uncovered.front();
    const PieceForest::Node& node = forest_->node(piece.piece);
    return {kind_of(piece.why), node.patch, complex_.shell(node.patch),
            forest_->in_model(node.hull),
            text_of(piece.why) + obstacle_text(piece, forest_->frame())};
  }
  OpenQuestion orientation_question(const ShellWalk& walk) const {
    return {Kind::kOrientation,
            complex_.shells()[walk.shell].first_patch,
            walk.shell,
            {},
            "the winding number is " + std::to_string(walk.winding_inside) +
                " on the inner side of this shell and " + std::to_string(walk.winding_outside) +
                " on the outer one, not 1 and 0: its normals point the wrong way, or it is wrongly "
                "nested"};
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
  PatchDecision out_;
};

}  // namespace

PatchDecision decide_patches(const PatchComplex& complex, const PatchDecisionOptions& options,
                             std::optional<PieceForest>* forest) {
  return Decider(complex, options, forest).run();
}

}  // namespace veritope
