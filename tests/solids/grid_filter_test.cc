// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/filter/grid_filter.h"

#include <gtest/gtest.h>

#include <mutex>

#include "splines/bspline_pieces.h"
#include "splines/knot_insertion.h"
#include "tests/support/micro_tiles.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

using micro_tiles::Point;
using Lines = std::array<std::vector<Rational>, 3>;

Lines even_lines(const std::array<int, 3>& counts) {
  Lines out;
  for (std::size_t a = 0; a < 3; ++a)
    for (int i = 0; i <= counts[a]; ++i) out[a].push_back(Rational(i) / Rational(counts[a]));
  return out;
}

// A twisted cage round the cube [-1,1]^3.
BSplineVolume<Rational> twisted() {
  return to_bspline(micro_tiles::cage({2, 1, 2}, [](const Point& u) {
    Point p;
    for (std::size_t c = 0; c < 3; ++c)
      p[c] = (u[c] + u[c] - Rational(1)) * Rational(9) / Rational(8);
    p[0] += u[2] * (Rational(1) - u[2]) / Rational(3);
    p[2] += p[0] * p[1] / Rational(9);
    return p;
  }));
}

struct Fixture {
  TriangleMesh mesh = shapes::torus(24, 12, 0.7, 0.3);
  TileFilter filter = std::move(TileFilter::make(mesh).value());
  std::shared_ptr<const TileShape> jack =
      std::make_shared<const TileShape>(micro_tiles::shape_of(micro_tiles::jack(3)));
  TileOfCell same = [this](const auto&) { return jack; };
};

TEST(FilterGrid, AgreesWithEveryCellAlone) {
  const Fixture f;
  const BSplineVolume<Rational> cage = twisted();
  const Lines lines = even_lines({7, 9, 8});
  const GridStatus all = filter_grid(f.filter, cage, lines, f.same, 1).value();
  const BezierVolume<Rational> map = bezier_pieces(cage).pieces.front();
  std::array<std::uint64_t, 5> counts{};
  for (std::size_t n = 0; n < all.status.size(); ++n) {
    const auto at = all.cells.index_of(n);
    CellMap cell{&map};
    for (std::size_t a = 0; a < 3; ++a)
      cell.lo[a] = lines[a][at[a]], cell.hi[a] = lines[a][at[a] + 1];
    const CellStatus status = f.filter.status(cell, *f.jack);
    ASSERT_EQ(all.at(at), status) << at[0] << " " << at[1] << " " << at[2];
    ++counts[static_cast<std::size_t>(status)];
  }
  EXPECT_EQ(all.counts, counts);
  EXPECT_GT(counts[0], 0u);
  EXPECT_GT(counts[1], 0u);
  EXPECT_GT(counts[3], 0u);
  EXPECT_EQ(counts[4], 0u);
}

TEST(FilterGrid, DoesNotDependOnTheNumberOfJobs) {
  const Fixture f;
  const Lines lines = even_lines({20, 20, 20});
  const GridStatus one = filter_grid(f.filter, twisted(), lines, f.same, 1).value();
  for (const unsigned jobs : {2u, 3u, 8u})
    EXPECT_EQ(filter_grid(f.filter, twisted(), lines, f.same, jobs).value().status, one.status);
}

TEST(FilterGrid, DoesNotDependOnKnotsOrTheDomain) {
  const Fixture f;
  const Lines lines = even_lines({8, 8, 8});
  const GridStatus plain = filter_grid(f.filter, twisted(), lines, f.same, 1).value();
  BSplineVolume<Rational> more = twisted();
  for (std::size_t a = 0; a < 3; ++a)
    more = insert_knot(more, a, Rational(static_cast<std::int64_t>(a) + 2) / Rational(8));
  EXPECT_EQ(filter_grid(f.filter, more, lines, f.same, 1).value().status, plain.status);
}

TEST(FilterGrid, AsksForTilesNearTheSurfaceOnly) {
  const Fixture f;
  std::mutex mutex;
  std::uint64_t asked = 0;
  const GridStatus all = filter_grid(
                             f.filter, twisted(), even_lines({24, 24, 24}),
                             [&](const std::array<std::uint32_t, 3>& cell) {
                               const std::lock_guard lock(mutex);
                               ++asked;
                               EXPECT_LT(cell[0], 24u);
                               return f.jack;
                             },
                             2)
                             .value();
  EXPECT_GE(asked, all.counts[1]);
  EXPECT_LT(asked, all.status.size() / 3);
}

