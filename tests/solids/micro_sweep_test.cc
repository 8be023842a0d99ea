// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "interval/upward.h"
#include "robust/base/random.h"
#include "solids/micro/bridge/box_bins.h"
#include "solids/micro/bridge/sweep_matrix.h"
#include "solids/micro/bridge/sweep_proof.h"
#include "solids/micro/fill_cage.h"
#include "solids/micro/matched_caps.h"
#include "solids/micro/micro_topology.h"
#include "solids/micro/sweep_nodes.h"
#include "splines/bezier_calculus.h"
#include "splines/bezier_degree.h"
#include "splines/bezier_domain.h"
#include "splines/bezier_product.h"
#include "splines/de_casteljau.h"
#include "tests/support/micro_cells.h"

namespace veritope {
namespace {

using micro_cells::box_tile;
using micro_cells::full;
using v_cells::cube;

Rational part(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

// Cells of one volume, of which some hold a post along u with caps [1/4, 3/4]^2 in u0 and u1.
struct SweptCells {
  Microstructure micro;
  VModel cage;
  std::vector<AnalysedTile> tiles;

  explicit SweptCells(const std::array<std::uint64_t, 3>& counts,
                      const MicroTile& tile = box_tile({0, 16, 16}, {64, 48, 48}),
                      const VVolume& volume = cube(0, 0, 0))
      : micro(full({volume}, counts, tile)),
        cage(make_v_model(micro.cage, VOrientation::kAuto).value()) {
    tiles.push_back(std::get<AnalysedTile>(analyse_tile(micro.tiles[0])));
  }
  void keep(const std::vector<std::size_t>& cells) {
    std::vector<std::uint8_t>& all = micro.grids[0].tiles;
    for (std::size_t c = 0; c < all.size(); ++c)
      all[c] = std::find(cells.begin(), cells.end(), c) != cells.end() ? 1 : 0;
  }
  void add(const CapPlace& place, const TilePoint& e, const TilePoint& f) {
    micro.sweeps.push_back({place, {e, f}});
  }
  std::string condition() const {
    EXPECT_TRUE(validate(micro).has_value());
    EXPECT_TRUE(std::holds_alternative<MicroCounts>(topology_of(micro, cage, tiles)));
    const auto proof = prove_sweeps(micro, cage, tiles, 2).value();
    const auto* defect = std::get_if<BridgeDefect>(&proof);
    return defect != nullptr ? defect->condition : "";
  }
};

using ExactMatrix = std::array<Rational, 9>;

bool is_definite_slowly(const BridgeMatrix& k, const ExactMatrix& j) {
  ExactMatrix s;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t l = 0; l < 3; ++l) {
        s[3 * r + c] += k[3 * r + l] * j[3 * l + c];
        s[3 * c + r] += k[3 * r + l] * j[3 * l + c];
      }
  const Rational det = s[0] * s[4] * s[8] + s[1] * s[5] * s[6] + s[2] * s[3] * s[7] -
                       s[2] * s[4] * s[6] - s[1] * s[3] * s[8] - s[0] * s[5] * s[7];
  return s[0].sign() == Sign::kPositive && (s[0] * s[4] - s[1] * s[3]).sign() == Sign::kPositive &&
         det.sign() == Sign::kPositive;
}

// Q2 as the page defines it, in fractions and in the parameters of the volume. The volume is one Bezier map of [0,1]^3.
bool holds_slowly(const SweepWitness& w, const BezierVolume<Rational>& volume,
                  const MicroGrid& grid, const MicroSweep& sweep) {
  const auto at = grid.shape().index_of(sweep.cap.cell);
  const auto across = static_cast<std::size_t>(sweep.cap.wall / 2);
  const bool is_end = sweep.cap.wall % 2 == 1;
  BezierVolume<Rational> map = volume;
  std::array<Rational, 3> length;
  for (std::size_t a = 0; a < 3; ++a) {
    Rational lo = grid.breaks[a][at[a]], hi = grid.breaks[a][at[a] + 1];
    if (a == across) {
      const Rational width = w.depth * (hi - lo);
      if (is_end)
        lo = hi - width;
      else
        hi = lo + width;
    }
    length[a] = hi - lo;
    map = restricted(map, a, lo, hi);
  }
  std::vector<BezierVolume<Rational>> columns;
  BezierVolume<Rational> weight(map.degrees(), 1, false);
  if (map.is_rational()) {
    BezierVolume<Rational> x(map.degrees(), 3, false), v(map.degrees(), 1, false);
    for (std::size_t i = 0; i < map.grid().count(); ++i) {
      for (int c = 0; c < 3; ++c) x.component(c)[i] = map.component(c)[i];
      v.component(0)[i] = map.component(3)[i];
    }
    weight = multiplied(v, v);
    for (std::size_t a = 0; a < 3; ++a)
      columns.push_back(
          elevate_to(difference(multiplied(v, derivative(x, a)), multiplied(derivative(v, a), x)),
                     weight.degrees()));
  } else {
    for (Rational& c : weight.component(0)) c = Rational(1);
    for (std::size_t a = 0; a < 3; ++a)
      columns.push_back(elevate_to(derivative(map, a), map.degrees()));
  }
  const Grid<3> net = weight.grid();
  for (std::size_t i = 0; i < net.count(); ++i) {
    ExactMatrix j;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t c = 0; c < 3; ++c)
        j[3 * c + a] = columns[a].component(static_cast<int>(c))[i] / length[a];
    if (!is_definite_slowly(w.matrix, j)) return false;
    if (net.index_of(i)[across] != (is_end ? net.size[across] - 1 : 0)) continue;
    for (int direction = 0; direction < 2; ++direction) {
      for (std::size_t c = 0; c < 3; ++c) {
        const Rational g = direction == 0 ? sweep.axis[0][c] : sweep.axis[1][c] - sweep.axis[0][c];
        j[3 * c + across] = Rational(is_end ? 1 : -1) * w.speed * weight.component(0)[i] * g;
      }
      if (!is_definite_slowly(w.matrix, j)) return false;
    }
  }
  return true;
}

// A map of [0,1]^3 near the identity, or its mirror image, with weights near 1 if it is rational.
BezierVolume<Rational> random_map(Random& random, bool is_rational, bool is_mirrored) {
  std::array<int, 3> degrees;
  for (int& d : degrees) d = 1 + static_cast<int>(random.below(2));
  BezierVolume<Rational> out(degrees, is_rational ? 4 : 3, is_rational);
  for (std::size_t i = 0; i < out.grid().count(); ++i) {
    const Rational w = is_rational ? part(random.between(7, 9), 8) : Rational(1);
    for (std::size_t c = 0; c < 3; ++c) {
      const Rational x = part(static_cast<std::int64_t>(out.grid().index_of(i)[c]), degrees[c]) +
                         part(random.between(-3, 3), 40);
      out.component(static_cast<int>(c))[i] = w * (is_mirrored && c == 0 ? Rational(0) - x : x);
    }
    if (is_rational) out.component(3)[i] = w;
  }
  return out;
}
VVolume volume_of(const BezierVolume<Rational>& map) {
  std::array<VVolume::Axis, 3> axes;
  for (std::size_t a = 0; a < 3; ++a) {
    axes[a].degree = map.degree(a);
    axes[a].knots.assign(static_cast<std::size_t>(map.degree(a)) + 1, Rational(0));
    axes[a].knots.insert(axes[a].knots.end(), static_cast<std::size_t>(map.degree(a)) + 1,
                         Rational(1));
  }
  const auto c = map.coefficients();
  return VVolume(axes, map.num_components(), map.is_rational(),
                 std::vector<Rational>(c.begin(), c.end()));
}

TEST(Sweeps, StraightAndBentOnesAreProved) {
  for (const int end : {0, 1}) {
    SweptCells s({4, 1, 1});
    s.keep({end == 1 ? std::size_t{0} : std::size_t{3}});
    const int out = end == 1 ? 1 : -1;
    s.add({0, end == 1 ? 0u : 3u, end}, {part(out, 4), Rational(0), Rational(0)},
          {part(out, 2), part(1, 8), part(-1, 8)});
    EXPECT_EQ(s.condition(), "") << end;
    // The volume ends at u = 1 and u = 0: sweeps may leave it.
    s.micro.sweeps[0].axis[1][0] = Rational(3 * out);
    EXPECT_EQ(s.condition(), "") << end;
  }
}

// PROVES MICRO-1.Q1
TEST(Sweeps, StartAtACapThatIsFree) {
  const TilePoint e = {part(1, 8), Rational(0), Rational(0)},
                  f = {part(1, 4), Rational(0), Rational(0)};
  SweptCells glued({4, 1, 1});
  glued.keep({0, 1});
  glued.add({0, 0, 1}, e, f);
  EXPECT_EQ(glued.condition(), "Q1");
  SweptCells no_cap({4, 1, 1});
  no_cap.keep({0});
  no_cap.add({0, 0, 3}, e, f);
  EXPECT_EQ(no_cap.condition(), "Q1");
  // A cap in the cage's border is free.
  SweptCells border({1, 1, 1});
  border.add({0, 0, 1}, e, f);
  EXPECT_EQ(border.condition(), "");
}

// PROVES MICRO-1.Q1
TEST(Sweeps, CapsWithPartnersAreFound) {
  SweptCells s({4, 1, 1});
  s.keep({0, 1, 3});
  const std::vector<CapPlace> all = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 1, 1}, {0, 3, 0}};
  EXPECT_EQ(matched_caps(s.micro, s.cage, s.tiles, all),
            (std::set<CapPlace>{{0, 0, 1}, {0, 1, 0}}));
  EXPECT_EQ(matched_caps(s.micro, s.cage, s.tiles, {{0, 1, 0}}), (std::set<CapPlace>{{0, 1, 0}}));
}

