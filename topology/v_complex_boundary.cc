// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/v_complex_boundary.h"

#include <algorithm>
#include <cstddef>

#include "robust/base/disjoint_sets.h"
#include "topology/v_complex_internal.h"

namespace veritope {
namespace {

// From a use without mate through the fan to its other end.
CurveUseId other_end_of_fan(const VComplexTables& t, CurveUseId u) {
  CurveUseId at = t.uses[u].across;
  while (!t.uses[at].mate.is_none()) at = t.uses[t.uses[at].mate].across;
  return at;
}

template <class Id>
std::size_t place_in(const std::vector<Id>& ascending, Id id) {
  return static_cast<std::size_t>(std::lower_bound(ascending.begin(), ascending.end(), id) -
                                  ascending.begin());
}

// The shells with their faces and loops.
void list_shells(const VComplexTables& t, BoundaryBrep& out) {
  DisjointSets<std::size_t> components(out.faces.size());
  for (std::size_t i = 0; i < out.uses.size(); ++i)
    components.join(place_in(out.faces, t.uses[out.uses[i]].half_surface),
                    place_in(out.faces, t.uses[out.across[i]].half_surface));
  out.shell_of.resize(out.faces.size());
  for (std::size_t f = 0; f < out.faces.size(); ++f) {
    const std::size_t root = components.find(f);
    if (root == f) {
      out.shell_of[f] = static_cast<std::uint32_t>(out.shells.size());
      out.shells.emplace_back().first_half = out.faces[f];
    }
    out.shell_of[f] = out.shell_of[root];
    VShell& shell = out.shells[out.shell_of[f]];
    ++shell.faces;
    shell.loops += t.half_surfaces[out.faces[f]].loops.size();
  }
}

}  // namespace

std::uint64_t BoundaryBrep::num_vertices() const {
  std::uint64_t out = 0;
  for (const VShell& shell : shells) out += shell.vertices;
  return out;
}

BoundaryBrep boundary_brep(const VComplex& complex) {
  const VComplexTables& t = complex.tables();
  BoundaryBrep out;
  for (const HalfVSurfaceId h : t.half_surfaces) {
    if (!t.mate(h).is_none()) continue;
    out.faces.push_back(h);
    for (const CurveUseId u : internal::uses_of_half(t, h)) out.uses.push_back(u);
  }
  std::sort(out.uses.begin(), out.uses.end());
  for (const CurveUseId u : out.uses) out.across.push_back(other_end_of_fan(t, u));
  list_shells(t, out);
  DisjointSets<std::size_t> vertices(out.uses.size());
  for (std::size_t i = 0; i < out.uses.size(); ++i)
    vertices.join(i, place_in(out.uses, t.uses[out.across[i]].next));
  for (std::size_t i = 0; i < out.uses.size(); ++i) {
    const std::size_t face = place_in(out.faces, t.uses[out.uses[i]].half_surface);
    VShell& shell = out.shells[out.shell_of[face]];
    shell.vertices += vertices.find(i) == i;
    shell.edges += out.uses[i] < out.across[i];
  }
  return out;
}

}  // namespace veritope
