// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_covering.h: whether the image of a small tetrahedron surely contains a point: the condition W13 of
// docs/certificates/dms-invalid.md. Theory: docs/THEORY.md, DMS-2.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_knots.h"
#include "solids/dms/dms_piece.h"
#include "solids/dms/dms_region.h"

namespace veritope {

/// One thread at a time.
class DmsCovering {
 public:
  /// All references must outlive this. REQUIRES a model without defects (solids/dms/dms_defects.h).
  DmsCovering(const DmsModel& model, const DmsKnotTable& knots, const DmsEvaluator& evaluator)
      : degree_(model.degree), knots_(knots), pieces_(model, evaluator) {}

  /// Whether the four corners, in a tetrahedron of the domain, make one that no triangle of knots cuts, and on each of
  /// its faces a plane parts x from the coefficients of the map, outward. Then the map takes a point inside to x.
  /// REQUIRES corners that are positively oriented.
  bool covers(std::uint32_t tetrahedron, const std::array<DmsPoint, 4>& corners, const DmsPoint& x);

 private:
  bool is_cut(std::uint32_t tetrahedron, const std::array<DmsPoint, 4>& corners) const;

  int degree_;
  const DmsKnotTable& knots_;
  DmsPieces pieces_;
};

/// Six times the volume of a tetrahedron, with its sign.
Rational six_volumes(const std::array<DmsPoint, 4>& corners);
/// Whether the closed tetrahedron contains the point. REQUIRES corners that are positively oriented.
bool contains(const std::array<DmsPoint, 4>& corners, const DmsPoint& p);

}  // namespace veritope
