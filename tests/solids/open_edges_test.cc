// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/open_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/predicates/test_scale.h"
#include "tests/support/brute_force.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

std::vector<OpenEdge> open_edges_of(const TriangleMesh& mesh, unsigned jobs = 1) {
  const auto num_vertices = static_cast<std::uint32_t>(mesh.positions.size());
  return list_open_edges(mesh, Incidence::build(mesh.faces, num_vertices, 1), jobs);
}
OpenEdges analysed(const TriangleMesh& mesh) {
  return analyse_open_edges(mesh, open_edges_of(mesh), 1);
}

TriangleMesh without(TriangleMesh mesh, const std::vector<std::size_t>& faces) {
  for (std::size_t i = faces.size(); i-- > 0;)
    mesh.faces.erase(mesh.faces.begin() + static_cast<std::ptrdiff_t>(faces[i]));
  return mesh;
}
template <typename Condition>
TriangleMesh without_if(TriangleMesh mesh, Condition condition) {
  std::erase_if(mesh.faces, condition);
  return mesh;
}

// All triangles with vertices of their own.
TriangleMesh torn(const TriangleMesh& mesh) {
  TriangleMesh out;
  for (const auto& f : mesh.faces) {
    const auto n = static_cast<std::uint32_t>(out.positions.size());
    for (const std::uint32_t v : f) out.positions.push_back(mesh.positions[v]);
    out.faces.push_back({n, n + 1, n + 2});
  }
  return out;
}

// A strip of triangles on a polyline, on the side `up` of it.
TriangleMesh strip(const std::vector<Vec3d>& line, Vec3d up) {
  TriangleMesh out;
  for (const Vec3d& p : line) {
    out.positions.push_back(p);
    out.positions.push_back({p.x + up.x, p.y + up.y, p.z + up.z});
  }
  for (std::uint32_t i = 0; i + 3 < out.positions.size(); i += 2) {
    out.faces.push_back({i, i + 2, i + 1});
    out.faces.push_back({i + 1, i + 2, i + 3});
  }
  return out;
}
std::vector<Vec3d> straight_line(int parts, double length, Vec3d from = {0, 0, 0}) {
  std::vector<Vec3d> out;
  for (int i = 0; i <= parts; ++i) out.push_back({from.x + length * i / parts, from.y, from.z});
  return out;
}
std::vector<Vec3d> arc(int parts, double radius, double from, double to) {
  std::vector<Vec3d> out;
  for (int i = 0; i <= parts; ++i) {
    const double t = from + (to - from) * i / parts;
    out.push_back({radius * std::cos(t), radius * std::sin(t), 0});
  }
  return out;
}

TEST(OpenEdgeList, IsThatOfBruteForceInTheDirectionsOfItsFaces) {
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(300)); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const TriangleMesh mesh = shapes::random_indexed(random, static_cast<int>(1 + random.below(30)),
                                                     static_cast<int>(3 + random.below(12)), 3);
    const auto edges = open_edges_of(mesh);
    std::vector<oracle::Edge> got;
    for (const OpenEdge& e : edges) {
      got.push_back(std::minmax(e.a, e.b));
      const auto& f = mesh.faces[e.face];
      bool runs = false;
      for (std::size_t k = 0; k < 3; ++k) runs = runs || (f[k] == e.a && f[(k + 1) % 3] == e.b);
      EXPECT_TRUE(runs) << shapes::to_text(mesh);
    }
    EXPECT_EQ(got, oracle::brute_topology(mesh.faces).boundary) << shapes::to_text(mesh);
    EXPECT_EQ(edges, open_edges_of(mesh, 3));
  }
}

TEST(OpenEdges, OfAClosedMeshAreNone) {
  const OpenEdges none = analysed(shapes::box({0, 0, 0}, {1, 1, 1}, 3));
  EXPECT_TRUE(none.nearest.empty());
  EXPECT_EQ(
      none.borders + none.holes + none.near_edges + none.touching_edges + none.unsearched_edges,
      0u);
  EXPECT_EQ(none.least_gap, 0);
}

void expect_holes(const TriangleMesh& mesh, std::uint64_t holes, const char* what) {
  const OpenEdges open = analysed(mesh);
  EXPECT_GT(open.nearest.size(), 0u) << what;
  EXPECT_EQ(open.borders, holes) << what;
  EXPECT_EQ(open.holes, holes) << what;
  EXPECT_EQ(open.near_edges, 0u) << what;
  EXPECT_EQ(open.greatest_gap, 0) << what;
}

