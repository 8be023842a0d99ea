// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "solids/micro/compose/composed_cage.h"
#include "solids/micro/fill_cage.h"
#include "solids/micro/jack_volumes.h"
#include "solids/micro/micro_topology.h"
#include "solids/volumes/primitives.h"
#include "splines/bspline_pieces.h"
#include "splines/de_boor.h"
#include "splines/knot_insertion.h"
#include "tests/support/micro_cells.h"

namespace veritope {
namespace {

using v_cells::cube;

// The control points of a patch, whatever its parametrisation is.
using PointSet = std::vector<TilePoint>;

PointSet sorted_points(PointSet points) {
  std::sort(points.begin(), points.end());
  return points;
}

// Control points of the faces of volumes that are glued to none.
std::vector<PointSet> border_faces(const VModel& model) {
  std::vector<PointSet> out;
  for (VFaceNumber f = 0; f < model.num_faces(); ++f) {
    if (!model.face(f).is_border()) continue;
    const VVolume& cell = model.cell(f / 6);
    const std::size_t axis = f % 6 / 2;
    PointSet points;
    for (std::size_t n = 0; n < cell.grid().count(); ++n) {
      const auto index = cell.grid().index_of(n);
      if (index[axis] != (f % 2 == 0 ? 0 : cell.grid().size[axis] - 1)) continue;
      points.push_back({cell.component(0)[n], cell.component(1)[n], cell.component(2)[n]});
    }
    out.push_back(sorted_points(std::move(points)));
  }
  std::sort(out.begin(), out.end());
  return out;
}

Rational fraction(Random& random, int least, int most, int over) {
  return Rational(least +
                  static_cast<int>(random.below(static_cast<std::uint64_t>(most - least + 1)))) /
         Rational(over);
}

struct JackCase {
  JackShape shape;
  WallNumbers numbers{};
  std::string text;
};
JackCase any_jack(Random& random) {
  JackCase out;
  out.shape.node = fraction(random, 1, 11, 24);
  out.shape.cap = fraction(random, 1, 11, 24);
  out.shape.degree = random.below(2) == 0 ? 1 : 3;
  out.shape.arms = static_cast<unsigned>(random.below(64));
  if (random.below(2) == 0) {
    out.shape.range = {1, kMaxWallNumber / 2 - 1};
    for (std::int32_t& n : out.numbers)
      n = 1 + static_cast<std::int32_t>(random.below(kMaxWallNumber / 2 - 1));
  }
  out.text = jack_tile(out.shape).value().name;
  for (const std::int32_t n : out.numbers) out.text += " " + std::to_string(n);
  return out;
}

TEST(JackVolumes, HaveTheSurfaceOfTheTileAsTheirBorder) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const JackCase jack = any_jack(random);
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + jack.text);
    std::vector<VVolume> cells;
    for (const auto& volume : jack_volumes(jack.shape, jack.numbers))
      cells.push_back(to_bspline(volume));
    const VModel model = make_v_model(cells, VOrientation::kKeep).value();
    std::size_t arms = 0;
    for (int wall = 0; wall < 6; ++wall) arms += jack.shape.arms >> wall & 1;
    EXPECT_EQ(model.num_cells(), 1 + arms);
    EXPECT_EQ(model.counts().internal, arms);
    for (std::size_t c = 0; c < model.num_cells(); ++c)
      EXPECT_EQ(model.hand(c), Sign::kPositive) << c;
    std::vector<PointSet> patches;
    const MicroTile tile = jack_tile(jack.shape).value();
    for (const TilePatch& p : tile.patches)
      patches.push_back(sorted_points(points_at(p, number_of(p, jack.numbers))));
    std::sort(patches.begin(), patches.end());
    EXPECT_EQ(border_faces(model), patches);
  }
}

struct NestCase {
  std::vector<VVolume> cage;
  Microstructure micro;
  std::vector<JackShape> shapes;

  std::vector<VVolume> composed() const {
    return composed_cage(micro,
                         [this](std::size_t tile, const WallNumbers& numbers) {
                           return jack_volumes(shapes[tile], numbers);
                         })
        .value();
  }
};
NestCase jacks_in(std::vector<VVolume> cage, const std::array<std::uint64_t, 3>& counts,
                  const JackShape& shape) {
  NestCase out;
  const VModel model = make_v_model(cage, VOrientation::kAuto).value();
  out.cage = cage;
  std::vector<JackShape> made;
  out.micro = fill_cage(
                  std::move(cage), model, counts,
                  [&](unsigned arms) {
                    JackShape s = shape;
                    s.arms &= arms;
                    made.push_back(s);
                    return jack_tile(s);
                  },
                  1000)
                  .value();
  for (const MicroTile& tile : out.micro.tiles)
    for (const JackShape& s : made)
      if (jack_tile(s).value() == tile) {
        out.shapes.push_back(s);
        break;
      }
  return out;
}

