// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/chain_boundary.h"

#include <map>
#include <utility>

#include "solids/chain/simplex_cell.h"

namespace veritope {
namespace {

// Sorts the corners; whether that is an odd permutation.
template <std::size_t Dim>
bool sort_corners(FacetIn<Dim>& facet) {
  bool is_odd = false;
  for (std::size_t i = 1; i < Dim; ++i)
    for (std::size_t k = i; k > 0 && facet[k] < facet[k - 1]; --k) {
      std::swap(facet[k], facet[k - 1]);
      is_odd = !is_odd;
    }
  return is_odd;
}

}  // namespace

template <std::size_t Dim>
std::optional<std::vector<BoundaryFacet<Dim>>> boundary_of(const Chain<Dim>& chain) {
  std::map<FacetIn<Dim>, Integer> sum;
  for (const ChainTerm<Dim>& t : chain.terms()) {
    const auto* const simplex = dynamic_cast<const SimplexCell<Dim>*>(t.cells.front().get());
    if (t.cells.size() != 1 || simplex == nullptr) return std::nullopt;
    for (std::size_t facet = 0; facet <= Dim; ++facet) {
      FacetIn<Dim> f;
      for (std::size_t i = 0, k = 0; i <= Dim; ++i)
        if (i != facet) f[k++] = simplex->corners()[i];
      const bool is_odd = sort_corners<Dim>(f) != (facet % 2 == 1);
      Integer& multiplicity = sum[std::move(f)];
      if (is_odd == (simplex->sign() > 0))
        multiplicity -= t.coefficient;
      else
        multiplicity += t.coefficient;
    }
  }
  std::vector<BoundaryFacet<Dim>> out;
  for (auto& [corners, multiplicity] : sum) {
    if (multiplicity.sign() == 0) continue;
    BoundaryFacet<Dim> facet{corners, std::move(multiplicity)};
    if (facet.multiplicity.sign() < 0) {
      facet.multiplicity = -facet.multiplicity;
      std::swap(facet.corners[0], facet.corners[1]);
    }
    out.push_back(std::move(facet));
  }
  return out;
}

template std::optional<std::vector<BoundaryFacet<2>>> boundary_of<2>(const Chain<2>&);
template std::optional<std::vector<BoundaryFacet<3>>> boundary_of<3>(const Chain<3>&);

}  // namespace veritope
