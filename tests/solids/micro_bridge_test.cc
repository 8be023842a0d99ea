// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "robust/base/random.h"
#include "solids/micro/bridge/bridge_matrix.h"
#include "solids/micro/bridge/bridge_proof.h"
#include "solids/micro/bridge/bridge_slices.h"
#include "solids/micro/fill_cage.h"
#include "solids/micro/micro_topology.h"
#include "splines/bezier_calculus.h"
#include "splines/de_casteljau.h"
#include "tests/support/micro_lattice.h"

namespace veritope {
namespace {

using micro_cells::box_tile;
using micro_cells::full;
using micro_cells::ring_cage;
using v_cells::cube;

Rational part(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

// Cells of the unit cube, of which some hold a post along u with caps [1/4, 3/4]^2 in u0 and u1.
struct Structure {
  Microstructure micro;
  VModel cage;
  std::vector<AnalysedTile> tiles;

  explicit Structure(const std::array<std::uint64_t, 3>& counts,
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
  MicroBridge& add(const CapPlace& place, const Rational& length, const TilePoint& aside = {}) {
    return micro_lattice::add_bridge(micro, cage, tiles, place, length, aside);
  }
  std::variant<std::vector<BridgeWitness>, BridgeDefect> prove() const {
    EXPECT_TRUE(validate(micro).has_value());
    EXPECT_TRUE(std::holds_alternative<MicroCounts>(topology_of(micro, cage, tiles)));
    return prove_bridges(micro, cage, tiles);
  }
  std::string condition() const {
    const auto proof = prove();
    const auto* defect = std::get_if<BridgeDefect>(&proof);
    return defect != nullptr ? defect->condition : "";
  }
};

// The definition, in fractions: all K J + (K J)^T, J the coefficients of the derivative, all raised to (p, q, 2).
bool is_shown_slowly(const BridgeMatrix& k, const MicroBridge& b) {
  std::array<std::vector<BezierVolume<Rational>>, 3> columns;
  BezierVolume<Rational> map({b.degrees[0], b.degrees[1], 2}, 3, false);
  for (std::size_t i = 0; i < b.points.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) map.component(static_cast<int>(c))[i] = b.points[i][c];
  std::vector<BezierVolume<Rational>> partial;
  for (std::size_t axis = 0; axis < 3; ++axis)
    partial.push_back(elevate_to(derivative(map, axis), map.degrees()));
  const auto det = [](const std::array<Rational, 9>& m) {
    return m[0] * m[4] * m[8] + m[1] * m[5] * m[6] + m[2] * m[3] * m[7] - m[2] * m[4] * m[6] -
           m[1] * m[3] * m[8] - m[0] * m[5] * m[7];
  };
  if (det(k).sign() != Sign::kPositive) return false;
  for (std::size_t i = 0; i < map.grid().count(); ++i) {
    std::array<Rational, 9> s;
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t l = 0; l < 3; ++l) {
          const Rational x = k[3 * r + l] * partial[c].component(static_cast<int>(l))[i];
          s[3 * r + c] += x;
          s[3 * c + r] += x;
        }
    if (s[0].sign() != Sign::kPositive || (s[0] * s[4] - s[1] * s[3]).sign() != Sign::kPositive ||
        det(s).sign() != Sign::kPositive)
      return false;
  }
  return true;
}

TEST(Bridges, StraightOnesAreProved) {
  for (const int end : {0, 1}) {
    Structure s({4, 1, 1});
    s.keep({end == 1 ? std::size_t{0} : std::size_t{3}});
    s.add({0, end == 1 ? 0u : 3u, end}, part(5, 8));
    const auto proof = s.prove();
    ASSERT_TRUE(std::holds_alternative<std::vector<BridgeWitness>>(proof))
        << std::get<BridgeDefect>(proof).message;
    const auto& witnesses = std::get<0>(proof);
    ASSERT_EQ(witnesses.size(), 1u);
    EXPECT_TRUE(is_shown_slowly(witnesses[0].matrix, s.micro.bridges[0]));
  }
}

// PROVES MICRO-1.R1
TEST(Bridges, RefusesOnesThatFold) {
  Structure s({4, 1, 1});
  s.keep({0});
  // The end is turned by half a turn about the axis.
  MicroBridge& b = s.add({0, 0, 1}, part(1, 2));
  std::swap(b.points[b.at(0, 0, 2)], b.points[b.at(1, 1, 2)]);
  std::swap(b.points[b.at(0, 1, 2)], b.points[b.at(1, 0, 2)]);
  EXPECT_EQ(s.condition(), "R1");
}

// PROVES MICRO-1.R1
TEST(Bridges, RefusesANegativeDeterminant) {
  Structure s({4, 1, 1});
  s.keep({0});
  MicroBridge& b = s.add({0, 0, 1}, part(1, 2));
  for (int k = 0; k <= 2; ++k) std::swap(b.points[b.at(0, 1, k)], b.points[b.at(1, 0, k)]);
  EXPECT_EQ(s.condition(), "R1");
  // K = -1 turns all K J + (K J)^T positive, but det K is negative.
  const BridgeMatrix k = {Rational(-1), Rational(0), Rational(0), Rational(0), Rational(-1),
                          Rational(0),  Rational(0), Rational(0), Rational(-1)};
  MicroBridge mirrored;
  mirrored.points.resize(mirrored.num_points());
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int l = 0; l < 3; ++l)
        mirrored.points[mirrored.at(i, j, l)] = {Rational(-i), Rational(-j), Rational(-l)};
  EXPECT_FALSE(shows_one_to_one(k, mirrored));
  EXPECT_FALSE(is_shown_slowly(k, mirrored));
}

// PROVES MICRO-1.R1
TEST(Bridges, MatricesAreJudgedAsTheDefinitionDoes) {
  Random random(7);
  int shown = 0;
  for (int n = 0; n < 200; ++n) {
    MicroBridge b;
    b.degrees = {1 + static_cast<int>(random.below(3)), 1 + static_cast<int>(random.below(2))};
    b.points.resize(b.num_points());
    for (int i = 0; i <= b.degrees[0]; ++i)
      for (int j = 0; j <= b.degrees[1]; ++j)
        for (int k = 0; k <= 2; ++k)
          b.points[b.at(i, j, k)] = {
              Rational(i * 8 + static_cast<int>(random.below(7)) - 3) / Rational(8 * b.degrees[0]),
              Rational(j * 8 + static_cast<int>(random.below(7)) - 3) / Rational(8 * b.degrees[1]),
              Rational(k * 8 + static_cast<int>(random.below(5)) - 2) / Rational(16)};
    BridgeMatrix k;
    for (std::size_t i = 0; i < 9; ++i)
      k[i] = Rational(static_cast<int>(random.below(9)) - 4 + (i % 4 == 0 ? 9 : 0));
    EXPECT_EQ(shows_one_to_one(k, b), is_shown_slowly(k, b)) << "seed 7, case " << n;
    if (const auto found = find_bridge_matrix(b)) {
      EXPECT_TRUE(is_shown_slowly(*found, b)) << "seed 7, case " << n;
      ++shown;
    }
  }
  EXPECT_GT(shown, 20);
}

// PROVES MICRO-1.R2
TEST(Bridges, StartAtACapThatIsFree) {
  Structure s({4, 1, 1});
  s.keep({0});
  MicroBridge& b = s.add({0, 0, 1}, part(1, 2));
  b.points[0][1] += part(1, 1000);
  EXPECT_EQ(s.condition(), "R2");
  Structure glued({4, 1, 1});
  glued.keep({0, 1});
  glued.add({0, 0, 1}, part(1, 8));
  EXPECT_EQ(glued.condition(), "R2");
  Structure no_cap({1, 4, 1});
  no_cap.keep({0});
  MicroBridge at_border = s.micro.bridges[0];  // no patch lies in the wall
  at_border.cap = {0, 0, 3};
  no_cap.micro.bridges.push_back(at_border);
  EXPECT_EQ(no_cap.condition(), "R2");
}

// PROVES MICRO-1.R2
TEST(Bridges, StartAtACapInAnyOfTheEightWays) {
  Structure s({4, 1, 1});
  s.keep({0});
  const MicroBridge plain = s.add({0, 0, 1}, part(1, 2));
  const auto front = front_of(s.micro, s.cage, plain.cap).value();
  const auto cap = cap_on_front(s.micro, s.cage, s.tiles, plain.cap, front).value();
  for (unsigned symmetry = 0; symmetry < 8; ++symmetry) {
    MicroBridge turned = plain;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        for (int k = 0; k <= 2; ++k) {
          int a = (symmetry & 2) != 0 ? 1 - i : i, b = (symmetry & 4) != 0 ? 1 - j : j;
          if ((symmetry & 1) != 0) std::swap(a, b);
          turned.points[turned.at(i, j, k)] = plain.points[plain.at(a, b, k)];
        }
    EXPECT_TRUE(start_symmetry(turned, cap).has_value()) << symmetry;
    // Those that reverse the orientation have a negative determinant.
    s.micro.bridges[0] = turned;
    EXPECT_EQ(s.condition(), is_v_symmetry_odd(symmetry) ? "R1" : "") << symmetry;
  }
}

// PROVES MICRO-1.R3
TEST(Bridges, RefusesOnesThroughATile) {
  Structure s({4, 1, 1});
  s.keep({0, 2});
  s.add({0, 0, 1}, part(1, 2));
  EXPECT_EQ(s.condition(), "R3");
  s.micro.bridges.clear();
  s.add({0, 0, 1}, part(1, 5));
  EXPECT_EQ(s.condition(), "");
}

// PROVES MICRO-1.R3
TEST(Bridges, StayInTheOpenBoxBeyondTheWall) {
  Structure s({4, 1, 1});
  s.keep({0});
  s.add({0, 0, 1}, part(3, 4));  // ends in the face of the volume
  EXPECT_EQ(s.condition(), "R3");
  s.micro.bridges.clear();
  MicroBridge b = s.add({0, 0, 1}, part(1, 2));
  const BridgeFront front = front_of(s.micro, s.cage, b.cap).value();
  EXPECT_TRUE(is_in_open_box(b, s.micro.cage[0], front));
  b.points[b.at(0, 1, 2)][0] = part(1, 4);  // in the wall's plane
  EXPECT_FALSE(is_in_open_box(b, s.micro.cage[0], front));
  b.points[b.at(0, 1, 2)] = {part(1, 2), Rational(1), part(1, 2)};  // in another face
  EXPECT_FALSE(is_in_open_box(b, s.micro.cage[0], front));
}

// PROVES MICRO-1.R3
TEST(Bridges, ARingOfOneTileAndABridgeIntoItself) {
  // The tile is the first of two cells around an axis. The bridge leaves through the face that is glued to the other end,
  // and comes to the tile's other side.
  Structure s({1, 2, 1}, box_tile({16, 0, 16}, {48, 64, 48}), ring_cage());
  s.keep({0});
  s.add({0, 0, 2}, part(1, 4));
  EXPECT_TRUE(front_of(s.micro, s.cage, s.micro.bridges[0].cap)->is_in_face);
  EXPECT_EQ(s.condition(), "");
  s.micro.bridges.clear();
  s.add({0, 0, 2}, part(3, 4));
  EXPECT_EQ(s.condition(), "R3");
}

// PROVES MICRO-1.R3
TEST(Bridges, OnlyTheFirstSliceMayTouchTheOwnCell) {
  Structure s({4, 1, 1});
  s.keep({0});
  const CapPlace place{0, 0, 1};
  const BridgeFront front = front_of(s.micro, s.cage, place).value();
  const MicroBridge straight = s.add(place, part(1, 2));
  MicroBridge back = straight;  // all of its points but the end's are beyond the wall
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) back.points[back.at(i, j, 2)][0] = part(1, 5);
  const TileCells cells(s.micro);
  BridgeSlices first(straight), second(back), third(straight);
  EXPECT_TRUE(cut_off_tiles(cells, place, front, first));
  ASSERT_TRUE(second.halve(0));
  EXPECT_FALSE(cut_off_tiles(cells, place, front, second));
  BridgeFront glued = front;  // behind a glued face no slice is excepted
  glued.is_in_face = true;
  EXPECT_FALSE(cut_off_tiles(cells, place, glued, third));
}

// PROVES MICRO-1.R4
TEST(Bridges, SquareArmsMeetAtTheirCornersFartherApartThanTheirRadii) {
  // Caps of half the width 1/16 in neighbouring rows, 1/4 apart: the second bridge ends beside the first, moved by
  // (1/8 - 1/100) along both axes across: axes are farther apart than the sum of the half-widths, and corners meet.
  Structure s({4, 4, 4}, box_tile({0, 16, 16}, {64, 48, 48}));
  s.keep({0, 5});  // (0, 0, 0) and (0, 1, 1)
  const Rational near = part(-1, 8) - part(1, 100);
  s.add({0, 0, 1}, part(5, 8));
  s.add({0, 5, 1}, part(5, 8), {Rational(0), near, near});
  EXPECT_EQ(s.condition(), "R4");
  // Axes end (1/8 - 1/100) sqrt(2) = 0.163 apart, and the half-widths add up to 0.125.
  s.micro.bridges.pop_back();
  const Rational far = part(-1, 8) + part(1, 100);
  s.add({0, 5, 1}, part(5, 8), {Rational(0), far, far});
  EXPECT_EQ(s.condition(), "");
}

// PROVES MICRO-1.R4
TEST(Bridges, BentOnesAreToldApartByTheirSlices) {
  Structure s({8, 4, 1});
  s.keep({0, 2});  // rows v = 0 and v = 2, in v of [1/16, 3/16] and of [9/16, 11/16]
  const TilePoint aside = {Rational(0), part(9, 32), Rational(0)};
  s.add({0, 0, 1}, part(3, 4), aside);
  s.add({0, 2, 1}, part(3, 4), aside);
  auto proof = s.prove();
  ASSERT_TRUE(std::holds_alternative<std::vector<BridgeWitness>>(proof));
  // Their boxes are disjoint. A third one, which follows the second one, has to be cut.
  EXPECT_TRUE(std::get<0>(proof)[0].cuts.empty());
  s.keep({0, 1});
  s.micro.bridges.clear();
  s.add({0, 0, 1}, part(3, 4), aside);
  s.add({0, 1, 1}, part(3, 4), aside);
  proof = s.prove();
  ASSERT_TRUE(std::holds_alternative<std::vector<BridgeWitness>>(proof));
  for (const BridgeWitness& w : std::get<0>(proof)) {
    EXPECT_FALSE(w.cuts.empty());
    EXPECT_TRUE(std::is_sorted(w.cuts.begin(), w.cuts.end()));
    for (const Rational& c : w.cuts) EXPECT_TRUE(Rational(0) < c && c < Rational(1));
  }
}

// A slice's box contains the points of the slice, and slices cover the bridge.
// PROVES MICRO-1.R3
TEST(Bridges, SlicesCoverTheBridge) {
  Random random(11);
  for (int n = 0; n < 50; ++n) {
    MicroBridge b;
    b.points.resize(b.num_points());
    BezierVolume<Rational> map({1, 1, 2}, 3, false);
    for (std::size_t i = 0; i < b.points.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c)
        map.component(static_cast<int>(c))[i] = b.points[i][c] =
            Rational(static_cast<int>(random.below(1000))) / Rational(777);
    BridgeSlices slices(b);
    for (int cut = 0; cut < 6; ++cut) slices.halve(random.below(slices.slices().size()));
    const auto cuts = slices.cuts();
    ASSERT_EQ(cuts.size() + 1, slices.slices().size());
    for (int sample = 0; sample < 50; ++sample) {
      const auto t = [&] {
        return Rational(static_cast<int>(random.below(1025))) / Rational(1024);
      };
      const Rational u = t(), v = t(), w = t();
      std::size_t slice = 0;
      while (slice < cuts.size() && cuts[slice] < w) ++slice;
      const auto p = evaluate<Rational, 3>(map, {u, v, w});
      const Box3d& box = slices.slices()[slice].box;
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_LE(Rational::from_double(box.lo[c]), p[c]) << "seed 11, case " << n;
        EXPECT_GE(Rational::from_double(box.hi[c]), p[c]) << "seed 11, case " << n;
      }
    }
  }
}

TEST(Bridges, CostWhatTheCertificatesPageSays) {
  Structure s({4, 1, 1});
  s.keep({0});
  MicroBridge b = s.add({0, 0, 1}, part(1, 2));
  for (TilePoint& p : b.points) p = {Rational(1), Rational(1), Rational(1)};
  b.points[5][1] = Rational(1023) / Rational(1024);  // 11 bits
  EXPECT_EQ(bridge_cost(b), 4u * 12 * 12 / 64);
  b.points[5][1] = Rational::power_of_two(2303);
  EXPECT_EQ(bridge_cost(b), std::uint64_t{4} * 2305 * 2305 / 64);
}

}  // namespace
}  // namespace veritope
