// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/literal_hypotheses_internal.h: how each hypothesis of the literal chain is decided. Internal to
// solids/chain.
#pragma once
#include <string>

#include "solids/chain/literal_facet_internal.h"
#include "solids/chain/literal_hypotheses.h"
#include "solids/chain/literal_sign_internal.h"

namespace veritope::internal {

LiteralHypothesis planes_share_lines(const PatchComplex& complex, const LiteralFacets& facets);
LiteralHypothesis curves_in_planes(const PatchComplex& complex, const LiteralFacets& facets);

/// An answer at one place, and why it is not kHolds.
struct PlaceAnswer {
  Decision decision = Decision::kHolds;
  std::string why;
};
/// CHAIN-6.G1 to G3. REQUIRES has_wedge.
PlaceAnswer is_in_wedge(const LiteralFacet& facet);
PlaceAnswer is_facing(const LiteralFacet& facet);
PlaceAnswer is_upright(const LiteralFacet& facet);
/// Fills graphs, in_wedges, facing and upright.
void decide_graphs(const PatchComplex& complex, const LiteralFacets& facets, unsigned jobs,
                   LiteralHypotheses& out);

/// "facet 3", "surface 0, span (0, 1), second half".
std::string name_of(const PatchComplex& complex, const LiteralFacet& facet);
/// "(0, 0.5, 1)", rounded to nearest.
std::string approx_text(const ExactPoint& p);

}  // namespace veritope::internal
