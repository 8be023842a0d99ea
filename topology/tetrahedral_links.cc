// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/tetrahedral_links.cc: what the links of a complex of tetrahedra are (topology/tetrahedral_complex.h).
#include <algorithm>
#include <map>

#include "robust/base/disjoint_sets.h"
#include "topology/tetrahedral_complex.h"
#include "topology/vertex_link.h"

namespace veritope {
namespace {

// The ids 0, 1, ... in place of any ids.
std::vector<std::array<std::uint32_t, 3>> renumbered(
    std::span<const std::array<std::uint32_t, 3>> triangles, std::uint32_t& count) {
  std::vector<std::uint32_t> ids;
  for (const auto& t : triangles) ids.insert(ids.end(), t.begin(), t.end());
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  count = static_cast<std::uint32_t>(ids.size());
  std::vector<std::array<std::uint32_t, 3>> out(triangles.begin(), triangles.end());
  for (auto& t : out)
    for (std::uint32_t& v : t)
      v = static_cast<std::uint32_t>(std::lower_bound(ids.begin(), ids.end(), v) - ids.begin());
  return out;
}

// Whether the triangles at a vertex are one fan; at most two of them share an edge.
bool is_one_fan(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                const std::vector<std::uint32_t>& corners) {
  const auto fans =
      internal::fans_of_corners(internal::edge_uses(triangles, corners), corners.size());
  return std::all_of(fans.begin(), fans.end(), [](std::uint32_t fan) { return fan == 0; });
}

}  // namespace

LinkKind classify_link(std::span<const std::array<std::uint32_t, 3>> given) {
  if (given.empty()) return LinkKind::kEmpty;
  std::uint32_t count = 0;
  const auto triangles = renumbered(given, count);
  std::map<std::array<std::uint32_t, 2>, int> directed;
  std::vector<std::vector<std::uint32_t>> corners(count);
  DisjointSets<std::uint32_t> parts(count);
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      if (a == b || ++directed[{a, b}] > 1) return LinkKind::kOther;
      corners[a].push_back(4 * t + k);
      parts.join(a, b);
    }
  std::int64_t num_open = 0;
  for (const auto& [edge, uses] : directed)
    if (!directed.contains({edge[1], edge[0]})) ++num_open;
  for (std::uint32_t v = 0; v < count; ++v)
    if (parts.find(v) != 0 || !is_one_fan(triangles, corners[v])) return LinkKind::kOther;
  const auto num_edges = (static_cast<std::int64_t>(directed.size()) + num_open) / 2;
  const std::int64_t euler =
      std::int64_t{count} - num_edges + static_cast<std::int64_t>(triangles.size());
  if (num_open == 0 && euler == 2) return LinkKind::kClosed;
  return num_open > 0 && euler == 1 ? LinkKind::kOpen : LinkKind::kOther;
}

LinkKind classify_link(std::span<const std::array<std::uint32_t, 2>> pairs) {
  if (pairs.empty()) return LinkKind::kEmpty;
  std::map<std::uint32_t, std::uint32_t> next, before;
  for (const auto& [a, b] : pairs)
    if (a == b || !next.emplace(a, b).second || !before.emplace(b, a).second)
      return LinkKind::kOther;
  const auto start = std::find_if(pairs.begin(), pairs.end(),
                                  [&](const auto& pair) { return !before.contains(pair[0]); });
  const std::uint32_t first = start == pairs.end() ? pairs[0][0] : (*start)[0];
  std::size_t steps = 0;
  std::uint32_t at = first;
  for (auto found = next.find(at); found != next.end() && steps < pairs.size();
       found = next.find(at)) {
    at = found->second;
    ++steps;
    if (at == first) break;
  }
  if (steps != pairs.size()) return LinkKind::kOther;
  return at == first ? LinkKind::kClosed : LinkKind::kOpen;
}

}  // namespace veritope
