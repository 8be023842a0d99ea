// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/inside/enclosed_patch_internal.h"

namespace veritope::internal {

std::vector<EnclosedPatch> enclosed_patches(const MicroTile& tile) {
  std::vector<EnclosedPatch> out;
  for (const TilePatch& patch : tile.patches) {
    EnclosedPatch& e = out.emplace_back(EnclosedPatch{patch.degrees, patch.wall, {}});
    for (const auto& list : patch.points) {
      auto& to = e.powers.emplace_back();
      for (const TilePoint& p : list) to.emplace_back(enclose(p[0]), enclose(p[1]), enclose(p[2]));
    }
  }
  return out;
}

// The number is a double.
void patch_points(const EnclosedPatch& patch, std::int32_t number, std::vector<Box3>* out) {
  *out = patch.powers.back();
  const Interval t(static_cast<double>(number) * 0x1p-20);
  for (std::size_t k = patch.powers.size() - 1; k-- > 0;)
    for (std::size_t i = 0; i < out->size(); ++i)
      for (std::size_t c = 0; c < 3; ++c)
        (*out)[i][c] = Interval::nonnegative_multiple((*out)[i][c], t) + patch.powers[k][i][c];
}

}  // namespace veritope::internal
