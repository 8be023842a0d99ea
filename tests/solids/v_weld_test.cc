// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/vmodel/v_weld.h"

#include <gtest/gtest.h>

#include <set>

#include "solids/vmodel/control_gap_internal.h"
#include "solids/vmodel/unit_space_internal.h"
#include "solids/vmodel/v_face_internal.h"
#include "splines/bspline_common.h"
#include "tests/support/v_cells.h"

namespace veritope {
namespace {

using v_cells::box;
using v_cells::cube;
using v_cells::Point;

Rational ratio(std::int64_t p, std::int64_t d) { return Rational(p) / Rational(d); }
const Rational kEps = ratio(1, 1000);

std::string text_of_cells(const std::vector<VVolume>& cells) {
  std::string out;
  for (const VVolume& cell : cells) out += v_cells::text_of(cell);
  return out;
}

std::uint64_t num_glued(const std::vector<VVolume>& cells) {
  return make_v_model(cells, VOrientation::kAuto).value().counts().internal;
}

// Moves the control points for which `is_chosen` by the same vector; the numbers of the points are those of the grid.
template <typename IsChosen>
VVolume with_shift(VVolume cell, IsChosen is_chosen, const Point& by) {
  const Grid<3> grid = cell.grid();
  for (std::size_t n = 0; n < grid.count(); ++n) {
    if (!is_chosen(grid.index_of(n))) continue;
    Point p = internal::control_point(cell, n);
    for (std::size_t c = 0; c < 3; ++c) p[c] += by[c];
    internal::set_control_point(cell, n, p);
  }
  return cell;
}

// Moves each control point by less than `most` in each coordinate.
VVolume perturbed(VVolume cell, const Rational& most, Random& random) {
  for (std::size_t n = 0; n < cell.grid().count(); ++n) {
    Point p = internal::control_point(cell, n);
    for (Rational& x : p) x += most * Rational(random.between(-1000, 1000)) / Rational(1001);
    internal::set_control_point(cell, n, p);
  }
  return cell;
}

// How far the maps are apart, by control points in their common function space.
Rational way_between(const VVolume& before, const VVolume& after) {
  const auto common = to_common_axes(before, after).value();
  return internal::control_gap(common.first, common.second).value();
}

// What holds for every result.
void expect_sound(const std::vector<VVolume>& cells, const Rational& eps, const VWeld& weld) {
  ASSERT_EQ(cells.size(), weld.cells.size());
  Rational most(0);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const bool is_listed =
        std::binary_search(weld.changed.begin(), weld.changed.end(), static_cast<std::uint32_t>(c));
    EXPECT_TRUE(is_listed || cells[c] == weld.cells[c]) << c;
    most = std::max(most, way_between(cells[c], weld.cells[c]));
  }
  EXPECT_EQ(most, weld.largest_displacement);
  EXPECT_LE(most, eps);
  EXPECT_EQ(weld.farthest.has_value(), most.sign() != 0);
  const VModel before = make_v_model(cells, VOrientation::kAuto).value(),
               after = make_v_model(weld.cells, VOrientation::kAuto).value();
  EXPECT_EQ(weld.glued_before, before.counts().internal);
  EXPECT_EQ(weld.glued_after, after.counts().internal);
  EXPECT_EQ(weld.glued_after - weld.glued_before, weld.welded.size());
  for (const VApartPair& pair : weld.apart)
    EXPECT_NE(after.face(pair.first).mate, pair.second) << pair.first;
  for (VFaceNumber f = 0; f < before.num_faces(); ++f) {
    EXPECT_TRUE(!before.face(f).is_glued() || after.face(f).mate == before.face(f).mate) << f;
    EXPECT_EQ(after.face(f).collapse, before.face(f).collapse) << f;
  }
  for (const VWeldedPair& pair : weld.welded) {
    EXPECT_EQ(after.face(pair.winner).mate, pair.loser);
    EXPECT_EQ(after.face(pair.winner).symmetry, pair.symmetry);
    EXPECT_FALSE(before.face(pair.winner).is_glued());
    EXPECT_FALSE(before.face(pair.loser).is_glued());
    EXPECT_LE(pair.displacement, weld.largest_displacement);
  }
}

VWeld welded(const std::vector<VVolume>& cells, const Rational& eps) {
  VWeld out = weld(cells, eps).value();
  expect_sound(cells, eps, out);
  return out;
}

bool is_right_end(const std::array<std::size_t, 3>& at) { return at[0] == 1; }
bool is_left_end(const std::array<std::size_t, 3>& at) { return at[0] == 0; }

TEST(VWeld, TheFaceWithTheLowerNumberWinsAmongEquals) {
  const std::vector<VVolume> cells{
      cube(0, 0, 0),
      with_shift(cube(1, 0, 0), is_left_end, {ratio(1, 1001), Rational(0), Rational(0)})};
  const VWeld out = welded(cells, kEps);
  ASSERT_EQ(out.welded.size(), 1u);
  EXPECT_EQ(out.welded[0].winner, 1u);
  EXPECT_EQ(out.welded[0].loser, 6u);
  EXPECT_EQ(out.welded[0].distance, ratio(1, 1001));
  EXPECT_EQ(out.welded[0].displacement, ratio(1, 1001));
  EXPECT_EQ(out.changed, std::vector<std::uint32_t>{1});
  EXPECT_EQ(out.cells[1], cube(1, 0, 0));
  EXPECT_EQ(out.farthest, std::optional<std::uint32_t>(1));
}

TEST(VWeld, ADistanceOfEpsIsNearAndALargerOneIsNot) {
  const auto at = [](const Rational& gap) {
    return std::vector<VVolume>{
        cube(0, 0, 0), with_shift(cube(1, 0, 0), is_left_end, {Rational(0), gap, Rational(0)})};
  };
  EXPECT_EQ(welded(at(kEps), kEps).welded.size(), 1u);
  const VWeld out = welded(at(kEps + ratio(1, 1000000000)), kEps);
  EXPECT_TRUE(out.welded.empty());
  EXPECT_TRUE(out.changed.empty());
  EXPECT_TRUE(out.apart.empty());
}

TEST(VWeld, NothingChangesWithoutNearFaces) {
  std::vector<VVolume> cells{cube(0, 0, 0), cube(1, 0, 0), elevate(cube(5, 0, 0), 1, 2)};
  const VWeld out = welded(cells, kEps);
  EXPECT_EQ(out.cells, cells);
  EXPECT_TRUE(out.changed.empty());
  EXPECT_TRUE(out.welded.empty());
  EXPECT_EQ(out.largest_displacement, Rational(0));
  EXPECT_EQ(out.glued_after, 1u);
}

TEST(VWeld, FacesThatHaveOnlyTheirCornersInCommonStayApart) {
  VVolume bulged = elevate(cube(1, 0, 0), 1, 1);
  bulged = with_shift(bulged, [](const auto& at) { return at[0] == 0 && at[1] == 1; },
                      {ratio(1, 4), Rational(0), Rational(0)});
  const VWeld out = welded({cube(0, 0, 0), bulged}, kEps);
  ASSERT_EQ(out.apart.size(), 1u);
  EXPECT_EQ(out.apart[0].first, 1u);
  EXPECT_EQ(out.apart[0].second, 6u);
  EXPECT_EQ(out.apart[0].reason, VApartReason::kControlPoints);
  EXPECT_EQ(out.apart[0].distance, std::optional<Rational>(ratio(1, 4)));
  EXPECT_TRUE(out.changed.empty());
}

TEST(VWeld, TheLowerDegreeWinsAndTheOtherCellKeepsItsMapElsewhere) {
  VVolume low = elevate(cube(0, 0, 0), 2, 2), high = cube(1, 0, 0);
  low = with_shift(low, is_right_end, {Rational(0), ratio(1, 3000), Rational(0)});
  const VWeld out = welded({low, high}, kEps);
  ASSERT_EQ(out.welded.size(), 1u);
  EXPECT_EQ(out.welded[0].winner, 6u);
  EXPECT_EQ(out.cells[1], high);
  EXPECT_EQ(out.cells[0], elevate(cube(0, 0, 0), 2, 2));
}

TEST(VWeld, TheOtherCellGetsDegreesAndKnotsOfTheWinner) {
  // Degrees (1, 3) win over (2, 3) on the face; the winner has a knot on the second one.
  VVolume first = insert_knot(elevate(cube(0, 0, 0), 2, 2), 2, ratio(1, 3));
  first = with_domain(first, 2, Rational(-1), Rational(5)).value();
  VVolume second = elevate(elevate(cube(1, 0, 0), 1, 1), 2, 2);
  second = with_shift(second, is_left_end, {ratio(1, 2000), Rational(0), ratio(1, 2000)});
  const VWeld out = welded({first, second}, kEps);
  ASSERT_EQ(out.welded.size(), 1u);
  EXPECT_EQ(out.welded[0].winner, 1u);
  EXPECT_EQ(out.cells[0], first);
  EXPECT_EQ(out.cells[1].axis(0).degree, 1);
  EXPECT_EQ(out.cells[1].axis(1).degree, 2);
  EXPECT_EQ(out.cells[1].axis(2).degree, 3);
  EXPECT_EQ(multiplicity(out.cells[1].axis(2), ratio(1, 3)), 1);
}

TEST(VWeld, WeightsAreKeptAndMustBeProportional) {
  const auto weighted = [](const Rational& middle) {
    return v_cells::rational(
        {1, 2, 1},
        [](std::size_t i, std::size_t j, std::size_t k) {
          return Point{Rational(1 + static_cast<std::int64_t>(i)),
                       ratio(static_cast<std::int64_t>(j), 2), Rational(k)};
        },
        [&](std::size_t, std::size_t j, std::size_t) { return j == 1 ? middle : Rational(2); });
  };
  const VVolume constant =
      with_shift(weighted(Rational(2)), is_left_end, {ratio(1, 2000), Rational(0), Rational(0)});
  const VWeld out = welded({cube(0, 0, 0), constant}, kEps);
  EXPECT_EQ(out.welded.size(), 1u);
  EXPECT_EQ(out.cells[1], weighted(Rational(2)));
  const VWeld apart = welded({cube(0, 0, 0), weighted(Rational(3))}, kEps);
  ASSERT_EQ(apart.apart.size(), 1u);
  EXPECT_EQ(apart.apart[0].reason, VApartReason::kWeights);
  EXPECT_FALSE(apart.apart[0].distance.has_value());
  // Weights on both sides that are proportional.
  const VVolume left =
      with_shift(v_cells::mapped(v_cells::with_factor(weighted(Rational(3)), ratio(5, 7)),
                                 [](Point p) { return p[0] -= Rational(1), p; }),
                 is_right_end, {Rational(0), Rational(0), ratio(-1, 3000)});
  const VWeld both = welded({left, weighted(Rational(3))}, kEps);
  EXPECT_EQ(both.welded.size(), 1u);
  EXPECT_EQ(both.cells[0], left);
}

TEST(VWeld, AttributesStay) {
  const VVolume plain =
      with_shift(cube(1, 0, 0), is_left_end, {ratio(1, 2000), Rational(0), Rational(0)});
  std::vector<Rational> values(plain.coefficients().begin(), plain.coefficients().end());
  for (int n = 0; n < 8; ++n) values.push_back(Rational(100 + n));
  const VVolume coloured(plain.axes(), 4, false, values);
  const VVolume first = insert_knot(cube(0, 0, 0), 1, ratio(1, 3));
  std::vector<VVolume> cells{first, coloured};
  const VWeld out = weld(cells, kEps).value();
  ASSERT_EQ(out.changed, std::vector<std::uint32_t>{0});  // fewer control points win
  cells = {cube(0, 0, 0), insert_knot(coloured, 1, ratio(1, 3))};
  const VWeld other = weld(cells, kEps).value();
  ASSERT_EQ(other.changed, std::vector<std::uint32_t>{1});
  const auto kept = other.cells[1].component(3);
  const auto attribute = std::as_const(cells[1]).component(3);
  EXPECT_TRUE(std::equal(attribute.begin(), attribute.end(), kept.begin(), kept.end()));
  EXPECT_EQ(num_glued(other.cells), 1u);
}

// Cells 0 and 1 are glued along x = 1; cell 2 lies on top of cell 1 alone, and its bottom wins.
TEST(VWeld, TheMateOfAFaceThatMovesMovesToo) {
  const VVolume top = with_shift(cube(1, 0, 1), [](const auto& at) { return at[2] == 0; },
                                 {ratio(1, 2000), ratio(1, 3000), ratio(1, 4000)});
  const std::vector<VVolume> cells{elevate(elevate(cube(0, 0, 0), 1, 1), 2, 1),
                                   elevate(elevate(cube(1, 0, 0), 1, 1), 2, 1), top};
  const VWeld out = welded(cells, kEps);
  ASSERT_EQ(out.welded.size(), 1u);
  EXPECT_EQ(out.welded[0].winner, 12u + 4);
  EXPECT_EQ(out.changed, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(out.glued_after, 2u);
}

// The first two cells touch in an edge only, which is a V-curve of both. It stays one when the second cell moves.
TEST(VWeld, WhatIsEqualStaysEqual) {
  const VVolume low = elevate(cube(0, 0, 0), 2, 1), high = elevate(cube(1, 1, 0), 2, 1);
  const VVolume beside = with_shift(
      box({Rational(-1), Rational(1), Rational(0)}, {Rational(1), Rational(2), Rational(1)}),
      is_right_end, {ratio(1, 2000), ratio(1, 3000), Rational(0)});
  const VWeld out = welded({low, high, beside}, kEps);
  EXPECT_EQ(out.glued_after, 1u);
  EXPECT_EQ(out.changed, (std::vector<std::uint32_t>{0, 1}));
  const VVolume &a = out.cells[0], &b = out.cells[1];
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(internal::control_point(a, a.grid().at({1, 1, k})),
              internal::control_point(b, b.grid().at({0, 0, k})));
}

TEST(VWeld, AFaceThatIsNearToTwoStaysApart) {
  const VVolume right = cube(1, 0, 0), longer = box({Rational(1), Rational(0), Rational(0)},
                                                    {Rational(3), Rational(1), Rational(1)});
  const std::vector<VVolume> cells{
      cube(0, 0, 0), with_shift(right, is_left_end, {ratio(1, 2000), Rational(0), Rational(0)}),
      with_shift(longer, is_left_end, {ratio(1, 3000), Rational(0), Rational(0)})};
  const VWeld out = welded(cells, kEps);
  EXPECT_TRUE(out.welded.empty());
  ASSERT_EQ(out.apart.size(), 2u);
  EXPECT_EQ(out.apart[0].reason, VApartReason::kSeveral);
  // Two of them glued: the third one has no mate.
  const VWeld taken = welded({cube(0, 0, 0), right, cells[2]}, kEps);
  ASSERT_EQ(taken.apart.size(), 1u);
  EXPECT_EQ(taken.apart[0].reason, VApartReason::kGlued);
  EXPECT_EQ(taken.apart[0].first, 12u);
  EXPECT_TRUE(taken.changed.empty());
}

TEST(VWeld, ACellThatIsThinnerThanEpsDoesNotCollapse) {
  const VVolume sheet =
      box({Rational(0), Rational(0), Rational(0)}, {ratio(1, 2000), Rational(1), Rational(1)});
  const VWeld alone = welded({sheet}, kEps);
  ASSERT_EQ(alone.apart.size(), 1u);
  EXPECT_EQ(alone.apart[0].reason, VApartReason::kCollapse);
  EXPECT_TRUE(alone.changed.empty());
  // Smaller than eps in all directions.
  const VVolume grain = v_cells::mapped(cube(0, 0, 0), [](Point p) {
    for (Rational& x : p) x /= Rational(3000);
    return p;
  });
  const VWeld small = welded({grain, cube(1, 0, 0)}, kEps);
  EXPECT_TRUE(small.changed.empty());
  std::set<VFaceNumber> crowded;
  for (const VApartPair& pair : small.apart) {
    EXPECT_EQ(pair.reason, VApartReason::kSeveral);
    crowded.insert({pair.first, pair.second});
  }
  EXPECT_EQ(crowded, (std::set<VFaceNumber>{0, 1, 2, 3, 4, 5}));
}

// A row of cubes around an edge whose corners drift by 2/3 eps from cell to cell: 0, 2/3, 4/3, 2 eps.
TEST(VWeld, AChainOfNearCornersIsCutWhereItGetsTooLong) {
  const auto sector = [](int n, const Rational& shift) {
    // Cell n of a fan around the z axis, each between two of these rays.
    const std::array<std::array<int, 2>, 5> rays{{{4, 0}, {3, 3}, {0, 4}, {-3, 3}, {-4, 0}}};
    return v_cells::polynomial({1, 1, 1}, [&](std::size_t i, std::size_t j, std::size_t k) {
      const auto ray = rays[static_cast<std::size_t>(n) + j];
      return Point{Rational(i == 1 ? ray[0] : 0) + shift, Rational(i == 1 ? ray[1] : 0),
                   Rational(k)};
    });
  };
  std::vector<VVolume> cells;
  for (int n = 0; n < 4; ++n) cells.push_back(sector(n, ratio(2 * n, 3000)));
  // All inner edges are one point at i = 0, so that the faces u = 0 are collapsed along v.
  const VWeld out = welded(cells, kEps);
  EXPECT_EQ(out.welded.size(), 3u);
  std::vector<VVolume> longer;
  for (int n = 0; n < 4; ++n) longer.push_back(sector(n, ratio(9 * n, 10000)));
  const VWeld cut = welded(longer, kEps);
  EXPECT_EQ(cut.welded.size(), 2u);
  ASSERT_EQ(cut.apart.size(), 1u);
  EXPECT_EQ(cut.apart[0].reason, VApartReason::kTooFar);
}

// The seam of a ring of one cell, four quarters around.
TEST(VWeld, ACellIsWeldedToItself) {
  const std::array<std::array<int, 2>, 5> around{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 1}}};
  VVolume ring =
      v_cells::polynomial({1, 1, 1}, [](std::size_t, std::size_t, std::size_t) { return Point{}; });
  ring = refine(ring, 1, {ratio(1, 4), ratio(1, 2), ratio(3, 4)});
  for (std::size_t n = 0; n < ring.grid().count(); ++n) {
    const auto at = ring.grid().index_of(n);
    const Rational r = at[0] == 0 ? Rational(2) : Rational(1);
    const auto& corner = around[at[1]];
    Point p{r * Rational(corner[0]), r * Rational(corner[1]), Rational(at[2])};
    if (at[1] == 4) p[1] += ratio(1, 1500);
    internal::set_control_point(ring, n, p);
  }
  const VWeld out = welded({ring}, kEps);
  ASSERT_EQ(out.welded.size(), 1u);
  EXPECT_EQ(out.welded[0].winner, 2u);
  EXPECT_EQ(out.welded[0].loser, 3u);
  EXPECT_EQ(out.glued_after, 1u);
}

