// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/predicates/grid_pairs.h: triangle_triangle against clipping, on all pairs of triangles with
// corners on a small grid and all ways to share names.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "tests/predicates/triangle_triangle_oracle.h"

namespace veritope::oracle {

inline std::string text(const ITriangle& t) {
  std::string out;
  for (const IPoint& p : t) {
    out +=
        "(" + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + ") ";
  }
  return out;
}

/// Every stride-th pair (i, j), i <= j, of the nx * ny * nz grid's triangles.
inline void compare_on_grid(int nx, int ny, int nz, std::size_t stride) {
  std::vector<IPoint> grid;
  for (int x = 0; x < nx; ++x) {
    for (int y = 0; y < ny; ++y) {
      for (int z = 0; z < nz; ++z) grid.push_back({x, y, z});
    }
  }
  std::vector<ITriangle> triangles;
  for (std::size_t a = 0; a < grid.size(); ++a) {
    for (std::size_t b = a + 1; b < grid.size(); ++b) {
      for (std::size_t c = b + 1; c < grid.size(); ++c) {
        const ITriangle t{grid[a], grid[b], grid[c]};
        if (!degenerate(t)) triangles.push_back(t);
      }
    }
  }
  const Ids t_ids{0, 1, 2};
  std::array<long, 6> seen{};
  std::size_t turn = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t j = i; j < triangles.size(); ++j) {
      if (turn++ % stride != 0) continue;
      ITriangle t = triangles[i], u = triangles[j];
      // Turn the corners about, differently from pair to pair.
      if (turn % 2 != 0) std::swap(t[0], t[1]);
      if (turn % 3 == 0) std::swap(u[1], u[2]);
      for_all_names(t, u, [&](const Ids& u_ids) {
        const TriangleContact c = classify(t, t_ids, u, u_ids);
        ++seen[static_cast<std::size_t>(c)];
        const IndexedTriangle a = indexed(t, t_ids), b = indexed(u, u_ids);
        EXPECT_EQ(triangle_triangle(a, b), c)
            << text(t) << "| " << text(u) << u_ids[0] << u_ids[1] << u_ids[2];
        EXPECT_EQ(triangle_triangle(b, a), c)
            << text(u) << "| " << text(t) << u_ids[0] << u_ids[1] << u_ids[2];
      });
      if (testing::Test::HasFailure()) return;
    }
  }
  for (std::size_t c = 0; c < 6; ++c) {
    const bool flat = nx == 1 || ny == 1 || nz == 1;
    const bool possible = !flat || c != static_cast<std::size_t>(TriangleContact::kImproper);
    EXPECT_TRUE(!possible || seen[c] > 0) << "contact " << c;
  }
}

}  // namespace veritope::oracle
