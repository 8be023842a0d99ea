// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/vmodel/v_faces.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "robust/base/entity_error.h"
#include "solids/patches/patch_complex.h"
#include "solids/vmodel/v_face_internal.h"
#include "splines/bspline_domain.h"
#include "splines/knot_insertion.h"

namespace veritope {

VFaces border_of(const VModel& model) {
  VFaces out;
  for (VFaceNumber f = 0; f < model.num_faces(); ++f) {
    if (!model.face(f).is_border()) continue;
    const std::size_t cell = f / 6, axis = f % 6 / 2;
    std::array<std::size_t, 2> axes = v_face_axes(axis);
    BSplineSurface<Rational> surface = internal::surface_of(
        internal::FaceView(model.cell(cell), f % 6), model.cell(cell).is_rational());
    // The table of the page: across axis 1 the ascending order points inward at the end.
    const bool is_swapped = ((f % 2 == 0) != (axis == 1)) != model.is_reversed(cell);
    if (is_swapped) {
      surface = swapped(surface, 0, 1);
      std::swap(axes[0], axes[1]);
    }
    out.surfaces.push_back(std::move(surface));
    out.faces.push_back(f);
    out.axes.push_back(axes);
    out.breaks.push_back({model.breaks(cell, axes[0]), model.breaks(cell, axes[1])});
  }
  return out;
}

Result<std::vector<Patch>> patches_of(const VFaces& border) {
  std::vector<Patch> out;
  for (std::size_t n = 0; n < border.surfaces.size(); ++n) {
    BSplineSurface<Rational> surface = border.surfaces[n];
    for (std::size_t k = 0; k < 2; ++k) {
      const auto knots = internal::breaks_of(surface.axis(k));
      std::vector<Rational> added;
      std::set_difference(border.breaks[n][k].begin(), border.breaks[n][k].end(), knots.begin(),
                          knots.end(), std::back_inserter(added));
      surface = refine(surface, k, added);
    }
    auto cut = bezier_pieces(std::move(surface));
    if (cut.pieces.size() > kMaxPatches - out.size())
      return Error{
          Code::kOverLimit, {}, "the border has over " + std::to_string(kMaxPatches) + " patches"};
    const Grid<2> grid = cut.grid();
    for (std::size_t i = 0; i < cut.pieces.size(); ++i) {
      const auto span = grid.index_of(i);
      PatchOrigin origin{
          PatchOrigin::Kind::kSurface,
          n,
          {static_cast<std::uint32_t>(span[0]), static_cast<std::uint32_t>(span[1])}};
      Result<Patch> patch = make_patch(std::move(cut.pieces[i]), origin);
      if (!patch) return patch.error();
      out.push_back(std::move(patch).value());
    }
  }
  return out;
}

}  // namespace veritope
