// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope certify of spline files: their surfaces and triangles as patches.
#include <algorithm>

#include "cli/certification.h"
#include "cli/decimal_text.h"
#include "cli/patch_report.h"
#include "io/formats.h"
#include "io/read_model.h"
#include "io/splines/patch_model.h"
#include "verify/certify/collar_certifier.h"
#include "verify/certify/patch_certifier.h"
#include "verify/certify/patch_decision.h"
#include "verify/certify/refutation_facts.h"
#include "verify/format/patch_invalid_certificate.h"
#include "verify/format/sha256.h"

namespace veritope::cli {
namespace {

// Whether the surface may be in pieces inside of its domain.
bool has_torn_knot(const ExactSurface& surface) {
  for (const auto& axis : surface.axes()) {
    std::size_t run = 0;
    for (std::size_t i = 0; i < axis.knots.size(); ++i) {
      run = i > 0 && axis.knots[i] == axis.knots[i - 1] ? run + 1 : 1;
      const bool is_inner =
          axis.domain_begin() < axis.knots[i] && axis.knots[i] < axis.domain_end();
      if (is_inner && run > static_cast<std::size_t>(axis.degree)) return true;
    }
  }
  return false;
}

// Whether it speaks of the directions of normals: it then is one of the model only if none was reversed.
bool is_of_orientation(const PatchRefutation& refutation) {
  if (const auto* const sides = std::get_if<SideWitness>(&refutation))
    return sides->same == 2 && sides->opposite == 0;
  return std::holds_alternative<TurnedShell>(refutation);
}

// Boxes that are tried in the plain frame of a collar, for each one in the frame that fits the model.
constexpr std::size_t kBoxesForCollar = 16;

class PatchCertification : public Certification {
 public:
  using Certification::Certification;

 private:
  bool read() override {
    phase("reading");
    Result<SplineFile> file = read_splines();
    report_.seconds.read = watch_.lap();
    if (!file) return refuse(fault_of(file.error()));
    PatchReport patches;
    patches.format = file->format;
    patches.bytes = file->bytes;
    patches.entities = file->model.entities.size();
    report_.sha256 = file->sha256;
    report_.patches = std::move(patches);
    if (file->format != SplineFormat::kJson && file->format != SplineFormat::kItd)
      return undecided("not-covered",
                       "certificates speak of .vjson and .itd files only: veritope convert writes "
                       "this model as one");
    for (const LeftOut& l : file->left_out)
      if (l.is_geometry)
        return undecided("not-covered", "the file has shapes that are not read: " + l.what);
    return have_short_numbers(*file) && take_patches(file->model);
  }

  // Certificates know numbers within the default limits only.
  bool have_short_numbers(const SplineFile& file) {
    if (!file.beyond_default_limits) return true;
    return undecided("not-covered", "the file has longer numbers than certificates may be about: " +
                                        fault_text(fault_of(*file.beyond_default_limits)));
  }

  Result<SplineFile> read_splines() {
    if (!needs_copy()) return read_spline_file(report_.path, settings_.reading);
    Result<ByteBuffer> bytes = read_once();
    if (!bytes) return bytes.error();
    spooled_ = std::move(*bytes);
    return read_spline_bytes({spooled_.data(), spooled_.size()}, report_.path, settings_.reading);
  }

  bool take_patches(const SplineModel& model) {
    Result<PatchSource> source = patch_source(model);
    if (!source) return refuse(fault_of(source.error()));
    if (!source->foreign.empty())
      return undecided("not-covered",
                       "patches are surfaces and triangles in space; this file has " +
                           to_string(source->foreign.front()));
    if (source->patches.empty())
      return refuse({"empty", {}, "there is no surface and no triangle in this file"});
    entities_ = std::move(source->entities);
    PatchInput input;
    input.patches = std::move(source->patches);
    Result<PatchComplex> complex = make_patch_complex(std::move(input), settings_.orientation);
    if (!complex) return refuse(fault_of(complex.error()));
    complex_.emplace(std::move(*complex));
    for (const SplineEntity& e : model.entities) {
      const auto* const surface = std::get_if<ExactSurface>(&e.shape);
      is_surface_.push_back(surface != nullptr);
      is_torn_ = is_torn_ || (surface != nullptr && has_torn_knot(*surface));
    }
    PatchReport& r = *report_.patches;
    r.patches = complex_->patches().size();
    r.edges = complex_->num_edges();
    r.vertices = complex_->num_vertices();
    r.shells = complex_->shells().size();
    return list_flipped() && have_short_breaks();
  }

