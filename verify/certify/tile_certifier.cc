// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/tile_certifier.h"

#include <string>
#include <utility>
#include <vector>

#include "io/splines/spline_model.h"
#include "robust/base/check.h"
#include "verify/certify/file_patches.h"
#include "verify/certify/refutation_finding.h"
#include "verify/certify/star_box_certifier.h"

namespace veritope {
namespace {

ExactSurface surface_of_patch(const TilePatch& patch) {
  std::array<KnotAxis<Rational>, 2> axes;
  for (std::size_t a = 0; a < 2; ++a) {
    axes[a].degree = patch.degrees[a];
    axes[a].knots.assign(static_cast<std::size_t>(axes[a].degree) + 1, Rational(0));
    axes[a].knots.resize(2 * axes[a].knots.size(), Rational(1));
  }
  std::vector<Rational> all;
  for (std::size_t c = 0; c < 3; ++c)
    for (const TilePoint& p : patch.points.front()) all.push_back(p[c]);
  return {axes, 3, false, std::move(all)};
}

Finding tile_reason(const char* code, std::string message) {
  Finding out;
  out.code = code;
  out.message = std::move(message);
  return out;
}

// The message with patches in the place of entities, which they are in the model of the tile.
Finding about_patches(Finding finding) {
  for (const auto& [from, to] :
       {std::pair{"entities ", "patches "}, std::pair{"entity ", "patch "}}) {
    const std::string word = from;
    for (std::size_t at = finding.message.find(word); at != std::string::npos;
         at = finding.message.find(word, at))
      finding.message.replace(at, word.size(), to);
  }
  return finding;
}

// What is against a tile whose patches were decided; nothing if they bound one body with one shell.
std::optional<Finding> fault_of(const FilePatches& patches, const PatchDecision& decision) {
  if (decision.refutation.has_value()) {
    if (std::holds_alternative<ReversedShell>(*decision.refutation))
      return tile_reason("inside-out", "the normals of the patches do not point out of the tile");
    return about_patches(finding_of(*patches.complex, patches.entities, *decision.refutation));
  }
  if (!decision.is_valid) return about_patches(*decision.open);
  if (decision.shells.size() != 1)
    return tile_reason("several-shells", "the surface has " +
                                             std::to_string(decision.shells.size()) +
                                             " components; a tile has one");
  if (decision.bodies != 1) return tile_reason("several-bodies", "the tile is not one solid");
  return std::nullopt;
}

}  // namespace

std::variant<certificate::StarBoxBody, Finding> star_boxes_of(const MicroTile& tile,
                                                              const CertifyOptions& options) {
  VT_CHECK(!tile.range.has_value(), "star boxes speak of one surface, not of a family");
  SplineModel model;
  for (const TilePatch& patch : tile.patches)
    model.entities.push_back({surface_of_patch(patch), {}, std::nullopt, {}});
  Result<FilePatches> patches = file_patches(model, PatchOrientation::kKeep);
  if (!patches) return tile_reason("not-covered", patches.error().message);
  FileDecisionOptions how;
  if (options.max_cells) how.search.cover.max_boxes = *options.max_cells;
  const FileDecision decided = decide_file_patches(*patches, how);
  if (auto fault = fault_of(*patches, decided.decision)) return std::move(*fault);
  if (!fits_certificate(*decided.forest, decided.decision.cover))
    return tile_reason("not-covered", "the star boxes have coordinates too long for a certificate");
  return make_star_box_2_body(*decided.forest, decided.decision.cover, decided.decision.walks,
                              patches->entities);
}

}  // namespace veritope
