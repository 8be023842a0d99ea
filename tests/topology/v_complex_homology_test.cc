// SPDX-License-Identifier: LGPL-3.0-or-later
// Boundary maps, Euler characteristic and Betti numbers of V-complexes whose homology is known.
#include "topology/v_complex_homology.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "tests/support/v_complex_shapes.h"
#include "topology/v_complex_edit.h"
#include "topology/v_complex_links.h"

namespace veritope {
namespace {

using Betti = std::array<std::uint64_t, 4>;
using v_shapes::complex_of;
using v_shapes::polycube;

Betti betti(const VComplex& complex) {
  const auto out = betti_numbers(complex);
  EXPECT_TRUE(out) << out.error().message;
  const BoundaryMaps maps = boundary_maps(complex);
  EXPECT_TRUE(product(maps.d2, maps.d3).is_zero());
  EXPECT_TRUE(product(maps.d1, maps.d2).is_zero());
  if (!out) return {};
  const auto& b = out.value();
  EXPECT_EQ(static_cast<std::int64_t>(b[0] + b[2]) - static_cast<std::int64_t>(b[1] + b[3]),
            euler_characteristic(complex));
  return b;
}

VComplex glued_cube(
    const std::vector<std::array<std::uint32_t, 3>>& gluings) {  // face, face, symmetry
  std::vector<HexahedralCell> cells(1);
  for (const auto& [f, g, symmetry] : gluings) v_shapes::glue_faces(cells, 0, f, 0, g, symmetry);
  return hexahedral_v_complex(cells).value().complex;
}

TEST(VComplexHomology, OfBallsRingsAndShells) {
  EXPECT_EQ(betti(VComplex()), (Betti{0, 0, 0, 0}));
  EXPECT_EQ(betti(complex_of({v_shapes::cube()})), (Betti{1, 0, 0, 0}));
  EXPECT_EQ(betti(complex_of(v_shapes::three_in_an_l())), (Betti{1, 0, 0, 0}));
  EXPECT_EQ(betti(complex_of(polycube({{0, 0, 0}, {2, 0, 0}}))), (Betti{2, 0, 0, 0}));
  std::vector<std::array<std::uint32_t, 3>> ring, shell;
  for (std::uint32_t n = 0; n < 27; ++n) {
    const std::array<std::uint32_t, 3> at{n % 3, n / 3 % 3, n / 9};
    if (at != std::array<std::uint32_t, 3>{1, 1, 1}) shell.push_back(at);
    if (at[2] == 0 && (at[0] != 1 || at[1] != 1)) ring.push_back(at);
  }
  EXPECT_EQ(betti(complex_of(polycube(ring))), (Betti{1, 1, 0, 0}));
  EXPECT_EQ(betti(complex_of(polycube(shell))), (Betti{1, 0, 1, 0}));
}

// PROVES VCOMPLEX-2
TEST(VComplexHomology, OfSelfGluedCubes) {
  EXPECT_EQ(betti(glued_cube({{4, 5, 0}})), (Betti{1, 1, 0, 0}));             // a ring
  EXPECT_EQ(betti(glued_cube({{2, 3, 0}, {4, 5, 0}})), (Betti{1, 2, 1, 0}));  // torus x interval
  EXPECT_EQ(betti(glued_cube({{0, 1, 0}, {2, 3, 0}, {4, 5, 0}})), (Betti{1, 3, 3, 1}));  // 3-torus
  // With a half turn in one direction: a half-turn space.
  EXPECT_EQ(betti(glued_cube({{0, 1, 0}, {2, 3, 0}, {4, 5, 6}})), (Betti{1, 1, 1, 1}));
}

// Torsion: the projective space and lens spaces have the Betti numbers of the sphere, over a field of odd characteristic.
TEST(VComplexHomology, TorsionDoesNotCount) {
  // Bipyramid as two halves of a lens: the upper side is glued to the lower side after a turn.
  const IntegerMatrix twice{1, {{{0, 2}}}};
  EXPECT_EQ(rank_modulo(twice, 2), 0u);
  EXPECT_EQ(rank_modulo(twice, kBettiPrime), 1u);
  bool has_torsion = false;
  for (unsigned n = 0; n < 64; ++n) {
    constexpr std::array<std::uint32_t, 4> kTurns{0, 3, 6, 5};
    const VComplex complex =
        glued_cube({{0, 1, kTurns[n & 3]}, {2, 3, kTurns[n >> 2 & 3]}, {4, 5, kTurns[n >> 4]}});
    const BoundaryMaps maps = boundary_maps(complex);
    has_torsion = has_torsion || rank_modulo(maps.d2, 2) < rank_modulo(maps.d2, kBettiPrime);
    const Betti b = betti(complex);
    EXPECT_EQ(b[3], 1u);
    if (is_manifold(complex)) {  // Poincare duality
      EXPECT_EQ(b[1], b[2]) << n;
    }
  }
  EXPECT_TRUE(has_torsion);
}

// PROVES VCOMPLEX-2
TEST(VComplexHomology, BridgesAccountForLoopsAndVoids) {
  EXPECT_EQ(betti(complex_of({v_shapes::cube_with_window()})), (Betti{1, 0, 0, 0}));
  EXPECT_EQ(betti(complex_of({v_shapes::cube_with_void()})), (Betti{1, 0, 1, 0}));
}

// PROVES VCOMPLEX-2
TEST(VComplexHomology, ACellWithAHandleIsRefusedUntilItIsCut) {
  VComplex complex = complex_of({v_shapes::cube_with_through_hole()});
  EXPECT_EQ(euler_characteristic(complex), 0);
  const auto refused = betti_numbers(complex);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Code::kBadArgument);
  EXPECT_EQ(refused.error().place.entity, 0u);
  // A cut from the outer wall to the inner one: bridges in top and bottom, and the two curves that join them.
  const VComplexTables& t = complex.tables();
  const auto from_to = [&](VPointId a, VPointId b, std::uint32_t half) {
    for (const CurveUseId u : t.uses)
      if (t.start(u) == a && t.end(u) == b &&
          (half > 99 || t.uses[u].half_surface == HalfVSurfaceId{half}))
        return u;
    return CurveUseId{};
  };
  const auto starting_at = [&](VPointId a, std::uint32_t half) {
    for (const CurveUseId u : t.uses)
      if (t.start(u) == a && t.uses[u].half_surface == HalfVSurfaceId{half}) return u;
    return CurveUseId{};
  };
  const VPointId p0{0}, p4{4}, p8{8}, p12{12};
  EXPECT_TRUE(split_surface(complex, starting_at(p0, 0), starting_at(p8, 0)));
  EXPECT_TRUE(split_surface(complex, starting_at(p4, 1), starting_at(p12, 1)));
  const std::vector<CurveUseId> cycle{from_to(p0, p8, 0), from_to(p8, p12, 100),
                                      from_to(p12, p4, 1), from_to(p4, p0, 100)};
  const auto cut = split_cell(complex, cycle, 0);
  ASSERT_TRUE(cut) << cut.error().message;
  EXPECT_TRUE(cut.value().cell.is_none());
  EXPECT_EQ(betti(complex), (Betti{1, 1, 0, 0}));
}

TEST(VComplexHomology, BoundaryMapsHaveTheirSigns) {
  const VComplex complex = complex_of(polycube({{0, 0, 0}, {1, 0, 0}}));
  const BoundaryMaps maps = boundary_maps(complex);
  ASSERT_EQ(maps.d3.columns.size(), 2u);
  EXPECT_EQ(maps.d3.columns[0].size(), 6u);
  std::int32_t shared = 0;
  for (const auto& [row, entry] : maps.d3.columns[0])
    for (const auto& [other, with] : maps.d3.columns[1])
      if (row == other) shared += entry * with;
  EXPECT_EQ(shared, -1);
  for (const auto& column : maps.d2.columns) EXPECT_EQ(column.size(), 4u);
  for (const auto& column : maps.d1.columns) {
    ASSERT_EQ(column.size(), 2u);
    EXPECT_EQ(column[0].second + column[1].second, 0);
  }
  // A 3-torus has no boundary at all.
  const BoundaryMaps torus = boundary_maps(glued_cube({{0, 1, 0}, {2, 3, 0}, {4, 5, 0}}));
  EXPECT_TRUE(torus.d3.is_zero() && torus.d2.is_zero() && torus.d1.is_zero());
}

}  // namespace
}  // namespace veritope