  // A certificate reverses whole entities.
  bool list_flipped() {
    const auto flipped = complex_->flipped();
    std::vector<bool> is_flipped(complex_->patches().size());
    for (const std::uint32_t p : flipped) is_flipped[p] = true;
    reversed_.assign(entities_.size(), false);
    for (std::size_t e = 0; e < entities_.size(); ++e) {
      const std::size_t first = entities_[e].first_patch, last = first + entities_[e].num_patches;
      reversed_[e] = first < last && is_flipped[first];
      for (std::size_t p = first; p < last; ++p)
        if (is_flipped[p] != reversed_[e])
          return undecided("not-covered", "pieces of entity " + std::to_string(e) +
                                              " would have to be reversed one by one");
      if (reversed_[e]) report_.patches->flipped.push_back(e);
    }
    return true;
  }

  bool have_short_breaks() {
    list_entities();
    const auto at = std::find_if_not(described_.begin(), described_.end(), breaks_fit_certificate);
    if (at == described_.end()) return true;
    return undecided("not-covered", "entity " + std::to_string(at - described_.begin()) +
                                        " has longer knots than certificates may be about");
  }

  bool decide() override {
    phase("deciding");
    decision_ = decided();
    if (settings_.orientation == PatchOrientation::kAuto && turn_shells()) decision_ = decided();
    report_.seconds.decide = watch_.lap();
    PatchReport& r = *report_.patches;
    r.boxes_tried = decision_.boxes_tried;
    if (decision_.refutation) {
      RefutationFacts facts = facts_of(*complex_, described_, *decision_.refutation);
      if (is_torn_)
        return undecided(
            "not-covered",
            "a surface has an inner knot of a multiplicity above its degree; " + facts.message);
      if (!r.flipped.empty() && is_of_orientation(*decision_.refutation))
        return undecided("not-certified", "with the entities that were reversed " + facts.message);
      r.defects.push_back(std::move(facts));
      return true;
    }
    if (!decision_.is_valid) {
      r.open = decision_.open;
      Place place;
      if (decision_.open->patch) {
        const PatchOrigin& origin = complex_->patch(*decision_.open->patch).origin();
        place.entity = origin.number;
      }
      return give_up(kExitUndecided, {"not-certified", place, decision_.open->message});
    }
    r.bodies = decision_.bodies;
    r.boxes = decision_.cover.boxes.size();
    r.shell_facts = decision_.shells;
    for (const PatchShellFacts& s : decision_.shells)
      r.genus += static_cast<std::uint64_t>(s.genus);
    r.volume = decision_.volume;
    if (settings_.with_collar) seek_collar();
    return true;
  }

  void seek_collar() {
    phase("looking for a collar");
    if (forest_->frame().is_plain())
      collar_ = find_patch_collar(*forest_, decision_.cover);
    else
      collar_.open.message =
          "octrees have cubes around the origin's grid: the model lies too far away, or is too "
          "flat";
    report_.patches->collar = collar_report(collar_, *forest_);
    report_.seconds.collar = watch_.lap();
  }

  PatchDecision decided() {
    list_entities();
    PatchDecisionOptions options;
    options.outer = outer_sides(described_, complex_->patches().size());
    if (settings_.tolerance) options.tolerance = *settings_.tolerance;
    PatchDecision decision = decide_patches(*complex_, options, &forest_);
    if (!settings_.with_collar || !decision.is_valid || forest_->frame().is_plain() ||
        !may_have_octree(*complex_))
      return decision;
    // Once more in the frame that a collar needs, if that is not much dearer.
    options.in_plain_frame = true;
    options.cover.max_boxes = kBoxesForCollar * (decision.boxes_tried + 256);
    std::optional<PieceForest> plain;
    PatchDecision again = decide_patches(*complex_, options, &plain);
    if (!again.is_valid) return decision;
    forest_ = std::move(plain);
    return again;
  }

