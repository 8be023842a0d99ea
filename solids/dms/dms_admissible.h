// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_admissible.h: tests of clouds that are sufficient for the conditions (a), (b) and (c) of
// docs/formats/dms-files.md, for those who choose knots: a cloud that passes is admissible, one that fails may be, too.
#pragma once
#include <cstdint>
#include <vector>

#include "predicates/exact_point.h"
#include "solids/base/box_hierarchy.h"
#include "solids/dms/dms_model.h"

namespace veritope {

/// Reads the model's later knots when it is asked; its tetrahedra and the knots t_0 are those of the construction.
class DmsAdmissibility {
 public:
  /// The model must outlive this object. REQUIRES tetrahedra that form a domain.
  explicit DmsAdmissibility(const DmsModel& model);

  const TetrahedralComplex& complex() const { return complex_; }
  /// Positive on the outer side of the plane of a face, as seen from its tetrahedron.
  Sign side_of_face(TetrahedronFace f, const ExactPoint3& p) const;
  /// Whether d(W_γ) > 0 and the barycentre is inside W_γ for all γ with |γ| < degree: this implies (a) and (b).
  bool has_core(std::uint32_t tetrahedron) const;
  /// Whether the hull of all knots of a boundary face's vertices is separated from each tetrahedron by the plane of the
  /// face, a plane of an axis, or the plane of a face of the tetrahedron: this implies (c).
  bool misses_inside(TetrahedronFace face) const;

 private:
  bool is_collapsed(std::uint32_t v) const { return model_.clouds[v].size() == 1; }
  bool is_as_before(const TetrahedronCorners& v, const TetrahedralIndex& gamma) const;
  bool contains(const TetrahedronCorners& v, const TetrahedralIndex& gamma,
                const ExactPoint3& core) const;
  bool is_separated(TetrahedronFace face, const std::vector<ExactPoint3>& knots,
                    std::uint32_t t) const;

  const DmsModel& model_;
  TetrahedralComplex complex_;
  std::vector<ExactPoint3> vertices_;
  BoxHierarchy boxes_;  // of the tetrahedra
};

}  // namespace veritope
