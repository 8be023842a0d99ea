// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/micro_inside_certifier.h"

#include <string>
#include <utility>
#include <variant>

#include "io/mesh/reading_rule.h"
#include "solids/micro/inside/micro_inside.h"
#include "topology/incidence.h"
#include "topology/surface.h"
#include "verify/certify/certificate_entities.h"
#include "verify/certify/mesh_certifier.h"
#include "verify/certify/solid_patches.h"
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

// Which model the statement names.
certificate::InsideStatement statement_about(const ModelFile& model) {
  certificate::InsideStatement out;
  out.sha256 = sha256_of(model);
  out.bytes = num_bytes(model);
  out.reading_rule = kReadingRule;
  return out;
}
certificate::InsideStatement statement_of(const ModelFile& file, const MeshFile& mesh) {
  certificate::InsideStatement out = statement_about(file);
  out.format = mesh_format_name(mesh.report.format);
  out.as_indexed = mesh.report.as_indexed;
  return out;
}

// A proof with what the certificate says of the model.
struct InsideCase {
  certificate::InsideStatement model;
  std::variant<certificate::ValidBody, certificate::StarBoxBody> solid;
  InsideProof proof;
};
using InsideAnswer = std::variant<InsideCase, Finding>;

InsideAnswer answer_for(const Microstructure& micro, const MicroProof& proof, const MeshFile& mesh,
                        const ModelFile& file, const CertifyOptions& options) {
  ValidityOptions how;
  how.jobs = options.jobs;
  how.max_defects = 1;
  const ValidityReport report = decide_validity(mesh.mesh, how);
  if (auto defect = model_defect(mesh, report)) return std::move(*defect);
  const InsideModel solid = shells_of(mesh.mesh, report, options.jobs);
  auto inside = prove_inside(micro, proof.tiles, proof.first_patches, solid, options.jobs);
  if (const auto* const defect = std::get_if<InsideDefect>(&inside))
    return finding_of_defect(micro, *defect);
  return InsideCase{statement_of(file, mesh), make_valid_body(mesh.mesh, report, options.jobs),
                    std::get<InsideProof>(std::move(inside))};
}
InsideAnswer answer_for(const Microstructure& micro, const MicroProof& proof,
                        const SplineFile& splines, const ModelFile& file,
                        const CertifyOptions& options) {
  auto solid = solid_patches_of(splines, options);
  if (auto* const finding = std::get_if<Finding>(&solid)) return std::move(*finding);
  auto& patches = std::get<SolidPatches>(solid);
  auto inside =
      prove_inside(micro, proof.tiles, proof.first_patches, *patches.patches.complex, options.jobs);
  if (const auto* const defect = std::get_if<InsideDefect>(&inside))
    return finding_of_defect(micro, *defect);
  certificate::InsideStatement statement = statement_about(file);
  statement.format = patches.format;
  return InsideCase{std::move(statement), std::move(patches.body),
                    std::get<InsideProof>(std::move(inside))};
}
template <typename File>
InsideAnswer answer_for(const Microstructure&, const MicroProof&, const File&, const ModelFile&,
                        const CertifyOptions&) {
  return model_finding("not-covered", File::kTitle + std::string(" is no solid for --model"));
}

}  // namespace

Certified certify_inside(const Microstructure& micro, const certificate::Subject& subject,
                         const ModelFile& model, const CertifyOptions& options) {
  auto structure = prove_microstructure(micro, subject, options);
  if (auto* const undecided = std::get_if<Certified>(&structure)) return std::move(*undecided);
  auto& proof = std::get<MicroProof>(structure);
  InsideAnswer answer = std::visit(
      [&](const auto& file) { return answer_for(micro, proof, file, model, options); }, model);
  if (auto* const finding = std::get_if<Finding>(&answer))
    return undecided_inside(micro, std::move(*finding));
  auto& found = std::get<InsideCase>(answer);
  certificate::MicroInsideBody body{std::move(proof.body), std::move(found.solid), {}};
  for (const VoidPoint& v : found.proof.voids)
    body.voids.push_back(
        {v.volume, {to_fraction(v.x[0]), to_fraction(v.x[1]), to_fraction(v.x[2])}, v.corner});
  if (const auto& skin = found.proof.skin)
    found.model.skin = skin->numerator().to_string() + "/" + skin->denominator().to_string();
  Certified out;
  MicroFacts facts = micro_facts_of(micro);
  facts.counts = proof.counts;
  facts.inside = InsideFacts{body.voids.size(), found.proof.skin};
  out.facts = std::move(facts);
  out.certificate = certificate::encode(subject, quantities_of(proof.counts), found.model, body);
  out.claim = certificate::kMicroInsideClaim;
  out.verdict = Verdict::kValid;
  return out;
}

}  // namespace veritope
