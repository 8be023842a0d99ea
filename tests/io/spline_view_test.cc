// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/spline_view.h"

#include <cmath>
#include <set>
#include <sstream>

#include "render/spline_view_internal.h"
#include "robust/base/random.h"
#include "tests/io/spline_test_util.h"

namespace veritope {
namespace {

using io_test::sample;

TEST(VtkOrder, NumbersCornersThenEdgesThenFacesThenTheInside) {
  const std::array<int, 3> d = {2, 3, 2};
  EXPECT_EQ(vtk_point_index({0, 0, 0}, d), 0u);
  EXPECT_EQ(vtk_point_index({2, 3, 0}, d), 2u);
  EXPECT_EQ(vtk_point_index({0, 3, 2}, d), 7u);
  EXPECT_EQ(vtk_point_index({1, 0, 0}, d), 8u);
  EXPECT_EQ(vtk_point_index({2, 1, 0}, d), 9u);
  // Vertical edges in the order of the corners below them: VTK 9, not 8.
  EXPECT_EQ(vtk_point_index({2, 3, 1}, d), 8u + 2 * 6 + 2);
  EXPECT_EQ(vtk_point_index({0, 3, 1}, d), 8u + 2 * 6 + 3);
  EXPECT_EQ(vtk_point_index({1, 1, 1}, d), 8u + 12 + 4 + 2 * (2 + 1 + 2));
  EXPECT_EQ(vtk_point_index({0, 2}, std::array<int, 2>{3, 2}), 3u);
  EXPECT_EQ(vtk_point_index({3}, std::array<int, 1>{3}), 1u);
}

TEST(VtkOrder, IsAPermutation) {
  for (int l = 1; l <= 4; ++l)
    for (int m = 1; m <= 4; ++m)
      for (int n = 1; n <= 4; ++n) {
        std::set<std::size_t> seen, flat;
        for (std::size_t i = 0; i <= static_cast<std::size_t>(l); ++i)
          for (std::size_t j = 0; j <= static_cast<std::size_t>(m); ++j) {
            flat.insert(vtk_point_index({i, j}, std::array<int, 2>{l, m}));
            for (std::size_t k = 0; k <= static_cast<std::size_t>(n); ++k)
              seen.insert(vtk_point_index({i, j, k}, std::array<int, 3>{l, m, n}));
          }
        EXPECT_EQ(seen.size(), static_cast<std::size_t>((l + 1) * (m + 1) * (n + 1)));
        EXPECT_EQ(*seen.rbegin(), seen.size() - 1);
        EXPECT_EQ(*flat.rbegin(), flat.size() - 1);
      }
}

TEST(SplineView, Base64IsThatOfTheRfc) {
  constexpr std::pair<const char*, const char*> kVectors[] = {
      {"", ""}, {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : kVectors) EXPECT_EQ(base64(bytes), text);
}

TEST(SplineView, AVtuHoldsTheBezierCellsWithTheirWeights) {
  const auto vtu = view_bytes(sample("two_cubes.mesh").model, ViewFormat::kVtu, {});
  ASSERT_TRUE(vtu);
  // Two spans along y; the second brick also two along x: 2 + 4 cells of 12 points.
  EXPECT_NE(vtu->find("NumberOfPoints=\"72\" NumberOfCells=\"6\""), std::string::npos)
      << vtu->substr(0, 400);
  EXPECT_NE(vtu->find("\n79\n79\n"), std::string::npos);
  EXPECT_NE(vtu->find("2 1 1\n"), std::string::npos);
}

TEST(SplineView, ChordsStayAsCloseToACircleAsAskedFor) {
  // A quarter of the unit circle, weights 1, 1/2 sqrt 2 rounded, 1.
  const SplineModel model = io_test::model_of(SplineFormat::kItd,
                                              "[CURVE BEZIER 3 P2 [1 1 0] [0.7071067811865476 "
                                              "0.7071067811865476 0.7071067811865476] [1 0 1]]");
  for (const double chord : {1e-2, 1e-4}) {
    ViewOptions options;
    options.chord = chord;
    const auto parts = tessellate(model, options);
    ASSERT_TRUE(parts);
    const Tessellation& t = (*parts)[0];
    double worst = 0;
    for (std::size_t i = 0; i + 1 < t.lines[0].size(); ++i) {
      const auto &a = t.points[t.lines[0][i]], &b = t.points[t.lines[0][i + 1]];
      EXPECT_NEAR(std::hypot(a[0], a[1]), 1, 1e-14);
      worst = std::max(worst, 1 - std::hypot((a[0] + b[0]) / 2, (a[1] + b[1]) / 2));
    }
    EXPECT_LT(worst, chord);
    EXPECT_GT(worst, chord / 50);
  }
}

// z = x y: straight along both axes, and yet no two triangles are near it. A triangle is farthest from it where two of its edges' middles lie.
TEST(SplineView, TrianglesFollowTheTwistOfABilinearPatch) {
  const SplineModel model = io_test::model_of(
      SplineFormat::kItd, "[SURFACE BEZIER 2 2 E3 [0 0 0] [1 0 0] [0 1 0] [1 1 1]]");
  for (const double chord : {1e-2, 1e-3}) {
    ViewOptions options;
    options.chord = chord;
    const auto obj = view_bytes(model, ViewFormat::kObj, options);
    ASSERT_TRUE(obj);
    std::istringstream lines(*obj);
    std::vector<std::array<double, 3>> points;
    std::size_t triangles = 0;
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string kind;
      words >> kind;
      if (kind == "v") {
        std::array<double, 3> p{};
        words >> p[0] >> p[1] >> p[2];
        points.push_back(p);
      } else if (kind == "f") {
        std::array<std::size_t, 3> f{};
        words >> f[0] >> f[1] >> f[2];
        ++triangles;
        for (std::size_t e = 0; e < 3; ++e) {
          const auto &a = points.at(f[e] - 1), &b = points.at(f[(e + 1) % 3] - 1);
          EXPECT_LE(std::abs((a[2] + b[2]) / 2 - (a[0] + b[0]) * (a[1] + b[1]) / 4), chord);
        }
      }
    }
    EXPECT_GT(triangles, 8u);
    EXPECT_LT(static_cast<double>(triangles), 4 / chord);
  }
}

TEST(SplineView, TheBoundaryOfAVolumeIsClosedAndOutward) {
  const auto parts = tessellate(sample("two_cubes.mesh").model, {});
  ASSERT_TRUE(parts);
  for (const Tessellation& t : *parts) {
    // The volume by the divergence theorem: both bricks are unit cubes.
    double six_volumes = 0;
    for (const auto& f : t.triangles) {
      const auto &a = t.points[f[0]], &b = t.points[f[1]], &c = t.points[f[2]];
      six_volumes += a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                     a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    EXPECT_NEAR(six_volumes / 6, 1, 1e-12);
  }
}

TEST(SplineView, ObjAndGltfCountFromOneAndFromZero) {
  const SplineModel model = sample("trimmed.itd").model;
  const auto obj = view_bytes(model, ViewFormat::kObj, {}),
             gltf = view_bytes(model, ViewFormat::kGltf, {});
  ASSERT_TRUE(obj && gltf);
  EXPECT_NE(obj->find("o entity_0_FACE\n"), std::string::npos);
  std::istringstream lines(*obj);
  std::string line;
  std::size_t num_points = 0;
  while (std::getline(lines, line)) {
    if (line.starts_with("v ")) ++num_points;
    if (!line.starts_with("l ") && !line.starts_with("f ")) continue;
    std::istringstream numbers(line.substr(2));
    for (std::size_t n = 0; numbers >> n;) EXPECT_TRUE(n >= 1 && n <= num_points);
  }
  EXPECT_NE(gltf->find("\"mode\":4"), std::string::npos);
  EXPECT_NE(gltf->find("\"mode\":3"), std::string::npos);
}

TEST(SplineView, WhatBinary64CannotHoldIsRefusedWithItsEntity) {
  const SplineModel model = io_test::model_of(
      SplineFormat::kItd, "[CURVE BEZIER 2 E1 [0] [1]] [CURVE BEZIER 2 E1 [0] [1e400]]");
  for (const ViewFormat format : {ViewFormat::kVtu, ViewFormat::kObj, ViewFormat::kGltf}) {
    const auto bytes = view_bytes(model, format, {});
    ASSERT_FALSE(bytes);
    EXPECT_EQ(bytes.error().code, Code::kNotFinite);
    EXPECT_EQ(bytes.error().place.entity, 1u);
  }
  const SplineModel wide = io_test::model_of(SplineFormat::kItd, "[CURVE BEZIER 2 E1 [0] [1e50]]");
  EXPECT_TRUE(view_bytes(wide, ViewFormat::kObj, {}));
  EXPECT_FALSE(view_bytes(wide, ViewFormat::kGltf, {}));
}

TEST(SplineView, FormatsHaveNames) {
  EXPECT_EQ(view_format_from_name("GLTF"), ViewFormat::kGltf);
  EXPECT_EQ(view_format_from_name("itd"), std::nullopt);
}

// Degree 12, 30 random knots, weights; numbers of `digits` digits.
ExactCurve random_curve(Random& random, int digits) {
  const auto number = [&] {
    std::string text;
    for (int i = 0; i < digits; ++i) text += static_cast<char>('0' + random.next() % 10);
    return Rational(Integer::from_decimal(text),
                    Integer::from_decimal("1" + std::string(text.size(), '0')));
  };
  KnotAxis<Rational> axis{12, {}, false};
  for (int i = 0; i < 30; ++i) axis.knots.push_back(number());
  std::sort(axis.knots.begin(), axis.knots.end());
  axis.knots.insert(axis.knots.begin(), 13, Rational(0));
  axis.knots.insert(axis.knots.end(), 13, Rational(1));
  const std::size_t n = axis.num_control();
  std::vector<Rational> coefficients(4 * n);
  for (Rational& x : coefficients) x = number();
  for (std::size_t i = 3 * n; i < 4 * n; ++i) coefficients[i] += Rational(1);
  return {{std::move(axis)}, 4, true, std::move(coefficients)};
}

TEST(SplineView, PiecesCutWithWideFloatsRoundToThoseCutExactly) {
  Random random(20251123);
  for (const int digits : {3, 17}) {
    const ExactCurve curve = random_curve(random, digits);
    EXPECT_EQ(internal::is_cut_exactly(curve), digits == 3);
    const auto exact = internal::rounded(bezier_pieces(curve), 0);
    const auto wide = internal::rounded(bezier_pieces(internal::with_wide_floats(curve)), 0);
    ASSERT_TRUE(exact && wide);
    EXPECT_EQ(exact->breaks, wide->breaks);
    EXPECT_EQ(exact->pieces, wide->pieces) << "seed 20251123, digits " << digits;
  }
}

TEST(SplineView, NumbersOfThousandsOfDigitsDoNotHoldUpAPicture) {
  // Cut exactly this takes minutes.
  Random random(20251124);
  const SplineModel model{{}, {{random_curve(random, 1000), {}, {}, {}}}};
  EXPECT_TRUE(view_bytes(model, ViewFormat::kObj, {}));
}

TEST(WideFloat, RoundsBelowTheLast256Bits) {
  using internal::WideFloat;
  Random random(20251125);
  const auto number = [&] {
    const Rational x(Integer(static_cast<std::int64_t>(random.next())),
                     Integer(1 + (random.next() >> 1)));
    return x * x * x * x * x *
           Rational::power_of_two(static_cast<std::int64_t>(random.next() % 2000) - 1000);
  };
  const auto near = [](const Rational& a, const Rational& b, const Rational& size) {
    return abs(a - b) <= size * Rational::power_of_two(-254);
  };
  for (int i = 0; i < 500; ++i) {
    const Rational x = number(), y = number();
    const WideFloat a(x), b(y);
    EXPECT_TRUE(near(a.exact(), x, abs(x))) << "seed 20251125, case " << i;
    const Rational u = a.exact(), v = b.exact();
    EXPECT_TRUE(near((a + b).exact(), u + v, abs(u + v)) || near((a + b).exact(), u + v, abs(u)));
    EXPECT_TRUE(near((a * b).exact(), u * v, abs(u * v)));
    EXPECT_EQ((a - a).exact(), Rational());
    EXPECT_EQ((-a).exact(), -u);
    EXPECT_EQ((a + WideFloat()).exact(), u);
  }
  EXPECT_EQ(WideFloat(Rational()).exact(), Rational());
  EXPECT_EQ(WideFloat(Rational(-3)).exact(), Rational(-3));
}

}  // namespace
}  // namespace veritope
