// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/v_border_defects.h: where the border of a V-model is no surface: curves that more than two sides of
// border faces pass, points at which border faces form more than one fan.
// The theorem: docs/THEORY.md, VMODEL-2. The conditions: docs/certificates/vmodel-invalid.md, section 4.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "solids/patches/patch_complex.h"
#include "solids/vmodel/v_faces.h"
#include "solids/vmodel/v_model.h"

namespace veritope {

/// A part of a side of a face of a cell, in a knot span of the axis along which the side runs. Side 2 s + e runs along
/// the first (s = 0) or second parameter of the face, at the begin (e = 0) or end of the other.
struct VArc {
  std::uint32_t cell = 0;
  std::size_t face = 0, side = 0, span = 0;
  std::array<Rational, 2> at;  ///< from 0 to 1 along the span, dyadic, low < high
};
/// Three sides of border faces that pass one arc, which at most two sides of a surface do.
struct VCrowdedCurve {
  std::array<VArc, 3> arcs;
  std::array<Rational, 3> middle;  ///< the point in the middle of the first arc
};
/// A point at which the border has two or more vertices.
struct VPinchedPoint {
  struct Corner {
    std::uint32_t cell = 0;
    std::size_t corner = 0;
  };
  std::array<Corner, 2> corners;  ///< at two of the vertices
  std::array<Rational, 3> at;
};

/// The faces that are neither glued nor collapsed, as patches glued along their sides.
struct VBorder {
  VFaces faces;
  PatchComplex complex;
};
/// Nothing for a model without border faces, or with more patches than a complex may have.
std::optional<VBorder> make_border(const VModel& model);

/// Equal sides are found in any degree; partly equal ones where a vertex lies on a side at a simple parameter. Nothing
/// where a face equals others that are not glued to it, or where a cell is collapsed in part near the place.
/// REQUIRES the border of the model, and the complex of its patches. @cost near-linear in the sides
std::optional<VCrowdedCurve> find_crowded_curve(const VModel& model, const VFaces& border,
                                                const PatchComplex& complex);
/// Nothing unless all sides fit. As above.
std::optional<VPinchedPoint> find_pinched_point(const VModel& model, const VFaces& border,
                                                const PatchComplex& complex);

/// Whether the point lies in the closed box around the control points of the cell.
bool is_near(const VVolume& cell, const std::array<Rational, 3>& point);

}  // namespace veritope
