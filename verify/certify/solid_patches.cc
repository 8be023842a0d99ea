// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/solid_patches.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "verify/certify/refutation_finding.h"
#include "verify/certify/stand_in.h"
#include "verify/certify/star_box_certifier.h"

namespace veritope {
namespace {

Finding solid_finding(const char* code, std::string message) {
  Finding out;
  out.code = code;
  out.message = std::move(message);
  return out;
}
Finding uncovered_solid(const std::string& why) {
  return solid_finding("not-covered", "the model: " + why);
}

// What is against a file whose patches checkers cannot find in its own bytes.
std::optional<Finding> copy_finding(const std::optional<StandIn>& stand_in) {
  if (!stand_in || !stand_in->is_copy()) return std::nullopt;
  return uncovered_solid(
      stand_in->is_of_volumes
          ? "checkers do not find the boundary faces of its volumes in its own bytes; veritope "
            "convert --faces writes them as a .vjson model"
          : "checkers do not read the splines of its format; veritope convert writes a .vjson "
            "model");
}

std::optional<Finding> patches_finding(const FilePatches& patches) {
  if (patches.not_covered) return uncovered_solid(patches.not_covered->message);
  const auto at =
      std::find_if_not(patches.entities.begin(), patches.entities.end(), breaks_fit_certificate);
  if (at == patches.entities.end()) return std::nullopt;
  return uncovered_solid("entity " + std::to_string(at - patches.entities.begin()) +
                         " has longer knots than certificates may be about");
}

// Nothing if the patches are proved to bound a solid.
std::optional<Finding> decision_finding(const FilePatches& patches, const FileDecision& decided) {
  const PatchDecision& d = decided.decision;
  if (d.refutation) {
    const Finding why = finding_of(*patches.complex, patches.entities, *d.refutation);
    return solid_finding("model-invalid", "the model is INVALID: " + why.code + ": " + why.message);
  }
  if (!d.is_valid)
    return solid_finding("model-invalid",
                         "the model is UNDECIDED: " + d.open->code + ": " + d.open->message);
  if (!fits_certificate(*decided.forest, d.cover))
    return uncovered_solid("its star boxes have coordinates too long for a certificate");
  return std::nullopt;
}

}  // namespace

std::variant<SolidPatches, Finding> solid_patches_of(const SplineFile& file,
                                                     const CertifyOptions& options) {
  if (auto why = uncovered_shapes(file)) return uncovered_solid(*why);
  if (file.beyond_default_limits)
    return uncovered_solid("it has longer numbers than certificates may be about");
  const Result<std::optional<StandIn>> stand_in = stand_in_of(file);
  if (!stand_in) return uncovered_solid(stand_in.error().message);
  if (auto copied = copy_finding(*stand_in)) return std::move(*copied);
  Result<FilePatches> patches = patches_of(file, *stand_in);
  if (!patches) return uncovered_solid(patches.error().message);
  if (auto uncovered = patches_finding(*patches)) return std::move(*uncovered);
  MemoryBudget budget(memory_allowed(options.max_memory));
  FileDecisionOptions how;
  how.search.budget = &budget;
  how.search.with_contacts_on_borders = false;
  if (options.max_cells) how.search.cover.max_boxes = *options.max_cells;
  const FileDecision decided = decide_file_patches(*patches, how);
  if (auto why = decision_finding(*patches, decided)) return std::move(*why);
  certificate::StarBoxBody body = make_star_box_2_body(*decided.forest, decided.decision.cover,
                                                       decided.decision.walks, patches->entities);
  const bool is_by_faces = stand_in->has_value() && (*stand_in)->is_by_own_faces();
  std::string format = subject_of(file, options.tool, is_by_faces).format;
  return SolidPatches{std::move(*patches), std::move(body), std::move(format)};
}

}  // namespace veritope
