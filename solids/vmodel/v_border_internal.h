// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/v_border_internal.h: the patches of a V-model's border, and where in the cells their sides are.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "solids/vmodel/v_border_defects.h"

namespace veritope::internal {

/// A part of a side, from one parameter to another, in the side's direction of travel or against it.
struct SidePart {
  PatchSide side;
  std::array<Rational, 2> at;
};

/// A side of a patch that lies in an edge of a cell.
struct CellSide {
  std::size_t cell = 0, face = 0, side = 0, axis = 0;
  std::array<Rational, 2> ends;  ///< parameters of the axis where the side begins and ends
};

class BorderPatches {
 public:
  /// All three are kept by reference.
  BorderPatches(const VModel& model, const VFaces& faces, const PatchComplex& complex);

  const VModel& model() const { return *model_; }
  const VFaces& faces() const { return *faces_; }
  const PatchComplex& complex() const { return *complex_; }
  /// The face of the model on which a patch lies.
  VFaceNumber face_of(std::uint32_t patch) const;
  /// Nothing for a side inside of its face.
  std::optional<CellSide> cell_side(PatchSide side) const;
  /// Whether a face that is not glued equals others.
  bool is_repeated(VFaceNumber face) const { return is_repeated_[face]; }
  /// Whether a cell that is collapsed in part is near.
  bool is_spoilt(const std::array<Rational, 3>& point) const;
  /// The vertex of a corner of a border face that is a corner of its cell; nothing for other corners of patches.
  std::optional<std::size_t> cell_corner(PatchCorner corner) const;

 private:
  const VModel* model_;
  const VFaces* faces_;
  const PatchComplex* complex_;
  std::vector<bool> is_repeated_;
};

/// The arcs of three parts that run along the same curve, cut to a piece on which all have dyadic ends.
std::optional<VCrowdedCurve> crowded_by(const BorderPatches& border,
                                        const std::array<SidePart, 3>& parts);

}  // namespace veritope::internal
