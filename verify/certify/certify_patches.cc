// SPDX-License-Identifier: LGPL-3.0-or-later
// certify for spline files: their surfaces and triangles are the patches of one complex.
#include <algorithm>
#include <cmath>
#include <new>
#include <span>
#include <utility>

#include "io/splines/volumes.h"
#include "splines/knot_insertion.h"
#include "verify/certify/certify_kinds_internal.h"
#include "verify/certify/collar_certifier.h"
#include "verify/certify/entity_parts.h"
#include "verify/certify/file_patches.h"
#include "verify/certify/fold_certifier.h"
#include "verify/certify/parameter_text.h"
#include "verify/certify/patch_reasons.h"
#include "verify/certify/refutation_finding.h"
#include "verify/certify/stand_in.h"
#include "verify/certify/vmodel_certifier.h"
#include "verify/format/patch_invalid_certificate.h"
#include "verify/format/patch_meeting_certificate.h"

namespace veritope {
namespace {

// What checkers ask for each patch before they glue all of them.
constexpr std::uint64_t kBytesOfGluedPatch = 3;
constexpr std::size_t kMostReasons = 19;  // and one more: not-certified
// The boxes that may be tried to find something else that is wrong with a model whose patches face the wrong way.
constexpr std::uint64_t kMostBoxesOfAdvice = 1000;

Finding why(const char* code, std::string message) {
  Finding out;
  out.code = code;
  out.message = std::move(message);
  return out;
}
Finding not_covered(std::string message) { return why("not-covered", std::move(message)); }

// Content of the file that no certificate covers; tested before its patches are made.
std::optional<Finding> uncovered_content(const SplineFile& file) {
  if (auto reason = uncovered_shapes(file)) return not_covered(std::move(*reason));
  if (file.beyond_default_limits)
    return not_covered("the file has longer numbers than certificates may be about: " +
                       text_of(finding_of(*file.beyond_default_limits)));
  return std::nullopt;
}

// Properties of the file's patches that no certificate covers.
std::optional<Finding> uncovered_patches(const FilePatches& patches) {
  if (patches.mixed_entity)
    return not_covered("pieces of entity " + std::to_string(*patches.mixed_entity) +
                       " would have to be reversed one by one");
  const auto at =
      std::find_if_not(patches.entities.begin(), patches.entities.end(), breaks_fit_certificate);
  if (at != patches.entities.end())
    return not_covered(EntityParts(*patches.complex, patches.entities)
                           .name(static_cast<std::size_t>(at - patches.entities.begin())) +
                       " has longer knots than certificates may be about");
  return std::nullopt;
}

// Whether the refutation is about the directions of normals. If entities were reversed, the refutation is about the
// changed model, not about the one in the file.
bool is_of_orientation(const PatchRefutation& refutation) {
  if (const auto* const sides = std::get_if<SideWitness>(&refutation))
    return sides->same == 2 && sides->opposite == 0;
  return std::holds_alternative<ReversedShell>(refutation);
}

bool is_limit(const std::string& code) {
  return code == open_code::kBudget || code == open_code::kMemory;
}

std::string_view claim_of(const PatchDecision& decision, bool has_collar) {
  const bool is_2 = decision.cover.needs_version_2();
  if (!decision.refutation && has_collar)
    return is_2 ? certificate::kCollar2Claim : certificate::kCollarClaim;
  if (!decision.refutation) return is_2 ? certificate::kStarBox2Claim : certificate::kStarBoxClaim;
  if (std::holds_alternative<MeetingWitness>(*decision.refutation))
    return certificate::kPatchInvalid2Claim;
  if (!std::holds_alternative<ReversedShell>(*decision.refutation))
    return certificate::kPatchInvalidClaim;
  return is_2 ? certificate::kReversedShell2Claim : certificate::kReversedShellClaim;
}

class Certification {
 public:
  /// @param faces  where the surfaces of the file's model lie, if they are boundary faces of volumes
  /// @param by_own_faces  the certificate numbers them as faces of the file's volumes, not as entities of a copy
  Certification(const SplineFile& file, std::span<const VolumeFace> faces, bool by_own_faces,
                const CertifyOptions& options)
      : file_(file),
        faces_(faces),
        by_own_faces_(by_own_faces),
        options_(options),
        facts_(out_.facts.emplace<PatchFacts>()),
        budget_(memory_allowed(options.max_memory)) {}

