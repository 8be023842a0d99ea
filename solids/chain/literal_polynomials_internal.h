// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/literal_polynomials_internal.h: the polynomials of a facet's patch whose signs decide. Internal to
// solids/chain.
#pragma once
#include <vector>

#include "solids/chain/literal_facet_internal.h"

namespace veritope::internal {

using Polynomial = BezierTriangle<Rational>;  // one component

/// l . P - offset, times the weight of the patch, which is positive. REQUIRES facet.map.
Polynomial linear_form(const LiteralFacet& facet, const ExactPoint& l, const Rational& offset);
/// The height of the patch over its base, times |normal| and the weight.
Polynomial height_form(const LiteralFacet& facet);
/// Coordinates of the patch along the base, with the origin at corner 0, times the weight: positively oriented, and
/// equal for two points iff their difference is a multiple of the normal.
std::array<Polynomial, 2> base_forms(const LiteralFacet& facet);
/// The coordinates of `p` in base_forms.
std::array<Rational, 2> base_coordinates(const LiteralFacet& facet, const ExactPoint& p);
/// The determinant of the projection of the patch onto its base, times a positive function.
Polynomial jacobian_form(const LiteralFacet& facet);
/// The weight of a patch; 1 for a polynomial one.
Polynomial weight_form(const LiteralFacet& facet);

Polynomial difference(const Polynomial& a, const Polynomial& b);  ///< REQUIRES one degree

/// l . c(t) - offset, times the weight, for the side k of the facet. REQUIRES facet.map.
std::vector<Rational> side_form(const LiteralFacet& facet, std::size_t k, const ExactPoint& l,
                                const Rational& offset);

/// How the side k turns around b, seen along the base's normal: det(c - b, c', N), times a positive function.
std::vector<Rational> turning_form(const LiteralFacet& facet, std::size_t k, const ExactPoint& b);

/// The point of the patch at these parameters.
ExactPoint point_at(const LiteralFacet& facet, const Barycentric<Rational>& at);

}  // namespace veritope::internal
