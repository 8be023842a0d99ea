// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fit/fit_rows.h: the linear equations of a fit: values at points of data as sums over control points,
// derivatives with respect to knots, and what the smoothness term measures.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "solids/base/box_hierarchy.h"
#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_program.h"
#include "solids/dms/fit/fit_points.h"
#include "solids/dms/fit/sparse_rows.h"

namespace veritope {

/// The control points of each tetrahedron: number[t * per_tetrahedron + tetrahedral_index(β)].
struct FitControl {
  std::size_t count = 0, per_tetrahedron = 0;
  std::vector<std::uint32_t> number;

  std::uint32_t of(std::uint32_t tetrahedron, const TetrahedralIndex& beta) const {
    return number[tetrahedron * per_tetrahedron + tetrahedral_index(beta)];
  }
};
/// REQUIRES shared control points.
FitControl fit_control(const DmsModel& model);

/// Derivatives along the axes of one value at one point with respect to knot `index` of a vertex.
struct KnotSlope {
  std::uint32_t vertex = 0;
  int index = 0;
  std::vector<std::array<double, 3>> along;  ///< for each attribute
};

/// Runs the programs of a model at points. The arguments must outlive this object.
class FitBasis {
 public:
  /// @param with_knots  whether slopes() will be asked for
  FitBasis(const DmsModel& model, const FitControl& control, const FitPoints& points,
           bool with_knots);

  /// Row i times the values of the control points is the value at point i.
  SparseRows rows();
  /// The derivatives at point i by eq. 11 of [HHQ04] as the format's page has it, for the knots 0 to n - 1 of the
  /// vertices of all tetrahedra that have a term there. Knots of one vertex that are equal have derivatives of their
  /// own. Points with nearly flat tetrahedra near them have no slopes.
  /// @param values  of the control points, num_attributes each
  std::vector<KnotSlope> slopes(std::size_t i, std::span<const double> values,
                                std::size_t num_attributes);

 private:
  std::array<double, 3> point_beside(std::size_t i) const;
  std::vector<std::uint32_t> near(std::size_t i) const;
  bool has_flat(std::span<const std::uint32_t> near) const;
  template <typename Visit>
  void visit_terms(std::size_t i, std::span<const std::uint32_t> near, Visit visit);
  void add_exact_row(std::size_t i, std::vector<std::pair<int, double>>& entries);

  const DmsModel& model_;
  const FitControl& control_;
  const FitPoints& points_;
  DmsPrograms<double> programs_;
  std::vector<std::pair<std::array<double, 3>, double>> centres_;  // if a tetrahedron is open
  std::vector<bool> is_flat_;
  std::optional<DmsEvaluator> exact_;  // if a tetrahedron is flat
  std::vector<bool> is_open_;          // whether a cloud of the tetrahedron is not collapsed
  BoxHierarchy open_;
  std::vector<std::uint32_t> open_numbers_;
  DmsRun<double> run_;
};

/// Differences of derivatives between neighbouring terms, in a tetrahedron and across faces. They are zero iff the map
/// from the Greville control points to the values is affine on each connected part of the domain.
SparseRows smoothness_rows(const DmsModel& model, const FitControl& control);

}  // namespace veritope
