// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope certify of spline files: their surfaces and triangles as patches.
#include <algorithm>

#include "cli/certification.h"
#include "cli/decimal_text.h"
#include "cli/patch_report.h"
#include "io/patch_model.h"
#include "io/read_splines.h"
#include "verify/certify/patch_decision.h"
#include "verify/certify/star_box_certifier.h"
#include "verify/format/sha256.h"

namespace veritope::cli {
namespace {

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
    if (file->format != SplineFormat::kJson)
      return undecided(
          "not-covered",
          "certificates speak of .vjson files only: veritope convert writes this model as one");
    for (const LeftOut& l : file->left_out)
      if (l.is_geometry)
        return undecided("not-covered", "the file has shapes that are not read: " + l.what);
    return take_patches(file->model);
  }

  Result<SplineFile> read_splines() {
    SplineReadOptions options;
    options.format = settings_.spline_format;
    options.limits = settings_.reading.limits;
    if (!needs_copy()) return read_spline_file(report_.path, options);
    Result<ByteBuffer> bytes = read_once();
    if (!bytes) return bytes.error();
    spooled_ = std::move(*bytes);
    return read_spline_bytes({spooled_.data(), spooled_.size()}, report_.path, options);
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
    for (std::size_t e = 0; e < model.entities.size(); ++e)
      is_surface_.push_back(std::holds_alternative<ExactSurface>(model.entities[e].shape));
    PatchReport& r = *report_.patches;
    r.patches = complex_->patches().size();
    r.edges = complex_->num_edges();
    r.vertices = complex_->num_vertices();
    r.shells = complex_->shells().size();
    return list_flipped();
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

  bool decide() override {
    phase("deciding");
    decision_ = decide_patches(*complex_, decision_options(), &forest_);
    if (settings_.orientation == PatchOrientation::kAuto && turn_shells())
      decision_ = decide_patches(*complex_, decision_options(), &forest_);
    report_.seconds.decide = watch_.lap();
    PatchReport& r = *report_.patches;
    r.boxes_tried = decision_.boxes_tried;
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
    return true;
  }

  PatchDecisionOptions decision_options() const {
    PatchDecisionOptions options;
    if (settings_.tolerance) options.tolerance = *settings_.tolerance;
    return options;
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
    std::vector<StarBoxEntity> entities;
    for (std::size_t e = 0; e < entities_.size(); ++e)
      entities.push_back({is_surface_[e], reversed_[e],
                          static_cast<std::uint32_t>(entities_[e].first_patch),
                          entities_[e].breaks});
    certificate::Subject subject;
    subject.sha256 = report_.sha256;
    subject.bytes = report_.patches->bytes;
    subject.format = spline_format_name(report_.patches->format);
    subject.tool = tool_name();
    bytes_ =
        make_star_box_certificate(*forest_, decision_.cover, decision_.walks, entities, subject);
    report_.certificate = CertificateReport{{}, to_hex(sha256(bytes_)), bytes_.size(), false};
    report_.seconds.certify = watch_.lap();
    forest_.reset();  // memory for the checker
    decision_.cover = {};
    return true;
  }

  bool is_valid() const override { return decision_.is_valid; }
  std::string claim() const override { return std::string(certificate::kStarBoxClaim); }
  void forget() override {
    if (!report_.patches) return;
    PatchReport& r = *report_.patches;
    r.bodies = r.genus = r.boxes = 0;
    r.shell_facts.clear();
    r.volume.reset();
  }
  std::string own_options() const override {
    std::string options;
    if (settings_.orientation == PatchOrientation::kAuto) options += "--orient auto ";
    if (settings_.tolerance)
      options += "--tolerance " + short_decimal(*settings_.tolerance, 17) + " ";
    return options;
  }

  // Always false.
  bool undecided(const char* code, std::string message) {
    return give_up(kExitUndecided, {code, {}, std::move(message)});
  }

  std::vector<PatchEntity> entities_;
  std::vector<bool> is_surface_, reversed_;
  std::optional<PatchComplex> complex_;
  std::optional<PieceForest> forest_;
  PatchDecision decision_;
};

}  // namespace

FileReport certify_patch_file(const std::string& path, const CertifySettings& settings,
                              const KeepCertificate& keep, Progress& progress) {
  return PatchCertification(path, settings, keep, progress).run();
}

}  // namespace veritope::cli
