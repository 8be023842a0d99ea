// SPDX-License-Identifier: LGPL-3.0-or-later
// Extrusion, ruled volumes, Boolean sums, sweeps, tubes, placement and cuts.
#include <gtest/gtest.h>

#include <random>

#include "solids/volumes/boolean_sum.h"
#include "solids/volumes/placed.h"
#include "solids/volumes/primitives.h"
#include "solids/volumes/ruled.h"
#include "solids/volumes/swept.h"
#include "splines/bspline_degree.h"
#include "tests/solids/volume_support.h"

namespace veritope {
namespace {

using volume_test::are_equal;
using volume_test::signs_of_jacobian;

constexpr std::uint64_t kSeed = 2103;

Rational q(int p, int r = 1) { return Rational(Integer(p), Integer(r)); }

// A surface with random control points near the unit square at height z, rational or not, with an inner knot or not.
CellSurface random_surface(std::mt19937_64& random, int z, bool is_rational) {
  std::array<KnotAxis<Rational>, 2> axes;
  for (auto& axis : axes) {
    axis = unit_axis(1 + static_cast<int>(random() % 3));
    if (random() % 2 == 0)
      axis.knots.insert(axis.knots.begin() + axis.degree + 1,
                        q(1 + static_cast<int>(random() % 4), 5));
  }
  const auto n = axes[0].num_control(), m = axes[1].num_control();
  std::vector<Rational> all(n * m * (is_rational ? 4 : 3));
  for (std::size_t i = 0; i < n * m; ++i) {
    const Rational w = is_rational ? q(1 + static_cast<int>(random() % 3)) : q(1);
    const auto noise = [&] { return q(static_cast<int>(random() % 11) - 5, 100); };
    all[i] = w * (q(static_cast<int>(i / m), static_cast<int>(n - 1)) + noise());
    all[n * m + i] = w * (q(static_cast<int>(i % m), static_cast<int>(m - 1)) + noise());
    all[2 * n * m + i] = w * (q(z) + noise());
    if (is_rational) all[3 * n * m + i] = w;
  }
  return CellSurface({axes[0], axes[1]}, is_rational ? 4 : 3, is_rational, std::move(all));
}

TEST(Ruled, HasBothSurfacesAsItsEnds) {
  std::mt19937_64 random(kSeed);
  for (int loop = 0; loop < 40; ++loop) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", loop " + std::to_string(loop));
    const CellSurface a = random_surface(random, 0, loop % 2 == 0),
                      b = random_surface(random, 1, loop % 3 == 0);
    const CellVolume volume = ruled(a, b).value();
    EXPECT_TRUE(are_equal(side_of(volume, 2, 0), a));
    EXPECT_TRUE(are_equal(side_of(volume, 2, 1), b));
    const CellVolume extrusion = extruded(a, {q(1), q(2), q(3)}).value();
    EXPECT_TRUE(are_equal(side_of(extrusion, 2, 0), a));
    EXPECT_TRUE(are_equal(side_of(extrusion, 2, 1), placed(a, translation({q(1), q(2), q(3)}))));
    const std::array<Rational, 3> at = {q(1, 3), q(2, 7), q(1, 4)};
    const auto p = point(extrusion, at).value(), s = point(a, {at[0], at[1]}).value();
    EXPECT_EQ(p, (std::vector{s[0] + q(1, 4), s[1] + q(2, 4), s[2] + q(3, 4)}));
  }
  std::mt19937_64 again(kSeed);
  EXPECT_FALSE(extruded(random_surface(again, 0, false), {}));
}

