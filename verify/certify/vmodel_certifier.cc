// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/vmodel_certifier.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "solids/vmodel/jacobian_sign.h"
#include "solids/vmodel/v_faces.h"
#include "verify/certify/certify_kinds_internal.h"
#include "verify/certify/exact_volume.h"
#include "verify/certify/file_patches.h"
#include "verify/certify/fold_certifier.h"
#include "verify/certify/parameter_text.h"
#include "verify/certify/refutation_finding.h"
#include "verify/certify/star_box_certifier.h"
#include "verify/certify/v_singularities.h"
#include "verify/certify/vmodel_refuter.h"
#include "verify/certify/vmodel_work.h"
#include "verify/certify/volume_fold.h"
#include "verify/certify/volume_subject.h"
#include "verify/format/vmodel_certificate.h"

namespace veritope {
namespace {

using certificate::VModelBody;
using certificate::VModelFace;

constexpr std::size_t kFewSolves = 5000;  // some hundredths of a second
constexpr int kMostUnit = 4096;           // of coordinates in a star-box body, as a power of two

Finding v_reason(const char* code, std::string message) {
  Finding out;
  out.code = code;
  out.message = std::move(message);
  return out;
}
EntityPart cell_part(std::uint64_t cell, const std::array<std::array<Rational, 2>, 3>& box) {
  EntityPart out;
  out.entity = cell;
  out.is_of_volume = true;
  for (const auto& [lo, hi] : box) out.parameters.push_back({round_down(lo), round_up(hi)});
  return out;
}
std::string name_of_cell(std::uint64_t cell) { return "cell " + std::to_string(cell); }

std::vector<VVolume> cells_in(const SplineFile& file) {
  std::vector<VVolume> out;
  for (const SplineEntity& e : file.model.entities) out.push_back(std::get<ExactVolume>(e.shape));
  return out;
}

Finding finding_of(const VForbiddenCollapse& c) {
  using Kind = VForbiddenCollapse::Kind;
  const char* const what = c.kind == Kind::kPartOfFace   ? "a part of a face is collapsed"
                           : c.kind == Kind::kPartOfEdge ? "a part of an edge is collapsed"
                           : c.face                      ? "a line inside of a face is collapsed"
                                                         : "a line inside of the cell is collapsed";
  Finding out = v_reason("not-certified", name_of_cell(c.cell) + ": " + what);
  if (!c.splits.empty())
    out.message += std::string("; split it at ") + "uvw"[c.splits.front().axis] + " = " +
                   number_text(c.splits.front().at);
  out.place.parts.push_back(cell_part(c.cell, c.box));
  return out;
}
Finding finding_of(const JacobianFinding& f) {
  using Kind = JacobianFinding::Kind;
  Finding out = v_reason("not-certified", name_of_cell(f.cell) + ": ");
  switch (f.kind) {
    case Kind::kFolded: out.message += "the Jacobian determinant has both signs"; break;
    case Kind::kFlat: out.message += "the Jacobian determinant is zero on a whole piece"; break;
    case Kind::kLeftHanded: out.message += "the Jacobian determinant is negative"; break;
    case Kind::kZero:
      out.message += "the Jacobian determinant is zero at a point inside of a piece or its sides";
      break;
    case Kind::kZeroFace:
      out.message +=
          "the Jacobian determinant is zero on a face that is glued or inside of the cell";
      break;
    case Kind::kUndecided:
      out.message += "the sign of the Jacobian determinant is not decided near some parameters";
      break;
  }
  out.place.parts.push_back(cell_part(f.cell, f.box));
  return out;
}

std::vector<VolumeFold> folds_among(const VModel& model,
                                    const std::vector<JacobianFinding>& findings) {
  std::vector<VolumeFold> out;
  for (const JacobianFinding& f : findings) {
    if (f.kind != JacobianFinding::Kind::kFolded || f.places.size() != 2) continue;
    VolumeFold& fold = out.emplace_back();
    fold.entity = f.cell;
    const bool is_first_positive = f.places[0].sign == Sign::kPositive;
    for (std::size_t i = 0; i < 2; ++i)
      fold.places[i] =
          fold_place_of(place_at(model, f.cell, f.places[is_first_positive ? i : 1 - i].at));
  }
  return out;
}

// After the fold that is certified, the others.
void list_folds(const SplineFile& file, const std::vector<VolumeFold>& folds, std::uint64_t first,
                std::size_t most, std::vector<Finding>& to) {
  for (const VolumeFold& fold : folds)
    if (fold.entity != first && to.size() < most) to.push_back(fold_finding(file, fold));
}

class VModelCertification {
 public:
  VModelCertification(const SplineFile& file, const CertifyOptions& options)
      : file_(file),
        options_(options),
        facts_(out_.facts.emplace<PatchFacts>()),
        budget_(memory_allowed(options.max_memory)) {}