// A volume that is bent, of degree 1 and 2, with a knot.
VVolume bent() {
  return refine(v_cells::polynomial(
                    {1, 2, 1},
                    [](std::size_t i, std::size_t j, std::size_t k) {
                      const auto n = [](std::size_t x) { return Rational(static_cast<int>(x)); };
                      return v_cells::Point{n(2 * i) + n(k * j) / Rational(4),
                                            n(3 * j) + n(i * k) / Rational(3),
                                            n(2 * k) + n(j * (2 - j)) / Rational(2)};
                    }),
                1, std::vector<Rational>{Rational(1) / Rational(3)});
}

std::vector<NestCase> cases() {
  JackShape straight, smooth, graded;
  straight.degree = 1;
  graded.degree = 1;
  graded.range = {1, kMaxWallNumber / 2 - 1};
  std::vector<NestCase> out;
  out.push_back(jacks_in({cube(0, 0, 0), cube(1, 0, 0)}, {2, 1, 1}, straight));
  out.push_back(jacks_in({bent()}, {1, 2, 2}, straight));
  out.push_back(jacks_in({cube(0, 0, 0)}, {2, 2, 1}, smooth));
  out.push_back(
      jacks_in({one_cell_cylinder(Rational(2), Rational(1)).value()}, {1, 1, 4}, straight));
  out.push_back(jacks_in({bent()}, {1, 2, 1}, graded));
  Random random(7);
  const VModel model = make_v_model(out.back().cage, VOrientation::kAuto).value();
  EXPECT_TRUE(number_walls(
      model,
      [&](const GridWall&) {
        return Result<std::int32_t>(50000 + static_cast<std::int32_t>(random.below(300000)));
      },
      out.back().micro));
  return out;
}

std::array<Rational, 3> point_of(const VVolume& volume, const std::array<Rational, 3>& at) {
  std::vector<Rational> p = point(volume, at).value();
  return {p[0], p[1], p[2]};
}

// The map of the cage at the cell's image of the tile's volume, one after the other.
TEST(ComposedCage, IsTheMapAfterTheCellAfterTheTile) {
  std::uint64_t seed = 0;
  for (const NestCase& nest : cases()) {
    Random random(++seed);
    SCOPED_TRACE("case " + std::to_string(seed));
    const std::vector<VVolume> composed = nest.composed();
    std::size_t next = 0;
    for (const MicroGrid& grid : nest.micro.grids)
      for (std::size_t c = 0; c < grid.tiles.size(); ++c) {
        const auto at = grid.shape().index_of(c);
        const auto volumes = jack_volumes(nest.shapes[grid.tiles[c] - 1u], grid.numbers_of(at));
        for (const BezierVolume<Rational>& volume : volumes) {
          ASSERT_LT(next, composed.size());
          for (int trial = 0; trial < 3; ++trial) {
            std::array<Rational, 3> t, q;
            for (Rational& x : t) x = fraction(random, 0, 12, 12);
            const auto p = point_of(to_bspline(volume), t);
            for (std::size_t a = 0; a < 3; ++a) {
              const Rational &lo = grid.breaks[a][at[a]], &hi = grid.breaks[a][at[a] + 1];
              q[a] = lo + (hi - lo) * p[a];
            }
            EXPECT_EQ(point_of(composed[next], t), point_of(nest.cage[grid.volume], q));
          }
          ++next;
        }
      }
    EXPECT_EQ(next, composed.size());
  }
}

MicroCounts topology_in(const Microstructure& micro, const VModel& cage) {
  std::vector<AnalysedTile> tiles;
  for (const MicroTile& t : micro.tiles) tiles.push_back(std::get<AnalysedTile>(analyse_tile(t)));
  const auto found = topology_of(micro, cage, tiles);
  if (const auto* defect = std::get_if<MicroDefect>(&found)) {
    ADD_FAILURE() << defect->condition << ": " << defect->message;
    return {};
  }
  return std::get<MicroCounts>(found);
}

TEST(ComposedCage, IsGluedWhereTilesAre) {
  for (const NestCase& nest : cases()) {
    const VModel outer = make_v_model(nest.cage, VOrientation::kAuto).value();
    const MicroCounts counts = topology_in(nest.micro, outer);
    const VModel inner = make_v_model(nest.composed(), VOrientation::kAuto).value();
    // A cube and its arms hang together by one face less than there are volumes.
    EXPECT_EQ(inner.counts().internal, inner.num_cells() - counts.tiles + counts.glued_caps);
    EXPECT_EQ(inner.counts().half_v_surfaces, 6 * inner.num_cells());
  }
}