TEST(OpenEdges, AlongHolesAreNotNear) {
  const TriangleMesh box = shapes::box({0, 0, 0}, {1, 1, 1}, 4);
  expect_holes(without(box, {17}), 1, "a triangle is missing");
  expect_holes(without(box, {0, 95, 130}), 3, "three triangles are missing");
  const std::uint32_t v = box.faces[37][0];
  expect_holes(without_if(box, [v](const auto& f) { return f[0] == v || f[1] == v || f[2] == v; }),
               1, "a fan is missing");
  const TriangleMesh prism = shapes::prism(40, 1, 3);
  const auto is_cap = [&](const auto& f) {
    const auto z = [&](std::size_t k) { return prism.positions[f[k]].z; };
    return z(0) == z(1) && z(1) == z(2);
  };
  expect_holes(without_if(prism, is_cap), 2, "both caps are missing");
  expect_holes(strip(straight_line(50, 1), {0, 1, 0}), 1, "a sheet");
  expect_holes(shapes::parse("tri 0,0,0 1,0,0 0,1,0"), 1, "a triangle");
}

// Tessellations have long edges along lines and short ones along arcs: a face is missing.
TEST(OpenEdges, AlongAHoleOfLongAndShortEdgesAreNotNear) {
  const double pi = std::numbers::pi;
  std::vector<Vec3d> rim;
  for (const double from : {0.0, pi / 2, pi, 3 * pi / 2}) {
    const double x = from == 0.0 || from > pi ? 5 : -5, y = from < 2 ? 5 : -5;
    for (const Vec3d& p : arc(16, 1, from, from + pi / 2)) rim.push_back({p.x + x, p.y + y, 0});
  }
  rim.push_back(rim.front());
  expect_holes(shapes::merged(strip(rim, {0, 0, 9})), 2, "round corners");
  std::vector<Vec3d> corner{{10, 0, 0}, {0, 0, 0}};
  for (int i = 1; i <= 100; ++i) corner.push_back({0.05 * i, 0.08 * i, 0});
  expect_holes(strip(corner, {0, 0, 9}), 1, "an acute corner");
}