// PROVES MICRO-1.Q2
TEST(Sweeps, RefusesCurvesThatTurnBack) {
  SweptCells s({4, 1, 1});
  s.keep({0});
  s.add({0, 0, 1}, {part(1, 2), Rational(0), Rational(0)}, {part(1, 4), Rational(0), Rational(0)});
  EXPECT_EQ(s.condition(), "Q2");  // it folds at its end
  s.micro.sweeps[0].axis = {TilePoint{part(-1, 64), Rational(0), Rational(0)},
                            {part(1, 2), Rational(0), Rational(0)}};
  EXPECT_EQ(s.condition(), "Q2");  // it begins into its tile
  s.micro.sweeps[0].axis = {TilePoint{Rational(0), part(1, 2), Rational(0)},
                            {part(1, 2), part(1, 2), Rational(0)}};
  EXPECT_EQ(s.condition(), "Q2");  // it begins along the wall
  s.micro.sweeps[0].axis = {TilePoint{part(1, 64), part(1, 2), Rational(0)},
                            {part(1, 2), part(1, 2), Rational(0)}};
  EXPECT_EQ(s.condition(), "");
}

// PROVES MICRO-1.Q2
TEST(Sweeps, WitnessesAreJudgedAsTheDefinitionDoes) {
  Random random(17);
  int shown = 0, refused = 0, rational = 0, mirrored = 0;
  for (int n = 0; n < 60; ++n) {
    const bool is_rational = random.below(2) == 0, is_mirrored = random.below(2) == 0;
    const BezierVolume<Rational> map = random_map(random, is_rational, is_mirrored);
    SweptCells s({3, 1, 2}, box_tile({0, 16, 16}, {64, 48, 48}), volume_of(map));
    s.keep({2});
    const int end = static_cast<int>(random.below(2));
    MicroSweep sweep{{0, 2, end}, {}};
    const int out = (end == 1) != is_mirrored ? 1 : -1;
    for (std::size_t k = 0; k < 2; ++k)
      sweep.axis[k] = {part(out * random.between(1, 6) + 3 * static_cast<int>(k) * out, 16),
                       part(random.between(-3, 3), 16), part(random.between(-3, 3), 16)};
    const SweepStarts starts(s.micro, s.tiles);
    const auto found = find_sweep_witness(starts, sweep);
    if (found) {
      EXPECT_TRUE(holds_slowly(*found, map, s.micro.grids[0], sweep)) << "seed 17, case " << n;
      EXPECT_TRUE(shows_one_to_one(*found, starts, sweep)) << "seed 17, case " << n;
      ++shown;
      rational += is_rational;
      mirrored += is_mirrored;
    }
    SweepWitness any;
    for (std::size_t i = 0; i < 9; ++i)
      any.matrix[i] = Rational(random.between(-2, 2) + (i % 4 == 0 ? 9 : 0)) *
                      Rational(is_mirrored && i % 3 == 0 ? -1 : 1);
    any.depth = part(random.between(1, 4), 4);
    any.speed = part(random.between(1, 8), 8);
    const bool is_shown = shows_one_to_one(any, starts, sweep);
    EXPECT_EQ(is_shown, holds_slowly(any, map, s.micro.grids[0], sweep)) << "seed 17, case " << n;
    refused += !is_shown;
  }
  EXPECT_GT(shown, 20);
  EXPECT_GT(rational, 5);
  EXPECT_GT(mirrored, 5);
  EXPECT_GT(refused, 5);
}

