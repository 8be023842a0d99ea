// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/surface.h"

#include <algorithm>
#include <atomic>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "robust/base/disjoint_sets.h"
#include "robust/base/parallel.h"
#include "topology/vertex_link.h"

namespace veritope {
namespace {

using Faces = std::span<const std::array<std::uint32_t, 3>>;

constexpr std::size_t kChunk = 1 << 12;

// What one block of vertices contributes; blocks are joined in order.
struct VertexBlock {
  std::uint64_t vertices = 0, edges = 0, boundary = 0, nonmanifold = 0, misoriented = 0, pinched = 0;
  bool is_cycle = true;
  std::vector<EdgeDefect> boundary_list, nonmanifold_list, misoriented_list;
  std::vector<VertexDefect> pinched_list;
  std::vector<std::uint32_t> irregular;  // vertices that are not one closed fan
};

struct EdgeTally {
  std::size_t first = 0, last = 0;  // range of uses
  std::size_t out = 0, in = 0;
};

EdgeDefect edge_defect(std::uint32_t v, std::span<const internal::EdgeUse> uses,
                       std::span<const std::uint32_t> corners, bool directed) {
  EdgeDefect d{v, uses[0].other, {}};
  if (directed && !uses[0].outgoing) std::swap(d.a, d.b);
  for (const auto& u : uses) d.faces.push_back(corner_face(corners[u.corner]));
  return d;
}

// Judges the edges {v, w}, w > v, so that each edge is judged once.
void judge_edges(std::uint32_t v, std::span<const std::uint32_t> corners,
                 const std::vector<internal::EdgeUse>& uses, std::size_t max_listed, VertexBlock& out) {
  for (std::size_t i = 0, j = 0; i < uses.size(); i = j) {
    std::size_t outgoing = 0;
    for (j = i; j < uses.size() && uses[j].other == uses[i].other; ++j) outgoing += uses[j].outgoing;
    const std::size_t n = j - i;
    out.is_cycle = out.is_cycle && 2 * outgoing == n;
    if (uses[i].other < v) continue;
    ++out.edges;
    const std::span<const internal::EdgeUse> range{uses.data() + i, n};
    const auto list = [&](std::uint64_t& count, std::vector<EdgeDefect>& defects, bool directed) {
      if (count++ < max_listed) defects.push_back(edge_defect(v, range, corners, directed));
    };
    if (n == 1) list(out.boundary, out.boundary_list, false);
    if (n > 2) list(out.nonmanifold, out.nonmanifold_list, false);
    if (n == 2 && outgoing != 1) list(out.misoriented, out.misoriented_list, true);
  }
}

void judge_irregular_vertex(Faces faces, std::span<const std::uint32_t> corners, std::uint32_t v,
                            std::size_t max_listed, VertexBlock& out) {
  out.irregular.push_back(v);
  const auto uses = internal::edge_uses(faces, corners);
  judge_edges(v, corners, uses, max_listed, out);
  const auto fan = internal::fans_of_corners(uses, corners.size());
  const std::uint32_t fans = 1 + *std::max_element(fan.begin(), fan.end());
  if (fans == 1) return;
  if (out.pinched++ >= max_listed) return;
  VertexDefect d{v, fans, std::vector<std::uint32_t>(fans, 0)};
  for (std::size_t i = fan.size(); i-- > 0;) d.faces[fan[i]] = corner_face(corners[i]);
  out.pinched_list.push_back(std::move(d));
}

VertexBlock judge_block(Faces faces, const Incidence& incidence, std::uint32_t begin, std::uint32_t end,
                        std::size_t max_listed) {
  VertexBlock out;
  internal::FanWalker walker(incidence.num_vertices());
  for (std::uint32_t v = begin; v < end; ++v) {
    const auto corners = incidence.corners(v);
    if (corners.empty()) continue;
    ++out.vertices;
    if (!walker.is_closed_fan(faces, corners, v, out.edges))
      judge_irregular_vertex(faces, corners, v, max_listed, out);
  }
  return out;
}

template <typename T>
void append(std::vector<T>& to, std::vector<T>& from, std::size_t max_listed) {
  for (auto& d : from) {
    if (to.size() >= max_listed) return;
    to.push_back(std::move(d));
  }
}

std::vector<std::uint32_t> collapsed_faces(Faces faces, unsigned jobs) {
  std::vector<std::vector<std::uint32_t>> parts(num_chunks(faces.size(), kChunk));
  parallel_for(faces.size(), kChunk, jobs, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
      if (is_collapsed(faces[f])) parts[chunk].push_back(static_cast<std::uint32_t>(f));
  });
  std::vector<std::uint32_t> out;
  for (const auto& p : parts) out.insert(out.end(), p.begin(), p.end());
  return out;
}

// The fans as nodes: a regular vertex is its own node, an irregular one has a node a fan behind all vertices.
struct FanNodes {
  std::span<const std::uint32_t> irregular;                // ascending
  std::vector<std::vector<std::uint32_t>> node_of_corner;  // for each irregular vertex
  std::vector<bool> is_irregular;
  std::size_t count = 0;

