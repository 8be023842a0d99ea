// SPDX-License-Identifier: LGPL-3.0-or-later
// decide_validity against brute force: maps of edges, breadth-first search, all pairs by rational clipping, rational rays.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/predicates/test_scale.h"
#include "tests/solids/decision_check.h"

namespace veritope {
namespace {

template <typename Make>
void agree(long loops, Make make) {
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(loops)); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    expect_as_brute_force(make(random), static_cast<unsigned>(1 + seed % 3), seed % 7);
    if (::testing::Test::HasFailure()) return;
  }
}

int any(Random& random, int low, int high) { return static_cast<int>(random.between(low, high)); }

// PROVES MESH-1
TEST(ValidityDiff, OnGridSoups) {
  agree(250, [](Random& r) { return shapes::grid_soup(r, any(r, 1, 24), any(r, 2, 4)); });
}

TEST(ValidityDiff, OnRandomIds) {
  agree(250, [](Random& r) { return shapes::random_indexed(r, any(r, 1, 24), any(r, 3, 12), any(r, 2, 5)); });
}

TEST(ValidityDiff, OnPolycubes) {
  agree(120, [](Random& r) { return shapes::random_polycube(r, any(r, 2, 3), any(r, 1, 12)); });
}

TEST(ValidityDiff, OnPolycubesWhoseShellsHaveVerticesOfTheirOwn) {
  agree(60, [](Random& r) {  // contacts of all kinds without a common vertex
    const TriangleMesh a = shapes::random_polycube(r, 2, any(r, 1, 4));
    return shapes::joined(a, shapes::moved(shapes::random_polycube(r, 2, any(r, 1, 4)), {0.5 * any(r, -2, 5), 0.5 * any(r, -2, 5), 0.5 * any(r, 0, 4)}));
  });
}

TEST(ValidityDiff, OnStarPolyhedraWithOneMovedVertex) {
  agree(60, [](Random& r) {
    TriangleMesh mesh = shapes::star_polyhedron(r, 2);
    Vec3d& p = mesh.positions[r.below(mesh.positions.size())];
    if (r.below(4) != 0) p = {p.x * 0.125 * any(r, -4, 12), p.y * 0.125 * any(r, -4, 12), p.z * 0.125 * any(r, -4, 12)};
    return mesh;
  });
}

TEST(ValidityDiff, OnNestsOfTetrahedraAndBoxes) {
  agree(100, [](Random& r) {
    std::vector<TriangleMesh> parts;
    for (int i = any(r, 1, 6); i > 0; --i) {
      const auto c = [&] { return static_cast<double>(any(r, 0, 12)); };
      const double x = c(), y = c(), z = c();
      const double s = any(r, 1, 7);
      parts.push_back(r.below(2) == 0 ? shapes::box({x, y, z}, {x + s, y + s, z + s})
                                      : shapes::mapped(shapes::parse("tet 0,0,0 1,0,0 0,1,0 0,0,1"), shapes::random_matrix(r, 6), {any(r, 0, 9), any(r, 0, 9), any(r, 0, 9)}));
      if (r.below(2) == 0) parts.back() = shapes::reversed(parts.back());
    }
    return r.below(2) == 0 ? shapes::joined(parts) : shapes::merged(shapes::joined(parts));
  });
}

TEST(ValidityDiff, OnValidScenesAndTheirRelatives) {
  agree(25, [](Random& r) {
    TriangleMesh mesh = shapes::nested_scene(r, any(r, 2, 9));
    if (r.below(3) == 0) mesh = shapes::relabelled(mesh, r);
    if (r.below(3) == 0) mesh = shapes::mapped(mesh, shapes::random_matrix(r, 3), {1, 1, 1});
    if (r.below(3) == 0)
      for (int i = 0; i < 12; ++i) std::swap(mesh.faces[static_cast<std::size_t>(i)][0], mesh.faces[static_cast<std::size_t>(i)][1]);
    return mesh;
  });
}

TEST(ValidityDiff, OnLongThinFacets) {
  agree(10, [](Random& r) {
    switch (r.below(4)) {
      case 0: return shapes::needle_soup(r, any(r, 20, 70));
      case 1: return shapes::hyperboloid(any(r, 12, 40), any(r, 1, 8));
      case 2: return shapes::tilted_cylinder(any(r, 5, 30), static_cast<shapes::Cap>(r.below(3)));
      default: return shapes::needles(r, any(r, 2, 20));
    }
  });
}

TEST(ValidityDiff, OnWavesAndSaddles) {
  agree(40, [](Random& r) {
    TriangleMesh mesh = r.below(2) == 0 ? shapes::wave(2 * any(r, 2, 12), any(r, 0, 40)) : shapes::saddle();
    return shapes::mapped(mesh, shapes::random_matrix(r, 4), {0, 0, 0});
  });
}

TEST(ValidityDiff, OnCoordinatesOfEveryScale) {
  agree(60, [](Random& r) {
    TriangleMesh mesh = r.below(2) == 0 ? shapes::grid_soup(r, any(r, 1, 16), 3) : shapes::random_polycube(r, 2, any(r, 1, 6));
    const int e = any(r, -1070, 1000);
    for (Vec3d& p : mesh.positions) {
      const double s = r.below(12) == 0 ? 1.0 : std::ldexp(1.0, e);
      p = {p.x * s, p.y * s, p.z * s};
    }
    return mesh;
  });
}

}  // namespace
}  // namespace veritope
