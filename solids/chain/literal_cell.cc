// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "solids/chain/literal_cell_internal.h"
#include "solids/chain/literal_polynomials_internal.h"
#include "solids/chain/literal_sign_internal.h"

namespace veritope::internal {

void add_rounded(const ExactPoint& p, Box3d& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    box.lo[k] = std::min(box.lo[k], round_down(p[k]));
    box.hi[k] = std::max(box.hi[k], round_up(p[k]));
  }
}

bool has_cell(const LiteralFacet& facet) {
  if (!facet.has_wedge || !facet.map) return false;
  const Polynomial h = height_form(facet);
  return std::any_of(h.coefficients().begin(), h.coefficients().end(),
                     [](const Rational& c) { return c.sign() != 0; });
}

LiteralCell::LiteralCell(const LiteralFacet& facet)
    : facet_(&facet), line_(facet), box_(empty_box()) {
  const Patch::Triangle& map = *facet.map;
  const Rational size = dot(facet.normal, facet.normal);
  for (std::size_t i = 0; i < map.count(); ++i) {
    ExactPoint p;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = map.component(static_cast<int>(k))[i];
      if (map.is_rational()) p[k] /= map.component(3)[i];
    }
    add_rounded(p, box_);
    add_rounded(minus(p, times(facet.height(p) / size, facet.normal)), box_);
  }
  Polynomial h = height_form(facet);
  for (const bool is_plus : {false, true}) {
    const Decision nowhere = nowhere_negative(h).decision;
    if (nowhere != Decision::kOpen) has_part_[is_plus ? 1 : 0] = nowhere == Decision::kViolated;
    for (Rational& c : h.coefficients()) c.negate();
  }
}

Meets LiteralCell::part_holds(const ExactPoint& q, bool is_plus) const {
  const Sign side = facet_->height(q).sign();
  if (has_part(is_plus) == false || (is_plus ? side < 0 : side > 0)) return Meets::kNone;
  for (std::size_t k = 0; k < 3; ++k)
    if (facet_->over_wall(k, q).sign() < 0) return Meets::kNone;
  const Meets met = line_.half_line(*facet_, q, is_plus);
  // A point of the patch in the plane of its base is in the closure of the points on one side if all are there.
  const bool is_all = has_part(is_plus) == true && has_part(!is_plus) == false;
  return met == Meets::kOn && side == 0 && !is_all ? Meets::kOpen : met;
}

Meets LiteralCell::add_cones(const ExactPoint& q, std::vector<LocalCone>& out) const {
  Meets all = Meets::kSome;
  for (const bool is_plus : {true, false}) {
    const Meets held = part_holds(q, is_plus);
    if (held == Meets::kOpen) return held;
    if (held == Meets::kNone) continue;
    if (held != Meets::kSome) all = Meets::kTouches;
    LocalCone cone;
    cone.coefficient = is_plus ? 1 : -1;
    for (std::size_t k = 0; k < 3; ++k)
      if (facet_->over_wall(k, q).sign() == 0) cone.inner.push_back(facet_->walls[k]);
    if (facet_->height(q).sign() == 0)
      cone.inner.push_back(times(Rational(is_plus ? 1 : -1), facet_->normal));
    out.push_back(std::move(cone));
  }
  return all;
}

}  // namespace veritope::internal
