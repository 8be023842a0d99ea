// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/collar_solids.h"

namespace veritope {
namespace {

Result<TriangleMesh> side_of(const PatchCollar& collar, int winding, CellSide side, int scale) {
  std::vector<bool> which;
  for (const Shore& shore : collar.shores) which.push_back(shore.winding == winding);
  return boundary_mesh(collar.complex, collar.collar.boundary, which, side, collar.root, scale);
}

}  // namespace

Result<TriangleMesh> outer_solid(const PatchCollar& collar, int scale) {
  return side_of(collar, 0, CellSide::kOut, scale);
}
Result<TriangleMesh> inner_solid(const PatchCollar& collar, int scale) {
  return side_of(collar, 1, CellSide::kIn, scale);
}
Result<TriangleMesh> collar_solid(const PatchCollar& collar, int scale) {
  const std::vector<bool> all(collar.shores.size(), true);
  return boundary_mesh(collar.complex, collar.collar.boundary, all, CellSide::kOut, collar.root,
                       scale);
}

}  // namespace veritope