// Chains everywhere: what is refused and what is welded fit together.
TEST(VWeld, GridsWithGapsAroundEpsAreWeldedInParts) {
  const std::uint64_t seed = 5;
  Random random(seed);
  std::size_t welded_pairs = 0, left = 0, by_sides = 0;
  for (int round = 0; round < 20; ++round) {
    std::vector<VVolume> cells = v_cells::grid(3, {1, 1, 1}, [](const Point& p) { return p; });
    for (VVolume& cell : cells)
      cell = perturbed(cell, kEps * ratio(round % 2 == 0 ? 6 : 8, 10), random);
    const VWeld out = welded(cells, kEps);
    ASSERT_FALSE(HasFailure()) << "seed " << seed << ", round " << round << "\n"
                               << text_of_cells(cells);
    welded_pairs += out.welded.size();
    left += 54 - out.glued_after;
    by_sides += static_cast<std::size_t>(
        std::count_if(out.welded.begin(), out.welded.end(),
                      [](const VWeldedPair& pair) { return pair.distance > kEps; }));
  }
  EXPECT_GT(welded_pairs, 100u);
  EXPECT_GT(left, 100u);
  EXPECT_GT(by_sides, 0u);
}

// A cube of six pyramids over its faces, and one of four wedges around the z axis, each cell shifted as a whole: what
// is collapsed follows its neighbours.
TEST(VWeld, CollapsedFacesFollowTheirNeighbours) {
  const std::uint64_t seed = 11;
  Random random(seed);
  const auto sign = [](std::size_t i) { return Rational(i == 0 ? -1 : 1); };
  for (int round = 0; round < 20; ++round) {
    const bool has_wedges = round % 2 == 1;
    std::vector<VVolume> cells;
    for (std::size_t n = 0; n < (has_wedges ? 4u : 6u); ++n)
      cells.push_back(
          v_cells::polynomial({1, 1, 1}, [&](std::size_t i, std::size_t j, std::size_t k) {
            Point p{};
            if (has_wedges) {
              const std::size_t a = n / 2;
              p[a] = i == 0 ? Rational(0) : sign(n % 2);
              p[1 - a] = i == 0 ? Rational(0) : sign(j);
              p[2] = Rational(k);
            } else if (k == 0) {
              p[n / 2] = sign(n % 2), p[(n / 2 + 1) % 3] = sign(i), p[(n / 2 + 2) % 3] = sign(j);
            }
            return p;
          }));
    while (cells.size() > 2 && random.below(3) != 0)
      cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(random.below(cells.size())));
    const std::uint64_t expected = num_glued(cells);
    for (VVolume& cell : cells) {
      Point shift;
      for (Rational& x : shift) x = kEps * ratio(random.between(-1000, 1000), 4001);
      cell = v_cells::redescribed(v_cells::turned(cell, static_cast<unsigned>(random.below(48))),
                                  random);
      cell = with_shift(
          cell, [](const auto&) { return true; }, shift);
    }
    const VWeld out = welded(cells, kEps);
    EXPECT_EQ(out.glued_after, expected) << "seed " << seed << ", round " << round << "\n"
                                         << text_of_cells(cells);
    EXPECT_LE(out.largest_displacement, kEps / Rational(2));
  }
}

