// SPDX-License-Identifier: Apache-2.0 OR MIT
// collar_collapse.cc: K3 of docs/certificates/collar.md. Cells are removed in the order of the
// certificate, then edges with faces, then vertices with edges, in any order. After a removal it is
// known where another one may have become possible, so the work is linear.
#include "collar.h"

namespace {

struct Remains {
  const Complex& k;
  const Shores& shores;
  std::vector<bool> faces, edges[3], vertices;  // the remaining ones

  Remains(const Complex& complex, const Shores& s)
      : k(complex), shores(s), faces(k.faces.size(), true), vertices(k.vertices.size(), true) {
    for (int d = 0; d < 3; ++d)
      for (const Around& edge : k.around[d]) edges[d].push_back(!is_empty(edge));
  }
  static bool is_empty(const Around& edge) {
    return std::count(edge.face, edge.face + 4, kNone) == 4;
  }

  void remove_cells(const std::vector<int64_t>& differences) {
    std::vector<bool> cells(k.codes.size(), true);
    int64_t face = 0;
    for (uint64_t step = 0; step < differences.size(); ++step) {
      const int64_t by = differences[step];
      require(magnitude(by) <= kMostFaces && face + by >= 0 && uint64_t(face + by) < k.faces.size(),
              "K3", "there is no such face, step", step);
      face += by;
      const Face& f = k.faces[size_t(face)];
      const bool below = f.cell[0] != kNone && cells[f.cell[0]];
      const bool above = f.cell[1] != kNone && cells[f.cell[1]];
      require(!shores.is_kept(uint32_t(face)) && below != above, "K3",
              "the face of a step is in d+ or not in exactly one cell, step", step);
      cells[f.cell[below ? 0 : 1]] = false;
      faces[size_t(face)] = false;
    }
  }

  struct Edge {
    int axis;
    uint32_t at;
  };
  bool is_kept(Edge e) const {
    for (uint32_t f : k.around[e.axis][e.at].face)
      if (f != kNone && shores.is_kept(f)) return true;
    return false;
  }
  // The only remaining face at the edge, or kNone.
  uint32_t only_face(Edge e) const {
    uint32_t only = kNone;
    int n = 0;
    for (uint32_t f : k.around[e.axis][e.at].face)
      if (f != kNone && faces[f]) only = f, ++n;
    return n == 1 ? only : kNone;
  }
  void remove_faces() {
    std::vector<Edge> open;
    for (int d = 0; d < 3; ++d)
      for (uint32_t i = 0; i < edges[d].size(); ++i) {
        open.push_back(Edge{d, i});
        while (!open.empty()) {
          const Edge e = open.back();
          open.pop_back();
          const uint32_t f = edges[e.axis][e.at] ? only_face(e) : kNone;
          if (f == kNone || is_kept(e)) continue;
          edges[e.axis][e.at] = false;
          faces[f] = false;
          k.each_edge(k.faces[f], [&](int axis, uint32_t at, int) {
            open.push_back(Edge{axis, at});
          });
        }
      }
  }
  void remove_edges() {
    std::vector<uint32_t> open;
    for (uint32_t first = 0; first < vertices.size(); ++first) {
      open.push_back(first);
      while (!open.empty()) {
        const uint32_t v = open.back();
        open.pop_back();
        Edge only = {0, 0};
        int n = 0;
        k.each_edge_at(v, [&](int d, uint32_t i) {
          if (edges[d][i]) only = Edge{d, i}, ++n;
        });
        if (!vertices[v] || n != 1 || is_kept(only)) continue;
        vertices[v] = false;
        edges[only.axis][only.at] = false;
        const uint32_t* const ends = &k.order[only.axis][only.at];
        open.push_back(ends[ends[0] == v ? 1 : 0]);
      }
    }
  }

  void check() const {
    for (uint32_t f = 0; f < faces.size(); ++f)
      require(!faces[f] || shores.is_kept(f), "K3", "a face remains:", f);
    for (int d = 0; d < 3; ++d)
      for (uint32_t i = 0; i < edges[d].size(); ++i)
        require(!edges[d][i] || is_kept(Edge{d, i}), "K3", "an edge remains, at vertex",
                k.order[d][i]);
    for (uint32_t v = 0; v < vertices.size(); ++v) {
      bool kept = false;
      k.each_edge_at(v, [&](int d, uint32_t i) { kept = kept || is_kept(Edge{d, i}); });
      require(!vertices[v] || kept, "K3", "a vertex remains:", v);
    }
  }
};

}  // namespace

void check_collapse(const Complex& k, const Shores& shores, const std::vector<int64_t>& collapses) {
  Remains r(k, shores);
  r.remove_cells(collapses);
  r.remove_faces();
  r.remove_edges();
  r.check();
}