  VModelAnswer run() {
    internal::enter(Phase::kDeciding, options_);
    Result<VModel> model = make_v_model(
        cells_in(file_), options_.orientation == PatchOrientation::kAuto ? VOrientation::kAuto
                                                                         : VOrientation::kKeep);
    if (!model) return undecided(v_reason("not-covered", text_of(finding_of(model.error()))));
    model_ = &*model;
    VModelFacts& facts = facts_.vmodel.emplace();
    facts.counts = model_->counts();
    for (std::size_t c = 0; c < model_->num_cells(); ++c)
      if (model_->is_reversed(c)) facts.reversed.push_back(c);
    for (VFaceNumber f = 0; f < model_->num_faces(); ++f)
      if (model_->face(f).is_border()) border_.push_back(f);
    const bool is_left_handed =
        options_.orientation == PatchOrientation::kKeep && !model_->left_handed().empty();
    if (!model_->forbidden().empty() && !is_left_handed) return collapsed();
    VModelWork work(*model_, file_.bytes);
    if (auto finding = work.of_pieces())
      return is_left_handed ? left_handed() : undecided(std::move(*finding));
    const VDeterminants determinants = decide_determinants(*model_, {options_.jobs});
    folds_ = folds_among(*model_, determinants.findings);
    if (is_left_handed && folds_.empty()) return left_handed();
    if (!determinants.is_proved()) return not_proved(determinants);
    if (auto finding = work.of_trees(determinants)) return undecided(std::move(*finding));
    has_proved_cells_ = true;
    return decide_boundary(determinants);
  }

 private:
  VModelRefuter refuter() const { return {*model_, file_}; }

  VModelAnswer invalid(VRefutation proof) {
    internal::enter(Phase::kCertifying, options_);
    out_.verdict = Verdict::kInvalid;
    out_.findings.assign(1, std::move(proof.finding));
    out_.certificate = certificate::encode(
        subject_of(file_, options_.tool),
        {static_cast<std::uint32_t>(model_->num_cells()), std::move(proof.certified)});
    out_.claim = certificate::kVModelInvalidClaim;
    return answer();
  }
  // INVALID if something else is proved wrong than what keeps the model from being VALID.
  VModelAnswer refuted_or(Finding finding) {
    if (const std::optional<VBorder> border = make_border(*model_))
      if (auto proof = border_defect(border->faces, border->complex))
        return invalid(std::move(*proof));
    return overlapping_or(std::move(finding), {});
  }
  VModelAnswer overlapping_or(Finding finding, const VOverlapOptions& overlaps) {
    if (const auto overlap = find_overlap(*model_, overlaps))
      if (auto proof = refuter().overlap(*overlap)) return invalid(std::move(*proof));
    return undecided(std::move(finding));
  }
  // Before star boxes, which take long to give up where sheets lie very near one another.
  std::optional<VRefutation> obvious_overlap() const {
    VOverlapOptions few;
    few.max_solves = kFewSolves;
    few.within_spans = false;
    const auto overlap = find_overlap(*model_, few);
    return overlap ? refuter().overlap(*overlap) : std::nullopt;
  }
  std::optional<VRefutation> border_defect(const VFaces& border,
                                           const PatchComplex& complex) const {
    if (const auto curve = find_crowded_curve(*model_, border, complex))
      if (auto proof = refuter().crowded(*curve)) return proof;
    if (const auto point = find_pinched_point(*model_, border, complex))
      return refuter().pinched(*point);
    return std::nullopt;
  }
  std::optional<VRefutation> collapsed_inside(
      std::uint32_t cell, const std::array<std::array<Rational, 2>, 3>& box) const {
    const auto overlap = find_collapsed_line(*model_, cell, box);
    return overlap ? refuter().overlap(*overlap) : std::nullopt;
  }
  std::optional<VRefutation> refuted_cell(const VDeterminants& determinants) const {
    for (const JacobianFinding& f : determinants.findings)
      if (auto proof = refuter().flat(f)) return proof;
    for (const JacobianFinding& f : determinants.findings)
      if (auto proof = collapsed_inside(f.cell, f.box)) return proof;
    return std::nullopt;
  }
  VModelAnswer undecided(Finding finding) {
    out_.verdict = Verdict::kUndecided;
    out_.findings.assign(1, std::move(finding));
    return answer();
  }
  VModelAnswer answer() {
    return {std::move(out_), std::move(border_), has_proved_cells_, std::move(folds_)};
  }

