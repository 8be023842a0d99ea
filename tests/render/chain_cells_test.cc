// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/chain_cells.h"

#include <gtest/gtest.h>

#include <set>

namespace veritope {
namespace {

TEST(VtkWedgeIndex, NumbersAllControlPoints) {
  for (int n = 1; n <= 6; ++n) {
    std::set<std::size_t> numbers;
    for (int k = 0; k < 2; ++k)
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i + j <= n; ++i) numbers.insert(vtk_wedge_index(i, j, k, n));
    const auto count = static_cast<std::size_t>((n + 1) * (n + 2));
    EXPECT_EQ(numbers.size(), count);
    EXPECT_EQ(*numbers.rbegin(), count - 1);
  }
}

// As in the comments and the code of VTK's vtkHigherOrderWedge.
TEST(VtkWedgeIndex, IsThatOfVtk) {
  EXPECT_EQ(vtk_wedge_index(0, 0, 0, 4), 0u);
  EXPECT_EQ(vtk_wedge_index(4, 0, 0, 4), 1u);
  EXPECT_EQ(vtk_wedge_index(0, 4, 1, 4), 5u);
  EXPECT_EQ(vtk_wedge_index(1, 0, 0, 4), 6u);
  EXPECT_EQ(vtk_wedge_index(3, 1, 0, 4), 9u);
  EXPECT_EQ(vtk_wedge_index(0, 3, 0, 4), 12u);
  EXPECT_EQ(vtk_wedge_index(1, 0, 1, 4), 15u);
  EXPECT_EQ(vtk_wedge_index(1, 1, 0, 4), 24u);
  EXPECT_EQ(vtk_wedge_index(2, 1, 0, 4), 25u);
  EXPECT_EQ(vtk_wedge_index(1, 2, 1, 4), 29u);
}

TEST(ChainCells, RefusesWhatBinary64DoesNotHave) {
  ChainCells cells;
  const Rational far = Rational::power_of_two(2000);
  const Status status = cells.add_tetrahedron({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, far}}}, {});
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, Code::kNotFinite);
}

// Weights beyond binary64 are scaled.
TEST(ChainCells, HasWeightsThatVtkReads) {
  ChainCells cells;
  BezierTriangle<Rational> top(1, 4, true);
  const Rational w = Rational::power_of_two(5000);
  const std::array<std::array<int, 3>, 3> corners{{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t c = 0; c < 3; ++c)
      top.component(static_cast<int>(c))[i] = w * Rational(corners[i][c]);
    top.component(3)[i] = i == 0 ? w : w / Rational(2);
  }
  ASSERT_TRUE(cells.add_wedge({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, top, {1, -1, 7}));
  const std::string text = cells.vtu_bytes();
  EXPECT_EQ(cells.num_cells(), 1u);
  EXPECT_NE(text.find("\n1\n0.5\n0.5\n1\n0.5\n0.5\n</DataArray>"), std::string::npos);
  EXPECT_NE(text.find("Name=\"coefficient\" NumberOfComponents=\"1\" format=\"ascii\">\n-1\n<"),
            std::string::npos);
}

}  // namespace
}  // namespace veritope