TEST(VWeld, ADistanceThatIsMuchTooLargeIsRefused) {
  std::vector<VVolume> cells;
  for (int n = 0; n < 100; ++n) cells.push_back(cube(2 * n, 0, 0));
  const Result<VWeld> refused = weld(cells, Rational(1000));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Code::kOverLimit);
  EXPECT_TRUE(refused.error().place.entity.has_value());
}

TEST(VWeld, WrongCellsAreRefusedAsByTheModel) {
  EXPECT_EQ(weld({}, kEps).error().code, Code::kEmpty);
  const VVolume negative = v_cells::rational(
      {1, 1, 1},
      [](std::size_t i, std::size_t j, std::size_t k) {
        return Point{Rational(i), Rational(j), Rational(k)};
      },
      [](std::size_t i, std::size_t, std::size_t) { return Rational(i == 0 ? -1 : 1); });
  const Result<VWeld> refused = weld({cube(0, 0, 0), negative}, kEps);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place.entity, std::optional<std::uint64_t>(1));
}

// ---- random grids

struct Grid3 {
  std::vector<VVolume> exact, cells;
};

// 2 x 2 x 2 or fewer cells of a bent cube in any descriptions, rational ones among them, each control point off by less
// than eps / 4.
Grid3 random_grid(Random& random, const Rational& eps) {
  const std::array<int, 3> degrees{static_cast<int>(1 + random.below(2)),
                                   static_cast<int>(1 + random.below(2)),
                                   static_cast<int>(1 + random.below(2))};
  const std::array<Rational, 3> bend{ratio(random.between(-2, 2), 16),
                                     ratio(random.between(-2, 2), 16),
                                     ratio(random.between(-2, 2), 16)};
  Grid3 out;
  out.exact = v_cells::grid(2, degrees, [&](const Point& p) {
    return Point{p[0] + bend[0] * p[1] * p[1], p[1] + bend[1] * p[2] * p[2], p[2] + bend[2] * p[0]};
  });
  const bool is_projective = random.below(3) == 0;
  for (VVolume& cell : out.exact) {
    if (is_projective) {  // (x, y, z) / (1 + x / 16)
      cell = v_cells::with_factor(cell, Rational(1));
      for (std::size_t n = 0; n < cell.grid().count(); ++n)
        cell.component(3)[n] += cell.component(0)[n] / Rational(16);
    }
    cell = v_cells::redescribed(v_cells::turned(cell, static_cast<unsigned>(random.below(48))),
                                random);
  }
  while (random.below(4) == 0)
    out.exact.erase(out.exact.begin() +
                    static_cast<std::ptrdiff_t>(random.below(out.exact.size())));
  for (const VVolume& cell : out.exact)
    out.cells.push_back(random.below(8) == 0 ? cell : perturbed(cell, eps / Rational(4), random));
  return out;
}