  VModelAnswer left_handed() {
    facts_.auto_helps = true;
    const auto& cells = model_->left_handed();
    for (const std::uint32_t c : cells) {
      auto proof = refuter().left_handed(c);
      if (!proof) continue;
      if (cells.size() > 1)
        proof->finding.message += "; " + std::to_string(cells.size()) + " cells are left-handed";
      return invalid(std::move(*proof));
    }
    Finding out = v_reason("left-handed", name_of_cell(cells.front()) +
                                              " is left-handed, and no certificate may be about "
                                              "numbers as long as its own");
    out.place.parts.push_back({cells.front(), {}, {}});
    return undecided(std::move(out));
  }
  VModelAnswer collapsed() {
    for (const VForbiddenCollapse& c : model_->forbidden())
      if (auto proof = collapsed_inside(c.cell, c.box)) return invalid(std::move(*proof));
    return refuted_or(finding_of(model_->forbidden().front()));
  }
  VModelAnswer not_proved(const VDeterminants& determinants) {
    Finding finding = finding_of(determinants.findings.front());
    if (!folds_.empty()) return undecided(std::move(finding));
    if (auto proof = refuted_cell(determinants)) return invalid(std::move(*proof));
    return refuted_or(std::move(finding));
  }

  VModelAnswer decide_boundary(const VDeterminants& determinants) {
    const VFaces border = border_of(*model_);
    if (border.faces.empty())
      return undecided(
          v_reason("not-certified", "every face is glued or collapsed: there is no boundary"));
    Result<FilePatches> patches = patches_of_border(border);
    if (!patches) return undecided(v_reason("not-covered", text_of(finding_of(patches.error()))));
    FilePatches& p = *patches;
    if (auto proof = border_defect(border, *p.complex)) return invalid(std::move(*proof));
    if (auto proof = obvious_overlap()) return invalid(std::move(*proof));
    facts_.patches = p.complex->patches().size();
    facts_.edges = p.complex->num_edges();
    facts_.vertices = p.complex->num_vertices();
    facts_.shells = p.complex->shells().size();
    FileDecisionOptions how;
    how.search.budget = &budget_;
    how.search.cover.work = options_.work;
    how.search.with_contacts_on_borders = false;
    if (options_.max_cells) how.search.cover.max_boxes = *options_.max_cells;
    if (options_.tolerance) how.search.tolerance = *options_.tolerance;
    const FileDecision decided = decide_file_patches(p, how);
    facts_.boxes_tried = decided.decision.boxes_tried;
    if (!decided.decision.is_valid)
      return overlapping_or(open_finding(p, decided.decision), near_crossing(p, decided.decision));
    facts_.vmodel->singular = singularities_of(*model_, determinants);
    if (options_.wants_regular && !facts_.vmodel->singular.empty()) return not_regular();
    conclude_valid(p, decided, determinants);
    return answer();
  }

  VModelAnswer not_regular() {
    for (const VSingularity& s : facts_.vmodel->singular)
      if (auto proof = refuter().singular(s)) return invalid(std::move(*proof));
    return undecided(v_reason("not-certified",
                              "the cells bound a solid, but the Jacobian determinant is zero on "
                              "parts of them, and no certificate may be about numbers as long as "
                              "those of a point there"));
  }

