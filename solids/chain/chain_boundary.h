// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/chain_boundary.h: the boundary of a chain of simplices.  Theory: docs/THEORY.md, CHAIN-4.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "robust/integer.h"
#include "solids/chain/chain.h"

namespace veritope {

/// A facet with the order of its corners that makes its multiplicity positive: the normal of a triangle, the right of a
/// segment, are on the side on which f is less.
template <std::size_t Dim>
struct BoundaryFacet {
  FacetIn<Dim> corners;
  Integer multiplicity;  ///< by which f changes across it, where no other facet is; > 0
};

/// The sum of the boundaries of all simplices, times their coefficients, without the facets that cancel. Facets are the
/// same if their corners are. Nothing if a term is not a single simplex. In the plane and in space.
/// @cost near-linear in the terms
template <std::size_t Dim>
std::optional<std::vector<BoundaryFacet<Dim>>> boundary_of(const Chain<Dim>& chain);

}  // namespace veritope
