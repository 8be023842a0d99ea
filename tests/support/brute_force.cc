// SPDX-License-Identifier: LGPL-3.0-or-later
#include "tests/support/brute_force.h"

#include <algorithm>
#include <deque>

#include "tests/support/exact_geometry.h"

namespace veritope::oracle {
namespace {

bool has_repeated_id(const std::array<std::uint32_t, 3>& f) { return f[0] == f[1] || f[1] == f[2] || f[0] == f[2]; }

Edge undirected(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

// The classes of `items` under the relation `touches`, each ascending, ordered by least item.
template <typename Touches>
std::vector<std::vector<std::uint32_t>> classes(const std::vector<std::uint32_t>& items, Touches neighbours) {
  std::set<std::uint32_t> left(items.begin(), items.end());
  std::vector<std::vector<std::uint32_t>> out;
  while (!left.empty()) {
    std::deque<std::uint32_t> queue{*left.begin()};
    left.erase(left.begin());
    std::vector<std::uint32_t> found;
    while (!queue.empty()) {
      const std::uint32_t x = queue.front();
      queue.pop_front();
      found.push_back(x);
      for (std::uint32_t y : neighbours(x))
        if (left.erase(y) != 0) queue.push_back(y);
    }
    std::sort(found.begin(), found.end());
    out.push_back(std::move(found));
  }
  return out;
}

std::vector<std::uint32_t> all_of(const BruteEdge& e) {
  std::vector<std::uint32_t> out = e.up;
  out.insert(out.end(), e.down.begin(), e.down.end());
  std::sort(out.begin(), out.end());
  return out;
}

bool boxes_apart(const TriangleMesh& mesh, std::uint32_t f, std::uint32_t g) {
  for (int k = 0; k < 3; ++k) {
    const auto range = [&](std::uint32_t face) {
      std::array<double, 3> c{};
      for (std::size_t i = 0; i < 3; ++i) c[i] = mesh.positions[mesh.faces[face][i]][k];
      std::sort(c.begin(), c.end());
      return c;
    };
    const auto a = range(f), b = range(g);
    if (a[2] < b[0] || b[2] < a[0]) return true;
  }
  return false;
}

}  // namespace

BruteTopology brute_topology(const Faces& faces) {
  BruteTopology out;
  std::vector<std::uint32_t> proper;
  std::map<std::uint32_t, std::vector<std::uint32_t>> faces_at;
  std::map<std::set<std::uint32_t>, std::uint32_t> first_with;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    if (has_repeated_id(faces[f])) {
      out.collapsed.push_back(f);
      continue;
    }
    proper.push_back(f);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = faces[f][i], b = faces[f][(i + 1) % 3];
      out.vertices.insert(a);
      faces_at[a].push_back(f);
      BruteEdge& e = out.edges[undirected(a, b)];
      (a < b ? e.up : e.down).push_back(f);
    }
    const auto [it, is_new] = first_with.try_emplace({faces[f].begin(), faces[f].end()}, f);
    if (!is_new) {
      ++out.duplicates;
      out.duplicate_pairs.emplace_back(it->second, f);
    }
  }
  std::set<std::uint32_t> irregular;
  for (const auto& [edge, e] : out.edges) {
    const std::size_t uses = e.up.size() + e.down.size();
    if (uses == 1) out.boundary.push_back(edge);
    if (uses > 2) out.nonmanifold.push_back(edge);
    if (uses == 2 && e.up.size() != 1)
      out.misoriented.emplace_back(edge, e.up.size() == 2 ? edge : Edge{edge.second, edge.first});
    if (e.up.size() != e.down.size()) out.is_cycle = false;
    if (e.up.size() != 1 || e.down.size() != 1) {
      irregular.insert(edge.first);
      irregular.insert(edge.second);
    }
  }
  for (const auto& [v, around] : faces_at) {
    const auto neighbours = [&, centre = v](std::uint32_t f) {
      std::vector<std::uint32_t> n;
      for (std::uint32_t w : faces[f])
        if (w != centre)
          for (std::uint32_t g : all_of(out.edges.at(undirected(centre, w)))) n.push_back(g);
      return n;
    };
    out.fans[v] = classes(around, neighbours);
    if (out.fans[v].size() > 1) {
      out.pinched.push_back(v);
      irregular.insert(v);
    }
  }
  out.irregular.assign(irregular.begin(), irregular.end());
  out.shells = classes(proper, [&](std::uint32_t f) {
    std::vector<std::uint32_t> n;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::uint32_t g : all_of(out.edges.at(undirected(faces[f][i], faces[f][(i + 1) % 3])))) n.push_back(g);
    return n;
  });
  return out;
}

std::vector<std::uint32_t> brute_degenerate(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    if (has_repeated_id(mesh.faces[f]) || is_zero(normal_of(rational_triangle(mesh, f)))) out.push_back(f);
  return out;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> brute_improper(const TriangleMesh& mesh) {
  const auto degenerate = brute_degenerate(mesh);
  const auto skip = [&](std::uint32_t f) { return std::binary_search(degenerate.begin(), degenerate.end(), f); };
  std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    for (std::uint32_t g = f + 1; g < mesh.faces.size(); ++g)
      if (!skip(f) && !skip(g) && !boxes_apart(mesh, f, g) && meet_improperly(mesh, f, g)) out.emplace_back(f, g);
  return out;
}

BruteDecision brute_decide(const TriangleMesh& mesh, std::uint64_t seed) {
  Random random(seed);
  BruteDecision out;
  out.topology = brute_topology(mesh.faces);
  const BruteTopology& t = out.topology;
  out.degenerate = brute_degenerate(mesh);
  out.improper = brute_improper(mesh);
  out.rules = {out.degenerate.size(), t.duplicates,       t.boundary.size(), t.nonmanifold.size(), t.misoriented.size(),
               t.pinched.size(),      out.improper.size(), 0,                 0};
  if (t.is_cycle && !t.shells.empty()) {
    out.volumes.emplace();
    for (const auto& shell : t.shells) out.volumes->push_back(signed_volume(mesh, shell));
  }
  bool surface_holds = true;
  for (std::size_t i = 0; i < 6; ++i) surface_holds = surface_holds && out.rules[i] == 0;
  if (surface_holds) {
    std::int64_t genus = 0;
    for (const auto& shell : t.shells) {
      std::set<std::uint32_t> vertices;
      for (std::uint32_t f : shell) vertices.insert(mesh.faces[f].begin(), mesh.faces[f].end());
      genus += 2 - (static_cast<std::int64_t>(vertices.size()) - static_cast<std::int64_t>(shell.size() / 2));
    }
    out.genus = genus / 2;
  }
  if (surface_holds && out.improper.empty()) {
    out.depths.emplace();
    out.bodies = 0;
    for (std::size_t s = 0; s < t.shells.size(); ++s) {
      const RVec p = rational(mesh.positions[mesh.faces[t.shells[s][0]][0]]);
      std::uint32_t depth = 0;
      for (std::size_t r = 0; r < t.shells.size(); ++r)
        if (r != s && winding_number(mesh, t.shells[r], p, random) != 0) ++depth;
      out.depths->push_back(depth);
      *out.bodies += depth % 2 == 0;
      if ((sgn((*out.volumes)[s]) > 0) != (depth % 2 == 0)) ++out.rules[depth == 0 ? 7 : 8];
    }
  }
  out.is_valid = true;
  for (std::uint64_t n : out.rules) out.is_valid = out.is_valid && n == 0;
  return out;
}

}  // namespace veritope::oracle
