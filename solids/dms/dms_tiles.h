// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_tiles.h: triangles that tile the boundary of a domain, on each of which the map is one polynomial:
// the conditions T1 and T2 of docs/certificates/dms-solid.md.
#pragma once
#include <array>
#include <cstddef>
#include <variant>
#include <vector>

#include "robust/base/work_share.h"
#include "solids/dms/dms_model.h"
#include "solids/dms/dms_region.h"

namespace veritope {

struct DmsTile {
  std::array<DmsPoint, 3> corners;
  std::vector<DmsPlane> planes;  ///< part knots from the tile, besides those that are not listed
};
/// How the long loops run; what they find does not depend on it.
struct DmsTileOptions {
  unsigned jobs = 1;          ///< threads
  WorkShare* work = nullptr;  ///< what is done of a step, if it is not null
  std::size_t max_tiles_of_face = 4096;
  std::size_t max_tiles = static_cast<std::size_t>(-1);  ///< of all faces together
};

/// A face of the boundary for which no tiles were found.
struct DmsOpenFace {
  TetrahedronFace face = 0;
  bool is_over_limit = false;  ///< there would be more than max_tiles
};

/// The tiles of each face of the boundary; those of a face that no triangle of knots meets are the face alone. Tiles of
/// neighbours have whole edges in common.
/// REQUIRES the complex of the model, and a model without defects of its domain.
/// @cost  for each face the triangles of knots that cross it, times its tiles
std::variant<std::vector<std::vector<DmsTile>>, DmsOpenFace> tile_boundary(
    const DmsModel& model, const TetrahedralComplex& complex, const DmsTileOptions& options = {});

}  // namespace veritope
