// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/mesh/cell_plans_internal.h"

#include <functional>

namespace veritope::internal {
namespace {

void append_range(std::uint32_t begin, std::uint32_t end, std::vector<PlanRange>& to) {
  if (begin == end) return;
  if (!to.empty() && to.back()[1] == begin)
    to.back()[1] = end;
  else
    to.push_back({begin, end});
}

CellPlan plan_of(const AnalysedTile& tile, const TileMesh& mesh, const LinkedCell& cell) {
  CellPlan out;
  for (std::size_t g = 0; g < mesh.num_groups(); ++g) {
    const std::uint32_t begin = mesh.group_begin(g), end = mesh.group_begin(g + 1);
    out.first_of_group.push_back(out.num_vertices);
    const bool is_own = is_own_group(cell, g), is_rim = g % 2 == 1;
    if (is_own || is_rim) append_range(begin, end, out.present);
    if (!is_own) continue;
    append_range(begin, end, out.own);
    out.num_vertices += end - begin;
  }
  for (std::uint32_t p = 0; p < mesh.parts().size(); ++p) {
    const std::uint32_t cap = tile.cap_of_patch[p];
    if (cap != AnalysedTile::kNoCap && (cell.dropped >> cap & 1) != 0) continue;
    out.patches.push_back(p);
    append_range(mesh.first_triangle(p), mesh.first_triangle(p + 1), out.triangles);
    append_range(mesh.first_quad(p), mesh.first_quad(p + 1), out.quads);
    out.num_triangles += mesh.first_triangle(p + 1) - mesh.first_triangle(p);
  }
  return out;
}

}  // namespace

bool is_own_group(const LinkedCell& cell, std::size_t group) {
  if (group == 0) return true;
  const std::size_t cap = (group - 1) / 2;
  return ((group % 2 == 1 ? cell.borrowed : cell.dropped) >> cap & 1) == 0;
}

std::size_t CellPlans::Hash::operator()(const Key& k) const {
  constexpr std::uint64_t kMix = 0x9e3779b97f4a7c15u;
  const std::uint64_t mesh = std::hash<const void*>()(k.mesh);
  std::uint64_t h = (mesh ^ k.dropped * kMix) * kMix;
  h = (h ^ h >> 29 ^ k.borrowed) * kMix;
  return h ^ h >> 32;
}

std::uint32_t CellPlans::number_of(const AnalysedTile& tile, const TileMesh& mesh,
                                   const LinkedCell& cell) {
  const Key key{&mesh, cell.dropped, cell.borrowed};
  if (key == last_key_) return last_;
  const auto [at, is_new] = numbers_.try_emplace(key, static_cast<std::uint32_t>(plans_.size()));
  if (is_new) plans_.push_back(plan_of(tile, mesh, cell));
  last_key_ = key;
  return last_ = at->second;
}

void CellPlans::clear() { *this = {}; }

}  // namespace veritope::internal
