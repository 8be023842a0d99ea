// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_invalid_surface.cc: W7 to W9 of docs/certificates/dms-invalid.md, about the boundary of the domain.
#include "dms_invalid.h"

namespace {

bool has(const DmsFace& face, uint64_t vertex) {
  return std::find(face.vertex.begin(), face.vertex.end(), vertex) != face.vertex.end();
}
void check_edge(const DmsModel& model, const DmsFinding& f) {
  const uint64_t a = f.vertices[0], b = f.vertices[1];
  require(a < b, "W7", "the vertices do not ascend");
  uint64_t faces = 0;
  for (const DmsFace& face : model.faces) faces += has(face, a) && has(face, b);
  require(faces >= 3, "W7", "faces of the boundary have the edge:", faces);
}

// The fans are the connected parts of a graph: each face joins its two other vertices.
void check_fans(const DmsModel& model, const DmsFinding& f) {
  std::map<uint32_t, uint32_t> parent;
  const auto root = [&](uint32_t v) {
    uint32_t r = v;
    while (parent[r] != r) r = parent[r];
    while (parent[v] != r) {
      const uint32_t next = parent[v];
      parent[v] = r;
      v = next;
    }
    return r;
  };
  uint64_t fans = 0;
  for (const DmsFace& face : model.faces) {
    if (!has(face, f.vertices[0])) continue;
    std::vector<uint32_t> others;
    for (uint32_t v : face.vertex)
      if (v != f.vertices[0]) others.push_back(v);
    for (uint32_t v : others) fans += parent.emplace(v, v).second;
    const uint32_t a = root(others[0]), b = root(others[1]);
    fans -= a != b;
    parent[a] = b;
  }
  require(fans >= 2, "W8", "the fans at the vertex are", fans);
}

void check_faces_meet(const DmsModel& model, const DmsFinding& f) {
  const DmsFace* face[2];
  DmsPoint mean[2];
  for (size_t i = 0; i < 2; ++i) {
    const size_t at = place_in_boundary(model, f.faces[i]);
    require(at < model.faces.size(), "W9", "not of the boundary: face", i);
    face[i] = &model.faces[at];
    const std::array<uint32_t, 3>& v = face[i]->vertex;
    mean[i] = dms_mean({&model.place(v[0]), &model.place(v[1]), &model.place(v[2])},
                       &f.numbers[3 * i], "W9");
  }
  require(!have_equal_vertices(*face[0], *face[1]), "W9", "the two faces are one");
  require(dms_equal(mean[0], mean[1]), "W9", "the points differ");
  bool is_improper = false;
  for (size_t c = 0; c < 3; ++c)
    is_improper = is_improper || (f.numbers[c].n.sign() > 0 && !has(*face[1], face[0]->vertex[c]));
  require(is_improper, "W9", "the point lies in a vertex or an edge of both faces");
}

}  // namespace

size_t place_in_boundary(const DmsModel& model, const DmsNamedFace& face) {
  const auto is_before = [](const DmsFace& f, const DmsNamedFace& g) {
    return f.tetrahedron != g.tetrahedron ? f.tetrahedron < g.tetrahedron : f.number < g.number;
  };
  const auto at = std::lower_bound(model.faces.begin(), model.faces.end(), face, is_before);
  if (at == model.faces.end() || at->tetrahedron != face.tetrahedron || at->number != face.number)
    return model.faces.size();
  return size_t(at - model.faces.begin());
}
bool have_equal_vertices(const DmsFace& f, const DmsFace& g) {
  for (uint32_t v : f.vertex)
    if (!has(g, v)) return false;
  return true;
}

void check_dms_surface_of_domain(const DmsModel& model, const DmsFinding& f) {
  if (f.kind == kEdgeOverused) return check_edge(model, f);
  if (f.kind == kSeveralFans) return check_fans(model, f);
  check_faces_meet(model, f);
}
