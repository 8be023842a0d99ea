// SPDX-License-Identifier: LGPL-3.0-or-later
// certify for meshes: every mesh is decided and has a certificate.
#include <algorithm>
#include <utility>

#include "io/mesh/reading_rule.h"
#include "verify/certify/certify_kinds_internal.h"
#include "verify/certify/mesh_certifier.h"

namespace veritope {
namespace {

certificate::Subject subject_of(const MeshFile& file, const CertifyOptions& options) {
  certificate::Subject out;
  out.sha256 = file.copy ? file.copy->sha256 : file.sha256;
  out.bytes = file.copy ? file.copy->bytes.size() : file.report.bytes;
  out.format = mesh_format_name(file.report.format);
  out.as_indexed = file.report.as_indexed;
  out.reading_rule = kReadingRule;
  out.tool = options.tool;
  return out;
}

// The defects with the polygons that their faces were cut from; none if `most` is 0, for then one was listed for the
// certificate.
std::vector<Finding> listed(std::vector<Finding> defects, const MeshFile& file, std::size_t most) {
  if (most == 0) return {};
  if (file.polygon_of_face.empty()) return defects;
  for (Finding& d : defects)
    for (const std::uint32_t f : d.place.faces) d.place.polygons.push_back(file.polygon_of_face[f]);
  return defects;
}

std::optional<CertifiedCopy> copy_of(const MeshFile& file) {
  if (!file.copy) return std::nullopt;
  return CertifiedCopy{file.copy->bytes, file.copy->sha256, file.copy->what, false,
                       mesh_format_name(file.report.format)};
}

ValidityReport without_evidence(ValidityReport report) {
  report.evidence = {};
  report.stars = {};
  report.meetings = {};
  return report;
}

Certified certified_reversed(const MeshFile& file, ValidityReport decision,
                             const CertifyOptions& options) {
  ReversedSolid solid = reverse_to_solid(file.mesh, std::move(decision), options.jobs);
  internal::enter(Phase::kCertifying, options);
  Certified out;
  out.verdict = Verdict::kValid;
  out.claim = certificate::kReversedClaim;
  out.copy = copy_of(file);
  out.certificate =
      make_mesh_certificate(solid, subject_of(file, options), options.jobs, options.work);
  out.facts =
      MeshFacts{without_evidence(std::move(solid.report)), std::nullopt, std::move(solid.reversal)};
  return out;
}

}  // namespace

Result<Certified> internal::certify_kind(const MeshFile& file, const CertifyOptions& options) {
  if (file.mesh.faces.empty()) return Error{Code::kEmpty, {}, "there is no face in this mesh"};
  enter(Phase::kDeciding, options);
  ValidityOptions how;
  how.jobs = options.jobs;
  how.work = options.work;
  how.keep_meetings = true;
  how.max_defects =
      std::max<std::size_t>(options.max_findings, 1);  // the certificate needs one of each rule
  ValidityReport decision = decide_validity(file.mesh, how);
  if (options.orientation == PatchOrientation::kAuto && is_valid_once_reversed(decision))
    return certified_reversed(file, std::move(decision), options);
  DefectList list = list_defects(file.mesh, decision, options.jobs);
  enter(Phase::kCertifying, options);
  Certified out;
  out.certificate = make_mesh_certificate(file.mesh, decision, list.defects,
                                          subject_of(file, options), options.jobs, options.work);
  out.verdict = decision.is_valid ? Verdict::kValid : Verdict::kInvalid;
  out.claim = decision.is_valid ? certificate::kValidClaim : certificate::kInvalidClaim;
  out.copy = copy_of(file);
  out.findings = listed(std::move(list.defects), file, options.max_findings);
  out.facts =
      MeshFacts{without_evidence(std::move(decision)), std::move(list.open_edges), std::nullopt};
  return out;
}

}  // namespace veritope
