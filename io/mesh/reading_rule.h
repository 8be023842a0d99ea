// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/reading_rule.h: the text of the rule that the readers implement (docs/certificates/reading-rule-1.md).
#pragma once
#include <string_view>

namespace veritope {

/// One line, exactly as in the statement of a certificate; without double quotes and backslashes.
inline constexpr std::string_view kReadingRule =
    "Reading rule v1: vertices with equal coordinates are one vertex, -0 equals +0, unless "
    "as_indexed is true (STL: always one); vertex ids count first occurrences in file order; "
    "polygons are fans from their first vertex; decimals round to the nearest binary64, ties to "
    "even; binary floats are widened exactly; normals, colours, texture, lines, groups and "
    "attribute bytes are ignored; unreferenced vertices are ignored; all solid blocks of an ASCII "
    "STL are one model; the file is refused unless it yields at least one triangle, finite "
    "coordinates and indices in range.";

}  // namespace veritope
