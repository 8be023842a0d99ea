// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/open_edges.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "robust/base/disjoint_sets.h"
#include "robust/base/parallel.h"
#include "solids/polyhedron/chunk_internal.h"

namespace veritope {

namespace {

// Borders, each named by one of its vertices.
class Borders {
 public:
  Borders(const TriangleMesh& mesh, std::span<const OpenEdge> edges)
      : edges_(edges), vertices_(mesh.positions.size()) {
    for (const OpenEdge& e : edges) vertices_.join(e.a, e.b);
  }

  void count(const std::vector<NearestEdge>& nearest, OpenEdges& out) {
    enum : std::uint8_t { kNoBorder, kHole, kCrack };
    std::vector<std::uint8_t> kind(vertices_.size(), kNoBorder);
    for (const OpenEdge& e : edges_) kind[vertices_.find(e.a)] = kHole;
    for (std::size_t i = 0; i < edges_.size(); ++i)
      if (nearest[i].is_near)
        for (const std::size_t j : {i, std::size_t{nearest[i].edge}})
          kind[vertices_.find(edges_[j].a)] = kCrack;
    for (const std::uint8_t k : kind) {
      out.borders += k != kNoBorder;
      out.holes += k == kHole;
    }
  }

 private:
  std::span<const OpenEdge> edges_;
  DisjointSets<> vertices_;
};

void count_edges(std::span<const EdgeEnds> ends, OpenEdges& out) {
  std::optional<std::size_t> least, greatest;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const NearestEdge& n = out.nearest[i];
    out.unsearched_edges += !n.is_searched;
    if (!n.is_near) continue;
    ++out.near_edges;
    out.touching_edges += n.is_touching;
    if (!least || n.gap.hi() < out.nearest[*least].gap.lo()) least = i;
    if (!greatest || n.gap.lo() > out.nearest[*greatest].gap.hi()) greatest = i;
  }
  const auto gap = [&](std::size_t i) {
    return nearest_root(squared_gap(ends[i], ends[out.nearest[i].edge]));
  };
  if (least) out.least_gap = gap(*least);
  if (greatest) out.greatest_gap = gap(*greatest);
}

// A side of a face at a vertex: the vertex at its other end, and whether the face runs away from the first one.
struct HalfEdge {
  std::uint32_t other, face;
  bool is_outgoing;
};

void add_open_edges(const TriangleMesh& mesh, const Incidence& incidence, std::uint32_t v,
                    std::vector<HalfEdge>& sides, std::vector<OpenEdge>& out) {
  sides.clear();
  for (const std::uint32_t corner : incidence.corners(v)) {
    const std::uint32_t face = corner_face(corner), k = corner_index(corner);
    const auto& t = mesh.faces[face];
    const std::uint32_t next = t[(k + 1) % 3], last = t[(k + 2) % 3];
    if (next > v) sides.push_back({next, face, true});
    if (last > v) sides.push_back({last, face, false});
  }
  std::sort(sides.begin(), sides.end(),
            [](const HalfEdge& x, const HalfEdge& y) { return x.other < y.other; });
  for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
    for (j = i + 1; j < sides.size() && sides[j].other == sides[i].other;) ++j;
    const HalfEdge& s = sides[i];
    if (j == i + 1)
      out.push_back({s.is_outgoing ? v : s.other, s.is_outgoing ? s.other : v, s.face});
  }
}

}  // namespace

std::vector<OpenEdge> list_open_edges(const TriangleMesh& mesh, const Incidence& incidence,
                                      unsigned jobs) {
  const std::size_t num_vertices = incidence.num_vertices();
  std::vector<std::vector<OpenEdge>> parts(num_chunks(num_vertices, internal::kChunk));
  parallel_for(num_vertices, internal::kChunk, jobs,
               [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                 std::vector<HalfEdge> sides;
                 for (std::size_t v = begin; v < end; ++v)
                   add_open_edges(mesh, incidence, static_cast<std::uint32_t>(v), sides,
                                  parts[chunk]);
               });
  std::vector<OpenEdge> out;
  for (const auto& part : parts) out.insert(out.end(), part.begin(), part.end());
  return out;
}

std::uint32_t search_steps(std::size_t num_edges) {
  constexpr std::size_t kLeast = 256, kMost = 1 << 20, kMostInAll = 1 << 25;
  const std::size_t share = kMostInAll / std::max<std::size_t>(num_edges, 1);
  return static_cast<std::uint32_t>(std::clamp(share, kLeast, kMost));
}

OpenEdges analyse_open_edges(const TriangleMesh& mesh, std::span<const OpenEdge> edges,
                             unsigned jobs) {
  std::vector<EdgeEnds> ends(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) ends[i] = ends_of(mesh, edges[i]);
  OpenEdges out;
  out.nearest = find_nearest_edges(ends, jobs, search_steps(edges.size()));
  Borders(mesh, edges).count(out.nearest, out);
  count_edges(ends, out);
  return out;
}

}  // namespace veritope