  // Points of cells next to a place where two of their faces cross: an overlap has all sizes there.
  VOverlapOptions near_crossing(const FilePatches& patches, const PatchDecision& decision) const {
    VOverlapOptions out;
    const auto* const crossing =
        decision.refutation ? std::get_if<CrossingWitness>(&*decision.refutation) : nullptr;
    if (crossing == nullptr) return out;
    for (const PatchRectangle& sheet : crossing->sheets) {
      const auto after = std::upper_bound(
          patches.entities.begin(), patches.entities.end(), sheet.patch,
          [](std::uint32_t patch, const StarBoxEntity& e) { return patch < e.first_patch; });
      add_hints(*(after - 1), sheet, out.hints);
    }
    return out;
  }
  void add_hints(const StarBoxEntity& entity, const PatchRectangle& sheet,
                 std::vector<VOverlapOptions::Hint>& to) const {
    const VolumeFace& face = *entity.face;
    const std::size_t columns = entity.breaks[1].size() - 1,
                      number = sheet.patch - entity.first_patch;
    const std::array<std::size_t, 2> span = {number / columns, number % columns};
    const auto cell = static_cast<std::uint32_t>(face.volume);
    VOverlapOptions::Hint hint{cell, {}};
    const auto move_in = [&](std::size_t axis, const Rational& t) {
      const KnotAxis<Rational>& a = model_->cell(cell).axis(axis);
      return std::max(a.domain_begin(), std::min(a.domain_end(), t));
    };
    for (const int halvings : {4, 8, 14, 20, 28, 36}) {
      const Rational step = Rational::power_of_two(-halvings);
      const KnotAxis<Rational>& across = model_->cell(cell).axis(face.axis);
      const Rational depth = (across.domain_end() - across.domain_begin()) * step;
      hint.at[face.axis] =
          face.end == 0 ? across.domain_begin() + depth : across.domain_end() - depth;
      for (const int side : {0, 1, 2, 3, 4}) {
        for (std::size_t k = 0; k < 2; ++k) {
          const Rational &lo = entity.breaks[k][span[k]], &hi = entity.breaks[k][span[k] + 1];
          const Rational middle = (sheet.at[k].lower() + sheet.at[k].upper()) / Rational(2);
          const int way = side == static_cast<int>(2 * k + 1)   ? 1
                          : side == static_cast<int>(2 * k + 2) ? -1
                                                                : 0;
          hint.at[face.axes[k]] =
              move_in(face.axes[k], lo + (hi - lo) * (middle + Rational(4 * way) * step));
        }
        to.push_back(hint);
      }
    }
  }

  Result<FilePatches> patches_of_border(const VFaces& border) const {
    Result<std::vector<Patch>> pieces = patches_of(border);
    if (!pieces) return pieces.error();
    FilePatches out;
    std::uint32_t first = 0;
    for (std::size_t i = 0; i < border.faces.size(); ++i) {
      const VFaceNumber f = border.faces[i];
      const std::size_t axis = f % 6 / 2, end = f % 2;
      const auto& across = model_->cell(f / 6).axis(axis);
      StarBoxEntity entity;
      entity.first_patch = first;
      entity.breaks = border.breaks[i];
      entity.face = VolumeFace{f / 6, axis, end, border.axes[i],
                               end == 0 ? across.domain_begin() : across.domain_end()};
      first +=
          static_cast<std::uint32_t>((entity.breaks[0].size() - 1) * (entity.breaks[1].size() - 1));
      out.entities.push_back(std::move(entity));
    }
    Result<PatchComplex> complex = make_patch_complex(std::move(*pieces));
    if (!complex) return complex.error();
    out.complex = std::make_unique<PatchComplex>(std::move(*complex));
    return out;
  }

  Finding open_finding(const FilePatches& patches, const PatchDecision& decision) const {
    if (!decision.open)
      return v_reason(
          "not-certified",
          "the faces that are not glued bound no solid: " +
              finding_of(*patches.complex, patches.entities, *decision.refutation).message);
    Finding out = *decision.open;
    if (out.code != open_code::kBudget && out.code != open_code::kMemory)
      out.code = "not-certified";
    if (out.place.patch) {
      const auto& entities = patches.entities;
      const auto after = std::upper_bound(
          entities.begin(), entities.end(), *out.place.patch,
          [](std::uint64_t patch, const StarBoxEntity& e) { return patch < e.first_patch; });
      out.place.source.entity = (after - 1)->face->volume;
    }
    return out;
  }