  Result<Certified> run() {
    if (auto finding = uncovered_content(file_)) return undecided(std::move(*finding));
    Result<FilePatches> patches = file_patches(file_.model, options_.orientation, faces_);
    if (!patches) return patches.error();
    patches_ = std::move(*patches);
    if (patches_.not_covered) return undecided(std::move(*patches_.not_covered));
    count();
    if (auto finding = uncovered_patches(patches_)) return undecided(std::move(*finding));
    internal::enter(Phase::kDeciding, options_);
    decided_ = decide_file_patches(patches_, decision_options());
    facts_.reversed = patches_.reversed();
    facts_.boxes_tried = decision().boxes_tried;
    std::optional<Finding> open = doubt();
    facts_.auto_helps = auto_helps();
    if (open) return undecided_by(std::move(*open));
    if (decision().is_valid) conclude_valid();
    certify();
    return std::move(out_);
  }

 private:
  const PatchDecision& decision() const { return decided_.decision; }

  // An UNDECIDED result with the facts that are known so far.
  Result<Certified> undecided(Finding finding) {
    out_.verdict = Verdict::kUndecided;
    out_.findings.assign(1, std::move(finding));
    return std::move(out_);
  }

  // The named reasons come before the general one.
  Result<Certified> undecided_by(Finding finding) {
    if (!decision().open) return undecided(std::move(finding));
    out_.findings = patch_reasons(patches_, kMostReasons);
    out_.findings.push_back(std::move(finding));
    out_.verdict = Verdict::kUndecided;
    return std::move(out_);
  }

  void count() {
    const PatchComplex& complex = *patches_.complex;
    facts_.patches = complex.patches().size();
    facts_.edges = complex.num_edges();
    facts_.vertices = complex.num_vertices();
    facts_.shells = complex.shells().size();
    list_open_sides();
    facts_.reversed = patches_.reversed();
    if (patches_.mixed_entity)  // list only those before the mixed one
      std::erase_if(facts_.reversed, [&](std::uint64_t e) { return e >= *patches_.mixed_entity; });
  }

  void list_open_sides() {
    facts_.open = open_borders(*patches_.complex, options_.max_findings);
    const EntityParts parts(*patches_.complex, patches_.entities);
    const auto whole = [&](PatchSide side) { return parts.of(side, {Rational(0), Rational(1)}); };
    for (const OpenSide& side : facts_.open.longest) {
      OpenSideFacts facts{whole(side.side), side, {}};
      if (side.near) facts.near = whole(*side.near);
      facts_.open_sides.push_back(std::move(facts));
    }
  }

  FileDecisionOptions decision_options() {
    FileDecisionOptions out;
    out.search.budget = &budget_;
    out.search.cover.work = options_.work;
    out.search.with_contacts_on_borders =
        kBytesOfGluedPatch * patches_.complex->patches().size() <= file_.bytes;
    if (options_.max_cells) out.search.cover.max_boxes = *options_.max_cells;
    if (options_.tolerance) out.search.tolerance = *options_.tolerance;
    if (options_.with_collar) out.frame = FrameWanted::kPlainIfCheap;
    out.may_turn_shells = options_.orientation == PatchOrientation::kAuto;
    return out;
  }

