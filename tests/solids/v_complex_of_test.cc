// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/vmodel/v_complex_of.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "solids/vmodel/v_parts.h"
#include "splines/de_boor.h"
#include "tests/support/v_cells.h"
#include "topology/v_complex_homology.h"
#include "topology/v_complex_links.h"

namespace veritope {
namespace {

using v_cells::cube;
using v_cells::Point;

using Numbers = std::array<std::uint64_t, 4>;  // points, curves, surfaces, internal surfaces

HexahedralVComplex complex_of(const VModel& model) {
  Result<HexahedralVComplex> out = v_complex_of(model);
  EXPECT_TRUE(out.has_value());
  EXPECT_FALSE(validate(out->complex.tables()).has_value());
  return std::move(out).value();
}
VModel glued(std::vector<VVolume> cells) {
  return make_v_model(std::move(cells), VOrientation::kAuto).value();
}
Numbers numbers_of(const VComplex& complex) {
  const VComplexCounts n = complex.counts();
  return {n.points, n.curves, n.surfaces, n.internal_surfaces};
}

// Ids are dense, in the order of least corners and edges, and curves run as their least edges.
void expect_ordered(const VModel& model, const HexahedralVComplex& out) {
  std::uint32_t points = 0, curves = 0;
  for (std::size_t c = 0; c < model.num_cells(); ++c) {
    for (const VPointId p : out.points[c]) {
      EXPECT_LE(p.value, points);
      points = std::max(points, p.value + 1);
    }
    for (std::size_t e = 0; e < 12; ++e) {
      const VCurveId curve = out.curves[c][e];
      EXPECT_EQ(curve.is_none(), model.is_edge_collapsed(c, e));
      if (curve.is_none()) continue;
      EXPECT_LE(curve.value, curves);
      if (curve.value == curves) {
        EXPECT_FALSE(out.is_edge_reversed[c][e]);
      }
      curves = std::max(curves, curve.value + 1);
    }
  }
  EXPECT_EQ(points, out.complex.tables().points.end_id());
  EXPECT_EQ(curves, out.complex.tables().curves.end_id());
}

// The middle of an edge and where it ends, exactly: for edges that no two curves of a test share.
std::array<Point, 3> places_of(const VVolume& cell, std::size_t edge, bool is_reversed) {
  std::array<Point, 3> out;
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<Rational, 3> at;
    const auto set = [&](std::size_t axis, const Rational& t) {
      const auto& knots = cell.axis(axis);
      at[axis] = knots.domain_begin() + t * (knots.domain_end() - knots.domain_begin());
    };
    const auto others = v_face_axes(edge / 4);
    set(others[0], Rational(static_cast<std::int64_t>(edge & 1)));
    set(others[1], Rational(static_cast<std::int64_t>(edge >> 1 & 1)));
    set(edge / 4, Rational(static_cast<std::int64_t>(is_reversed ? 2 - i : i)) / Rational(2));
    const auto p = point(cell, at).value();
    out[i] = {p[0], p[1], p[2]};
  }
  return out;
}

TEST(VComplexOf, NamesAreThoseOfTheCellsAxes) {
  EXPECT_EQ(v_face_name(3), "v1");
  EXPECT_EQ(v_edge_name(10), "u0v1");
  EXPECT_EQ(v_edge_name(5), "u1w0");
  EXPECT_EQ(v_corner_name(2), "u0v1w0");
}

TEST(VComplexOf, OfGluedCubesIsThatOfTheirGluing) {
  const VModel model = glued({cube(0, 0, 0), cube(1, 0, 0), cube(0, 1, 0)});
  const HexahedralVComplex out = complex_of(model);
  EXPECT_EQ(numbers_of(out.complex), (Numbers{16, 28, 16, 2}));
  expect_ordered(model, out);
  EXPECT_TRUE(is_manifold(out.complex));
  EXPECT_EQ(out.complex.common(VCellId{1}, VCellId{2}).curves.size(), 1u);
}

TEST(VComplexOf, CubesOnAnEdgeHaveOneVCurveWithTwoFans) {
  for (const int up : {0, 1}) {
    const VModel model = glued({cube(0, 0, 0), v_cells::turned(cube(1, 1, up), 5)});
    const HexahedralVComplex out = complex_of(model);
    EXPECT_EQ(numbers_of(out.complex),
              up == 0 ? (Numbers{14, 23, 12, 0}) : (Numbers{15, 24, 12, 0}));
    expect_ordered(model, out);
    EXPECT_EQ(nonmanifold_curves(out.complex).size(), up == 0 ? 1u : 0u);
    EXPECT_EQ(nonmanifold_points(out.complex).size(), up == 0 ? 2u : 1u);
    EXPECT_EQ(out.complex.common(VCellId{0}, VCellId{1}).is_exactly_one_point(), up == 1);
  }
}

TEST(VComplexOf, CellsAreReversedAsInTheModelAndFansTurnRight) {
  const VModel model = glued({swapped(cube(0, 0, 0), 0, 1), cube(1, 0, 0), cube(0, 1, 0)});
  const HexahedralVComplex out = complex_of(model);
  EXPECT_EQ(out.is_reversed, (std::vector<bool>{true, false, false}));
  // The inner V-curve is x = y = 1, upward or downward; around it, counterclockwise as seen from its end: the cells
  // at (0, 1), (0, 0), (1, 0).
  const VCommon common = out.complex.common(VCellId{1}, VCellId{2});
  ASSERT_EQ(common.curves.size(), 1u);
  const VFan fan = out.complex.fans(common.curves[0])[0];
  std::vector<std::uint32_t> cells;
  for (std::size_t i = 0; i < fan.uses.size(); i += 2)
    cells.push_back(out.complex.half_surface(out.complex.use(fan.uses[i]).half_surface).cell.value);
  bool runs_up = false;
  for (std::size_t e = 0; e < 12; ++e)
    if (out.curves[0][e] == common.curves[0])
      runs_up = places_of(model.cell(0), e, out.is_edge_reversed[0][e])[2][2] == Rational(1);
  EXPECT_EQ(cells, runs_up ? (std::vector<std::uint32_t>{2, 0, 1})
                           : (std::vector<std::uint32_t>{1, 0, 2}));
}

TEST(VComplexOf, ACellWhoseOwnEdgesAreEqualHasOneVCurveOfThem) {
  // A prism over a triangle with a slit: the edges v = 0 and v = 1 at u = 1 are the same segment, and no face is glued.
  const VVolume cell =
      v_cells::polynomial({1, 2, 1}, [](std::size_t i, std::size_t j, std::size_t k) {
        const std::array<std::array<int, 2>, 3> outer{{{4, 0}, {-4, 8}, {4, 0}}},
            inner{{{2, 1}, {-2, 3}, {2, -1}}};
        const auto& p = i == 0 ? outer[j] : inner[j];
        return Point{Rational(p[0]), Rational(p[1]), Rational(static_cast<std::int64_t>(k))};
      });
  const VModel model = glued({cell});
  EXPECT_EQ(model.counts().v_points, 8u);
  const HexahedralVComplex out = complex_of(model);
  EXPECT_EQ(numbers_of(out.complex), (Numbers{6, 11, 6, 0}));
  expect_ordered(model, out);
  EXPECT_EQ(nonmanifold_curves(out.complex).size(), 1u);
}

TEST(VComplexOf, ClosedCurvesThatRunAgainstEachOtherAreOne) {
  // Two rings, one on the other's rim z = 0 and mirrored, of which v runs against v: no face is equal.
  const auto ring = [](int up, bool is_turned) {
    const VVolume cell =
        v_cells::polynomial({1, 3, 1}, [&](std::size_t i, std::size_t j, std::size_t k) {
          const std::array<std::array<int, 2>, 4> around{{{0, 0}, {6, 1}, {-3, 7}, {0, 0}}};
          const int r = i == 0 && k == 0 ? 1 : i == 0 ? 2 : 3;
          return Point{Rational(r * around[j][0]), Rational(r * around[j][1]),
                       Rational(up * static_cast<int>(i + k))};
        });
    return is_turned ? reversed(cell, 1) : cell;
  };
  for (const bool is_turned : {false, true}) {
    const VModel model = glued({ring(1, false), ring(-1, is_turned)});
    const HexahedralVComplex out = complex_of(model);
    expect_ordered(model, out);
    const VCommon common = out.complex.common(VCellId{0}, VCellId{1});
    ASSERT_EQ(common.curves.size(), 1u);
    const auto& ends = out.complex.curve(common.curves[0]).ends;
    EXPECT_EQ(ends[0], ends[1]);
    for (std::size_t e = 0; e < 12; ++e)
      if (out.curves[1][e] == common.curves[0]) {
        EXPECT_EQ(out.is_edge_reversed[1][e], is_turned);
      }
  }
}

TEST(VComplexOf, EqualVCurvesWithAPolynomialFactorAreTwo) {
  // Both cells have the edge from (0,0,0) to (1,0,0); the weights along it are 1, 2 in one of them.
  const auto cell = [](int side, int weight) {
    return v_cells::rational(
        {1, 1, 1},
        [&](std::size_t i, std::size_t j, std::size_t k) {
          return Point{Rational(static_cast<std::int64_t>(i)), Rational(side * static_cast<int>(j)),
                       Rational(side * static_cast<int>(k))};
        },
        [&](std::size_t i, std::size_t, std::size_t) { return Rational(i == 0 ? 1 : weight); });
  };
  for (const int weight : {1, 2}) {
    const VModel model = glued({cell(1, 1), v_cells::with_factor(cell(-1, weight), Rational(3))});
    const VCommon common = complex_of(model).complex.common(VCellId{0}, VCellId{1});
    EXPECT_EQ(common.curves.size(), weight == 1 ? 1u : 0u);
    EXPECT_EQ(common.points.size(), 2u);
  }
}

TEST(VComplexOf, ManyCurvesBetweenTwoPointsAreSorted) {
  // Slices of a lemon with parabolas between two poles; slice n is from meridian n to n + 1, and every other is left
  // out, so that equal meridians are found without gluing; then all, which leaves a ring of 12.
  const auto meridian = [](int n) {
    const std::array<std::array<int, 2>, 12> around{{{4, 0},
                                                     {4, 2},
                                                     {2, 4},
                                                     {0, 4},
                                                     {-2, 4},
                                                     {-4, 2},
                                                     {-4, 0},
                                                     {-4, -2},
                                                     {-2, -4},
                                                     {0, -4},
                                                     {2, -4},
                                                     {4, -2}}};
    return around[static_cast<std::size_t>(n % 12)];
  };
  const auto slice = [&](int n) {
    return v_cells::polynomial({2, 1, 1}, [&](std::size_t i, std::size_t j, std::size_t k) {
      const auto m = meridian(n + static_cast<int>(j));
      const int r = i == 1 ? (k == 0 ? 1 : 2) : 0;
      const int z = i == 1 ? 0 : i == 0 ? -1 : 1;
      return Point{Rational(r * m[0]), Rational(r * m[1]), Rational(z * (1 + static_cast<int>(k)))};
    });
  };
  std::vector<VVolume> all;
  for (int n = 0; n < 12; ++n) all.push_back(slice(n));
  const VModel model = glued(all);
  EXPECT_EQ(model.counts().internal, 12u);
  const HexahedralVComplex out = complex_of(model);
  EXPECT_EQ(out.complex.counts().points, 4u);
  EXPECT_EQ(out.complex.counts().curves,
            26u);  // 12 inner meridians, 12 outer ones, and a segment at each pole
  std::vector<VVolume> some;
  for (int n = 0; n < 12; n += 2) some.push_back(slice(n));
  EXPECT_EQ(complex_of(glued(some)).complex.counts().curves, 26u);
}

TEST(VComplexOf, CollapsesThatLeaveNoVComplexAreNamed) {
  const VVolume flat = v_cells::polynomial({1, 1, 1}, [](std::size_t, std::size_t, std::size_t k) {
    return Point{Rational(0), Rational(0), Rational(static_cast<std::int64_t>(k))};
  });
  const auto out = v_complex_of(glued({cube(3, 0, 0), flat}));
  ASSERT_FALSE(out.has_value());
  EXPECT_EQ(out.error().place.entity, 1u);
  EXPECT_EQ(out.error().message, "cell 1: edge u0v0 is between collapsed faces only");
}

// Random cubes of a lattice, bent, each described in another way: elements are those of the lattice.
TEST(VComplexOf, RandomDescriptionsHaveTheElementsOfTheLattice) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    std::vector<VVolume> cells;
    std::string text;
    for (int n = 0; n < 27; ++n) {
      if (random.below(3) != 0) continue;
      const VVolume bent =
          v_cells::mapped(elevate(cube(n / 9, n / 3 % 3, n % 3), 0, 1), [](const Point& p) {
            return Point{p[0] + p[1] * p[2] / Rational(7), p[1] + p[2] / Rational(5), p[2]};
          });
      cells.push_back(v_cells::turned(v_cells::redescribed(bent, random),
                                      static_cast<unsigned>(random.below(48))));
      text += v_cells::text_of(cells.back());
    }
    if (cells.empty()) continue;
    SCOPED_TRACE(text);
    const VModel model = glued(cells);
    const HexahedralVComplex out = complex_of(model);
    expect_ordered(model, out);
    std::map<Point, VPointId> points;
    std::map<std::array<Point, 3>, VCurveId> curves;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      for (std::size_t i = 0; i < 8; ++i) {
        const VPointId p = out.points[c][i];
        EXPECT_EQ(points.try_emplace(v_corner_point(cells[c], i), p).first->second, p);
      }
      for (std::size_t e = 0; e < 12; ++e) {
        const VCurveId id = out.curves[c][e];
        const auto at = places_of(cells[c], e, out.is_edge_reversed[c][e]);
        EXPECT_EQ(curves.try_emplace(at, id).first->second, id);
        const auto& ends = out.complex.curve(id).ends;
        EXPECT_EQ(points.at(at[0]), ends[0]);
        EXPECT_EQ(points.at(at[2]), ends[1]);
      }
    }
    EXPECT_EQ(points.size(), out.complex.counts().points);
    EXPECT_EQ(curves.size(), out.complex.counts().curves);
    EXPECT_EQ(out.is_reversed.size(), cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c)
      EXPECT_EQ(out.is_reversed[c], model.is_reversed(c));
  }
}

}  // namespace
}  // namespace veritope