TEST(OpenEdges, OfALongBorderOfShortEdgesAreNotNear) {
  expect_holes(strip(arc(20'000, 1, 0, 6), {0, 0, 1}), 1, "a curve");
  expect_holes(strip(straight_line(20'000, 1), {0, 0, 1}), 1, "a line");
}

TEST(OpenEdges, KnowTheGapOfACrackExactly) {
  for (const double gap : {0x1p-52, 0x1p-40, 1e-9, 1e-6, 1e-3}) {
    SCOPED_TRACE(gap);
    const TriangleMesh low = strip(straight_line(8, 1, {1, 1, 0}), {0, -1, 0});
    const TriangleMesh high = strip(straight_line(8, 1, {1, 1 + gap, 0}), {0, 1, 0});
    const TriangleMesh mesh = shapes::joined(low, high);
    const auto edges = open_edges_of(mesh);
    const OpenEdges open = analyse_open_edges(mesh, edges, 1);
    EXPECT_EQ(open.borders, 2u);
    EXPECT_EQ(open.holes, 0u);
    EXPECT_EQ(open.near_edges, 16u);
    EXPECT_EQ(open.touching_edges, 0u);
    const double exact = (1 + gap) - 1;
    EXPECT_EQ(open.least_gap, exact);
    EXPECT_EQ(open.greatest_gap, exact);
    const Rational r = Rational::from_double(exact);
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (open.nearest[i].is_near) {
        const OpenEdge& other = edges[open.nearest[i].edge];
        EXPECT_EQ(squared_gap(ends_of(mesh, edges[i]), ends_of(mesh, other)), r * r);
      }
  }
}

TEST(OpenEdges, KnowTheLeastAndTheGreatestGap) {
  const auto pair = [](double z, double gap) {
    return shapes::joined(strip(straight_line(3, 3, {0, 0, z}), {0, -1, 0}),
                          strip(straight_line(3, 3, {0, gap, z}), {0, 1, 0}));
  };
  TriangleMesh mesh = pair(0, 1e-4);
  for (const double gap : {1e-5, 1e-3, 1e-7, 1e-6})
    mesh = shapes::joined(mesh, pair(mesh.positions.back().z + 10, gap));
  OpenEdges open = analysed(mesh);
  EXPECT_EQ(open.near_edges, 30u);
  EXPECT_EQ(open.least_gap, 1e-7);
  EXPECT_EQ(open.greatest_gap, 1e-3);
  open = analysed(shapes::joined(shapes::joined(mesh, pair(100, 0)), pair(200, 0.5)));
  EXPECT_EQ(open.least_gap, 0);
  EXPECT_EQ(open.greatest_gap, 1e-3);
  EXPECT_EQ(open.touching_edges, 6u);
  EXPECT_EQ(open.borders, 14u);
  EXPECT_EQ(open.holes, 2u);
}

TEST(OpenEdges, OfATornMeshTouch) {
  for (const TriangleMesh& mesh :
       {shapes::box({0, 0, 0}, {1, 2, 3}, 3), shapes::torus(12, 8, 3, 1)}) {
    const OpenEdges open = analysed(torn(mesh));
    EXPECT_EQ(open.nearest.size(), 3 * mesh.faces.size());
    EXPECT_EQ(open.borders, mesh.faces.size());
    EXPECT_EQ(open.touching_edges, open.nearest.size());
    EXPECT_EQ(open.near_edges, open.nearest.size());
    EXPECT_EQ(open.holes, 0u);
    EXPECT_EQ(open.greatest_gap, 0);
  }
}

// A line of long edges against one of short edges.
OpenEdges t_junction(double gap, int exponent = 0) {
  const TriangleMesh coarse = strip(straight_line(4, 4), {0, -1, 0});
  const TriangleMesh fine = strip(straight_line(16, 4, {0, gap, 0}), {0, 1, 0});
  return analysed(shapes::scaled(shapes::joined(coarse, fine), exponent));
}

TEST(OpenEdges, AtTJunctionsAreNearWithAndWithoutAGap) {
  const OpenEdges none = t_junction(0);
  EXPECT_EQ(none.near_edges, 20u);
  EXPECT_EQ(none.touching_edges, 20u);
  EXPECT_EQ(none.greatest_gap, 0);
  for (const double gap : {0x1p-1000, 1e-15, 1e-5, 1e-2}) {
    const OpenEdges some = t_junction(gap);
    EXPECT_EQ(some.near_edges, 20u) << gap;
    EXPECT_EQ(some.touching_edges, 0u) << gap;
    EXPECT_EQ(some.least_gap, gap);
    EXPECT_EQ(some.greatest_gap, gap);
    EXPECT_EQ(some.holes, 0u);
  }
  EXPECT_EQ(t_junction(0.03).near_edges, 4u)
      << "as an eighth of the short edges' length, and a 33rd of that of the long ones";
  EXPECT_EQ(t_junction(0.03).holes, 0u)
      << "a border is a crack if other edges are near one of its own";
}

TEST(OpenEdges, OfTwoTessellationsOfOneArcAreNear) {
  const TriangleMesh mesh =
      shapes::joined(strip(arc(8, 1, 0, 2), {0, 0, 1}), strip(arc(64, 1, 0, 2), {0, 0, -1}));
  const OpenEdges open = analysed(mesh);
  EXPECT_GE(open.near_edges, 8u);
  EXPECT_EQ(open.holes, 0u);
}

TEST(OpenEdges, AreTheSameAtAllSizes) {
  for (const int exponent : {-1020, -500, 0, 500, 1020}) {
    SCOPED_TRACE(exponent);
    const OpenEdges open = t_junction(0x1p-6, exponent);
    EXPECT_EQ(open.near_edges, 20u);
    EXPECT_EQ(open.least_gap, std::ldexp(1.0, exponent - 6));
    EXPECT_EQ(t_junction(0, exponent).touching_edges, 20u);
    EXPECT_EQ(t_junction(0.25, exponent).near_edges, 0u);
  }
  // 16 and 1 units of the least subnormal number.
  const TriangleMesh tiny = shapes::scaled(shapes::joined(shapes::parse("tri 0,0,0 16,0,0 8,-16,0"),
                                                          shapes::parse("tri 0,1,0 16,1,0 8,17,0")),
                                           -1074);
  EXPECT_EQ(analysed(tiny).near_edges, 2u);
  EXPECT_EQ(analysed(tiny).least_gap, 0x1p-1074);
  const TriangleMesh huge = shapes::parse(
      "tri -1e308,-1e308,0 1e308,-1e308,0 0,-1.5e308,0; tri -1e308,-1.01e308,0 1e308,-1.01e308,0 "
      "0,1.7e308,1e-300");
  const OpenEdges open = analysed(huge);
  EXPECT_EQ(open.near_edges, 2u);
  EXPECT_EQ(open.least_gap, 1.01e308 - 1e308);
}

TEST(OpenEdges, OfLengthZeroArePartsOfBordersAndNearNone) {
  // Vertices 1 and 2 lie at one point.
  const TriangleMesh mesh = shapes::parse("v 0,0,0 1,0,0 1,0,0 0,1,0; f 0,1,2 0,2,3");
  const auto edges = open_edges_of(mesh);
  ASSERT_EQ(edges.size(), 4u);
  const OpenEdges open = analyse_open_edges(mesh, edges, 1);
  EXPECT_EQ(open.borders, 1u);
  EXPECT_EQ(open.near_edges, 0u);
  EXPECT_EQ(open.holes, 1u);
}

}  // namespace
}  // namespace veritope