  // Why there is no verdict; nothing if out_ has one.
  std::optional<Finding> doubt() {
    if (decision().refutation) return doubt_about_refutation();
    if (decision().is_valid) {
      out_.verdict = Verdict::kValid;
      return std::nullopt;
    }
    Finding open = *decision().open;
    if (!is_limit(open.code)) open.code = "not-certified";
    const EntityParts parts(*patches_.complex, patches_.entities);
    if (open.place.patch)
      open.place.source.entity = parts.number_in_file(parts.entity_of(*open.place.patch));
    for (const PatchPart& sheet : decision().facing) open.place.parts.push_back(parts.of(sheet));
    return open;
  }
  std::optional<Finding> doubt_about_refutation() {
    Finding defect = finding_of(*patches_.complex, patches_.entities, *decision().refutation);
    if (!patches_.torn.empty()) {
      Finding torn = torn_knot_finding(patches_.torn.front());
      torn.message += "; its pieces do not fit: " + defect.message;
      return torn;
    }
    if (defect.code == "side-overused")
      defect.message += repetition_text(patches_, std::get<SideWitness>(*decision().refutation));
    if (!facts_.reversed.empty() && is_of_orientation(*decision().refutation))
      return why("not-certified", "with the entities that were reversed " + defect.message);
    out_.verdict = Verdict::kInvalid;
    out_.findings.push_back(std::move(defect));
    return std::nullopt;
  }

  bool auto_helps() {
    const bool is_reversible =
        faces_.empty() && patches_.torn.empty() && options_.orientation == PatchOrientation::kKeep;
    if (!is_reversible || decision().is_valid) return false;
    if (decision().open) return decision().open->code == open_code::kOrientation;
    if (!is_of_orientation(*decision().refutation)) return false;
    // Boxes cover a turned shell, and the walks between shells say what to reverse.
    if (std::holds_alternative<ReversedShell>(*decision().refutation)) return true;
    return fit_once_reversed();
  }
  // Whether all sides fit once whole patches are reversed, and nothing else is found to be wrong.
  bool fit_once_reversed() {
    Result<FilePatches> fitting = file_patches(file_.model, PatchOrientation::kAuto);
    if (!fitting || fitting->mixed_entity || !fitting->complex->is_closed_oriented_surface())
      return false;
    FileDecisionOptions how = decision_options();
    how.frame = FrameWanted::kAny;
    how.may_turn_shells = true;
    how.search.cover.max_boxes =
        std::min<std::size_t>(how.search.cover.max_boxes, kMostBoxesOfAdvice);
    const FileDecision found = decide_file_patches(*fitting, how);
    return found.decision.is_valid || (found.decision.open && is_limit(found.decision.open->code));
  }

  void conclude_valid() {
    facts_.bodies = decision().bodies;
    facts_.boxes = decision().cover.boxes.size();
    facts_.shell_facts = decision().shells;
    for (const PatchShellFacts& s : decision().shells)
      facts_.genus += static_cast<std::uint64_t>(s.genus);
    facts_.volume = decision().volume;
    if (options_.with_collar) seek_collar();
  }

  void seek_collar() {
    internal::enter(Phase::kSeekingCollar, options_);
    if (decision().cover.has_several_sheets())
      collar_.open = why("no-collar",
                         "star boxes hold several sheets, because walls are thin: cells as small "
                         "as their thickness would be very many");
    else if (decided_.forest->frame().is_plain())
      collar_ = find_collar_or_fail();
    else
      collar_.open = why("no-collar",
                         "octrees have cubes around the origin's grid: the model lies too far "
                         "away, or is too flat");
    facts_.collar = collar_facts(collar_, *decided_.forest);
  }

  // The star boxes are proved: not even a system that has less memory than the limit says takes that away.
  PatchCollarSearch find_collar_or_fail() {
    CollarSearchOptions limits;
    if (options_.max_cells) limits.max_cells = *options_.max_cells;
    try {
      PatchCollarSearch out = find_patch_collar(*decided_.forest, decision().cover, limits);
      if (!out.collar || fits_certificate(*decided_.forest, decision().cover, *out.collar))
        return out;
      out.collar.reset();
      out.open = why("no-collar",
                     "one was found, but the star boxes have units so short that checkers cannot "
                     "hold the collar's coordinates in them");
      return out;
    } catch (const std::bad_alloc&) {
      PatchCollarSearch out;
      out.open = why(open_code::kMemory, "the system has no more memory");
      return out;
    }
  }

