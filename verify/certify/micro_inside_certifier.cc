// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/micro_inside_certifier.h"

#include <string>
#include <utility>

#include "io/mesh/reading_rule.h"
#include "solids/micro/inside/micro_inside.h"
#include "topology/incidence.h"
#include "topology/surface.h"
#include "verify/certify/certificate_entities.h"
#include "verify/certify/mesh_certifier.h"
#include "verify/format/micro_inside_certificate.h"

namespace veritope {
namespace {

Certified undecided_inside(const Microstructure& micro, Finding finding) {
  Certified out;
  out.facts = micro_facts_of(micro);
  out.findings.push_back(std::move(finding));
  return out;
}

Finding model_finding(std::string code, std::string message) {
  Finding out;
  out.code = std::move(code);
  out.message = std::move(message);
  return out;
}

// Why the mesh cannot be the model of a certificate; nothing if it can.
std::optional<Finding> model_defect(const MeshFile& model, const ValidityReport& report) {
  if (model.copy)
    return model_finding("not-covered", std::string("the model is polygons of a file ") +
                                            model.report.container +
                                            ", which checkers do not read; convert it to .off");
  if (report.is_valid) return std::nullopt;
  const DefectList list = list_defects(model.mesh, report);
  Finding out;
  out.code = "model-invalid";
  out.message = "the model is INVALID";
  if (!list.defects.empty())
    out.message += ": " + list.defects.front().code + ": " + list.defects.front().message;
  return out;
}

InsideModel shells_of(const TriangleMesh& mesh, const ValidityReport& report, unsigned jobs) {
  const SurfaceTopology topology = analyse_surface(
      mesh.faces,
      Incidence::build(mesh.faces, static_cast<std::uint32_t>(mesh.positions.size()), jobs), 0,
      jobs);
  InsideModel out;
  out.mesh = &mesh;
  out.shells.shell_of_face.assign(topology.shell_of_face.data(),
                                  topology.shell_of_face.data() + mesh.faces.size());
  out.shells.depth = report.nesting.depth;
  return out;
}

// The finding with the cell's box, or the bridge's volume, in the parameters of the cage.
Finding finding_of_defect(const Microstructure& micro, const InsideDefect& defect) {
  Finding out;
  out.code = "not-inside";
  out.message = std::string(defect.condition) + ": " + defect.message;
  if (!defect.patch) return out;
  const MicroGrid& grid = micro.grids[defect.patch->grid];
  const auto at = grid.shape().index_of(defect.patch->cell);
  EntityPart part;
  part.entity = grid.volume;
  part.is_of_volume = true;
  for (std::size_t a = 0; a < 3; ++a)
    part.parameters.push_back(
        {round_down(grid.breaks[a][at[a]]), round_up(grid.breaks[a][at[a] + 1])});
  out.place.parts.push_back(std::move(part));
  return out;
}

certificate::InsideStatement statement_of(const MeshFile& model, const InsideProof& proof) {
  certificate::InsideStatement out;
  out.sha256 = model.sha256;
  out.bytes = model.report.bytes;
  out.format = mesh_format_name(model.report.format);
  out.reading_rule = kReadingRule;
  out.as_indexed = model.report.as_indexed;
  if (proof.skin)
    out.skin = proof.skin->numerator().to_string() + "/" + proof.skin->denominator().to_string();
  return out;
}

}  // namespace

Certified certify_inside(const Microstructure& micro, const certificate::Subject& subject,
                         const MeshFile& model, const CertifyOptions& options) {
  auto structure = prove_microstructure(micro, subject, options);
  if (auto* const undecided = std::get_if<Certified>(&structure)) return std::move(*undecided);
  auto& proof = std::get<MicroProof>(structure);
  ValidityOptions how;
  how.jobs = options.jobs;
  how.max_defects = 1;
  const ValidityReport report = decide_validity(model.mesh, how);
  if (auto defect = model_defect(model, report)) return undecided_inside(micro, *defect);
  const InsideModel solid = shells_of(model.mesh, report, options.jobs);
  auto inside = prove_inside(micro, proof.tiles, proof.first_patches, solid, options.jobs);
  if (const auto* const defect = std::get_if<InsideDefect>(&inside))
    return undecided_inside(micro, finding_of_defect(micro, *defect));
  const auto& found = std::get<InsideProof>(inside);
  certificate::MicroInsideBody body{
      std::move(proof.body), make_valid_body(model.mesh, report, options.jobs), {}};
  for (const VoidPoint& v : found.voids)
    body.voids.push_back(
        {v.volume, {to_fraction(v.x[0]), to_fraction(v.x[1]), to_fraction(v.x[2])}, v.corner});
  Certified out;
  MicroFacts facts = micro_facts_of(micro);
  facts.counts = proof.counts;
  facts.inside = InsideFacts{body.voids.size(), found.skin};
  out.facts = std::move(facts);
  out.certificate =
      certificate::encode(subject, quantities_of(proof.counts), statement_of(model, found), body);
  out.claim = certificate::kMicroInsideClaim;
  out.verdict = Verdict::kValid;
  return out;
}

}  // namespace veritope
