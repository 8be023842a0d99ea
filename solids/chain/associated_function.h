// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/associated_function.h: f, f* and the solid of a chain: definitions 3, 4 and 6 of seed 001 [GRF03].
// Theory: docs/THEORY.md, CHAIN-2.
#pragma once
#include <cstddef>
#include <optional>

#include "robust/integer.h"
#include "solids/chain/chain.h"
#include "solids/base/box_hierarchy.h"

namespace veritope {
namespace internal {
template <std::size_t Dim>
class GermSum;
}

/// The functions of one chain. Immutable: threads may share it.
template <std::size_t Dim>
class AssociatedFunction {
 public:
  /// @cost near-linear in the terms
  explicit AssociatedFunction(Chain<Dim> chain);

  const Chain<Dim>& chain() const { return chain_; }

  /// f, definition 3: the sum of the coefficients of the closed cells that hold the point, each times the cell's value.
  /// Nothing if the point is on a curved wall of a cell that matters, or if that is open.
  std::optional<Integer> value(const PointIn<Dim>& q) const;
  /// The solid, definition 4: f != 0.
  std::optional<bool> holds(const PointIn<Dim>& q) const;
  /// f*, definition 6: 0 unless every neighbourhood of the point has points of the interior of the solid; else the
  /// greatest value of f in a small neighbourhood, or the least if the greatest is not positive. Nothing at a curved
  /// wall, where walls meet that bound no half-spaces (Cell::germ), or on more than kMostWalls hyperplanes.
  std::optional<Integer> regular_value(const PointIn<Dim>& q) const;
  static constexpr std::size_t kMostWalls = 64;
  /// f off all walls beside the point, in one direction, the same for all cells. For the normal chain of a surface it
  /// is the winding number, too, where only flat walls are (NormalChain::value). Nothing where regular_value() has no
  /// value, but any number of hyperplanes is allowed.
  std::optional<Integer> value_beside(const PointIn<Dim>& q) const;
  /// Whether the point is on no wall of any cell that is there; then f is constant near it, and f* is f. Nothing if
  /// that is open.
  std::optional<bool> is_off_walls(const PointIn<Dim>& q) const;

 private:
  template <typename Visit>
  void visit_terms(const ChainPoint<Dim>& q, Visit visit) const;
  // The cells near q, with their coefficients; false if one of them is not known there.
  bool add_germs(const ChainPoint<Dim>& q, internal::GermSum<Dim>& sum) const;

  Chain<Dim> chain_;
  BoxHierarchy boxes_;
};

extern template class AssociatedFunction<1>;
extern template class AssociatedFunction<2>;
extern template class AssociatedFunction<3>;

}  // namespace veritope
