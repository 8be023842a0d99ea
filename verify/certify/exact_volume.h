// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/exact_volume.h: the volume within polynomial patches, without rounding.
#pragma once
#include <optional>
#include <span>

#include "robust/rational.h"
#include "solids/patches/patch.h"

namespace veritope {

/// A third of the integral of n·S over the patches (Gauss): the volume that they enclose, if they are the boundary of
/// a solid, outward. Nothing if one of them is rational. @cost O(products of coefficients)
std::optional<Rational> exact_volume(std::span<const Patch> patches);

}  // namespace veritope
