// SPDX-License-Identifier: Apache-2.0 OR MIT
// collar_shores.cc: K1 and K2 of docs/certificates/collar.md: the boundary of |K|, its components and
// those of |K|.
#include "collar.h"

namespace {

typedef std::vector<uint32_t> Classes;  // parents; a class is named by its least element
uint32_t find(Classes* parent, uint32_t i) {
  while ((*parent)[i] != i) i = (*parent)[i] = (*parent)[(*parent)[i]];
  return i;
}
void unite(Classes* parent, uint32_t i, uint32_t j) {
  i = find(parent, i), j = find(parent, j);
  (*parent)[std::max(i, j)] = std::min(i, j);
}
Classes singles(size_t n) {
  Classes r(n);
  for (uint32_t i = 0; i < n; ++i) r[i] = i;
  return r;
}

// The boundary faces at an edge, at most four.
int boundary_faces(const Complex& k, const Around& edge, uint32_t* out) {
  int n = 0;
  for (uint32_t f : edge.face)
    if (f != kNone && k.faces[f].is_boundary()) out[n++] = f;
  return n;
}

// By K1E every boundary edge at the vertex has two boundary faces, and a boundary face at the vertex
// has two edges there: the faces form cycles, one iff all edges are connected.
bool is_one_cycle(const Complex& k, uint32_t vertex) {
  uint32_t faces[6][4];
  int n = 0;
  k.each_edge_at(vertex, [&](int d, uint32_t i) {
    if (boundary_faces(k, k.around[d][i], faces[n]) != 0) ++n;
  });
  bool reached[6] = {true, false, false, false, false, false};
  int open[6] = {0}, num = n > 0;  // edges that were reached, each once
  for (int at = 0; at < num; ++at)
    for (int j = 0; j < n; ++j) {
      const uint32_t *const a = faces[open[at]], *const b = faces[j];
      if (reached[j] || (a[0] != b[0] && a[0] != b[1] && a[1] != b[0] && a[1] != b[1])) continue;
      reached[j] = true;
      open[num++] = j;
    }
  return num == n;
}

}  // namespace

Shores::Shores(const Complex& k, const std::vector<uint8_t>& sides) {
  const uint32_t n = uint32_t(k.vertices.size());
  uint32_t faces[4];
  for (int d = 0; d < 3; ++d)
    for (uint32_t i = 0; i < n; ++i) {
      const int num = boundary_faces(k, k.around[d][i], faces);
      require(num == 0 || num == 2, "K1E", "an edge is not in two boundary faces, one is",
              faces[0]);
    }
  for (uint32_t v = 0; v < n; ++v)
    require(is_one_cycle(k, v), "K1V", "the boundary faces form no cycle at vertex", v);
  find_components(k);
  pair(k, sides);
}

void Shores::find_components(const Complex& k) {
  Classes faces = singles(k.faces.size()), cells = singles(k.codes.size());
  uint32_t two[4];
  for (int d = 0; d < 3; ++d)
    for (const Around& edge : k.around[d])
      if (boundary_faces(k, edge, two) != 0) unite(&faces, two[0], two[1]);
  for (const Face& f : k.faces)
    if (!f.is_boundary()) unite(&cells, f.cell[0], f.cell[1]);
  of_face.assign(k.faces.size(), kNone);
  for (uint32_t f = 0; f < k.faces.size(); ++f) {
    if (!k.faces[f].is_boundary()) continue;
    const uint32_t first = find(&faces, f);
    if (first == f) least.push_back(f);
    of_face[f] = first == f ? uint32_t(least.size() - 1) : of_face[first];
  }
  uint32_t components = 0;
  for (uint32_t i = 0; i < k.codes.size(); ++i) {
    const uint32_t first = find(&cells, i);
    of_cell.push_back(first == i ? components++ : of_cell[first]);
  }
  outer.assign(components, kNone), inner.assign(components, kNone);

  chi.assign(least.size(), 0);
  for (uint32_t f = 0; f < k.faces.size(); ++f)
    if (of_face[f] != kNone) ++chi[of_face[f]];
  for (int d = 0; d < 3; ++d)
    for (const Around& edge : k.around[d])
      if (boundary_faces(k, edge, two) != 0) --chi[of_face[two[0]]];
  for (uint32_t v = 0; v < k.vertices.size(); ++v) {
    uint32_t shore = kNone;
    k.each_edge_at(v, [&](int d, uint32_t i) {
      if (boundary_faces(k, k.around[d][i], two) != 0) shore = of_face[two[0]];
    });
    if (shore != kNone) ++chi[shore];
  }
}

void Shores::pair(const Complex& k, const std::vector<uint8_t>& sides) {
  require(sides.size() == least.size(), "K2", "the components of the boundary are", least.size());
  for (uint32_t i = 0; i < least.size(); ++i) {
    require(sides[i] <= 1, "K2", "no side, of the boundary's component", i);
    is_outer.push_back(sides[i] == 1);
    uint32_t& to = (sides[i] == 1 ? outer : inner)[of_cell[k.faces[least[i]].any_cell()]];
    require(to == kNone, "K2", "two components on one side of a collar, one is", i);
    to = i;
  }
  for (uint32_t i = 0; i < outer.size(); ++i)
    require(outer[i] != kNone && inner[i] != kNone, "K2", "no two sides, of component", i);
}
