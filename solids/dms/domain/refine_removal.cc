// SPDX-License-Identifier: LGPL-3.0-or-later
// Vertices that are taken away. The star of a vertex is replaced by the cone over its shell from a neighbour, as in
// refine_cavity.cc: it fills the star if the neighbour sees all faces of the shell without it from inside, and lies on
// every facet that the vertex lies on.
#include <algorithm>
#include <cmath>

#include "robust/base/check.h"
#include "solids/dms/domain/refine_mesh.h"
#include "topology/tetrahedral_flips.h"

namespace veritope {

std::vector<std::uint32_t> RefineMesh::tetrahedra_at(std::uint32_t v) const {
  return tetrahedra_around(complex_, at_vertex_[v], v);
}

// The least volume over the cube of the longest edge of the tetrahedra that the removal would make; negative if one
// of them would not be positive, or a vertex would be in none.
double RefineMesh::approx_shape_after(std::uint32_t v, std::uint32_t neighbour,
                                      std::span<const std::uint32_t> star) const {
  double least = HUGE_VAL;
  std::set<std::uint32_t> before, after{v};
  for (const std::uint32_t t : star) {
    TetrahedronCorners c = complex_.corners(t);
    before.insert(c.begin(), c.end());
    if (std::find(c.begin(), c.end(), neighbour) != c.end()) continue;
    std::replace(c.begin(), c.end(), v, neighbour);
    const auto &p = points_[c[0]], &q = points_[c[1]], &r = points_[c[2]], &s = points_[c[3]];
    if (orient3d(p, q, r, s) != Sign::kPositive) return -1;
    after.insert(c.begin(), c.end());
    double longest = 0;
    std::array<Vec3d, 4> at{p.rounded(), q.rounded(), r.rounded(), s.rounded()};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        longest =
            std::max(longest, std::hypot(at[i].x - at[j].x, at[i].y - at[j].y, at[i].z - at[j].z));
    for (std::size_t i = 1; i < 4; ++i)
      at[i] = {at[i].x - at[0].x, at[i].y - at[0].y, at[i].z - at[0].z};
    const double d = at[1].x * (at[2].y * at[3].z - at[2].z * at[3].y) +
                     at[1].y * (at[2].z * at[3].x - at[2].x * at[3].z) +
                     at[1].z * (at[2].x * at[3].y - at[2].y * at[3].x);
    least = std::min(least, std::max(0.0, d / (longest * longest * longest)));
  }
  if (!std::includes(after.begin(), after.end(), before.begin(), before.end())) return -1;
  return std::isnan(least) ? 0 : least;
}

bool RefineMesh::remove_vertex(std::uint32_t v) {
  if (facets_at_[v].size() > 2) return false;
  const std::vector<std::uint32_t> star = tetrahedra_at(v);
  std::set<std::uint32_t> neighbours;
  for (const std::uint32_t t : star)
    for (const std::uint32_t w : complex_.corners(t))
      if (w != v && std::includes(facets_at_[w].begin(), facets_at_[w].end(), facets_at_[v].begin(),
                                  facets_at_[v].end()))
        neighbours.insert(w);
  double most = -1;
  std::uint32_t best = v;
  for (const std::uint32_t w : neighbours)
    if (const double shape = approx_shape_after(v, w, star); shape > most) most = shape, best = w;
  if (best == v) return false;
  replace_vertex(v, best, star);
  return true;
}

void RefineMesh::replace_vertex(std::uint32_t v, std::uint32_t neighbour,
                                std::span<const std::uint32_t> star) {
  BoundaryNotes notes;
  std::vector<TetrahedronFace> shell;
  for (const std::uint32_t t : star)
    for (TetrahedronFace f = 4 * t; f < 4 * t + 4; ++f) {
      const auto corners = complex_.vertices(f);
      const auto at = std::find(corners.begin(), corners.end(), v);
      if (at == corners.end()) {
        shell.push_back(f);
      } else if (is_on_boundary(f)) {
        const auto k = static_cast<std::size_t>(at - corners.begin());
        notes.rim[std::minmax(corners[(k + 1) % 3], corners[(k + 2) % 3])] = facet_[f];
      }
    }
  note_kept(shell, notes);
  std::vector<std::uint32_t> ends;  // of the segments at the vertex: none or two
  for (const std::uint32_t t : star)
    for (const std::uint32_t w : complex_.corners(t))
      if (w != v && is_segment(v, w) && std::find(ends.begin(), ends.end(), w) == ends.end())
        ends.push_back(w);
  for (const std::uint32_t w : ends) {
    const auto found = segments_.find(std::minmax(v, w));
    const FacetPair facets = found->second;
    segments_.erase(found);
    if (w != neighbour) segments_[std::minmax(neighbour, w)] = facets;
  }
  const std::vector<std::uint32_t> added = complex_.replace_by_cone(star, shell, neighbour);
  VT_CHECK(!added.empty(), "some tetrahedron at the vertex does not have the neighbour");
  take_added(added, neighbour, notes);
  at_vertex_[v] = kNoFacet;
  facets_at_[v].clear();
}

}  // namespace veritope
