// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/page_star.h: condition V7 in the words of docs/certificates/mesh.md section 4, in rationals.
#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "tests/support/exact_geometry.h"

namespace veritope::oracle {

/// Directions 1..13 of section 3, copied from the page.
inline constexpr std::array<std::array<std::int32_t, 3>, 13> kPageDirections{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, -1, 0},
                                                                             {1, 0, 1}, {1, 0, -1}, {0, 1, 1}, {0, 1, -1}, {1, 1, 1},
                                                                             {1, 1, -1}, {1, -1, 1}, {1, -1, -1}}};

/// Empty if (a) and (b) hold at v with direction d; otherwise the one that fails.
inline std::string judge_star(const TriangleMesh& mesh, std::uint32_t v, const std::array<std::int32_t, 3>& d) {
  if (d == std::array<std::int32_t, 3>{0, 0, 0}) return "d is 0";
  const RVec e{Rational(d[0]), Rational(d[1]), Rational(d[2])};
  const bool steep = d[1] != 0 || d[2] != 0;
  const RVec g = steep ? RVec{Rational(0), Rational(d[2]), Rational(-std::int64_t{d[1]})} : RVec{Rational(0), Rational(0), Rational(1)};
  int s = 0, turns = 0, referenced = 0;
  for (const auto& f : mesh.faces)
    for (std::size_t k = 0; k < 3; ++k) {
      if (f[k] != v) continue;
      ++referenced;
      const RVec at = rational(mesh.positions[v]);
      RVec p = rational(mesh.positions[f[(k + 1) % 3]]), q = rational(mesh.positions[f[(k + 2) % 3]]);
      const int side = sgn(dot(cross(p - at, q - at), e));
      if (side == 0 || (s != 0 && side != s)) return "(a) the normals do not look the same way along d";
      s = side;
      if (s < 0) std::swap(p, q);
      turns += sgn(dot(g, p - at)) >= 0 && sgn(dot(g, q - at)) < 0;
    }
  if (referenced == 0) return "v is not referenced";
  return turns == 1 ? "" : "(b) they turn " + std::to_string(turns) + " times";
}

}  // namespace veritope::oracle
