// SPDX-License-Identifier: LGPL-3.0-or-later
// Links of V-curves and V-points, the boundary of cells, and the boundary B-rep.
#include "topology/v_complex_links.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "tests/support/v_complex_shapes.h"
#include "topology/v_complex_boundary.h"
#include "topology/v_complex_edit.h"
#include "topology/v_complex_homology.h"

namespace veritope {
namespace {

using v_shapes::complex_of;
using v_shapes::polycube;

// Points of one octant each around the middle of a cube: bit n of `octants` for the octant n.
VComplex octants(unsigned octants) {
  std::vector<std::array<std::uint32_t, 3>> cubes;
  for (std::uint32_t n = 0; n < 8; ++n)
    if ((octants >> n & 1) != 0) cubes.push_back({n & 1, n >> 1 & 1, n >> 2});
  return complex_of(polycube(cubes));
}

// The point with the most curves.
VPointId middle(const VComplex& complex) {
  VPointId out{0};
  for (const VPointId p : complex.tables().points)
    if (complex.point(p).curves.size() > complex.point(out).curves.size()) out = p;
  return out;
}

TEST(VComplexLinks, AnInnerPointHasASphereAndABoundaryPointADisk) {
  const VComplex complex = octants(255);
  const VPointLink inner = link_of(complex, middle(complex));
  ASSERT_EQ(inner.components.size(), 1u);
  EXPECT_TRUE(inner.components[0].is_sphere());
  EXPECT_EQ(inner.components[0].vertices, 6u);
  EXPECT_EQ(inner.components[0].edges, 12u);
  EXPECT_EQ(inner.components[0].faces, 8u);
  EXPECT_TRUE(is_manifold(complex));
  for (const VPointId p : complex.tables().points) {
    const bool is_disk = link_of(complex, p).components.at(0).is_disk();
    EXPECT_EQ(is_disk, p != middle(complex));
  }
}

TEST(VComplexLinks, TwoCubesOnOneEdgeHaveTwoFans) {
  const VComplex complex = complex_of(polycube({{0, 0, 0}, {1, 1, 0}}));
  const auto curves = nonmanifold_curves(complex);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(link_of(complex, curves[0]).open_fans, 2u);
  EXPECT_EQ(nonmanifold_points(complex).size(), 2u);
  for (const VPointId p : nonmanifold_points(complex))
    EXPECT_TRUE(link_of(complex, p).has_pinched_curve);
  EXPECT_FALSE(is_manifold(complex));
}

TEST(VComplexLinks, TwoCubesOnOnePointHaveTwoDisks) {
  const VComplex complex = complex_of(polycube({{0, 0, 0}, {1, 1, 1}}));
  EXPECT_TRUE(nonmanifold_curves(complex).empty());
  const auto points = nonmanifold_points(complex);
  ASSERT_EQ(points.size(), 1u);
  const VPointLink link = link_of(complex, points[0]);
  ASSERT_EQ(link.components.size(), 2u);
  EXPECT_TRUE(link.components[0].is_disk() && link.components[1].is_disk());
}

TEST(VComplexLinks, AllOctantsButTwoOppositeOnesLeaveAnAnnulus) {
  const VComplex complex = octants(0b01111110);
  EXPECT_TRUE(nonmanifold_curves(complex).empty());
  const auto points = nonmanifold_points(complex);
  ASSERT_EQ(points.size(), 1u);
  const VPointLink link = link_of(complex, points[0]);
  ASSERT_EQ(link.components.size(), 1u);
  EXPECT_EQ(link.components[0].boundary_circles, 2u);
  EXPECT_EQ(link.components[0].genus(), 0);
}

// Truth from the octants alone: an edge is good if the cells at it are consecutive, the point if in addition both the
// cells and the gaps are connected through faces.
bool is_good(unsigned octants) {
  const auto components = [](unsigned set) {
    unsigned count = 0;
    for (unsigned n = 0; n < 8; ++n) {
      if ((set >> n & 1) == 0) continue;
      ++count;
      std::vector<unsigned> todo{n};
      set &= ~(1u << n);
      while (!todo.empty()) {
        const unsigned m = todo.back();
        todo.pop_back();
        for (unsigned axis = 0; axis < 3; ++axis)
          if ((set >> (m ^ 1u << axis) & 1) != 0) {
            set &= ~(1u << (m ^ 1u << axis));
            todo.push_back(m ^ 1u << axis);
          }
      }
    }
    return count;
  };
  for (unsigned axis = 0; axis < 3; ++axis) {
    for (unsigned end = 0; end < 2; ++end) {
      const unsigned p = 1u << (axis + 1) % 3, q = 1u << (axis + 2) % 3, base = end << axis;
      const auto has = [&](unsigned n) { return (octants >> n & 1) != 0; };
      if (has(base) == has(base | p | q) && has(base | p) == has(base | q) &&
          has(base) != has(base | p))
        return false;
    }
  }
  return components(octants) <= 1 && components(~octants & 255u) <= 1;
}

// PROVES VCOMPLEX-1
TEST(VComplexLinks, AllSetsOfOctantsAreJudgedRight) {
  unsigned good = 0;
  for (unsigned set = 1; set < 256; ++set) {
    EXPECT_EQ(is_manifold(octants(set)), is_good(set)) << set;
    good += is_good(set) ? 1 : 0;
  }
  EXPECT_GT(good, 100u);
  EXPECT_LT(good, 200u);
}

// Opposite faces of a cube glued by all quarter turns: 64 closed complexes. Its Euler characteristic is the sum of the
// genera of the links, so it is a manifold iff that is 0.
// PROVES VCOMPLEX-1
TEST(VComplexLinks, ClosedComplexesAreManifoldsIffTheirEulerCharacteristicIsZero) {
  unsigned manifolds = 0, others = 0;
  constexpr std::array<std::uint32_t, 4> kTurns{0, 3, 6,
                                                5};  // keep the orientation of the parameters
  for (unsigned n = 0; n < 64; ++n) {
    std::vector<HexahedralCell> cells(1);
    for (unsigned axis = 0; axis < 3; ++axis)
      v_shapes::glue_faces(cells, 0, 2 * axis, 0, 2 * axis + 1, kTurns[n >> 2 * axis & 3]);
    const auto made = hexahedral_v_complex(cells);
    if (!made) {
      ADD_FAILURE() << n << ": " << made.error().message;
      continue;
    }
    const VComplex& complex = made.value().complex;
    std::int64_t genera = 0;
    for (const VPointId p : complex.tables().points) {
      const VPointLink link = link_of(complex, p);
      for (const VPointLinkComponent& component : link.components) {
        EXPECT_EQ(component.boundary_circles, 0u);
        genera += component.genus();
      }
    }
    EXPECT_EQ(euler_characteristic(complex), genera) << n;
    EXPECT_EQ(is_manifold(complex), genera == 0) << n;
    ++(genera == 0 ? manifolds : others);
  }
  EXPECT_GT(manifolds, 4u);
  EXPECT_GT(others, 4u);
}

TEST(VComplexLinks, TheBoundaryOfACellIsSeenBeforeGluing) {
  const auto surfaces = [](const v_shapes::Polyhedron& cell) {
    std::vector<std::int64_t> out;
    const VComplex complex = complex_of({cell});
    for (const auto& component : boundary_of_cell(complex, VCellId{0}))
      out.push_back(component.genus());
    return out;
  };
  EXPECT_EQ(surfaces(v_shapes::cube()), std::vector<std::int64_t>{0});
  EXPECT_EQ(surfaces(v_shapes::cube_with_window()), std::vector<std::int64_t>{0});
  EXPECT_EQ(surfaces(v_shapes::cube_with_through_hole()), std::vector<std::int64_t>{1});
  EXPECT_EQ(surfaces(v_shapes::cube_with_void()), (std::vector<std::int64_t>{0, 0}));
}

std::vector<std::int64_t> genera_of(const VComplex& complex) {
  std::vector<std::int64_t> out;
  const BoundaryBrep brep = boundary_brep(complex);
  for (const VShell& shell : brep.shells) out.push_back(shell.genus());
  return out;
}

TEST(BoundaryBrep, IsAClosedSurfaceWithItsGenus) {
  const VComplex complex = complex_of(v_shapes::three_in_an_l());
  const BoundaryBrep brep = boundary_brep(complex);
  EXPECT_EQ(brep.faces.size(), 14u);
  EXPECT_EQ(brep.num_edges(), 28u);
  EXPECT_EQ(brep.num_vertices(), 16u);
  ASSERT_EQ(brep.shells.size(), 1u);
  EXPECT_EQ(brep.shells[0].genus(), 0);
  for (std::size_t i = 0; i < brep.uses.size(); ++i) {
    const CurveUse &u = complex.use(brep.uses[i]), &v = complex.use(brep.across[i]);
    EXPECT_EQ(u.curve, v.curve);
    EXPECT_NE(u.is_forward, v.is_forward);
  }
}

TEST(BoundaryBrep, OfRingsAndShells) {
  EXPECT_EQ(genera_of(complex_of({v_shapes::cube_with_through_hole()})),
            std::vector<std::int64_t>{1});
  EXPECT_EQ(genera_of(complex_of({v_shapes::cube_with_void()})), (std::vector<std::int64_t>{0, 0}));
  std::vector<std::array<std::uint32_t, 3>> ring, shell;
  for (std::uint32_t n = 0; n < 27; ++n) {
    const std::array<std::uint32_t, 3> at{n % 3, n / 3 % 3, n / 9};
    if (at != std::array<std::uint32_t, 3>{1, 1, 1}) shell.push_back(at);
    if (at[2] == 0 && (at[0] != 1 || at[1] != 1)) ring.push_back(at);
  }
  EXPECT_EQ(genera_of(complex_of(polycube(ring))), std::vector<std::int64_t>{1});
  EXPECT_EQ(genera_of(complex_of(polycube(shell))), (std::vector<std::int64_t>{0, 0}));
}

// Sheets that meet in a non-manifold curve or point are separate.
TEST(BoundaryBrep, PullsPinchedSheetsApart) {
  EXPECT_EQ(genera_of(complex_of(polycube({{0, 0, 0}, {1, 1, 0}}))),
            (std::vector<std::int64_t>{0, 0}));
  EXPECT_EQ(genera_of(complex_of(polycube({{0, 0, 0}, {1, 1, 1}}))),
            (std::vector<std::int64_t>{0, 0}));
  EXPECT_EQ(boundary_brep(complex_of(polycube({{0, 0, 0}, {1, 1, 1}}))).num_vertices(), 16u);
}

}  // namespace
}  // namespace veritope