// The faces of a volume, as they are or in other function spaces, times constants, give a volume with these faces; the
// Boolean sum of a volume that is linear in one variable is that volume.
TEST(BooleanSum, HasTheSixSurfacesAsItsFaces) {
  std::mt19937_64 random(kSeed + 1);
  for (int loop = 0; loop < 40; ++loop) {
    SCOPED_TRACE("seed " + std::to_string(kSeed + 1) + ", loop " + std::to_string(loop));
    const bool is_rational = loop % 2 == 0;
    const CellVolume volume =
        ruled(random_surface(random, 0, is_rational), random_surface(random, 2, is_rational))
            .value();
    SixFaces faces = {side_of(volume, 0, 0), side_of(volume, 0, 1), side_of(volume, 1, 0),
                      side_of(volume, 1, 1), side_of(volume, 2, 0), side_of(volume, 2, 1)};
    const SixFaces want = faces;
    for (CellSurface& f : faces) {
      const std::size_t axis = random() % 2;
      if (random() % 2 == 0) f = elevate(f, axis, 1);
      if (random() % 2 == 0) f = refine(f, axis, {q(1 + static_cast<int>(random() % 8), 9)});
      if (random() % 2 == 0) f = with_domain(f, axis, q(-3), q(5, 2)).value();
      if (is_rational)
        for (Rational& x : f.coefficients()) x *= q(1 + static_cast<int>(loop), 3);
      if (is_rational && random() % 2 == 0)
        for (Rational& x : f.coefficients()) x *= q(2, 3);
    }
    const Result<CellVolume> sum = boolean_sum(faces);
    ASSERT_TRUE(sum) << sum.error().message;
    for (std::size_t f = 0; f < 6; ++f)
      EXPECT_TRUE(are_equal(side_of(*sum, f / 2, f % 2), want[f])) << face_name(f);
    const CellCurve u = side_of(want[4], 1, 0);
    EXPECT_EQ(sum->dimension(), 3) << u.dimension();
  }
}

TEST(BooleanSum, OfATrilinearVolumeIsTheVolume) {
  const CellVolume box = box_cells({q(0), q(0), q(0)}, {q(1), q(2), q(3)}).value()[0];
  CellVolume bent = box;
  bent.component(0)[3] = q(1, 2);
  bent.component(2)[6] = q(-1, 5);
  SixFaces faces = {side_of(bent, 0, 0), side_of(bent, 0, 1), side_of(bent, 1, 0),
                    side_of(bent, 1, 1), side_of(bent, 2, 0), side_of(bent, 2, 1)};
  EXPECT_EQ(boolean_sum(faces).value(), bent);
}

TEST(BooleanSum, NamesTheEdgeAndTheDefect) {
  const CellVolume box = box_cells({q(0), q(0), q(0)}, {q(1), q(1), q(1)}).value()[0];
  const SixFaces faces = {side_of(box, 0, 0), side_of(box, 0, 1), side_of(box, 1, 0),
                          side_of(box, 1, 1), side_of(box, 2, 0), side_of(box, 2, 1)};
  SixFaces moved = faces;
  moved[5].component(2)[3] += q(1, 1024);
  EXPECT_EQ(boolean_sum(moved).error().message,
            "faces u1 and w1 differ along the edge u1w1: their control points in one function "
            "space are up to "
            "1/1024 apart in a coordinate");
  SixFaces weighted = faces;
  weighted[1] = homogeneous(weighted[1]);
  for (int c = 0; c < 4; ++c) weighted[1].component(c)[0] *= q(2);
  EXPECT_EQ(boolean_sum(weighted).error().message,
            "faces u1 and v0 differ along the edge u1v0: their control points are equal, their "
            "weights are not "
            "proportional");
  SixFaces slanted = faces;  // proportional along v0 and v1 by different constants, so not along w0
  slanted[1] = homogeneous(slanted[1]);
  for (int c = 0; c < 4; ++c)
    for (const std::size_t i : {2, 3}) slanted[1].component(c)[i] *= q(2);
  EXPECT_EQ(boolean_sum(slanted).error().message,
            "faces u1 and w0 differ along the edge u1w0: their control points are equal, their "
            "weights are not proportional");
  SixFaces flat = faces;
  flat[2] = CellSurface(flat[2].axes(), 2, false, std::vector<Rational>(8));
  EXPECT_FALSE(boolean_sum(flat));
}

TEST(BooleanSum, ArrangesSurfacesInAnyOrderAndOrientation) {
  std::mt19937_64 random(kSeed + 2);
  for (int loop = 0; loop < 20; ++loop) {
    SCOPED_TRACE("seed " + std::to_string(kSeed + 2) + ", loop " + std::to_string(loop));
    const CellVolume volume =
        ruled(random_surface(random, 0, loop % 2 == 0), random_surface(random, 2, false)).value();
    std::vector<CellSurface> all;
    for (std::size_t f = 0; f < 6; ++f) {
      CellSurface s = side_of(volume, f / 2, f % 2);
      if (random() % 2 == 0) s = swapped(s, 0, 1);
      if (random() % 2 == 0) s = reversed(s, 0);
      if (random() % 2 == 0) s = reversed(s, 1);
      all.push_back(std::move(s));
    }
    std::shuffle(all.begin(), all.end(), random);
    const Result<CellVolume> sum =
        boolean_sum_in_any_order({all[0], all[1], all[2], all[3], all[4], all[5]});
    ASSERT_TRUE(sum) << sum.error().message;
    EXPECT_EQ(hand_in_the_middle(*sum), Sign::kPositive);
    for (const CellSurface& s : all) {
      int found = 0;
      for (std::size_t f = 0; f < 6; ++f)
        found += volume_test::symmetry_parity(side_of(*sum, f / 2, f % 2), s) ? 1 : 0;
      EXPECT_EQ(found, 1);
    }
    all[3].component(0)[0] += q(1);
    EXPECT_FALSE(boolean_sum_in_any_order({all[0], all[1], all[2], all[3], all[4], all[5]}));
  }
}

