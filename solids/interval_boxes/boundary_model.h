// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/interval_boxes/boundary_model.h: the surface V of the paper's conditions, as a closed complex of patches with
// its trees of pieces; or a closed plane curve, as the wall over it. Source: [SSP01] 2. Design:
// docs/design/0019-paper-conditions.md.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "robust/base/box3d.h"
#include "robust/base/result.h"
#include "solids/patches/patch_complex.h"
#include "solids/pieces/piece_forest.h"

namespace veritope {

/// V, with its pieces. The callers' boxes are in the model's units; forest() has its own (times 2^scale).
///
/// A plane curve C is the wall C x [-2, 2] (times the size of C) with two cones that close it; a box of the plane is
/// its product with [-1, 1] (times 2^-20 of that size: few pieces are near it). What lies in such a box is (C in the
/// box) x [-1, 1]: an arc is a disk, two half-boxes are two balls, components and Euler characteristics are the same.
/// The cones never meet a box; they may cross each other or the wall's rim.
///
/// Nothing is said about whether V is embedded: the conditions are decided from the part of the abstract surface in a
/// box, and a box that two sheets enter is not a disk. Embeddedness as a whole is what certificates prove (THEORY 4).
class BoundaryModel {
 public:
  /// @error kBadArgument unless the complex is a closed oriented surface (the message names the first finding); as
  /// PieceForest::make
  /// @param budget  of the forest, as PieceForest::make
  static Result<BoundaryModel> make(PatchComplex complex, MemoryBudget* budget = nullptr);
  /// Closed loops of plane curves, each in the direction that has the inside on its left: curve i + 1 begins where
  /// curve i ends.
  /// @error kBadArgument unless the walls over them close up; kEmpty without a curve
  static Result<BoundaryModel> make_planar(
      const std::vector<std::vector<BezierCurve<Rational>>>& loops);

  int dimension() const { return dimension_; }
  bool is_planar() const { return dimension_ == 2; }
  const PatchComplex& complex() const { return *complex_; }
  PieceForest& forest() { return *forest_; }

  /// The signs of the three coordinates of all normals of a piece, 0 where they are not proved to be of one strict
  /// sign. At a pole the normal is divided by the distance to the pole. Signs are kept: what is proved of a piece holds
  /// for its parts, whose nets are used for the other coordinates only.
  std::array<int, 3> normal_signs(PieceForest::Id piece);
  /// The signs found so far, without a net: those of the smallest piece around this one that was examined.
  std::array<int, 3> known_normal_signs(PieceForest::Id piece) const;

  /// Converts a box to the forest's coordinates; in a planar model the box's third side is replaced. Returns nothing if
  /// a coordinate is not finite or would lose bits.
  std::optional<Box3d> to_forest(const Box3d& box) const;
  /// Converts a box back to the model's units, exactly.
  Box3d from_forest(const Box3d& box) const;

 private:
  BoundaryModel() = default;
  std::unique_ptr<PatchComplex> complex_;
  std::unique_ptr<PieceForest> forest_;
  int dimension_ = 3;
  double window_ = 0;  // half the height of a planar model's boxes
  struct NormalSigns {
    bool is_known = false;
    std::array<std::int8_t, 3> sign{};
  };
  std::vector<NormalSigns> normal_signs_;  // by piece
};

/// The winding number of V around a point off V, in the forest's coordinates; nothing if it is not decided within the
/// budget. THEORY 6: no direction is bad. @cost a walk along a ray
std::optional<int> winding_number(PieceForest& forest, const Point3d& at);

}  // namespace veritope
