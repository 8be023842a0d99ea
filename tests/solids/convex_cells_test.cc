// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/convex_cells_test.cc: cells that planes cut: they fill what the tetrahedra filled, and share faces.
#include "solids/dms/domain/convex_cells.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "predicates/projection.h"
#include "robust/base/random.h"
#include "solids/dms/domain/convex_polygon.h"
#include "solids/tetrahedra/delaunay.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/mesh_domain_check.h"

namespace veritope {
namespace {

// Six times the volume, from the first vertex of a convex cell.
Rational six_volumes(const ConvexCells& all, const ConvexCell& cell) {
  Rational sum;
  const DmsPoint apex = all.place(all.faces()[cell.faces[0]].corners[0]);
  for (const std::uint32_t f : cell.faces) {
    const CellFace& face = all.faces()[f];
    std::vector<AnyPoint3> corners;
    for (const std::uint32_t v : face.corners) corners.push_back(all.vertex(v));
    for (const auto& t : triangulate_convex(corners, face.corners)) {
      const auto at = [&](std::size_t k) { return minus(all.place(face.corners[t[k]]), apex); };
      sum += abs(dot(at(0), cross(at(1), at(2))));
    }
  }
  return sum;
}

bool has_both_sides(const ConvexCells& all, std::uint32_t cell, std::uint32_t plane) {
  bool is_above = false, is_below = false;
  for (const std::uint32_t v : all.skeleton(cell).vertices) {
    is_above |= all.side(plane, v) == Sign::kPositive;
    is_below |= all.side(plane, v) == Sign::kNegative;
  }
  return is_above && is_below;
}

// Every edge of a face has the face, corners are joined by edges, faces know their cells, vertices their sides.
void expect_consistent(const ConvexCells& all, const std::string& what) {
  for (std::uint32_t f = 0; f < all.faces().size(); ++f) {
    const CellFace& face = all.faces()[f];
    ASSERT_EQ(face.corners.size(), face.edges.size()) << what;
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const CellEdge& edge = all.edges()[face.edges[i]];
      const std::uint32_t a = face.corners[i], b = face.corners[(i + 1) % face.corners.size()];
      EXPECT_TRUE(edge.ends == (std::array{a, b}) || edge.ends == (std::array{b, a})) << what;
      EXPECT_EQ(std::count(edge.faces.begin(), edge.faces.end(), f), 1) << what;
      EXPECT_EQ(all.side(face.plane, a), Sign::kZero) << what;
    }
    for (const std::uint32_t c : face.cells)
      if (c != kNoCell) {
        const auto& faces = all.cells()[c].faces;
        EXPECT_EQ(std::count(faces.begin(), faces.end(), f), 1) << what;
      }
  }
  for (std::uint32_t c = 0; c < all.cells().size(); ++c) {
    const ConvexCells::Skeleton parts = all.skeleton(c);
    // A cell is a ball.
    EXPECT_EQ(parts.vertices.size() + all.cells()[c].faces.size(), parts.edges.size() + 2) << what;
    for (const CellHalfSpace& s : all.cells()[c].sides)
      for (const std::uint32_t v : parts.vertices) EXPECT_NE(all.side(s.plane, v), -s.side) << what;
  }
}

TEST(ConvexCells, FillTheSamePlaceAfterAnyCuts) {
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(20)); ++seed) {
    Random random(seed);
    const std::string what = "seed " + std::to_string(seed);
    std::vector<Vec3d> points;
    const auto coordinate = [&] { return static_cast<double>(random.below(7)); };
    for (int i = 0; i < 9; ++i) points.push_back({coordinate(), coordinate(), coordinate()});
    const auto delaunay = delaunay_tetrahedra(points);
    if (!delaunay) continue;
    std::vector<CellPlane> planes;
    while (planes.size() < 6) {
      const auto id = [&] { return static_cast<std::uint32_t>(random.below(points.size())); };
      const CellPlane p{id(), id(), id()};
      if (!collinear(points[p[0]], points[p[1]], points[p[2]])) planes.push_back(p);
    }
    ConvexCells all(points, delaunay->tetrahedra, planes);
    Rational before, after;
    for (const ConvexCell& cell : all.cells()) before += six_volumes(all, cell);
    for (std::uint32_t plane = 0; plane < planes.size(); ++plane)
      for (std::uint32_t c = 0; c < all.cells().size() && all.cells().size() < 60; ++c)
        if (has_both_sides(all, c, plane)) all.cut(c, plane);
    expect_consistent(all, what);
    for (const ConvexCell& cell : all.cells()) {
      const Rational volume = six_volumes(all, cell);
      EXPECT_GT(volume, Rational(0)) << what;
      after += volume;
    }
    EXPECT_EQ(before, after) << what;
  }
}

}  // namespace
}  // namespace veritope