  void conclude_valid(const FilePatches& patches, const FileDecision& decided,
                      const VDeterminants& determinants) {
    internal::enter(Phase::kCertifying, options_);
    const PatchDecision& decision = decided.decision;
    out_.verdict = Verdict::kValid;
    facts_.bodies = decision.bodies;
    facts_.boxes = decision.cover.boxes.size();
    facts_.shell_facts = decision.shells;
    for (const PatchShellFacts& s : decision.shells)
      facts_.genus += static_cast<std::uint64_t>(s.genus);
    facts_.volume = decision.volume;
    facts_.vmodel->volume = exact_volume(patches.complex->patches());
    VModelBody body = body_of(determinants);
    body.boundary = make_star_box_body(*decided.forest, decision.cover, decision.walks,
                                       patches.entities, kMostUnit);
    body.boundary.version = 2;
    out_.certificate =
        certificate::encode(subject_of(file_, options_.tool), quantities(determinants), body);
    out_.claim = certificate::kVModelClaim;
  }

  VModelBody body_of(const VDeterminants& determinants) const {
    VModelBody out;
    for (std::size_t c = 0; c < model_->num_cells(); ++c) {
      certificate::VModelCell& cell = out.cells.emplace_back();
      cell.is_reversed = model_->is_reversed(c);
      for (std::size_t a = 0; a < 3; ++a)
        for (const Rational& t : model_->added_breaks(c, a))
          cell.added_breaks[a].push_back(to_fraction(t));
    }
    for (VFaceNumber f = 0; f < model_->num_faces(); ++f) {
      const VFaceRole& role = model_->face(f);
      VModelFace& face = out.faces.emplace_back();
      if (role.is_collapsed()) face.kind = VModelFace::Kind::kCollapsed;
      if (!role.is_glued()) continue;
      face.kind = role.mate < f ? VModelFace::Kind::kNamed : VModelFace::Kind::kGlued;
      if (role.mate > f) face.other = role.mate, face.symmetry = role.symmetry;
    }
    for (const PieceProof& proof : determinants.proofs)
      out.determinants.push_back({proof.piece, proof.zeros, proof.tree});
    return out;
  }
  certificate::VModelQuantities quantities(const VDeterminants& determinants) const {
    const VCounts& n = model_->counts();
    certificate::VModelQuantities out;
    out.cells = n.cells, out.pieces = n.pieces;
    out.half_v_surfaces = n.half_v_surfaces, out.v_surfaces = n.v_surfaces;
    out.v_curves = n.v_curves, out.v_points = n.v_points, out.euler = n.euler;
    out.reversed = n.reversed, out.singular = determinants.num_zeros;
    out.patches = facts_.patches, out.shells = facts_.shells;
    out.bodies = facts_.bodies, out.genus = facts_.genus;
    return out;
  }

  const SplineFile& file_;
  const CertifyOptions& options_;
  Certified out_;
  PatchFacts& facts_;
  MemoryBudget budget_;
  const VModel* model_ = nullptr;
  std::vector<VFaceNumber> border_;
  bool has_proved_cells_ = false;
  std::vector<VolumeFold> folds_;
};

}  // namespace

std::optional<VModelAnswer> certify_vmodel(const SplineFile& file, const CertifyOptions& options) {
  if (!has_only_volumes(file)) return std::nullopt;
  const std::optional<VolumeSubject> subject = volume_subject_of(file);
  if (!subject) return std::nullopt;
  VModelAnswer out = VModelCertification(subject->file(file), options).run();
  out.certified.copy = subject->certified_copy();
  for (const VolumeFold& fold : out.folds) {
    auto folded = certify_fold_at(file, fold, options);
    if (!folded) continue;
    folded->facts = std::move(out.certified.facts);
    out.certified = std::move(*folded);
    list_folds(file, out.folds, fold.entity, options.max_findings, out.certified.findings);
    break;
  }
  return out;
}

}  // namespace veritope