  std::uint32_t node(const Incidence& incidence, std::uint32_t v, std::uint32_t corner) const {
    if (irregular.empty() || !is_irregular[v]) return v;
    const auto i = static_cast<std::size_t>(
        std::lower_bound(irregular.begin(), irregular.end(), v) - irregular.begin());
    const auto corners = incidence.corners(v);
    const auto k = std::lower_bound(corners.begin(), corners.end(), corner) - corners.begin();
    return node_of_corner[i][static_cast<std::size_t>(k)];
  }
};

FanNodes number_fans(Faces faces, const Incidence& incidence, std::span<const std::uint32_t> irregular) {
  FanNodes out;
  out.count = incidence.num_vertices();
  out.irregular = irregular;
  if (out.irregular.empty()) return out;
  out.is_irregular.resize(incidence.num_vertices());
  for (std::uint32_t v : out.irregular) {
    out.is_irregular[v] = true;
    const auto corners = incidence.corners(v);
    auto fan = internal::fans_of_corners(internal::edge_uses(faces, corners), corners.size());
    const std::size_t first = out.count;
    for (auto& f : fan) {
      out.count = std::max(out.count, first + f + 1);
      f += static_cast<std::uint32_t>(first);
    }
    out.node_of_corner.push_back(std::move(fan));
  }
  VT_CHECK(out.count < 0xffffffffu, "more fans than 32 bits can number");
  return out;
}

void connect_faces(Faces faces, const Incidence& incidence, const FanNodes& fans,
                   ConcurrentDisjointSets& sets, std::size_t begin, std::size_t end) {
  for (std::size_t f = begin; f < end; ++f) {
    const auto& t = faces[f];
    if (is_collapsed(t)) continue;
    const auto c = static_cast<std::uint32_t>(4 * f);
    const std::uint32_t n0 = fans.node(incidence, t[0], c);
    sets.join(n0, fans.node(incidence, t[1], c + 1));
    sets.join(n0, fans.node(incidence, t[2], c + 2));
  }
}

// Handles the usual case that every face is in one component; returns false otherwise.
bool is_one_shell(Faces faces, const FanNodes& fans, ConcurrentDisjointSets& sets, unsigned jobs,
                  SurfaceTopology& out) {
  if (faces.empty() || !out.collapsed.empty() || !fans.irregular.empty()) return false;
  const std::uint32_t root = sets.find(faces[0][0]);
  std::atomic<bool> one{true};
  parallel_for(faces.size(), kChunk, jobs, [&](std::size_t, std::size_t begin, std::size_t end) {
    bool same = true;
    for (std::size_t f = begin; f < end; ++f) {
      same = same && sets.find(faces[f][0]) == root;
      out.shell_of_face[f] = 0;
    }
    if (!same) one.store(false, std::memory_order_relaxed);
  });
  if (one.load()) out.shells.push_back({0, out.vertices, out.edges, out.faces});
  return one.load();
}

void number_shells(Faces faces, const Incidence& incidence, const FanNodes& fans,
                   ConcurrentDisjointSets& sets, SurfaceTopology& out) {
  std::vector<std::uint32_t> shell_of_root(sets.size(), SurfaceTopology::kNoShell);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (is_collapsed(faces[f])) {
      out.shell_of_face[f] = SurfaceTopology::kNoShell;
      continue;
    }
    const std::uint32_t root = sets.find(fans.node(incidence, faces[f][0], static_cast<std::uint32_t>(4 * f)));
    std::uint32_t& s = shell_of_root[root];
    if (s == SurfaceTopology::kNoShell) {
      s = static_cast<std::uint32_t>(out.shells.size());
      out.shells.push_back({static_cast<std::uint32_t>(f), 0, 0, 0});
    }
    out.shell_of_face[f] = s;
    ++out.shells[s].faces;
  }
}

