// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_evaluator.h: exact values and derivatives of a simplex-spline solid at rational points, knots and knot
// planes included (docs/formats/dms-files.md, "The map").
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "predicates/entry_path.h"
#include "robust/base/box3d.h"
#include "solids/base/box_hierarchy.h"
#include "solids/dms/dms_model.h"
#include "splines/dms_spline.h"

namespace veritope {

/// What rule H says of a point: the tetrahedron that contains it, and the path into it.
struct DmsPlace {
  std::uint32_t tetrahedron = 0;
  EntryPath path;
};

struct DmsValue {
  std::vector<Rational> value;                    ///< x, y, z and the attributes
  std::vector<std::array<Rational, 3>> gradient;  ///< of each of them
};

namespace internal {
class DmsTable;
}

/// Keeps what does not depend on the point, for the tetrahedra that were needed last; so one thread at a time.
class DmsEvaluator {
 public:
  /// The model must outlive the evaluator. REQUIRES a model that validate() accepts.
  explicit DmsEvaluator(const DmsModel& model);
  ~DmsEvaluator();

  /// Nothing for a point outside of the closed domain. If tetrahedra overlap, the first one that is entered.
  std::optional<DmsPlace> locate(const DmsPoint& point) const;

  /// The value and the derivatives along the axes at the point of the place. REQUIRES d(W_γ) != 0 for the γ of the
  /// model's form whose N_γ do not vanish: a model without defects (solids/dms/dms_defects.h).
  /// @cost each simplex spline of the tetrahedra whose knots' box contains the point, once
  DmsValue evaluate(const DmsPlace& place);
  /// One component of the value, as evaluate() has it, without derivatives.
  Rational component(const DmsPlace& place, std::size_t number);

  /// The tetrahedra whose knots' boxes contain the point, ascending: all others have no term there.
  std::vector<std::uint32_t> near(const ExactPoint3& point) const;
  /// Those whose knots' boxes meet the box.
  std::vector<std::uint32_t> near(const Box3d& box) const;
  /// A box around a tetrahedron's corners, and one around all its knots. Bounds are at most the greatest double.
  const Box3d& corner_box(std::uint32_t tetrahedron) const { return corner_boxes_[tetrahedron]; }
  const Box3d& knot_box(std::uint32_t tetrahedron) const { return knot_boxes_[tetrahedron]; }
  /// The frames of a tetrahedron's knots, none of them computed yet; the evaluator must outlive it.
  internal::DmsTable make_table(std::uint32_t tetrahedron) const;

  /// visit(I, γ, N_γ) for the basis functions with |γ| = sum that are not off their support at the place.
  /// REQUIRES 0 <= sum <= model.degree.
  template <typename Visit>
  void for_each_basis(const DmsPlace& place, int sum, Visit visit);

  /// What is kept of a tetrahedron, for the units of this folder: valid until the next call of another function.
  internal::DmsTable& table(std::uint32_t tetrahedron);

 private:
  friend class DmsLineIntegrator;
  struct Basis {
    TetrahedralIndex gamma;
    Rational value;
  };
  std::vector<Basis> basis(std::uint32_t tetrahedron, const EntryPath& path, int sum);
  void drop_tables_if_many();
  void add_terms(const DmsPlace& place, std::size_t first_component, DmsSums<Rational>& sums);

  const DmsModel& model_;
  std::vector<ExactPoint3> knots_;       // of all clouds
  std::vector<std::size_t> first_knot_;  // of each vertex
  std::vector<Box3d> corner_boxes_, knot_boxes_;
  BoxHierarchy by_corners_, by_knots_;
  std::unordered_map<std::uint32_t, std::unique_ptr<internal::DmsTable>> tables_;
  std::size_t num_frames_ = 0;
};

template <typename Visit>
void DmsEvaluator::for_each_basis(const DmsPlace& place, int sum, Visit visit) {
  for (const std::uint32_t t : near(place.path.start()))
    for (const Basis& b : basis(t, place.path, sum)) visit(t, b.gamma, b.value);
}

}  // namespace veritope
