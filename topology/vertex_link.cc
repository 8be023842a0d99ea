// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/vertex_link.h"

#include <algorithm>

#include "robust/base/disjoint_sets.h"
#include "topology/incidence.h"

namespace veritope::internal {
namespace {

struct Wedge {
  std::uint32_t next, prev;  // the face is (v, next, prev)
};

inline Wedge wedge(const std::array<std::uint32_t, 3>& f, std::uint32_t k) {
  return {f[k == 2 ? 0 : k + 1], f[k == 0 ? 2 : k - 1]};
}

}  // namespace

bool FanWalker::is_closed_fan(std::span<const std::array<std::uint32_t, 3>> faces,
                              std::span<const std::uint32_t> corners, std::uint32_t v,
                              std::uint64_t& edges) {
  const std::uint32_t stamp = v + 1;
  std::uint64_t greater = 0;
  for (std::uint32_t c : corners) {
    const Wedge w = wedge(faces[corner_face(c)], corner_index(c));
    Mark& m = marks_[w.next];
    if (m.stamp == stamp) return false;  // two faces leave v along one edge
    m = {stamp, w.prev};
    greater += w.next > v;
  }
  const std::uint32_t start = wedge(faces[corner_face(corners[0])], corner_index(corners[0])).next;
  std::size_t steps = 0;
  std::uint32_t at = start;
  do {
    const Mark& m = marks_[at];
    if (m.stamp != stamp) return false;  // no face leaves v along the edge by which the last face came in
    at = m.prev;
  } while (++steps < corners.size() && at != start);
  if (at != start || steps != corners.size()) return false;
  edges += greater;
  return true;
}

std::vector<EdgeUse> edge_uses(std::span<const std::array<std::uint32_t, 3>> faces,
                               std::span<const std::uint32_t> corners) {
  std::vector<EdgeUse> uses;
  uses.reserve(2 * corners.size());
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    const Wedge w = wedge(faces[corner_face(corners[i])], corner_index(corners[i]));
    uses.push_back({w.next, i, true});
    uses.push_back({w.prev, i, false});
  }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return a.other != b.other ? a.other < b.other : a.corner < b.corner;
  });
  return uses;
}

std::vector<std::uint32_t> fans_of_corners(const std::vector<EdgeUse>& uses, std::size_t num_corners) {
  DisjointSets sets(num_corners);
  for (std::size_t i = 1; i < uses.size(); ++i) {
    if (uses[i].other == uses[i - 1].other) sets.join(uses[i - 1].corner, uses[i].corner);
  }
  std::vector<std::uint32_t> fan(num_corners), number(num_corners);
  std::uint32_t fans = 0;
  for (std::uint32_t i = 0; i < num_corners; ++i) {
    const std::uint32_t root = sets.find(i);
    if (root == i) number[i] = fans++;
    fan[i] = number[root];
  }
  return fan;
}

}  // namespace veritope::internal