// PROVES MICRO-1.Q3
TEST(Sweeps, RefusesOnesThroughATile) {
  SweptCells s({4, 1, 1});
  s.keep({0, 2});
  s.add({0, 0, 1}, {part(1, 4), Rational(0), Rational(0)}, {part(1, 2), Rational(0), Rational(0)});
  EXPECT_EQ(s.condition(), "Q3");
  s.micro.sweeps[0].axis = {TilePoint{part(1, 16), Rational(0), Rational(0)},
                            {part(1, 5), Rational(0), Rational(0)}};
  EXPECT_EQ(s.condition(), "");
  // A tile beside the cell across the wall.
  SweptCells row({2, 2, 1});
  row.keep({0, 3});
  row.add({0, 0, 1}, {part(1, 8), Rational(0), Rational(0)}, {part(1, 4), part(1, 2), Rational(0)});
  EXPECT_EQ(row.condition(), "Q3");
}

// PROVES MICRO-1.Q3
TEST(Sweeps, RefusesOnesIntoTheirOwnTile) {
  // A volume that turns around three sides of a square, and further: its end lies before its begin, 8 higher up.
  const std::array<std::array<int, 2>, 4> bend = {{{0, 0}, {8, 0}, {8, 8}, {-6, 8}}};
  const std::array<std::array<int, 2>, 4> off = {{{0, -1}, {1, -1}, {1, 1}, {0, 1}}};
  const VVolume turned =
      v_cells::polynomial({3, 1, 1}, [&](std::size_t i, std::size_t j, std::size_t k) {
        const auto y = static_cast<int>(j);
        return v_cells::Point{Rational(bend[i][0] + y * off[i][0]),
                              Rational(bend[i][1] + y * off[i][1]), Rational(k)};
      });
  SweptCells s({1, 1, 1}, box_tile({0, 16, 16}, {64, 48, 48}), turned);
  const TilePoint e = {Rational(-2), Rational(0), Rational(0)};
  s.add({0, 0, 0}, e, {Rational(-4), Rational(5), Rational(0)});
  EXPECT_EQ(s.condition(), "");
  s.micro.sweeps[0].axis[1][1] = Rational(9);  // into the other end
  EXPECT_EQ(s.condition(), "Q3");
}

