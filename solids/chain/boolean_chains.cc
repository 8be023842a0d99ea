// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/boolean_chains.h"

#include <string>
#include <utility>
#include <vector>

#include "solids/base/box_hierarchy.h"

namespace veritope {
namespace {

template <std::size_t Dim>
ChainTerm<Dim> intersection_of_terms(const ChainTerm<Dim>& a, const ChainTerm<Dim>& b) {
  ChainTerm<Dim> out{a.coefficient * b.coefficient, a.cells, common(a.box, b.box)};
  out.cells.insert(out.cells.end(), b.cells.begin(), b.cells.end());
  return out;
}

}  // namespace

template <std::size_t Dim>
Result<Chain<Dim>> product(const Chain<Dim>& a, const Chain<Dim>& b, std::uint64_t max_cells) {
  std::vector<Box3d> boxes;
  for (const ChainTerm<Dim>& t : b.terms()) boxes.push_back(t.box);
  const BoxHierarchy tree(boxes);
  std::vector<ChainTerm<Dim>> terms;
  bool is_over = false;
  for (const ChainTerm<Dim>& t : a.terms())
    tree.visit([&](const Box3d& box) { return !is_over && meets(box, t.box); },
               [&](std::uint32_t j) {
                 is_over = terms.size() >= max_cells;
                 if (!is_over) terms.push_back(intersection_of_terms(t, b.terms()[j]));
               });
  if (is_over)
    return Error{Code::kOverLimit,
                 {},
                 "more than " + std::to_string(max_cells) +
                     " pairs of cells have overlapping boxes: " + std::to_string(a.terms().size()) +
                     " cells against " + std::to_string(b.terms().size())};
  return Chain<Dim>::from_terms(std::move(terms));
}

template <std::size_t Dim>
Result<Chain<Dim>> intersection_of(const Chain<Dim>& a, const Chain<Dim>& b,
                                   std::uint64_t max_cells) {
  return product(a, b, max_cells);
}

template <std::size_t Dim>
Result<Chain<Dim>> union_of(const Chain<Dim>& a, const Chain<Dim>& b, std::uint64_t max_cells) {
  const Result<Chain<Dim>> both = product(a, b, max_cells);
  if (!both) return both.error();
  return a + b - *both;
}

template <std::size_t Dim>
Result<Chain<Dim>> difference_of(const Chain<Dim>& a, const Chain<Dim>& b,
                                 std::uint64_t max_cells) {
  const Result<Chain<Dim>> both = product(a, b, max_cells);
  if (!both) return both.error();
  return a - *both;
}

template <std::size_t Dim>
Result<Chain<Dim>> complement_of(const Chain<Dim>& a, const PointIn<Dim>& lo,
                                 const PointIn<Dim>& hi) {
  const Result<Chain<Dim>> all = box_chain<Dim>(lo, hi);
  if (!all) return all.error();
  if (a.is_zero()) return *all;
  const Box3d box = a.box();
  for (std::size_t k = 0; k < Dim; ++k) {
    const bool is_inside = is_finite(box) && lo[k] < Rational::from_double(box.lo[k]) &&
                           Rational::from_double(box.hi[k]) < hi[k];
    if (!is_inside)
      return bad_argument("the box from " + lo[k].to_string() + " to " + hi[k].to_string() +
                          " along axis " + std::to_string(k) +
                          " has not all cells of the chain in its interior");
  }
  return *all - a;
}

#define VT_INSTANTIATE(Dim)                                                                       \
  template Result<Chain<Dim>> product<Dim>(const Chain<Dim>&, const Chain<Dim>&, std::uint64_t);  \
  template Result<Chain<Dim>> intersection_of<Dim>(const Chain<Dim>&, const Chain<Dim>&,          \
                                                   std::uint64_t);                                \
  template Result<Chain<Dim>> union_of<Dim>(const Chain<Dim>&, const Chain<Dim>&, std::uint64_t); \
  template Result<Chain<Dim>> difference_of<Dim>(const Chain<Dim>&, const Chain<Dim>&,            \
                                                 std::uint64_t);                                  \
  template Result<Chain<Dim>> complement_of<Dim>(const Chain<Dim>&, const PointIn<Dim>&,          \
                                                 const PointIn<Dim>&);
VT_INSTANTIATE(1)
VT_INSTANTIATE(2)
VT_INSTANTIATE(3)
#undef VT_INSTANTIATE

}  // namespace veritope
