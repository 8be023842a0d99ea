// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>

#include "solids/patches/patch_complex_internal.h"

namespace veritope::internal {
MatchedSides match_sides(std::span<const Patch> patches) {
  MatchedSides out;
  out.edge_of_side.assign(4 * patches.size(), PatchComplex::kNone);
  out.travel.assign(4 * patches.size(), Travel::kForward);
  std::vector<std::pair<std::uint64_t, PatchSide>> hashed;
  hashed.reserve(4 * patches.size());
  for_each_side(patches, [&](PatchSide s) {
    const SideForm form(patches[s.patch], s.side);
    if (form.is_collapsed()) return;
    out.travel[4 * std::size_t{s.patch} + s.side] = form.travel();
    hashed.emplace_back(form.hash(), s);
  });
  auto edges = equal_classes(std::move(hashed),
                             [&](PatchSide s) { return SideForm(patches[s.patch], s.side); });
  std::sort(edges.begin(), edges.end());
  for (const auto& sides : edges) {
    out.first_side.push_back(out.sides.size());
    for (const PatchSide s : sides) {
      out.edge_of_side[4 * std::size_t{s.patch} + s.side] =
          static_cast<std::uint32_t>(out.first_side.size() - 1);
      out.sides.push_back(s);
    }
  }
  out.first_side.push_back(out.sides.size());
  return out;
}

}  // namespace veritope::internal