TEST(Swept, InterpolatesEverySectionExactly) {
  std::mt19937_64 random(kSeed + 3);
  for (int loop = 0; loop < 12; ++loop) {
    SCOPED_TRACE("seed " + std::to_string(kSeed + 3) + ", loop " + std::to_string(loop));
    const int degree = 1 + loop % 4;
    std::vector<CellSurface> sections;
    std::vector<Rational> parameters;
    Rational w;
    const int count = degree + 1 + static_cast<int>(random() % 5);
    for (int i = 0; i < count; ++i) {
      sections.push_back(random_surface(random, i, false));
      parameters.push_back(w += q(1 + static_cast<int>(random() % 5), 3));
    }
    const CellVolume volume = swept(sections, parameters, degree, SweepMode::kInterpolate).value();
    EXPECT_EQ(volume.axis(2).degree, degree);
    for (std::size_t i = 0; i < sections.size(); ++i)
      EXPECT_TRUE(are_equal(isoparametric(volume, 2, parameters[i]).value(), sections[i])) << i;
    const CellVolume rows = swept(sections, parameters, degree, SweepMode::kApproximate).value();
    const auto space = in_one_space<2>(sections).value();
    for (std::size_t k = 0; k < space.size(); ++k)
      for (std::size_t i = 0; i < space[k].coefficients().size(); ++i)
        EXPECT_EQ(rows.coefficients()[i * space.size() + k], space[k].coefficients()[i]);
  }
}

TEST(Swept, RefusesWhatItCannotInterpolate) {
  std::mt19937_64 random(kSeed + 4);
  const std::vector<CellSurface> two = {random_surface(random, 0, false),
                                        random_surface(random, 1, false)};
  const auto sentence = [&](std::vector<Rational> parameters, int degree) {
    const auto volume = swept(two, parameters, degree, SweepMode::kInterpolate);
    return volume ? std::string("built") : volume.error().message;
  };
  EXPECT_EQ(sentence({q(0), q(1)}, 1), "built");
  EXPECT_EQ(sentence({q(0), q(1)}, 0), "degree must be at least 1, not 0");
  EXPECT_EQ(sentence({q(0), q(1)}, 2), "sections of a sweep of degree 2 must be at least 3, not 2");
  EXPECT_EQ(sentence({q(0)}, 1), "parameters must be as many as the sections, 2, not 1");
  EXPECT_EQ(sentence({q(1), q(1)}, 1), "parameters do not increase: 1 follows 1");
  // Weights that alternate make the weight of an interpolating control point negative.
  std::vector<CellSurface> heavy(7, homogeneous(two[0]));
  for (std::size_t i = 1; i < 7; i += 2)
    for (Rational& x : heavy[i].coefficients()) x *= q(1000);
  const std::vector<Rational> parameters = {q(0), q(1), q(2), q(3), q(4), q(5), q(6)};
  EXPECT_FALSE(swept(heavy, parameters, 3, SweepMode::kInterpolate));
  EXPECT_TRUE(swept(heavy, parameters, 3, SweepMode::kApproximate));
  EXPECT_EQ(swept(std::vector<CellSurface>(300, two[0]), std::vector<Rational>(300), 1,
                  SweepMode::kInterpolate)
                .error()
                .message,
            "parameters do not increase: 0 follows 0");
}

