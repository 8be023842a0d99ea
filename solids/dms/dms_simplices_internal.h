// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_simplices_internal.h: the vertices, edges, triangles and tetrahedra of a domain as sets of vertices.
// Each multiset of vertices of a tetrahedron belongs to one of them.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "topology/tetrahedral_complex.h"

namespace veritope::internal {

// The sets of one to four vertices of the tetrahedra, ascending and unique.
struct DmsSimplices {
  std::vector<std::array<std::uint32_t, 1>> vertices;
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 4>> tetrahedra;

  explicit DmsSimplices(const std::vector<TetrahedronCorners>& all) {
    for (TetrahedronCorners t : all) {
      std::sort(t.begin(), t.end());
      tetrahedra.push_back(t);
      for (std::size_t a = 0; a < 4; ++a) {
        vertices.push_back({t[a]});
        for (std::size_t b = a + 1; b < 4; ++b) {
          edges.push_back({t[a], t[b]});
          for (std::size_t c = b + 1; c < 4; ++c) triangles.push_back({t[a], t[b], t[c]});
        }
      }
    }
    const auto unique = [](auto& list) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    };
    unique(vertices), unique(edges), unique(triangles), unique(tetrahedra);
  }
  // Multisets of n vertices of one tetrahedron: those that have all vertices of a simplex, for each simplex.
  std::uint64_t num_multisets(int n) const {
    const auto m = static_cast<std::uint64_t>(n - 1);
    const std::uint64_t pairs = m * (m - 1) / 2,
                        triples = pairs * (m - 2) / 3;  // of m; 0 if m is less
    return vertices.size() + edges.size() * m + triangles.size() * pairs +
           tetrahedra.size() * triples;
  }
  bool contains(std::span<const std::uint32_t> ascending) const {
    std::array<std::uint32_t, 4> set{};
    std::size_t count = 0;
    for (const std::uint32_t v : ascending) {
      if (count > 0 && set[count - 1] == v) continue;
      if (count == 4) return false;
      set[count++] = v;
    }
    const auto has = [&](const auto& list) {
      typename std::decay_t<decltype(list)>::value_type key{};
      std::copy_n(set.begin(), key.size(), key.begin());
      return std::binary_search(list.begin(), list.end(), key);
    };
    switch (count) {
      case 1: return has(vertices);
      case 2: return has(edges);
      case 3: return has(triangles);
      default: return has(tetrahedra);
    }
  }
};

}  // namespace veritope::internal
