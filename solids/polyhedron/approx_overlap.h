// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/approx_overlap.h: the intersection of two triangles, quickly and roughly: for the order of lists,
// and for pictures.
#pragma once
#include <array>
#include <optional>

#include "predicates/vec.h"

namespace veritope {

/// The approximate greatest distance between two common points of two triangles that have one; no decision may use it.
/// Neither negative nor NaN, infinite beyond binary64. Its relative error is approximately 10^-10 for triangles whose
/// planes form no tiny angle, and may be 1 for others and for triangles that barely meet.
/// The result has the same bits with every compiler. @cost less than a microsecond
double approx_common_extent(const std::array<Vec3d, 3>& t, const std::array<Vec3d, 3>& u);

/// The approximate ends of the segment in which two triangles cross; nothing if they seem not to, or nearly lie in one
/// plane. For pictures: no decision may use it.
std::optional<std::array<Vec3d, 2>> approx_common_segment(const std::array<Vec3d, 3>& t,
                                                          const std::array<Vec3d, 3>& u);

}  // namespace veritope