// PROVES MICRO-1.Q4
TEST(Sweeps, RefusesOnesThatMeet) {
  SweptCells s({4, 4, 1});
  s.keep({0, 1});  // rows v = 0 and v = 1
  const Rational zero;
  s.add({0, 0, 1}, {part(1, 4), zero, zero}, {part(1, 2), part(1, 4), zero});
  s.add({0, 1, 1}, {part(1, 4), zero, zero}, {part(1, 2), zero, zero});
  EXPECT_EQ(s.condition(), "Q4");
  s.micro.sweeps[0].axis[1][1] = part(1, 9);  // the gap of the caps is 1/8
  EXPECT_EQ(s.condition(), "");
  s.micro.sweeps[1].axis[1][1] = part(1, 4);  // it follows
  s.micro.sweeps[0].axis[1][1] = part(1, 4);
  EXPECT_EQ(s.condition(), "");
}

TEST(BoxBins, FindAllBoxesThatMeet) {
  Random random(31);
  internal::BoxBins bins({1, 1, 0.5});
  std::vector<Box3d> boxes;
  const auto box = [&] {
    Box3d out;
    for (std::size_t c = 0; c < 3; ++c) {
      out.lo[c] = static_cast<double>(random.between(-80, 80)) / 8;
      out.hi[c] =
          out.lo[c] + static_cast<double>(random.between(0, random.below(20) == 0 ? 400 : 12)) / 8;
    }
    return out;
  };
  for (std::uint32_t n = 0; n < 200; ++n) {
    const Box3d asked = box();
    const auto near = bins.near(asked);
    EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      const bool is_found = std::binary_search(near.begin(), near.end(), i);
      EXPECT_TRUE(is_found || !meets(boxes[i], asked)) << "seed 31, box " << n;
    }
    boxes.push_back(box());
    bins.add(n, boxes.back());
  }
}