  void certify() {
    internal::enter(Phase::kCertifying, options_);
    const certificate::Subject subject = subject_of(file_, options_.tool, by_own_faces_);
    out_.certificate = collar_.collar ? make_collar_certificate(*decided_.forest, decision().cover,
                                                                decision().walks, *collar_.collar,
                                                                patches_.entities, subject)
                                      : make_patch_certificate(patches_, decided_, subject);
    if (collar_.collar) out_.without_collar = make_patch_certificate(patches_, decided_, subject);
    out_.claim = claim_of(decision(), collar_.collar.has_value());
  }

  const SplineFile& file_;
  const std::span<const VolumeFace> faces_;
  const bool by_own_faces_;
  const CertifyOptions& options_;
  Certified out_;
  PatchFacts& facts_;
  MemoryBudget budget_;  // before what it is charged for
  FilePatches patches_;
  FileDecision decided_;
  PatchCollarSearch collar_;
};

// Whether the faces of the stand-in are these.
bool has_faces(const StandIn& stand_in, const std::vector<VFaceNumber>& border) {
  return whole_faces(stand_in.faces) == border;
}

Result<Certified> decided_stand_in(StandIn stand_in, CertifyOptions options) {
  // The volume says which side of its faces is outside: a volume inside another one is no cavity.
  if (stand_in.is_of_volumes) options.orientation = PatchOrientation::kKeep;
  Result<Certified> out =
      Certification(stand_in.file, stand_in.faces, stand_in.is_by_own_faces(), options).run();
  if (!out) return out;
  if (stand_in.is_of_volumes) out->boundary_faces = stand_in.what;
  if (stand_in.is_copy())
    out->copy = {std::move(stand_in.bytes), stand_in.file.sha256, std::move(stand_in.what),
                 stand_in.is_of_volumes};
  return out;
}

// The first volume that may be torn at an inner knot, because that occurs more often than the degree.
std::optional<Finding> torn_volume(const SplineModel& model) {
  for (std::uint64_t e = 0; e < model.entities.size(); ++e) {
    const auto* const volume = std::get_if<ExactVolume>(&model.entities[e].shape);
    for (std::size_t a = 0; volume != nullptr && a < 3; ++a)
      for (const Rational& t : volume->axis(a).knots) {
        const KnotAxis<Rational>& axis = volume->axis(a);
        if (multiplicity(axis, t) <= axis.degree || !(axis.domain_begin() < t) ||
            !(t < axis.domain_end()))
          continue;
        Finding out =
            not_covered(entity_text(e) + ": the inner knot " + number_text(t) + " of " + "uvw"[a] +
                        " occurs more often than the degree, so that the volume may be "
                        "torn there, and certificates about cells do not cover that");
        out.place.parts.push_back({e, {}, {}, {}, true});
        return out;
      }
  }
  return std::nullopt;
}

// No certificate can speak of the cells, whatever is known of their boundary faces.
Certified cells_not_covered(const SplineModel& model, bool is_boundary_valid) {
  Certified out;
  out.facts.emplace<PatchFacts>();
  std::optional<Finding> torn = torn_volume(model);
  out.findings = {torn ? std::move(*torn)
                       : not_covered("the numbers of the volumes are longer than certificates "
                                     "about cells may hold")};
  if (is_boundary_valid)
    out.findings.front().message +=
        "; the boundary faces bound a solid (veritope convert --faces writes them)";
  return out;
}
// What refutes the boundary faces refutes the cells only if it does not depend on which faces are glued.
bool refutes_cells(const Certified& faces) {
  return faces.verdict == Verdict::kInvalid && faces.findings.front().code == "patches-crossing";
}

// A face that touches itself is wrong wherever it is split, if it is a curve or a point there.
bool are_two_faces_that_touch(const Finding& finding) {
  const auto& parts = finding.place.parts;
  return finding.code == "patches-touching" && parts.size() == 2 &&
         (parts[0].entity != parts[1].entity || parts[0].face != parts[1].face);
}

// Cells that are not certified: what is known of the boundary.
Certified with_boundary(VModelAnswer cells, StandIn stand_in, const CertifyOptions& options) {
  const bool is_same = has_faces(stand_in, cells.border);
  Result<Certified> faces = decided_stand_in(std::move(stand_in), options);
  if (faces && !is_same && cells.has_proved_cells && faces->verdict == Verdict::kValid) {
    Finding& finding = cells.certified.findings.front();
    finding.code = "partial-contact";
    finding.message =
        "faces are not glued because one cell has a part of another's face: " + finding.message;
  }
  if (!faces || !is_same) return std::move(cells.certified);
  // Two faces that touch refute the surface, but not cells, which may be valid once they are split there.
  if (faces->verdict == Verdict::kInvalid && are_two_faces_that_touch(faces->findings.front())) {
    Finding& finding = cells.certified.findings.front();
    finding = std::move(faces->findings.front());
    finding.code = "contact";
    return std::move(cells.certified);
  }
  if (faces->verdict == Verdict::kInvalid) {
    std::get<PatchFacts>(faces->facts).vmodel = std::get<PatchFacts>(cells.certified.facts).vmodel;
    return std::move(*faces);
  }
  if (faces->verdict == Verdict::kValid)
    cells.certified.findings.front().message +=
        "; its boundary faces bound a solid (veritope convert --faces writes them)";
  return std::move(cells.certified);
}

}  // namespace

Result<Certified> internal::certify_kind(const SplineFile& file, const CertifyOptions& options) {
  if (has_attributes(file.model)) return certify_kind(without_attributes(file), options);
  std::optional<VModelAnswer> cells;
  if (!options.with_collar) cells = certify_vmodel(file, options);
  if (cells && cells->certified.verdict != Verdict::kUndecided) return std::move(cells->certified);
  if (auto folded = certify_fold(file, options)) {
    if (cells) folded->facts = std::move(cells->certified.facts);
    return std::move(*folded);
  }
  Result<std::optional<StandIn>> made = stand_in_of(file);
  if (!made) {
    if (cells) return std::move(cells->certified);
    Certified out;
    out.facts.emplace<PatchFacts>();
    out.findings = {not_covered(text_of(finding_of(made.error())))};
    return out;
  }
  if (!*made) return Certification(file, {}, false, options).run();
  if (cells) return with_boundary(std::move(*cells), std::move(**made), options);
  const bool is_about_cells = (*made)->is_of_volumes && !options.with_collar;
  Result<Certified> out = decided_stand_in(std::move(**made), options);
  if (out && is_about_cells && out->verdict != Verdict::kUndecided && !refutes_cells(*out))
    return cells_not_covered(file.model, out->verdict == Verdict::kValid);
  return out;
}

CollarFacts collar_facts(const PatchCollarSearch& search, const PieceForest& forest) {
  CollarFacts out;
  out.open = search.open;
  if (!search.collar) return out;
  const OctreeKeySet& cells = search.collar->complex.cells();
  out.cells = cells.size();
  out.finest_level = cells.finest_level();
  out.coarsest_level = out.finest_level;
  for (const OctreeKey key : cells.keys())
    out.coarsest_level = std::min(out.coarsest_level, key.level());
  const double edge = std::ldexp(search.collar->root.edge(), -forest.scale());
  out.longest_edge = std::ldexp(edge, -static_cast<int>(out.coarsest_level));
  out.shortest_edge = std::ldexp(edge, -static_cast<int>(out.finest_level));
  return out;
}

}  // namespace veritope
