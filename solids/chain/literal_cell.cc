// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "solids/chain/literal_cell_internal.h"
#include "solids/chain/literal_polynomials_internal.h"

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
}

Meets LiteralCell::part_holds(const ExactPoint& q, bool is_plus) const {
  const Sign side = facet_->height(q).sign();
  if (is_plus ? side < 0 : side > 0) return Meets::kNone;
  for (std::size_t k = 0; k < 3; ++k)
    if (facet_->over_wall(k, q).sign() < 0) return Meets::kNone;
  return line_.half_line(*facet_, q, is_plus);
}

bool LiteralCell::add_cones(const ExactPoint& q, std::vector<LocalCone>& out) const {
  for (const bool is_plus : {true, false}) {
    const Meets held = part_holds(q, is_plus);
    if (held == Meets::kOpen) return false;
    if (held == Meets::kNone) continue;
    LocalCone cone;
    cone.coefficient = is_plus ? 1 : -1;
    for (std::size_t k = 0; k < 3; ++k)
      if (facet_->over_wall(k, q).sign() == 0) cone.inner.push_back(facet_->walls[k]);
    if (facet_->height(q).sign() == 0)
      cone.inner.push_back(times(Rational(is_plus ? 1 : -1), facet_->normal));
    out.push_back(std::move(cone));
  }
  return true;
}

}  // namespace veritope::internal