// The points of nodes contain the sweep's points, and halves cover their node.
// PROVES MICRO-1.Q3
TEST(Sweeps, NodesContainTheirPoints) {
  Random random(23);
  for (int n = 0; n < 20; ++n) {
    const BezierVolume<Rational> map = random_map(random, n % 2 == 0, false);
    SweptCells s({2, 1, 1}, box_tile({0, 16, 16}, {64, 48, 48}), volume_of(map));
    s.keep({0});
    MicroSweep sweep{{0, 0, 1}, {}};
    for (TilePoint& v : sweep.axis)
      for (Rational& x : v) x = part(random.between(-8, 8), 8);
    const SweepStarts starts(s.micro, s.tiles);
    const BezierSurface<Rational> cap = starts.cap(sweep.cap).value();
    const ScopedUpward upward;
    SweepNodes nodes(starts.wall(sweep.cap), cap, sweep.axis);
    for (int sample = 0; sample < 20; ++sample) {
      std::array<Rational, 3> at, lo, hi;
      for (std::size_t a = 0; a < 3; ++a) {
        at[a] = part(random.between(0, 64), 64);
        hi[a] = Rational(1);
      }
      SweepNodes::Node node;
      for (int level = 0; level < 7; ++level) {
        const auto axis = static_cast<std::size_t>(level % 3);
        const Rational middle = (lo[axis] + hi[axis]) / Rational(2);
        const auto [low, high] = nodes.halves(node);
        node = at[axis] <= middle ? low : high;
        (at[axis] <= middle ? hi : lo)[axis] = middle;
      }
      const auto p = evaluate<Rational, 2>(cap, {at[0], at[1]});
      const auto image = evaluate<Rational, 3>(map, {part(1, 2), p[0], p[1]});
      const Box3d box = nodes.box(node);
      std::vector<Box3> points;
      nodes.points(node, &points);
      Box3 around = points.front();
      for (const Box3& q : points) around = hull(around, q);
      const Rational &w = at[2], middle = Rational(2) * w * (Rational(1) - w);
      for (std::size_t c = 0; c < 3; ++c) {
        const Rational x = (map.is_rational() ? image[c] / image[3] : image[c]) +
                           middle * sweep.axis[0][c] + w * w * sweep.axis[1][c];
        EXPECT_TRUE(Rational::from_double(box.lo[c]) <= x && x <= Rational::from_double(box.hi[c]))
            << "seed 23, case " << n;
        EXPECT_TRUE(Rational::from_double(around[c].lo()) <= x &&
                    x <= Rational::from_double(around[c].hi()))
            << "seed 23, case " << n;
      }
    }
  }
}

}  // namespace
}  // namespace veritope