  // Shells that are wrongly oriented as a whole, which takes winding numbers to see. Each entity lies in one shell.
  bool turn_shells() {
    if (decision_.walks.walks.empty() || !decision_.walks.missing.empty()) return false;
    const std::vector<std::uint32_t> shells = shells_to_turn(decision_.walks);
    if (shells.empty()) return false;
    std::vector<Patch> patches(complex_->patches().begin(), complex_->patches().end());
    report_.patches->flipped.clear();
    for (std::size_t e = 0; e < entities_.size(); ++e) {
      const std::size_t first = entities_[e].first_patch, last = first + entities_[e].num_patches;
      const std::uint32_t shell = complex_->shell(static_cast<std::uint32_t>(first));
      if (first < last && std::binary_search(shells.begin(), shells.end(), shell)) {
        reversed_[e] = !reversed_[e];
        for (std::size_t p = first; p < last; ++p) patches[p] = reversed(patches[p]);
      }
      if (reversed_[e]) report_.patches->flipped.push_back(e);
    }
    forest_.reset();
    complex_.emplace(make_patch_complex(std::move(patches)).value());
    return true;
  }

  bool certify() override {
    phase("certifying");
    certificate::Subject subject;
    subject.sha256 = report_.sha256;
    subject.bytes = report_.patches->bytes;
    subject.format = spline_format_name(report_.patches->format);
    subject.tool = tool_name();
    bytes_ = certificate_of(subject);
    report_.certificate = CertificateReport{{}, to_hex(sha256(bytes_)), bytes_.size(), false};
    report_.seconds.certify = watch_.lap();
    forest_.reset();  // memory for the checker
    decision_.cover = {};
    has_collar_ = collar_.collar.has_value();
    collar_ = {};
    return true;
  }

  certificate::Bytes certificate_of(const certificate::Subject& subject) const {
    if (collar_.collar)
      return make_collar_certificate(*forest_, decision_.cover, decision_.walks, *collar_.collar,
                                     described_, subject);
    return make_patch_certificate(*complex_, forest_, decision_, described_, subject);
  }
  void list_entities() {
    described_.clear();
    for (std::size_t e = 0; e < entities_.size(); ++e)
      described_.push_back({is_surface_[e], reversed_[e],
                            static_cast<std::uint32_t>(entities_[e].first_patch),
                            entities_[e].breaks});
  }

  bool is_valid() const override { return decision_.is_valid; }
  std::string claim() const override {
    if (decision_.refutation) {
      const bool is_turned = std::holds_alternative<TurnedShell>(*decision_.refutation);
      return std::string(is_turned ? certificate::kTurnedShellClaim
                                   : certificate::kPatchInvalidClaim);
    }
    return std::string(has_collar_ ? certificate::kCollarClaim : certificate::kStarBoxClaim);
  }
  void forget() override {
    if (!report_.patches) return;
    PatchReport& r = *report_.patches;
    r.bodies = r.genus = r.boxes = 0;
    r.shell_facts.clear();
    r.defects.clear();
    r.volume.reset();
    r.collar.reset();
  }
  std::string own_options() const override {
    std::string options;
    if (settings_.orientation == PatchOrientation::kAuto) options += "--orient auto ";
    if (settings_.with_collar) options += "--collar ";
    if (settings_.tolerance)
      options += "--tolerance " + short_decimal(*settings_.tolerance, 17) + " ";
    if (settings_.reading.format)
      options += std::string("--format ") + model_format(*settings_.reading.format).name + " ";
    return options;
  }

  // Always false.
  bool undecided(const char* code, std::string message) {
    return give_up(kExitUndecided, {code, {}, std::move(message)});
  }

  std::vector<PatchEntity> entities_;
  std::vector<bool> is_surface_, reversed_;
  std::vector<StarBoxEntity> described_;  ///< what certificates say of entities_
  bool is_torn_ =
      false;  ///< a surface has an inner knot of too great a multiplicity: no refutation is certified
  std::optional<PatchComplex> complex_;
  std::optional<PieceForest> forest_;
  PatchDecision decision_;
  PatchCollarSearch collar_;
  bool has_collar_ = false;  ///< the certificate says so
};

}  // namespace

FileReport certify_patch_file(const std::string& path, const CertifySettings& settings,
                              const KeepCertificate& keep, Progress& progress) {
  return PatchCertification(path, settings, keep, progress).run();
}

}  // namespace veritope::cli
