// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_knots.h: the knots of a model, numbered, and the sets V_γ of its tetrahedra ("The map" in
// docs/formats/dms-files.md), with boxes that find those near a place.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "robust/base/box3d.h"
#include "solids/base/box_hierarchy.h"
#include "solids/dms/dms_model.h"

namespace veritope {

/// A matrix, row by row.
using DmsMatrix = std::array<Rational, 9>;

/// V_γ of a tetrahedron.
struct DmsSupport {
  std::uint32_t tetrahedron = 0;
  TetrahedralIndex gamma{};
};

class DmsKnotTable {
 public:
  /// The model must outlive the table. REQUIRES a model that validate() accepts.
  explicit DmsKnotTable(const DmsModel& model);

  std::size_t size() const { return points_.size(); }
  /// Knots of one vertex that are one point have one number.
  std::uint32_t number(std::uint32_t vertex, int i) const {
    return numbers_[vertex * stride_ + static_cast<std::size_t>(i)];
  }
  const DmsPoint& point(std::uint32_t number) const { return *points_[number]; }
  /// Its bounded_doubles.
  const std::array<double, 3>& rounded(std::uint32_t number) const { return rounded_[number]; }
  /// One number for each V_γ, |γ| = n - 1.
  std::uint64_t key(const DmsSupport& support) const {
    return support.tetrahedron * std::uint64_t{gammas_.size()} + tetrahedral_index(support.gamma);
  }
  /// The numbers of the knots of V_γ, each once.
  std::vector<std::uint32_t> knots(const DmsSupport& support) const;
  /// The four corners t_0 of a tetrahedron.
  std::array<DmsPoint, 4> corners(std::uint32_t tetrahedron) const;
  /// All γ with |γ| = n - 1.
  std::span<const TetrahedralIndex> gammas() const { return gammas_; }

  /// The tetrahedra whose V_γ, |γ| = n - 1, have boxes that meet the box; those whose own boxes do. Ascending.
  std::vector<std::uint32_t> near(const Box3d& box) const { return find(by_knots_, box); }
  std::vector<std::uint32_t> tetrahedra_near(const Box3d& box) const {
    return find(by_corners_, box);
  }

  /// The derivative of the affine map that takes W_γ to the control points c(I, γ + e_m), times n.
  /// REQUIRES d(W_γ) != 0.
  DmsMatrix derivative(const DmsSupport& support) const;

 private:
  static std::vector<std::uint32_t> find(const BoxHierarchy& tree, const Box3d& box);

  const DmsModel& model_;
  std::size_t stride_;
  std::vector<std::uint32_t> numbers_;
  std::vector<const DmsPoint*> points_;
  std::vector<std::array<double, 3>> rounded_;
  std::vector<TetrahedralIndex> gammas_;
  BoxHierarchy by_knots_, by_corners_;
};

/// The nearest double; NaN for numbers above 2^100 in absolute value, for filters.
double bounded_double(const Rational& x);
std::array<double, 3> bounded_doubles(const DmsPoint& p);

/// The least box of doubles around points.
Box3d box_around(std::span<const DmsPoint> points);

/// The linear part, row by row, of the affine map that takes four points to four values.
/// REQUIRES points that are not in one plane.
DmsMatrix linear_part(const std::array<DmsPoint, 4>& points, const std::array<DmsPoint, 4>& values);

DmsPoint difference(const DmsPoint& a, const DmsPoint& b);
DmsPoint cross_product(const DmsPoint& a, const DmsPoint& b);
Rational dot_product(const DmsPoint& a, const DmsPoint& b);

}  // namespace veritope
