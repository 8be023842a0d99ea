// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/duplicates.h"

#include <algorithm>

#include "topology/incidence.h"

namespace veritope {
namespace {

struct Entry {
  std::array<std::uint32_t, 3> ids;  // ascending
  std::uint32_t face;
  auto operator<=>(const Entry&) const = default;
};

DuplicateFaces among(std::vector<Entry> entries, std::size_t max_listed) {
  std::sort(entries.begin(), entries.end());
  DuplicateFaces out;
  for (std::size_t i = 0, j = 0; i < entries.size(); i = j) {
    for (j = i + 1; j < entries.size() && entries[j].ids == entries[i].ids; ++j)
      out.first.emplace_back(entries[i].face, entries[j].face);
    if (j == i + 1) continue;
    std::vector<std::uint32_t>& group = out.groups.emplace_back();
    for (std::size_t k = i; k < j; ++k) group.push_back(entries[k].face);
  }
  out.count = out.first.size();
  std::sort(out.first.begin(), out.first.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (out.first.size() > max_listed) out.first.resize(max_listed);
  return out;
}

}  // namespace

// If every edge has at most two faces, a face and its duplicate have all three edges to themselves: they are a shell of
// two faces on three vertices.
DuplicateFaces find_duplicate_faces(std::span<const std::array<std::uint32_t, 3>> faces,
                                    const SurfaceTopology& topology, std::size_t max_listed) {
  const bool all = topology.nonmanifold_edges > 0;
  const auto in_pillow = [&](std::size_t f) {
    const Shell& s = topology.shells[topology.shell_of_face[f]];
    return s.faces == 2 && s.vertices == 3;
  };
  const bool any_pillow = std::any_of(topology.shells.begin(), topology.shells.end(),
                                      [](const Shell& s) { return s.faces == 2 && s.vertices == 3; });
  std::vector<Entry> entries;
  if (all || any_pillow)
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (is_collapsed(faces[f]) || (!all && !in_pillow(f))) continue;
      Entry e{faces[f], static_cast<std::uint32_t>(f)};
      std::sort(e.ids.begin(), e.ids.end());
      entries.push_back(e);
    }
  return among(std::move(entries), max_listed);
}

}  // namespace veritope
