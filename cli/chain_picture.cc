// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/chain_picture.h"

#include "render/chain_cells.h"
#include "solids/chain/base_side.h"
#include "solids/chain/free_form_cell.h"
#include "solids/chain/normal_chain.h"

namespace veritope::cli {
namespace {

std::int64_t coefficient_of(BaseSide side) {
  return side == BaseSide::kPlus ? 1 : side == BaseSide::kMinus ? -1 : 0;
}

}  // namespace

Result<std::string> chain_picture(const PatchComplex& complex, const ExactPoint& origin) {
  ChainCells out;
  for (std::uint32_t p = 0; p < complex.patches().size(); ++p)
    for (const BaseTriangle& t : base_triangles(complex.patch(p))) {
      const int sign = to_int(simplex_sign(t, origin));
      if (sign == 0) continue;
      const Status status = out.add_tetrahedron({origin, t[0], t[1], t[2]}, {0, sign, p});
      if (!status) return status.error();
    }
  for (std::uint32_t p = 0; p < complex.patches().size(); ++p) {
    const Patch& patch = complex.patch(p);
    if (patch.is_flat_triangle()) continue;
    const std::vector<BaseTriangle> bases = base_triangles(patch);
    const std::vector<Patch::Triangle> maps = triangles_of(patch);
    for (std::size_t half = 0; half < bases.size(); ++half) {
      const Status status =
          out.add_wedge(bases[half], maps[half], {1, coefficient_of(base_side(patch)), p});
      if (!status) return status.error();
    }
  }
  return out.vtu_bytes();
}

}  // namespace veritope::cli
