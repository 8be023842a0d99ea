// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/plane_cell.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "robust/base/fp_guard.h"
#include "solids/chain/simplex_cell.h"

namespace veritope {
namespace {

int sign_of_arc(const PlaneArc& arc) {
  const auto sides = arc.sides();
  return sides && sides->has_left && !sides->has_right ? -1 : 1;
}

bool is_on_segment(const PointIn<2>& a, const PointIn<2>& b, const PointIn<2>& q) {
  if (orientation_of<2>({a, b, q}) != 0) return false;
  for (std::size_t k = 0; k < 2; ++k)
    if (q[k] < std::min(a[k], b[k]) || std::max(a[k], b[k]) < q[k]) return false;
  return true;
}

}  // namespace

ArcCell::ArcCell(PlaneArc arc)
    : Cell<2>(arc.box()), arc_(std::move(arc)), sign_(sign_of_arc(arc_)) {}

std::optional<int> ArcCell::value(const ChainPoint<2>& q) const {
  const std::optional<CellGerm<2>> near = germ(q);
  if (!near) return std::nullopt;
  return near->half_spaces.empty() ? near->inside : near->border;
}

std::optional<CellGerm<2>> ArcCell::germ(const ChainPoint<2>& q) const {
  if (!meets(box(), q.box())) return CellGerm<2>::constant(0);
  const PointIn<2>&a = arc_.start(), &b = arc_.end();
  // Across a ray that is not along the chord; the rest of the function does not depend on it.
  const std::size_t axis = a[1] == b[1] ? 1 : 0;
  const std::optional<int> passes = arc_.passes(q, axis);
  if (!passes) return std::nullopt;
  if (a == b || !is_on_segment(a, b, q.exact()))
    return CellGerm<2>::constant(sign_ * (*passes - passes_of_segment(a, b, q.exact(), axis)));
  // On the left of the chord a ray that it passes upwards meets it.
  const bool is_upward = axis == 0 ? a[1] < b[1] : b[0] < a[0];
  const int left = sign_ * (*passes - (is_upward ? 1 : 0)), right = left + sign_;
  const NormalIn<2> to_left{a[1] - b[1], b[0] - a[0]};
  return CellGerm<2>{
      {to_left}, left, std::max({0, left, right}) + std::min({0, left, right}), right};
}

Chain<2> plane_chain(std::span<const PlaneArc> arcs, const PointIn<2>& origin) {
  const ScopedDefaultFp nearest;
  std::vector<FacetIn<2>> chords;
  for (const PlaneArc& arc : arcs) chords.push_back({arc.start(), arc.end()});
  std::vector<ChainTerm<2>> terms = original_simplices<2>(chords, origin).terms();
  for (const PlaneArc& arc : arcs) {
    const auto sides = arc.sides();
    if (sides && !sides->has_left && !sides->has_right) continue;  // it lies in its chord's line
    auto cell = std::make_shared<const ArcCell>(arc);
    const Integer sign(cell->sign());
    terms.push_back({sign, {std::move(cell)}, arc.box()});
  }
  return Chain<2>::from_terms(std::move(terms));
}

}  // namespace veritope