TEST(FilterGrid, EveryCellMayHaveItsOwnTile) {
  const TriangleMesh mesh = shapes::parse("box 1/4,-1,-1 4,2,2");
  const TileFilter filter = std::move(TileFilter::make(mesh).value());
  const auto cage = to_bspline(micro_tiles::cage({1, 1, 1}, [](const Point& u) { return u; }));
  const auto tile_of = [](const std::array<std::uint32_t, 3>& cell) {
    // The first row has tiles in the right half of their cells, the second row in the left half.
    const Rational lo(cell[1] == 0 ? 5 : 1), hi(cell[1] == 0 ? 7 : 3), eight(8);
    return std::make_shared<const TileShape>(micro_tiles::shape_of(micro_tiles::box(
        {lo / eight, lo / eight, lo / eight}, {hi / eight, hi / eight, hi / eight})));
  };
  const GridStatus all = filter_grid(filter, cage, even_lines({2, 2, 1}), tile_of, 1).value();
  EXPECT_EQ(all.at({0, 0, 0}), CellStatus::kKept);
  EXPECT_EQ(all.at({0, 1, 0}), CellStatus::kOutside);
  EXPECT_EQ(all.at({1, 0, 0}), CellStatus::kKept);
  EXPECT_EQ(all.at({1, 1, 0}), CellStatus::kKept);
}

TEST(FilterGrid, APartOfAGridHasTheStatusesOfTheWhole) {
  const Fixture f;
  const BSplineVolume<Rational> cage = insert_knot(twisted(), 2, Rational(1) / Rational(2));
  const Lines lines = even_lines({8, 8, 8});
  const GridStatus all = filter_grid(f.filter, cage, lines, f.same, 1).value();
  for (const std::size_t first : {1u, 4u, 5u}) {
    Lines part = lines;
    part[2].erase(part[2].begin(), part[2].begin() + static_cast<std::ptrdiff_t>(first));
    part[0].pop_back();
    const GridStatus some = filter_grid(f.filter, cage, part, f.same, 1).value();
    ASSERT_EQ(some.cells.size, (std::array<std::size_t, 3>{7, 8, 8 - first}));
    for (std::size_t c = 0; c < some.status.size(); ++c) {
      const auto at = some.cells.index_of(c);
      EXPECT_EQ(some.status[c], all.at({at[0], at[1], at[2] + first})) << first << " " << c;
    }
  }
}

TEST(FilterGrid, RefusesLinesThatAreNoGrid) {
  const Fixture f;
  const auto message = [&](const BSplineVolume<Rational>& cage, const Lines& lines) {
    const auto out = filter_grid(f.filter, cage, lines, f.same, 1);
    EXPECT_FALSE(out.has_value());
    EXPECT_EQ(out.error().code, Code::kBadArgument);
    return out.error().message;
  };
  Lines lines = even_lines({2, 2, 2});
  lines[1] = {Rational(0)};
  EXPECT_NE(message(twisted(), lines).find("axis 1 bound no cell"), std::string::npos);
  lines[1] = {Rational(0), Rational(3) / Rational(2)};
  EXPECT_NE(message(twisted(), lines).find("axis 1 run from 0 to 3/2"), std::string::npos);
  lines[1] = {Rational(-1), Rational(1)};
  EXPECT_NE(message(twisted(), lines).find("axis 1 run from -1 to 1"), std::string::npos);
  lines[1] = {Rational(0), Rational(1) / Rational(2), Rational(1) / Rational(2), Rational(1)};
  EXPECT_NE(message(twisted(), lines).find("do not increase"), std::string::npos);
  lines = even_lines({2, 2, 2});
  const auto more = insert_knot(twisted(), 2, Rational(1) / Rational(3));
  EXPECT_NE(message(more, lines).find("axis 2 miss the knot 1/3"), std::string::npos);
  const auto flat = to_bspline(BezierVolume<Rational>({1, 1, 1}, 2, false));
  EXPECT_NE(message(flat, lines).find("2 coordinates"), std::string::npos);
}

}  // namespace
}  // namespace veritope
