// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/vmodel_refuter.h: what is proved wrong with a V-model: findings with their certificates.
// Theory: docs/THEORY.md, VMODEL-2. The page: docs/certificates/vmodel-invalid.md.
#pragma once
#include <optional>

#include "io/splines/read_splines.h"
#include "solids/base/finding.h"
#include "solids/vmodel/jacobian_sign.h"
#include "solids/vmodel/v_border_defects.h"
#include "solids/vmodel/v_overlap.h"
#include "verify/certify/vmodel_facts.h"
#include "verify/certify/volume_fold.h"
#include "verify/format/vmodel_invalid_certificate.h"

namespace veritope {

/// A finding and what its certificate holds. Codes: "flat", "left-handed", "singular", "overlap", "curve-nonmanifold",
/// "point-nonmanifold".
struct VRefutation {
  Finding finding;
  certificate::VModelInvalidFinding certified;
};

/// Places in knot spans, as certificates of folds name them.
FoldPlace fold_place_of(const VPlace& place);

/// Each function returns nothing where there is no proof, or where it needs longer numbers or more work than checkers
/// accept.
class VModelRefuter {
 public:
  /// Both are kept by reference. REQUIRES that the model is of the file's volumes.
  VModelRefuter(const VModel& model, const SplineFile& file) : model_(model), file_(file) {}

  /// The determinant vanishes on a piece.
  std::optional<VRefutation> flat(const JacobianFinding& piece) const;
  /// The determinant is negative in the middle of a knot span of the cell.
  std::optional<VRefutation> left_handed(std::uint32_t cell) const;
  /// The determinant vanishes at a point of the box.
  std::optional<VRefutation> singular(const VSingularity& where) const;
  std::optional<VRefutation> overlap(const VOverlap& overlap) const;
  std::optional<VRefutation> crowded(const VCrowdedCurve& curve) const;
  std::optional<VRefutation> pinched(const VPinchedPoint& point) const;

 private:
  std::optional<certificate::CellPoint> certified_point(const VPlace& place) const;

  const VModel& model_;
  const SplineFile& file_;
};

}  // namespace veritope