// Shells share no edge, but may share a vertex: it counts in each.
void count_shell_cells(Faces faces, const Incidence& incidence, SurfaceTopology& out) {
  if (out.shells.size() == 1) {
    out.shells[0].vertices = out.vertices;
    out.shells[0].edges = out.edges;
    return;
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;  // a shell at v, the other end of one of its edges there
  for (std::uint32_t v = 0; v < incidence.num_vertices(); ++v) {
    ends.clear();
    for (std::uint32_t c : incidence.corners(v)) {
      const std::uint32_t f = corner_face(c), k = corner_index(c);
      ends.emplace_back(out.shell_of_face[f], faces[f][(k + 1) % 3]);
      ends.emplace_back(out.shell_of_face[f], faces[f][(k + 2) % 3]);
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const auto& [shell, end] = ends[i];
      if (i == 0 || ends[i - 1].first != shell) ++out.shells[shell].vertices;
      if (end > v) ++out.shells[shell].edges;
    }
  }
}

}  // namespace

SurfaceTopology analyse_surface(Faces faces, const Incidence& incidence, std::size_t max_listed,
                                unsigned jobs) {
  const std::uint32_t num_vertices = incidence.num_vertices();
  const std::size_t blocks = jobs == 0 ? 1 : jobs;
  std::vector<VertexBlock> parts(blocks);
  const auto cut = [&](std::uint64_t n, std::size_t j) { return n * j / blocks; };
  parallel_for(blocks, 1, jobs, [&](std::size_t j, std::size_t, std::size_t) {
    parts[j] = judge_block(faces, incidence, static_cast<std::uint32_t>(cut(num_vertices, j)),
                           static_cast<std::uint32_t>(cut(num_vertices, j + 1)), max_listed);
  });
  SurfaceTopology out;
  out.is_cycle = true;
  for (auto& p : parts) {
    out.vertices += p.vertices;
    out.edges += p.edges;
    out.boundary_edges += p.boundary;
    out.nonmanifold_edges += p.nonmanifold;
    out.misoriented_edges += p.misoriented;
    out.nonmanifold_vertices += p.pinched;
    out.is_cycle = out.is_cycle && p.is_cycle;
    append(out.boundary, p.boundary_list, max_listed);
    append(out.nonmanifold, p.nonmanifold_list, max_listed);
    append(out.misoriented, p.misoriented_list, max_listed);
    append(out.pinched, p.pinched_list, max_listed);
    out.irregular.insert(out.irregular.end(), p.irregular.begin(), p.irregular.end());
  }
  out.collapsed = collapsed_faces(faces, jobs);
  out.faces = faces.size() - out.collapsed.size();

  const FanNodes fans = number_fans(faces, incidence, out.irregular);
  ConcurrentDisjointSets sets(fans.count);
  parallel_for(blocks, 1, jobs, [&](std::size_t j, std::size_t, std::size_t) {
    sets.reset(cut(fans.count, j), cut(fans.count, j + 1));
  });
  parallel_for(blocks, 1, jobs, [&](std::size_t j, std::size_t, std::size_t) {
    connect_faces(faces, incidence, fans, sets, cut(faces.size(), j), cut(faces.size(), j + 1));
  });
  out.shell_of_face = Buffer<std::uint32_t>(faces.size());
  if (!is_one_shell(faces, fans, sets, jobs, out)) {
    number_shells(faces, incidence, fans, sets, out);
    count_shell_cells(faces, incidence, out);
  }
  return out;
}

}  // namespace veritope
