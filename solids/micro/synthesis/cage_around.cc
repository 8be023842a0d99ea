// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/synthesis/cage_around.h"

#include <utility>
#include <vector>

#include "solids/classify/patch_classifier.h"
#include "solids/vmodel/v_faces.h"

namespace veritope {
namespace {

// The border was proved to bound a solid; a point is inside iff it is off the border and its winding number is not 0.
bool is_inside(const PatchClassifier& border, const Vec3d& point) {
  const PointAnswer answer = border.classify(point);
  return !answer.is_decided || (!answer.is_on() && answer.winding != 0);
}

}  // namespace

Result<std::optional<CageEscape>> find_escape(const VModel& cage, const TriangleMesh& mesh) {
  const std::optional<CageGap> gap = find_gap(cage, content_of(mesh));
  if (!gap) return std::optional<CageEscape>();
  CageEscape out{static_cast<std::uint32_t>(gap->part), std::nullopt, gap->face};
  Result<std::vector<Patch>> patches = patches_of(border_of(cage));
  if (!patches) return patches.error();
  Result<PatchComplex> complex = make_patch_complex(std::move(*patches), PatchOrientation::kKeep);
  if (!complex) return complex.error();
  if (!complex->is_closed_oriented_surface()) return std::optional(out);
  const PatchClassifier border = PatchClassifier::of_valid_model(*complex);
  for (const std::uint32_t v : mesh.faces[out.triangle])
    if (!is_inside(border, mesh.positions[v])) {
      out.vertex = v;
      break;
    }
  return std::optional(out);
}

}  // namespace veritope
