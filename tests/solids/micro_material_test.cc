// SPDX-License-Identifier: LGPL-3.0-or-later
// Materials: values at corners of cells, rounded once for each place in space.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "solids/micro/cage/radial_cage.h"
#include "solids/micro/synthesis/material.h"
#include "solids/micro/synthesis/wall_thickness.h"
#include "splines/de_boor.h"
#include "tests/support/micro_cells.h"

namespace veritope {
namespace {

using micro_cells::box_tile;
using micro_cells::full;

RealFormula material_formula(const std::string& text) {
  return parse_formula(text, std::vector<std::string>(kWallVariables.begin(), kWallVariables.end()))
      .value();
}
MicroTile some_tile() { return box_tile({16, 16, 16}, {48, 48, 48}); }
/// Two unit cubes that are glued to each other.
Microstructure two_cubes() {
  return full({v_cells::cube(0, 0, 0), v_cells::cube(1, 0, 0)}, {2, 3, 1}, some_tile());
}
Microstructure ring() {
  RadialShape shape;
  shape.inner = Rational(1), shape.outer = Rational(2), shape.high = Rational(1);
  const CellVolume cell = radial_cage(shape).value().cell;
  return full({cell}, {2, 8, 1}, some_tile());
}

TEST(Material, IsTheFormulaAtTheCorners) {
  const Microstructure micro = two_cubes();
  const MicroMaterial m = material_by(material_formula("x + 2*y - 4*z"), "a", micro).value();
  EXPECT_EQ(m.name, "a");
  ASSERT_EQ(m.values.size(), 2u);
  for (std::size_t g = 0; g < 2; ++g) {
    const Grid<3> corners = micro.grids[g].corner_shape();
    ASSERT_EQ(m.values[g].size(), corners.count());
    for (std::size_t c = 0; c < corners.count(); ++c) {
      const auto at = corners.index_of(c);
      const double exact = static_cast<double>(g) + static_cast<double>(at[0]) / 2 +
                           2 * static_cast<double>(at[1]) / 3 - 4 * static_cast<double>(at[2]);
      EXPECT_EQ(m.values[g][c], std::llround(std::ldexp(exact, kWallBits))) << g << ' ' << c;
    }
  }
}

// u is 1 in one cube and 0 in the other one where they meet, and the angle of a ring is 0 and 1 at once.
TEST(Material, IsContinuousWhereFacesAreOneInSpace) {
  for (const Microstructure& micro : {two_cubes(), ring()}) {
    const MicroMaterial m =
        material_by(material_formula("u + 10*v + 100*w + rand(3)"), "a", micro).value();
    std::map<std::vector<Rational>, std::int64_t> known;
    std::size_t repeated = 0;
    for (std::size_t g = 0; g < micro.grids.size(); ++g) {
      const MicroGrid& grid = micro.grids[g];
      for (std::size_t c = 0; c < m.values[g].size(); ++c) {
        const auto at = grid.corner_shape().index_of(c);
        const std::array<Rational, 3> x{grid.breaks[0][at[0]], grid.breaks[1][at[1]],
                                        grid.breaks[2][at[2]]};
        const auto [place, is_new] =
            known.emplace(point(micro.cage[grid.volume], x).value(), m.values[g][c]);
        EXPECT_EQ(place->second, m.values[g][c]);
        repeated += !is_new;
      }
    }
    EXPECT_GE(repeated, 6u);
  }
}

TEST(Material, NamesTheCornerWithoutAValue) {
  const Microstructure micro = two_cubes();
  const auto message = [&](const char* formula) {
    const auto found = material_by(material_formula(formula), "a", micro);
    return found ? "ok" : found.error().message;
  };
  EXPECT_TRUE(message("1/(x-1/2)").starts_with("corner (1, 0, 0) of grid 0: the divisor of "))
      << message("1/(x-1/2)");
  EXPECT_TRUE(message("sqrt(1-x)").starts_with("corner (1, 0, 0) of grid 1: "))
      << message("sqrt(1-x)");
  EXPECT_EQ(message("2^32*x"),
            "corner (2, 0, 0) of grid 0: the value 4503599627370496/2^20 is not below 2^32 in "
            "absolute value");
  EXPECT_EQ(message("1/2^20 - 2^31*x"), "ok");
  EXPECT_EQ(message("2^32-1"), "ok");
}

TEST(Material, RandomFormulasAreRoundedOnce) {
  const unsigned seed = 1;
  std::mt19937 random(seed);
  const Microstructure micro = ring();
  for (int round = 0; round < 20; ++round) {
    const int a = static_cast<int>(random() % 200) - 100,
              b = static_cast<int>(random() % 200) - 100;
    const std::string text = std::to_string(a) + "/7*x + " + std::to_string(b) + "/3*z*z";
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + text);
    const MicroMaterial m = material_by(material_formula(text), "a", micro).value();
    const MicroGrid& grid = micro.grids[0];
    for (std::size_t c = 0; c < m.values[0].size(); ++c) {
      const auto at = grid.corner_shape().index_of(c);
      const std::vector<Rational> p =
          point(micro.cage[0], std::array<Rational, 3>{grid.breaks[0][at[0]], grid.breaks[1][at[1]],
                                                       grid.breaks[2][at[2]]})
              .value();
      const Rational exact =
          Rational(a) / Rational(7) * p[0] + Rational(b) / Rational(3) * p[2] * p[2];
      const Rational error = exact * Rational::power_of_two(kWallBits) - Rational(m.values[0][c]);
      EXPECT_LE(abs(error), Rational(1) / Rational(2));
    }
  }
}

}  // namespace
}  // namespace veritope
