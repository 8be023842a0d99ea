// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_hulls.h: the conditions E1 and E3 of docs/certificates/dms-solid.md: separate control points agree,
// and no hull of knots of the boundary reaches into a tetrahedron.
#pragma once
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "solids/dms/dms_model.h"
#include "solids/dms/dms_region.h"

namespace veritope {

/// The first tetrahedron one of whose separate control points differs from that of an earlier tetrahedron at the same
/// multiset of vertices, in one of `count` components from `component` on: x, y and z unless told otherwise.
/// REQUIRES separate control points.
std::optional<std::uint32_t> find_disagreeing_control(const DmsModel& model,
                                                      std::size_t component = 0,
                                                      std::size_t count = 3);

/// A face of the boundary and a tetrahedron that no plane parts: a hull of knots reaches into it.
struct DmsOpenHull {
  TetrahedronFace face = 0;
  std::uint32_t tetrahedron = 0;
};
/// For each face of the boundary the planes that part the hulls of its knots from tetrahedra, besides those across the
/// axes and those of the tetrahedra's faces, which are not listed; or where there is no plane: the model breaks (c).
/// REQUIRES the complex of the model, without faces that are overused.
std::variant<std::vector<std::vector<DmsPlane>>, DmsOpenHull> part_hulls(
    const DmsModel& model, const TetrahedralComplex& complex);

}  // namespace veritope
