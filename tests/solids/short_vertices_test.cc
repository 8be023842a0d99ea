// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/short_vertices_test.cc: vertices with shorter numbers stay on their flats, and tetrahedra stay positive.
#include "solids/dms/domain/short_vertices.h"

#include <gtest/gtest.h>

namespace veritope {
namespace {

using Kind = VertexFlat::Kind;

ExactPoint3 at(const Rational& x, const Rational& y, const Rational& z) {
  return ExactPoint3(std::array<Rational, 3>{x, y, z});
}
Rational third() {
  return Rational(1) / Rational(Integer::from_decimal("3000000000000000000000000000001"));
}

// The unit tetrahedron cut at one point into four, three or two.
struct Cut {
  std::vector<ExactPoint3> points{at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), at(0, 0, 1)};
  std::vector<TetrahedronCorners> tetrahedra;

  explicit Cut(const ExactPoint3& p) {
    points.push_back(p);
    for (std::size_t m = 0; m < 4; ++m) {
      TetrahedronCorners t{0, 1, 2, 3};
      t[m] = 4;
      if (sign_of(t) == Sign::kPositive) tetrahedra.push_back(t);
    }
  }
  Sign sign_of(const TetrahedronCorners& t) const {
    return orient3d(points[t[0]], points[t[1]], points[t[2]], points[t[3]]);
  }
  void shorten(const VertexFlat& flat) {
    std::vector<VertexFlat> flats(points.size());
    flats.back() = flat;
    shorten_vertices(flats, tetrahedra, points);
    for (const TetrahedronCorners& t : tetrahedra) EXPECT_EQ(sign_of(t), Sign::kPositive);
  }
};

TEST(ShortVertices, AreShortAnywhereInside) {
  Cut cut(at(Rational(1) / Rational(7) + third(), Rational(1) / Rational(5) + third(),
             Rational(1) / Rational(3)));
  EXPECT_EQ(cut.tetrahedra.size(), 4u);
  cut.shorten({Kind::kFree, {}});
  EXPECT_LE(num_bits(cut.points[4]), 20u);
}

TEST(ShortVertices, StayInTheirPlane) {
  const Rational x = Rational(1) / Rational(3) + third(), y = Rational(1) / Rational(5);
  Cut cut(at(x, y, Rational(1) - x - y));
  EXPECT_EQ(cut.tetrahedra.size(), 3u);
  cut.shorten({Kind::kPlane, {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}});
  const auto& p = cut.points[4].at();
  EXPECT_EQ(p[0] + p[1] + p[2], Rational(1));
  EXPECT_LE(num_bits(cut.points[4]), 20u);
}

TEST(ShortVertices, StayOnTheirLine) {
  const Rational x = Rational(1) / Rational(3) + third();
  Cut cut(at(x, Rational(1) - x, 0));
  EXPECT_EQ(cut.tetrahedra.size(), 2u);
  cut.shorten({Kind::kLine, {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d()}});
  const auto& p = cut.points[4].at();
  EXPECT_EQ(p[0] + p[1], Rational(1));
  EXPECT_EQ(p[2], Rational(0));
  EXPECT_LE(num_bits(cut.points[4]), 20u);
}

TEST(ShortVertices, TakeAsManyDigitsAsThePlaceNeeds) {
  // Nearer to a facet than 2^-40 times the size.
  const Rational tiny = Rational::power_of_two(-50) + third() * Rational::power_of_two(-60);
  Cut cut(at(Rational(1) / Rational(4), Rational(1) / Rational(4), tiny));
  cut.shorten({Kind::kFree, {}});
  EXPECT_GT(cut.points[4].at()[2], Rational(0));
  EXPECT_LE(num_bits(cut.points[4]), 160u);
}

TEST(ShortVertices, StayWhereTheyAreFixedOrShort) {
  Cut fixed(at(Rational(1) / Rational(7) + third(), Rational(1) / Rational(5),
               Rational(1) / Rational(3)));
  const auto before = fixed.points[4].at();
  fixed.shorten({});
  EXPECT_EQ(fixed.points[4].at(), before);
  Cut brief(at(Rational(1) / Rational(7), Rational(1) / Rational(5), Rational(1) / Rational(3)));
  const auto also = brief.points[4].at();
  brief.shorten({Kind::kFree, {}});
  EXPECT_EQ(brief.points[4].at(), also);
}

}  // namespace
}  // namespace veritope
