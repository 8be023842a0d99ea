// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/chain.h"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <utility>

#include "robust/base/fp_guard.h"
#include "solids/chain/simplex_cell.h"

namespace veritope {

template <std::size_t Dim>
Chain<Dim>::Chain(Integer coefficient, CellPointer<Dim> cell) {
  if (coefficient.sign() == 0) return;
  const Box3d box = cell->box();
  terms_.push_back({std::move(coefficient), {std::move(cell)}, box});
}

template <std::size_t Dim>
Box3d Chain<Dim>::box() const {
  Box3d out = empty_box();
  for (const ChainTerm<Dim>& t : terms_) out = hull(out, t.box);
  return out;
}

template <std::size_t Dim>
Chain<Dim> Chain<Dim>::scaled(const Integer& factor) const {
  Chain out;
  if (factor.sign() == 0) return out;
  out = *this;
  for (ChainTerm<Dim>& t : out.terms_) t.coefficient *= factor;
  return out;
}

template <std::size_t Dim>
Chain<Dim> Chain<Dim>::sum_of(const std::array<std::span<const ChainTerm<Dim>>, 2>& parts,
                              bool negates) {
  Terms terms(parts[0].begin(), parts[0].end());
  for (const ChainTerm<Dim>& t : parts[1]) {
    terms.push_back(t);
    if (negates) terms.back().coefficient = -terms.back().coefficient;
  }
  return from_terms(std::move(terms));
}

template <std::size_t Dim>
Chain<Dim> Chain<Dim>::from_terms(Terms terms) {
  // The order of addresses tells equal sets of cells, and nothing else depends on it.
  std::map<std::vector<const Cell<Dim>*>, std::size_t> place;
  Chain out;
  for (ChainTerm<Dim>& t : terms) {
    std::vector<const Cell<Dim>*> key;
    for (const CellPointer<Dim>& c : t.cells) key.push_back(c.get());
    std::sort(key.begin(), key.end(), std::less<>());
    const auto [at, is_new] = place.try_emplace(std::move(key), out.terms_.size());
    if (is_new)
      out.terms_.push_back(std::move(t));
    else
      out.terms_[at->second].coefficient += t.coefficient;
  }
  std::erase_if(out.terms_, [](const ChainTerm<Dim>& t) { return t.coefficient.sign() == 0; });
  return out;
}

template <std::size_t Dim>
Chain<Dim> original_simplices(std::span<const FacetIn<Dim>> facets, const PointIn<Dim>& origin) {
  const ScopedDefaultFp nearest;
  std::vector<ChainTerm<Dim>> terms;
  for (const FacetIn<Dim>& facet : facets) {
    typename SimplexCell<Dim>::Corners corners;
    corners[0] = origin;
    for (std::size_t i = 0; i < Dim; ++i) corners[i + 1] = facet[i];
    auto simplex = SimplexCell<Dim>::make(corners);
    if (!simplex) continue;  // no interior
    const Box3d box = (*simplex)->box();
    terms.push_back({Integer(to_int((*simplex)->sign())), {*std::move(simplex)}, box});
  }
  return Chain<Dim>::from_terms(std::move(terms));
}

// Kuhn's simplices: from lo to hi along the axes in every order.
template <std::size_t Dim>
Result<Chain<Dim>> box_chain(const PointIn<Dim>& lo, const PointIn<Dim>& hi) {
  const ScopedDefaultFp nearest;
  for (std::size_t k = 0; k < Dim; ++k)
    if (!(lo[k] < hi[k]))
      return bad_argument("the box has no interior: it extends from " + lo[k].to_string() + " to " +
                          hi[k].to_string() + " along axis " + std::to_string(k));
  std::array<std::size_t, Dim> order;
  std::iota(order.begin(), order.end(), std::size_t{0});
  Chain<Dim> out;
  do {
    typename SimplexCell<Dim>::Corners corners;
    corners.fill(lo);
    for (std::size_t i = 0; i < Dim; ++i)
      for (std::size_t j = i + 1; j <= Dim; ++j) corners[j][order[i]] = hi[order[i]];
    out = out + Chain<Dim>(Integer(1), SimplexCell<Dim>::make(corners).value());
  } while (std::next_permutation(order.begin(), order.end()));
  return out;
}

template class Chain<1>;
template class Chain<2>;
template class Chain<3>;
template Chain<1> original_simplices<1>(std::span<const FacetIn<1>>, const PointIn<1>&);
template Chain<2> original_simplices<2>(std::span<const FacetIn<2>>, const PointIn<2>&);
template Chain<3> original_simplices<3>(std::span<const FacetIn<3>>, const PointIn<3>&);
template Result<Chain<1>> box_chain<1>(const PointIn<1>&, const PointIn<1>&);
template Result<Chain<2>> box_chain<2>(const PointIn<2>&, const PointIn<2>&);
template Result<Chain<3>> box_chain<3>(const PointIn<3>&, const PointIn<3>&);

}  // namespace veritope
