// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/decision_laws.h: what every decision must satisfy: M7 agrees with a test of all pairs one by
// one.
#pragma once
#include <cstdio>
#include <cstdlib>
#include <string>

#include "predicates/triangle_triangle.h"
#include "solids/polyhedron/validity.h"
#include "tests/support/report_text.h"
#include "tests/support/shapes.h"

namespace veritope::fuzz {

[[noreturn]] inline void fail(const std::string& what, const TriangleMesh& mesh) {
  std::fprintf(stderr, "%s\n%s\n", what.c_str(), shapes::to_text(mesh).c_str());
  std::abort();
}

/// The number of pairs of facets that meet outside their common simplex, found without boxes, stars
/// or separators.
inline std::uint64_t improper_pairs_one_by_one(const TriangleMesh& mesh) {
  const auto signs = facet_signs(mesh, 1);
  const auto indexed = [&](std::size_t f) {
    const auto& t = mesh.faces[f];
    return IndexedTriangle{{mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]}, t};
  };
  std::uint64_t count = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (std::size_t g = f + 1; g < mesh.faces.size(); ++g)
      count += signs.signs[f] != 0 && signs.signs[g] != 0 && !is_proper(triangle_triangle(indexed(f), indexed(g)));
  return count;
}

inline void check_decision(const TriangleMesh& mesh, const ValidityReport& report) {
  const std::uint64_t pairs = improper_pairs_one_by_one(mesh);
  if (report.counts.selfint_pairs != pairs)
    fail("M7: " + std::to_string(report.counts.selfint_pairs) + ", pair by pair " + std::to_string(pairs), mesh);
}

}  // namespace veritope::fuzz