// A cylinder's and a square prism's side, closed along u or v, from the right or the left.
TEST(Tube, FillsAClosedSurface) {
  KnotAxis<Rational> around{2, {}, false};
  for (const int u : {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}) around.knots.emplace_back(u);
  const std::array<std::array<int, 3>, 9> circle = {{{1, 0, 1},
                                                     {1, 1, 1},
                                                     {0, 2, 2},
                                                     {-1, 1, 1},
                                                     {-1, 0, 1},
                                                     {-1, -1, 1},
                                                     {0, -2, 2},
                                                     {1, -1, 1},
                                                     {1, 0, 1}}};
  std::vector<Rational> all;
  for (int c = 0; c < 4; ++c)
    for (const auto& p : circle)
      for (int z = 0; z < 2; ++z)
        all.push_back(c == 2 ? q(3 * z * p[2]) : q(p[c == 3 ? 2 : static_cast<std::size_t>(c)]));
  const CellSurface side({around, unit_axis(1)}, 4, true, all);
  for (const CellSurface& s : {side, swapped(side, 0, 1), reversed(side, 0), reversed(side, 1)}) {
    const CellVolume volume = tube(s).value();
    EXPECT_EQ(hand_in_the_middle(volume), Sign::kPositive);
    const auto signs = signs_of_jacobian(volume);
    EXPECT_EQ(signs[1], 1);
    EXPECT_EQ(signs[0], 0) << "the four cut edges of a smooth section";
  }
  CellSurface open = side;
  open.component(0)[16] = q(2);
  EXPECT_EQ(tube(open).error().message, "surface is closed along neither of its axes");
}

TEST(Placed, MovesPointsAndKeepsAttributes) {
  std::vector<Rational> all;
  for (int c = 0; c < 5; ++c)
    for (int i = 0; i < 8; ++i) all.push_back(c < 3 ? q(i >> (2 - c) & 1) : q(10 * c + i));
  const CellVolume volume({unit_axis(1), unit_axis(1), unit_axis(1)}, 5, false, all);
  Placement placement = translation({q(1), q(2), q(3)});
  placement.linear[0][0] = q(2);
  placement.linear[1][2] = q(1, 2);
  const CellVolume moved = placed(volume, placement);
  const std::array<Rational, 3> at = {q(1, 3), q(1, 5), q(1, 7)};
  const auto p = point(volume, at).value(), m = point(moved, at).value();
  EXPECT_EQ(
      m, (std::vector{q(2) * p[0] + q(1), p[1] + q(1, 2) * p[2] + q(2), p[2] + q(3), p[3], p[4]}));
  EXPECT_EQ(determinant(placement), q(2));
  EXPECT_EQ(distance_from_rotation(placement), q(3));
}

TEST(Split, CutsEveryKindOfCellWithoutChangingIt) {
  const Cells sphere = sphere_cells(q(1)).value();
  for (const CellVolume& cell : sphere)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto parts = split(cell, axis, q(1, 3)).value();
      for (const auto& [part, u] : {std::pair(parts[0], q(1, 5)), std::pair(parts[1], q(4, 5))}) {
        std::array<Rational, 3> at = {q(1, 2), q(1, 7), q(2, 3)};
        at[axis] = u;
        EXPECT_EQ(point(part, at).value(), point(cell, at).value());
      }
      EXPECT_TRUE(are_equal(side_of(parts[0], axis, 1), side_of(parts[1], axis, 0)));
    }
  const CellVolume box = box_cells({q(0), q(0), q(0)}, {q(1), q(1), q(1)}).value()[0];
  EXPECT_EQ(split(box, 0, q(1)).error().message,
            "at must lie inside of the domain, from 0 to 1, and it is 1");
}

TEST(CommonSpace, RefusesWhatIsTooLargeBeforeItIsComputed) {
  KnotAxis<Rational> many{1, {q(0)}, false};
  for (int i = 0; i <= 3000; ++i) many.knots.emplace_back(i);
  many.knots.push_back(q(3000));
  const auto flat = [](const KnotAxis<Rational>& u, const KnotAxis<Rational>& v) {
    return CellSurface({u, v}, 3, false,
                       std::vector<Rational>(3 * u.num_control() * v.num_control()));
  };
  const auto sum = ruled(flat(many, unit_axis(1)), flat(unit_axis(1), many));
  ASSERT_FALSE(sum);
  EXPECT_EQ(sum.error().code, Code::kOverLimit);
  const auto high = ruled(flat(unit_axis(16), unit_axis(1)), flat(unit_axis(1), unit_axis(1)));
  ASSERT_FALSE(high);
  EXPECT_EQ(high.error().message, "a degree of 16 is over the limit of cells, 15");
}

}  // namespace
}  // namespace veritope
