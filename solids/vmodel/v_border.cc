// SPDX-License-Identifier: LGPL-3.0-or-later
// The patches of a V-model's border, and where in the cells they are.
#include <algorithm>
#include <utility>

#include "solids/vmodel/v_border_internal.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace internal {
namespace {

std::array<std::size_t, 2> spans_of(const Patch& patch) {
  return {patch.origin().span[0], patch.origin().span[1]};
}

}  // namespace

BorderPatches::BorderPatches(const VModel& model, const VFaces& faces, const PatchComplex& complex)
    : model_(&model), faces_(&faces), complex_(&complex), is_repeated_(model.num_faces()) {
  for (const auto& pair : model.copies())
    for (const VFaceNumber f : pair) is_repeated_[f] = true;
  for (const auto& crowd : model.crowds())
    for (const VFaceNumber f : crowd) is_repeated_[f] = true;
}

VFaceNumber BorderPatches::face_of(std::uint32_t patch) const {
  return faces_->faces[complex_->patch(patch).origin().number];
}

std::optional<CellSide> BorderPatches::cell_side(PatchSide side) const {
  const Patch& patch = complex_->patch(side.patch);
  const std::size_t n = patch.origin().number, k = side.side % 2;  // u along sides 0 and 2
  const auto span = spans_of(patch);
  const auto& breaks = faces_->breaks[n];
  // Side 0: v = 0; 1: u = 1; 2: v = 1, against u; 3: u = 0, against v.
  const std::size_t end = side.side == 1 || side.side == 2 ? 1 : 0;
  if (span[1 - k] != (end == 0 ? 0 : breaks[1 - k].size() - 2)) return std::nullopt;
  CellSide out;
  out.cell = faces_->faces[n] / 6;
  out.face = faces_->faces[n] % 6;
  out.axis = faces_->axes[n][k];
  out.side = 2 * (v_face_axes(out.face / 2)[0] == out.axis ? 0 : 1) + end;
  out.ends = {breaks[k][span[k]], breaks[k][span[k] + 1]};
  if (side.side >= 2) std::swap(out.ends[0], out.ends[1]);
  return out;
}

bool BorderPatches::is_spoilt(const std::array<Rational, 3>& point) const {
  const auto& forbidden = model_->forbidden();
  return std::any_of(forbidden.begin(), forbidden.end(), [&](const VForbiddenCollapse& c) {
    return is_near(model_->cell(c.cell), point);
  });
}

std::optional<std::size_t> BorderPatches::cell_corner(PatchCorner corner) const {
  const Patch& patch = complex_->patch(corner.patch);
  const std::size_t n = patch.origin().number;
  const auto span = spans_of(patch);
  static constexpr std::array<std::array<std::size_t, 2>, 4> kEnds = {
      {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  const std::size_t face = faces_->faces[n] % 6;
  std::size_t out = face % 2 << face / 2;
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t end = kEnds[corner.corner][k];
    if (span[k] != (end == 0 ? 0 : faces_->breaks[n][k].size() - 2)) return std::nullopt;
    out |= end << faces_->axes[n][k];
  }
  return out;
}

}  // namespace internal

std::optional<VBorder> make_border(const VModel& model) {
  VFaces faces = border_of(model);
  if (faces.faces.empty()) return std::nullopt;
  Result<std::vector<Patch>> patches = patches_of(faces);
  if (!patches) return std::nullopt;
  Result<PatchComplex> complex = make_patch_complex(std::move(patches).value());
  if (!complex) return std::nullopt;
  return VBorder{std::move(faces), std::move(complex).value()};
}

bool is_near(const VVolume& cell, const std::array<Rational, 3>& point) {
  for (std::size_t c = 0; c < 3; ++c) {
    bool is_below = false, is_above = false;
    for (std::size_t i = 0; i < cell.grid().count() && !(is_below && is_above); ++i) {
      const Rational& x = cell.component(static_cast<int>(c))[i];
      const Rational here = cell.is_rational() ? x / cell.component(3)[i] : x;
      is_below = is_below || here <= point[c];
      is_above = is_above || here >= point[c];
    }
    if (!is_below || !is_above) return false;
  }
  return true;
}

}  // namespace veritope
