// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/simplex_cell.h: closed simplices as cells of chains.
#pragma once
#include "robust/base/result.h"
#include "robust/base/sign.h"
#include "solids/chain/cell.h"

namespace veritope {

/// A segment, a triangle, or a tetrahedron, with any rational corners.
template <std::size_t Dim>
class SimplexCell : public Cell<Dim> {
 public:
  using Corners = std::array<PointIn<Dim>, Dim + 1>;

  /// @error kBadArgument if the corners are in one hyperplane: such a set has no interior
  static Result<std::shared_ptr<const SimplexCell>> make(const Corners& corners);

  const Corners& corners() const { return corners_; }
  /// The sign of the signed length, area or volume: that of orientation_of(corners).
  Sign sign() const { return sign_; }

  CellKind kind() const override { return CellKind::kSimplex; }
  std::optional<int> value(const ChainPoint<Dim>& q) const override;
  std::optional<CellGerm<Dim>> germ(const ChainPoint<Dim>& q) const override;
  bool add_facets(std::vector<FacetIn<Dim>>& out) const override;

 private:
  SimplexCell(const Corners& corners, Sign sign);
  // On which side of the facet opposite to corner `facet` q lies: positive is inward.
  Sign side_of(const ChainPoint<Dim>& q, std::size_t facet) const;
  NormalIn<Dim> inward_normal(std::size_t facet) const;

  Corners corners_;
  Sign sign_;
  std::optional<std::array<std::array<double, Dim>, Dim + 1>> doubles_;
};

/// The sign of det(corners[i] - corners[0], i = 1, ..., Dim).
template <std::size_t Dim>
Sign orientation_of(const std::array<PointIn<Dim>, Dim + 1>& corners);
/// The determinant of Dim vectors.
template <std::size_t Dim>
Rational determinant_of(const std::array<NormalIn<Dim>, Dim>& rows);

extern template class SimplexCell<1>;
extern template class SimplexCell<2>;
extern template class SimplexCell<3>;

}  // namespace veritope