TEST(VWeld, RandomGridsOffByLessThanAQuarterOfEpsAreWelded) {
  const std::uint64_t seed = 2026;
  Random random(seed);
  std::size_t pairs = 0, with_knots = 0;
  for (int round = 0; round < 60; ++round) {
    const Grid3 grid = random_grid(random, kEps);
    const VWeld out = welded(grid.cells, kEps);
    const std::string operands = "seed " + std::to_string(seed) + ", round " +
                                 std::to_string(round) + "\n" + text_of_cells(grid.cells);
    ASSERT_EQ(out.glued_after, num_glued(grid.exact)) << operands;
    ASSERT_TRUE(out.apart.empty()) << operands;
    ASSERT_LE(out.largest_displacement, kEps / Rational(2)) << operands;
    const VWeld again = welded(out.cells, kEps);
    ASSERT_EQ(again.cells, out.cells) << operands;
    ASSERT_TRUE(again.changed.empty()) << operands;
    pairs += out.welded.size();
    for (const std::uint32_t c : out.changed)
      with_knots += out.cells[c].grid().count() > grid.cells[c].grid().count() ? 1 : 0;
    if (HasFailure()) FAIL() << operands;
  }
  EXPECT_GT(pairs, 300u);
  EXPECT_GT(with_knots, 50u);
}

TEST(VWeld, RandomGridsOffByMuchMoreThanEpsStayAsTheyAre) {
  const std::uint64_t seed = 7;
  Random random(seed);
  for (int round = 0; round < 10; ++round) {
    const Grid3 grid = random_grid(random, Rational(1) / Rational(100));
    const Rational eps = ratio(1, 1000000000);
    const VWeld out = welded(grid.cells, eps);
    EXPECT_TRUE(out.welded.empty()) << "seed " << seed << ", round " << round;
    EXPECT_TRUE(out.changed.empty());
  }
}

}  // namespace
}  // namespace veritope
