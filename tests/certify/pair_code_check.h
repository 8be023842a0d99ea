// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/certify/pair_code_check.h: all pairs of triangles with corners in a small grid that meet properly, and their codes.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "predicates/triangle_triangle.h"
#include "robust/base/random.h"
#include "tests/certify/pair_code_oracle.h"
#include "verify/certify/pair_codes.h"

namespace veritope {

/// The points {0..nx-1} x {0..ny-1} x {0..nz-1} as vertices, all non-degenerate triangles on them as facets.
struct GridTriangles {
  GridTriangles(int nx, int ny, int nz) {
    for (int x = 0; x < nx; ++x)
      for (int y = 0; y < ny; ++y)
        for (int z = 0; z < nz; ++z) {
          points.push_back({x, y, z});
          mesh.positions.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
        }
    const auto n = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t a = 0; a < n; ++a)
      for (std::uint32_t b = a + 1; b < n; ++b)
        for (std::uint32_t c = b + 1; c < n; ++c)
          if (!oracle::is_null(oracle::outer(oracle::difference(points[b], points[a]), oracle::difference(points[c], points[a]))))
            mesh.faces.push_back({a, b, c});
  }
  oracle::NamedTriangle<std::int64_t> named(std::size_t f) const {
    const auto& t = mesh.faces[f];
    return {{points[t[0]], points[t[1]], points[t[2]]}, t};
  }
  IndexedTriangle indexed(std::size_t f) const {
    const auto& t = mesh.faces[f];
    return {{mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]}, t};
  }
  std::string text(std::size_t f) const {
    std::string out = "tri";
    for (std::uint32_t v : mesh.faces[f]) {
      const auto& p = points[v];
      out += " " + std::to_string(p[0]) + "," + std::to_string(p[1]) + "," + std::to_string(p[2]);
    }
    return out;
  }

  std::vector<oracle::Point<std::int64_t>> points;
  TriangleMesh mesh;
};

struct PairCodeTally {
  long pairs = 0, proper = 0;
  long longest = 0;  ///< bytes
};

/// The codes of one pair: there are some, they hold by the page, and none is left over. False (and a failure) if not.
inline bool expect_codes(const GridTriangles& grid, std::size_t f, std::size_t g, PairCodeTally& tally) {
  ++tally.pairs;
  if (!is_proper(triangle_triangle(grid.indexed(f), grid.indexed(g)))) return true;
  ++tally.proper;
  const auto codes = find_pair_codes(grid.mesh, static_cast<std::uint32_t>(f), static_cast<std::uint32_t>(g));
  tally.longest = std::max(tally.longest, static_cast<long>(codes.size()));
  std::span<const std::uint8_t> left(codes);
  const std::string why = codes.empty() ? "no codes" : oracle::judge_codes(grid.named(f), grid.named(g), left);
  if (why.empty() && left.empty()) return true;
  ADD_FAILURE() << (why.empty() ? "codes are left over" : why) << ": " << grid.text(f) << " ; " << grid.text(g);
  return false;
}

/// Ordered pairs, each with probability `part`.
inline PairCodeTally expect_codes_on_grid(int nx, int ny, int nz, double part, std::uint64_t seed = 1) {
  GridTriangles grid(nx, ny, nz);
  Random random(seed);
  for (auto& t : grid.mesh.faces)
    for (int i = 0; i < 2; ++i) std::swap(t[random.below(3)], t[random.below(3)]);  // corners in any order
  PairCodeTally tally;
  for (std::size_t f = 0; f < grid.mesh.faces.size(); ++f)
    for (std::size_t g = 0; g < grid.mesh.faces.size(); ++g)
      if (f != g && (part >= 1 || random.unit() < part) && !expect_codes(grid, f, g, tally)) return tally;
  return tally;
}

}  // namespace veritope
