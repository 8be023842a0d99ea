// SPDX-License-Identifier: LGPL-3.0-or-later
// The solver on pairs of patches, each with a common point that is known.
#include "verify/certify/crossing_solver.h"

#include <gtest/gtest.h>

#include "models/patch_shapes.h"
#include "tests/certify/crossing_planes.h"
#include "tests/certify/planted_crossings.h"
#include "verify/certify/sheet_tangents_internal.h"

namespace veritope {
namespace {

using planted::broken;
using planted::complex_of;
using planted::flat;
using planted::floor_patch;
using planted::ratio;
using planted::wall_patch;

// How far apart the two places are in space, by exact images.
double gap_of(const PatchComplex& complex, const std::array<SheetPlace, 2>& at) {
  std::array<std::array<double, 3>, 2> p;
  for (std::size_t s = 0; s < 2; ++s)
    p[s] = approx_point(
        planted::image(complex.patch(at[s].patch),
                       {Rational::from_double(at[s].at[0]), Rational::from_double(at[s].at[1])}));
  return std::hypot(p[0][0] - p[1][0], p[0][1] - p[1][1], p[0][2] - p[1][2]);
}

// Only the two patches of each model that cross at the planted point are given to the solver.
TEST(CrossingSolver, ProvesWhatIsPlantedNearTheGuess) {
  Random random(21);
  for (int i = 0; i < 24; ++i) {
    const planted::PlantedModel m = planted::two_shells(random);
    SCOPED_TRACE(std::to_string(i) + ": " + m.name);
    const PatchComplex complex =
        complex_of({m.patches[m.places[0].patch], m.patches[m.places[1].patch]});
    const PieceForest forest = PieceForest::make(complex).value();
    std::array<SheetPlace, 2> guess;
    for (std::size_t s = 0; s < 2; ++s) {
      guess[s].patch = static_cast<std::uint32_t>(s);
      for (std::size_t k = 0; k < 2; ++k)
        guess[s].at[k] = std::clamp(
            nearest_double(m.places[s].at[k]) + random.between(-9, 9) / 1000.0, 0.0, 1.0);
    }
    CrossingSolver solver(forest);
    const auto solution = solver.solve(guess, 0.125);
    ASSERT_TRUE(solution);
    EXPECT_LE(gap_of(complex, *solution), 1e-11);
    for (std::size_t s = 0; s < 2; ++s)
      for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR((*solution)[s].at[k], guess[s].at[k], 0.125);
    const auto witness = solver.prove(*solution);
    ASSERT_TRUE(witness);
    EXPECT_EQ(broken(complex, *witness), std::nullopt);
  }
}

TEST(CrossingSolver, StaysWithinItsReach) {
  const PatchComplex complex = complex_of({floor_patch(), wall_patch(-1)});
  const PieceForest forest = PieceForest::make(complex).value();
  CrossingSolver solver(forest);
  const std::array<SheetPlace, 2> guess{SheetPlace{0, {0.125, 0.5}}, SheetPlace{1, {0.5, 0.5}}};
  EXPECT_FALSE(solver.solve(guess, 0.25));
  EXPECT_TRUE(solver.solve(guess, 0.375));
  EXPECT_TRUE(solver.solve(guess, 0.5));
}

TEST(CrossingSolver, ParallelSheetsHaveNoSolution) {
  const PatchComplex complex = complex_of({floor_patch(), flat({-1, -1, 1}, {2, 0, 0}, {0, 2, 0})});
  const PieceForest forest = PieceForest::make(complex).value();
  CrossingSolver solver(forest);
  EXPECT_FALSE(solver.solve({SheetPlace{0, {0.25, 0.5}}, SheetPlace{1, {0.5, 0.5}}}, 1));
}

// The curve in which they meet ends on the wall's border, in the floor's interior. In either order of the two.
TEST(CrossingSolver, ABorderInAnInteriorIsFixedThere) {
  for (const bool floor_first : {true, false})
    for (const bool is_end : {true, false}) {
      const Patch floor = floor_patch(), wall = flat({0, -ratio(1, 2), -1}, {0, 1, 0}, {0, 0, 2});
      const PatchComplex complex =
          floor_first ? complex_of({floor, wall}) : complex_of({wall, floor});
      const PieceForest forest = PieceForest::make(complex).value();
      CrossingSolver solver(forest);
      const std::uint32_t f = floor_first ? 0 : 1;
      const double s = is_end ? 1.0 : 0.0;
      std::array<SheetPlace, 2> at{SheetPlace{f, {0.5, 0.25 + 0.5 * s}},
                                   SheetPlace{1 - f, {s, 0.5}}};
      if (!floor_first) std::swap(at[0], at[1]);
      const auto witness = solver.prove(at);
      ASSERT_TRUE(witness);
      EXPECT_EQ(broken(complex, *witness), std::nullopt);
      EXPECT_EQ(witness->sheets[0].patch, f);
      EXPECT_TRUE(witness->sheets[1].at[0].is_point());
      EXPECT_EQ(witness->sheets[1].at[0].lower(), Rational::from_double(s));
    }
}

// Sheets that meet at borders of both alone, as neighbours do, or that touch: nothing is proved.
TEST(CrossingSolver, BordersThatMeetAndContactsAreNotProved) {
  const Patch floor = floor_patch();
  {
    const PatchComplex complex = complex_of({floor, flat({1, -1, 0}, {0, 2, 0}, {0, 0, 2})});
    const PieceForest forest = PieceForest::make(complex).value();
    CrossingSolver solver(forest);
    EXPECT_FALSE(solver.prove({SheetPlace{0, {1, 0.5}}, SheetPlace{1, {0.5, 0}}}));
  }
  // z = y^2 touches the floor along a line.
  std::vector<Rational> c;
  for (const int x : {-1, 1}) c.insert(c.end(), 3, Rational(x));
  for (int i = 0; i < 2; ++i)
    for (const int y : {-1, 0, 1}) c.push_back(Rational(y));
  for (int i = 0; i < 2; ++i)
    for (const int z : {1, -1, 1}) c.push_back(Rational(z));
  const Patch bowl = make_patch(BezierSurface<Rational>({1, 2}, 3, false, c)).value();
  const PatchComplex complex = complex_of({floor, bowl});
  const PieceForest forest = PieceForest::make(complex).value();
  CrossingSolver solver(forest);
  const std::array<SheetPlace, 2> contact{SheetPlace{0, {0.5, 0.5}}, SheetPlace{1, {0.5, 0.5}}};
  EXPECT_FALSE(solver.prove(contact));
  // Nor is a place next to it, which is no solution.
  EXPECT_FALSE(solver.prove({SheetPlace{0, {0.25, 0.75}}, SheetPlace{1, {0.25, 0.5}}}));
}

// Two planes at an angle of 2^-slope cross next to a border of the second, so only small boxes fit. In these the sheets
// are so near each other that doubles find signs of X3 which do not hold.
TEST(CrossingSolver, SignsThatHoldInDoublesAloneAreNoProof) {
  const PatchPoint e1{ratio(2, 3), ratio(1, 3), ratio(2, 3)},
      e2{-ratio(2, 3), ratio(2, 3), ratio(1, 3)}, normal{ratio(1, 3), ratio(2, 3), -ratio(2, 3)};
  const auto combined = [&](const Rational& a, const Rational& b, const Rational& c) {
    PatchPoint out;
    for (std::size_t k = 0; k < 3; ++k) out[k] = a * e1[k] + b * e2[k] + c * normal[k];
    return out;
  };
  std::size_t proofs = 0, refused = 0;
  for (int slope = 20; slope <= 30; slope += 2)
    for (int depth = 28; depth <= 34; depth += 2) {
      SCOPED_TRACE(std::to_string(slope) + " " + std::to_string(depth));
      const Rational rise = Rational::power_of_two(1 - slope),
                     border = ratio(7, 5) * Rational::power_of_two(-depth);
      const PatchComplex complex =
          complex_of({flat(combined(-1, -1, 0), combined(2, 0, 0), combined(0, 2, 0)),
                      flat(combined(Rational(-2) * border, -ratio(9, 10), -border * rise),
                           combined(2, 0, rise), combined(0, 2, 0))});
      const PieceForest forest = PieceForest::make(complex).value();
      CrossingSolver solver(forest);
      const auto witness =
          solver.prove({SheetPlace{0, {0.5, 0.5}}, SheetPlace{1, {nearest_double(border), 0.45}}});
      if (witness) {
        EXPECT_EQ(broken(complex, *witness), std::nullopt);
      }
      proofs += witness ? 1 : 0;
      refused += solver.num_exact - (witness ? 1 : 0);
    }
  EXPECT_GT(proofs, 0u);
  EXPECT_GT(refused, 0u);
}

TEST(SheetTangents, LengthsAreRightWhereSquaresLeaveTheRangeOfDoubles) {
  for (const int scale : {-1000, -600, -538, -400, -1, 0, 1, 400, 600, 1000}) {
    const auto at = [&](double v) { return std::ldexp(v, scale); };
    EXPECT_DOUBLE_EQ(internal::length_of({at(3), -at(4), at(12)}), at(13)) << scale;
  }
}

// A point of a bent patch is the foot of its own perpendicular.
TEST(CrossingSolver, RefinesNoPlaceThatMeetsOnlyItself) {
  const PatchComplex complex = complex_of(patch_shapes::pn_torus(12, 8));
  const PieceForest forest = PieceForest::make(complex).value();
  CrossingSolver solver(forest);
  for (std::uint32_t p = 0; p < complex.patches().size(); ++p)
    for (const double away : {0.125, 0.0625, 0x1p-8})
      EXPECT_FALSE(solver.prove_close({{{p, {0.5, 0.5}}, {p, {0.5 + away, 0.5 - away}}}}, 4));
  EXPECT_EQ(solver.num_refined, 0u);
}

// One bent sheet occurs twice: every place of it is close to the other one, and none is a crossing.
TEST(CrossingSolver, RefinesOnlySomePlacesOfSheetsThatCoincide) {
  const Patch sheet = patch_shapes::sphere().front();
  const PatchComplex complex = complex_of({sheet, sheet});
  const PieceForest forest = PieceForest::make(complex).value();
  CrossingSolver solver(forest);
  for (int i = 1; i < 64; ++i)
    for (int k = 1; k < 64; ++k)
      EXPECT_FALSE(solver.prove_close({{{0, {i / 64.0, k / 64.0}}, {1, {i / 64.0, k / 64.0}}}}, 1));
  EXPECT_EQ(solver.num_refined, CrossingSolver::kMostRefinedInAll);
}

}  // namespace
}  // namespace veritope
