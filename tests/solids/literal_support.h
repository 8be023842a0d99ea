// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/literal_support.h: small models for the literal chain.
#pragma once
#include <array>
#include <map>
#include <vector>

#include "solids/patches/patch.h"
#include "splines/bezier_triangle.h"
#include "splines/pn_triangle.h"

namespace veritope::literal {

using Patches = std::vector<Patch>;
using Heights = std::map<std::array<int, 3>, Rational>;  // Bernstein coefficients, by their indices

inline Rational fraction(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

/// The map over a triangle whose z differs from that of the flat triangle by these coefficients.
inline Patch over(const std::array<PatchPoint, 3>& corners, int degree, const Heights& heights) {
  Patch::Triangle map(degree, 3, false);
  for_each_triangle_index(degree, [&](int i, int j, int k) {
    for (std::size_t c = 0; c < 3; ++c)
      map.component(static_cast<int>(c))[triangle_index(j, k)] =
          (Rational(i) * corners[0][c] + Rational(j) * corners[1][c] +
           Rational(k) * corners[2][c]) /
          Rational(degree);
    const auto h = heights.find({i, j, k});
    if (h != heights.end()) map.component(2)[triangle_index(j, k)] += h->second;
  });
  return make_patch(std::move(map)).value();
}

/// A tetrahedron whose face over (0,0,0), (1,0,0), (0,1,0), seen from above, is the map with these heights; its apex is
/// below. The other faces are flat, so that heights on the sides must be 0.
inline Patches tetrahedron_with(const Heights& heights, int degree = 1,
                                const PatchPoint& apex = {fraction(1, 4), fraction(1, 5), -2}) {
  const PatchPoint a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  return {over({a, b, c}, degree, heights), over({b, a, apex}, degree, {}),
          over({c, b, apex}, degree, {}), over({a, c, apex}, degree, {})};
}

inline Patches pn_solid(const std::vector<PatchPoint>& points,
                        const std::vector<std::array<std::size_t, 3>>& faces) {
  Patches out;
  for (const auto& f : faces) {
    const std::array<PnPoint, 3> corners{points[f[0]], points[f[1]], points[f[2]]};
    out.push_back(make_patch(make_pn_triangle(corners, corners).value().points).value());
  }
  return out;
}
/// PN triangles with the normal of each vertex along its position.
inline Patches pn_octahedron() {
  return pn_solid(
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
      {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2}, {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}});
}
inline Patches pn_tetrahedron() {
  return pn_solid({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                  {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
}

}  // namespace veritope::literal
