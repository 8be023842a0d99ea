// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/vmodel/v_overlap.h"

#include <gtest/gtest.h>

#include "tests/support/v_cells.h"

namespace veritope {
namespace {

using v_cells::box;
using v_cells::cube;
using v_cells::Point;

VModel cells_as_they_are(std::vector<VVolume> cells) {
  return make_v_model(std::move(cells), VOrientation::kKeep).value();
}
Rational over(std::int64_t p, std::int64_t d) { return Rational(p) / Rational(d); }

void expect_found(const VModel& model, const std::string& what) {
  const std::optional<VOverlap> found = find_overlap(model);
  ASSERT_TRUE(found) << what;
  EXPECT_TRUE(is_overlap(model, *found)) << what;
}

TEST(VOverlap, CellsThatHaveACornerInOneAnotherOverlap) {
  const Rational half = over(1, 2);
  expect_found(cells_as_they_are({cube(0, 0, 0), box({half, half, half},
                                                     {Rational(2), Rational(2), Rational(2)})}),
               "a corner");
  expect_found(cells_as_they_are({cube(0, 0, 0), cube(0, 0, 0)}), "a copy");
  expect_found(cells_as_they_are({box({Rational(0), Rational(0), Rational(0)},
                                      {Rational(3), Rational(3), Rational(3)}),
                                  cube(1, 1, 1)}),
               "a cell inside of another");
}

TEST(VOverlap, OverlapsAsThinAsABillionthAreFound) {
  for (const int halvings : {10, 20, 30, 34}) {
    const Rational x = Rational(1) - Rational::power_of_two(-halvings);
    expect_found(cells_as_they_are({cube(0, 0, 0), box({x, Rational(0), Rational(0)},
                                                       {Rational(2), Rational(1), Rational(1)})}),
                 std::to_string(halvings));
  }
}

TEST(VOverlap, CellsThatOnlyTouchDoNotOverlap) {
  EXPECT_FALSE(find_overlap(cells_as_they_are({cube(0, 0, 0), cube(1, 0, 0)})));
  EXPECT_FALSE(find_overlap(cells_as_they_are({cube(0, 0, 0), cube(1, 1, 1), cube(1, 1, 0)})));
  EXPECT_FALSE(find_overlap(cells_as_they_are(v_cells::grid(3, {2, 1, 1}, [](Point p) {
    p[2] += p[0] * p[0] / Rational(16);
    return p;
  }))));
}

// r (1 + i t)^6 for r in [1, 2], t in [-1, 1]: one and a half turns around the z axis, with a positive determinant. The
// coefficients of (1 + i t)^6 are 8 i^(j - 3).
VVolume one_and_a_half_turns() {
  return v_cells::polynomial({6, 1, 1}, [](std::size_t i, std::size_t j, std::size_t k) {
    static constexpr std::array<std::array<int, 2>, 4> kTurn = {{{0, 8}, {-8, 0}, {0, -8}, {8, 0}}};
    const Rational r(j == 0 ? 1 : 2);
    return Point{Rational(kTurn[i % 4][0]) * r, Rational(kTurn[i % 4][1]) * r,
                 Rational(k == 0 ? 1 : 0)};
  });
}
TEST(VOverlap, ACellThatRunsThroughItselfIsFound) {
  const VModel model = cells_as_they_are({one_and_a_half_turns()});
  const std::optional<VOverlap> found = find_overlap(model);
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->somewhere || found->point);
  EXPECT_EQ(found->inside.cell, found->somewhere ? found->somewhere->box.cell : found->point->cell);
  EXPECT_TRUE(is_overlap(model, *found));
}

TEST(VOverlap, APlaneThatIsCollapsedInsideOfACellIsFoundExactly) {
  // (u, v, w) -> (w u, w v, w) on w in [-1, 1]: w = 0 is one point.
  const VModel model = cells_as_they_are(
      {v_cells::polynomial({1, 1, 2}, [](std::size_t i, std::size_t j, std::size_t k) {
        const int x = i == 0 ? -1 : 1, y = j == 0 ? -1 : 1, w = static_cast<int>(k) - 1;
        return Point{Rational(x * w), Rational(y * w), Rational(w)};
      })});
  const std::array<Rational, 2> all = {Rational(0), Rational(1)};
  const auto found = find_collapsed_line(model, 0, {all, all, {over(1, 4), over(3, 4)}});
  ASSERT_TRUE(found && found->point);
  EXPECT_TRUE(is_overlap(model, *found));
  EXPECT_EQ(parameters_of(model, found->inside)[2], over(1, 2));
  EXPECT_FALSE(find_collapsed_line(cells_as_they_are({cube(0, 0, 0)}), 0, {all, all, all}));
}

TEST(VOverlap, OnlyProofsPass) {
  const VModel model = cells_as_they_are({cube(0, 0, 0), cube(0, 0, 0)});
  VOverlap found = find_overlap(model).value();
  ASSERT_TRUE(found.somewhere);
  ASSERT_TRUE(is_overlap(model, found));
  VOverlap changed = found;
  changed.inside.at = {Rational(0), over(1, 2), over(1, 2)};  // on the border
  EXPECT_FALSE(is_overlap(model, changed));
  changed = found;
  changed.somewhere->box.cell = changed.inside.cell;  // the same place
  EXPECT_FALSE(is_overlap(model, changed));
  changed = found;
  std::swap(changed.somewhere->rows[0], changed.somewhere->rows[1]);
  EXPECT_FALSE(is_overlap(model, changed));
  changed = found;
  changed.somewhere->box.at[0] = {over(3, 4), Rational(1)};  // without the point
  EXPECT_FALSE(is_overlap(model, changed));
  changed = found;
  changed.somewhere.reset();
  changed.point = changed.inside;
  EXPECT_FALSE(is_overlap(model, changed));
  changed.point->cell = 1 - changed.inside.cell;
  EXPECT_TRUE(is_overlap(model, changed));
  changed.point->at[0] = over(1, 3);
  EXPECT_FALSE(is_overlap(model, changed));
}

TEST(VOverlap, PlacesAreInKnotSpans) {
  Random random(1);
  VVolume cell = v_cells::redescribed(cube(0, 0, 0), random);
  cell =
      insert_knot(cell, 0, (cell.axis(0).domain_begin() + cell.axis(0).domain_end()) / Rational(2));
  const VModel model = cells_as_they_are({cell});
  for (int i = 0; i <= 8; ++i) {
    Point at;
    for (std::size_t a = 0; a < 3; ++a)
      at[a] = cell.axis(a).domain_begin() +
              (cell.axis(a).domain_end() - cell.axis(a).domain_begin()) * over(i, 8);
    const VPlace place = place_at(model, 0, at);
    EXPECT_EQ(parameters_of(model, place), at) << i;
    EXPECT_EQ(point_of(model, place), (Point{over(i, 8), over(i, 8), over(i, 8)})) << i;
  }
}

// Boxes at random: find_overlap answers as the boxes' coordinates do.
TEST(VOverlap, RandomBoxesOverlapIffTheirCoordinatesDo) {
  const std::uint64_t seed = 20261127;
  Random random(seed);
  for (int round = 0; round < 200; ++round) {
    std::array<Point, 2> low, high;
    for (std::size_t b = 0; b < 2; ++b)
      for (std::size_t c = 0; c < 3; ++c) {
        low[b][c] = Rational(random.between(0, 12));
        high[b][c] = low[b][c] + Rational(random.between(1, 8));
      }
    bool overlaps = true;
    for (std::size_t c = 0; c < 3; ++c)
      overlaps = overlaps && low[0][c] < high[1][c] && low[1][c] < high[0][c];
    std::vector<VVolume> cells;
    for (std::size_t b = 0; b < 2; ++b)
      cells.push_back(v_cells::redescribed(box(low[b], high[b]), random));
    const std::string what = "seed " + std::to_string(seed) + ", round " + std::to_string(round) +
                             "\n" + v_cells::text_of(cells[0]) + v_cells::text_of(cells[1]);
    const VModel model = cells_as_they_are(cells);
    const auto found = find_overlap(model);
    if (found) {
      EXPECT_TRUE(is_overlap(model, *found) && overlaps) << what;
    }
    // Two bars that cross have no corner, middle of a side or of a face in one another.
    if (!found && overlaps) {
      int through = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        through |= low[0][c] < low[1][c] && high[1][c] < high[0][c] ? 1 : 0;
        through |= low[1][c] < low[0][c] && high[0][c] < high[1][c] ? 2 : 0;
      }
      EXPECT_EQ(through, 3) << what;
    }
  }
}

}  // namespace
}  // namespace veritope
