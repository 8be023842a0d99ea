// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/chain.h: extended simplicial chains: definitions 2 and 5 of seed 001 [GRF03], for the line, the plane
// and space from one template. Their function f is in solids/chain/associated_function.h.
// Theory: docs/THEORY.md, CHAIN-2.  Design: docs/design/0058-chains-as-types.md.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "robust/base/result.h"
#include "robust/integer.h"
#include "solids/chain/cell.h"

namespace veritope {

/// An extended cell with its coefficient. Several cells stand for their intersection, ExCell of section 5 there: its
/// value is the product of theirs.
template <std::size_t Dim>
struct ChainTerm {
  Integer coefficient;
  std::vector<CellPointer<Dim>> cells;  ///< at least one; the same cell may occur more than once
  Box3d box;                            ///< contains the intersection
};

/// A formal sum of cells with integer coefficients. Terms with the same cells are one term; those with the coefficient
/// 0 are left out. Cells are the same if they are one object: two simplices with equal corners are two cells.
template <std::size_t Dim>
class Chain {
 public:
  /// The zero of the sum.
  Chain() = default;
  /// coefficient * cell.
  Chain(Integer coefficient, CellPointer<Dim> cell);

  const std::vector<ChainTerm<Dim>>& terms() const { return terms_; }
  bool is_zero() const { return terms_.empty(); }
  /// Contains all cells; empty for the zero.
  Box3d box() const;

  /// Definition 5: coefficients of the same cell are added.
  friend Chain operator+(const Chain& a, const Chain& b) {
    return sum_of({{a.terms_, b.terms_}}, false);
  }
  friend Chain operator-(const Chain& a, const Chain& b) {
    return sum_of({{a.terms_, b.terms_}}, true);
  }
  /// Definition 5: every coefficient is multiplied.
  friend Chain operator*(const Integer& factor, const Chain& a) { return a.scaled(factor); }

  /// Sums of many terms, at the cost of their number.
  static Chain from_terms(std::vector<ChainTerm<Dim>> terms);

 private:
  using Terms = std::vector<ChainTerm<Dim>>;
  static Chain sum_of(const std::array<std::span<const ChainTerm<Dim>>, 2>& parts, bool negates);
  Chain scaled(const Integer& factor) const;

  Terms terms_;
};

/// Original simplices: those that facets form with an origin, with the signs of their volumes as coefficients.
/// Definition 2; of a closed oriented surface, or of a closed polygon, the chain's f is its winding number off all
/// walls. Simplices without an interior have the coefficient 0 and are left out.
template <std::size_t Dim>
Chain<Dim> original_simplices(std::span<const FacetIn<Dim>> facets, const PointIn<Dim>& origin);

/// delta_R: the chain of a closed box, whose f is 1 inside of it. It has Dim! simplices.
/// @error kBadArgument unless lo < hi in every coordinate
template <std::size_t Dim>
Result<Chain<Dim>> box_chain(const PointIn<Dim>& lo, const PointIn<Dim>& hi);

extern template class Chain<1>;
extern template class Chain<2>;
extern template class Chain<3>;

}  // namespace veritope
