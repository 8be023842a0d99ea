// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/patches/curve_agreement_internal.h: whether two arcs are one curve, in which parametrizations, and where a
// point lies on a curve: exactly.
#pragma once
#include <array>
#include <optional>

#include "solids/patches/common_roots.h"
#include "solids/patches/patch.h"
#include "solids/patches/side_overlaps.h"

namespace veritope::internal {

/// REQUIRES positive weights.
PatchPoint point_at(const Patch::Curve& curve, const Rational& t);

/// The parameters in [0,1] at which the curve passes the point. is_everywhere: the curve is that point.
CommonRoots parameters_of(const PatchPoint& point, const Patch::Curve& curve);

/// The arc from at[0] to at[1] as a curve over [0,1]; run backwards if at[1] < at[0]. REQUIRES different ends.
Patch::Curve arc_of(const Patch::Curve& curve, const std::array<Rational, 2>& at);

/// How two arcs from one point to another agree; nothing if they do not even lie on one algebraic curve.
/// REQUIRES positive weights.
std::optional<CurveAgreement> agreement_of(const Patch::Curve& a, const Patch::Curve& b);

}  // namespace veritope::internal