TEST(ComposedCage, HasTheLeastDegrees) {
  JackShape straight, smooth;
  straight.degree = 1;
  for (const VVolume& v : jacks_in({cube(0, 0, 0)}, {1, 1, 1}, straight).composed())
    for (std::size_t a = 0; a < 3; ++a) EXPECT_EQ(v.axis(a).degree, 1);
  // Boxes leave the arms of a jack as they are: cubic along one axis.
  const std::vector<VVolume> cubic = jacks_in({cube(0, 0, 0)}, {1, 1, 1}, smooth).composed();
  for (std::size_t n = 0; n < cubic.size(); ++n)
    for (std::size_t a = 0; a < 3; ++a)
      EXPECT_EQ(cubic[n].axis(a).degree, n > 0 && a == (n - 1) / 2 ? 3 : 1) << n << " " << a;
}

MicroCounts nested_counts(const NestCase& nest, const std::array<std::uint64_t, 3>& counts) {
  const std::vector<VVolume> cage = nest.composed();
  const VModel model = make_v_model(cage, VOrientation::kAuto).value();
  const Microstructure micro =
      fill_cage(
          cage, model, counts, [](unsigned) { return jack_tile({}); }, 100000)
          .value();
  return topology_in(micro, model);
}

// Two jacks of seven volumes hang together at 6 + 6 + 1 faces. With n x n x n jacks a volume, 3 n^2 (n - 1) caps are
// glued inside of it, and n^2 at each of these faces; one component, each tile a ball: genus 1 - tiles + caps.
TEST(ComposedCage, NestedJacksHaveTheGenusThatIsCountedByHand) {
  JackShape straight;
  straight.degree = 1;
  const NestCase two = jacks_in({v_cells::box({0, 0, 0}, {2, 1, 1})}, {2, 1, 1}, straight);
  const MicroCounts one = nested_counts(two, {1, 1, 1});
  EXPECT_EQ(one.tiles, 14u);
  EXPECT_EQ(one.glued_caps, 13u);
  EXPECT_EQ(one.components, 1u);
  EXPECT_EQ(one.genus, 0);
  const MicroCounts eight = nested_counts(two, {2, 2, 2});
  EXPECT_EQ(eight.tiles, 112u);
  EXPECT_EQ(eight.glued_caps, 14u * 12u + 13u * 4u);
  EXPECT_EQ(eight.components, 1u);
  EXPECT_EQ(eight.shells, 1u);
  EXPECT_EQ(eight.genus, 109);
}

TEST(ComposedCage, RefusesWhatNoCageHolds) {
  JackShape straight, smooth;
  straight.degree = 1;
  NestCase none = jacks_in({cube(0, 0, 0)}, {1, 1, 1}, straight);
  none.micro.grids[0].tiles[0] = 0;
  const auto volumes_of = [](const NestCase& nest) {
    return [&nest](std::size_t tile, const WallNumbers& numbers) {
      return jack_volumes(nest.shapes[tile], numbers);
    };
  };
  const auto empty = composed_cage(none.micro, volumes_of(none));
  ASSERT_FALSE(empty);
  EXPECT_EQ(empty.error().code, Code::kEmpty);

  // One control point is moved: a polynomial of the degree 3 in each parameter.
  const VVolume cubic =
      v_cells::polynomial({3, 3, 3}, [](std::size_t i, std::size_t j, std::size_t k) {
        const Rational x(static_cast<int>(i)), y(static_cast<int>(j)), z(static_cast<int>(k));
        return v_cells::Point{x + Rational(i == 1 && j == 1 && k == 1 ? 1 : 0) / Rational(4), y, z};
      });
  const NestCase high = jacks_in({cubic}, {1, 1, 1}, smooth);
  const auto degree = composed_cage(high.micro, volumes_of(high));
  ASSERT_FALSE(degree);
  EXPECT_EQ(degree.error().code, Code::kOverLimit);
  EXPECT_NE(degree.error().message.find("cell (0, 0, 0) of grid 0"), std::string::npos)
      << degree.error().message;

  const NestCase one = jacks_in({cube(0, 0, 0)}, {1, 1, 1}, straight);
  EXPECT_TRUE(composed_cage(one.micro, volumes_of(one), 7));
  const auto seven = composed_cage(one.micro, volumes_of(one), 6);
  ASSERT_FALSE(seven);
  EXPECT_EQ(seven.error().code, Code::kOverLimit);
  EXPECT_NE(seven.error().message.find("more than 6 volumes"), std::string::npos)
      << seven.error().message;
}

}  // namespace
}  // namespace veritope
