// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/separator_search.h: a polynomial that is positive on one set of points and negative on another, in
// floating point. Nothing here decides.
#pragma once
#include <optional>
#include <vector>

#include "solids/star_box/sheet_separator.h"

namespace veritope {

/// A polynomial that is near 1 on `above` and near -1 on `below`, by least squares, of the least degree for which it is
/// clearly positive and negative there; nothing if degree 3 does not suffice. `unit` is a power of two, about the
/// size of the place.
std::optional<SheetSeparator> find_separator(const std::vector<Point3d>& above,
                                             const std::vector<Point3d>& below,
                                             const Point3d& origin, double unit);

/// The sign that the separator clearly has on all of the points, approximately; kZero if it has none.
Sign common_sign(const SheetSeparator& separator, const std::vector<Point3d>& points);

}  // namespace veritope
