// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/collar/collar_mesh.h"

#include <gtest/gtest.h>

#include "solids/polyhedron/validity.h"
#include "tests/support/collar_examples.h"

namespace veritope {
namespace {

using octree_shapes::CollarExample;

OctreeRoot unit_root() { return {{-0.25, 3, 1}, 1.0 / OctreeKey::kGrid}; }

// Unions of cells of all levels: closed meshes with the volume of the cells and the genus of the boundary, exactly.
TEST(CollarMesh, OfEveryManifoldOfCellsIsValidAndHasItsVolume) {
  std::size_t hanging = 0;
  for (const CollarExample& example : octree_shapes::collar_examples()) {
    SCOPED_TRACE(example.name);
    const CommonSubdivision complex = octree_shapes::build(example.cells);
    const ComplexBoundary boundary = analyse_boundary(complex);
    if (!boundary.is_manifold()) continue;
    const std::vector<bool> all(boundary.components.size(), true);
    const TriangleMesh mesh =
        boundary_mesh(complex, boundary, all, CellSide::kOut, unit_root(), 0).value();
    const ValidityReport report = decide_validity(mesh, {});
    EXPECT_TRUE(report.is_valid);
    EXPECT_EQ(report.counts.shells, boundary.components.size());
    std::int64_t genus = 0;
    for (const BoundaryComponent& c : boundary.components) genus += c.genus();
    EXPECT_EQ(report.counts.genus, std::optional(genus));
    Rational volume(0);
    for (const OctreeCell& c : example.cells)
      volume = volume + Rational::power_of_two(-3 * static_cast<int>(c.level));
    EXPECT_EQ(report.volume.value(), volume);
    for (std::uint32_t f = 0; f < complex.num_faces(); ++f)
      hanging += complex.faces()[f].num_cells() == 1 && complex.edges_of_face(f).size() > 4 ? 1 : 0;
  }
  EXPECT_GT(hanging, 0u);
}

TEST(CollarMesh, OfOneSideTurnsItsNormalsAsAsked) {
  const CommonSubdivision complex = octree_shapes::build(octree_shapes::thick_wall());
  const ComplexBoundary boundary = analyse_boundary(complex);
  ASSERT_EQ(boundary.components.size(), 2u);
  for (const bool first : {true, false})
    for (const CellSide side : {CellSide::kOut, CellSide::kIn}) {
      const TriangleMesh mesh =
          boundary_mesh(complex, boundary, {first, !first}, side, unit_root(), 0).value();
      const bool is_outer = boundary.components[first ? 0 : 1].faces == 6 * 24 * 24;
      EXPECT_EQ(decide_validity(mesh, {}).is_valid, is_outer == (side == CellSide::kOut));
    }
}

TEST(CollarMesh, RefusesCoordinatesThatBinary64DoesNotHold) {
  const CommonSubdivision complex = octree_shapes::build(octree_shapes::thick_wall());
  const ComplexBoundary boundary = analyse_boundary(complex);
  const auto refused = [&](const std::vector<bool>& which, int scale) {
    const auto mesh = boundary_mesh(complex, boundary, which, CellSide::kOut, unit_root(), scale);
    return mesh ? std::optional<Code>() : std::optional(mesh.error().code);
  };
  EXPECT_EQ(refused({true, true}, 1074), Code::kNotFinite);
  EXPECT_EQ(refused({true, true}, -1024), Code::kNotFinite);
  EXPECT_EQ(refused({false, false}, 0), Code::kEmpty);
  EXPECT_EQ(refused({true, true}, 900), std::nullopt);
}

}  // namespace
}  // namespace veritope
